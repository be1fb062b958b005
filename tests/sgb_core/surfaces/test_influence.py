"""The influence of a shape parameter, held to finite differences of the surface itself."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import PARAMETER_RANGES, PARAMETERS, Segment, ShapeParameters
from sgb_core.surfaces.influence import quartic_rates, section_influence
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import Law

S = np.linspace(0.0, 1.0, 9)
POINTS = (((1, 0), (3, 0.5), (3, 2), (1, 3)), ((1, 3), (0, 4), (2, 5), (2, 6)))


def chain(shape):
    return Profile.of([Segment(points, shape) for points in POINTS], ["G0"])


def inner(low, high):
    """Values at which a step either way stays in range."""
    return st.floats(low + 1e-3, high - 1e-3)


shapes = st.builds(ShapeParameters, *(inner(*PARAMETER_RANGES[name]) for name in PARAMETERS))


@given(shapes, st.sampled_from(PARAMETERS), st.sampled_from([None, 0, 1]))
def test_it_is_the_derivative(shape, name, segment):
    step = 1e-4
    profile = chain(shape)

    def moved(by):
        changed = shape.__class__(
            **{n: getattr(shape, n) + (by if n == name else 0.0) for n in PARAMETERS}
        )
        return Profile(
            tuple(
                s.with_shape(changed) if segment in (None, k) else s
                for k, s in enumerate(profile.segments)
            ),
            profile.rules,
        ).sample(len(S))

    # The curve is linear in each parameter: the difference quotient is exact but for rounding.
    wanted = np.linalg.norm(moved(step) - moved(-step), axis=-1) / (2 * step)
    assert section_influence(profile, name, S, segment) == pytest.approx(wanted, abs=1e-10)


def test_with_laws_it_is_the_derivative_at_each_angle():
    law = Law("omega", "raised-cosine", 0.2, 0.9)
    profile = chain(ShapeParameters(2.0, 4.0, 0.5, 0.5))
    theta = np.array([0.0, 1.0, 4.0])
    found = section_influence(profile, "lambda2", S, None, (law,), theta)
    assert found.shape == (3, 2, len(S))
    up = Profile(
        tuple(s.with_shape(replace(s.shape, lambda2=5.0)) for s in profile.segments), profile.rules
    )
    for k, angle in enumerate(theta):
        for segment in range(2):
            a = RevolutionSurface(profile, laws=(law,)).point(segment, S, angle)
            b = RevolutionSurface(up, laws=(law,)).point(segment, S, angle)
            assert found[k, segment] == pytest.approx(np.linalg.norm(b - a, axis=-1), abs=1e-12)


def test_the_ends_never_move_and_neutral_has_no_influence_of_omega():
    profile = chain(ShapeParameters(3.0, 1.0, 2.0, 0.7))
    for name in PARAMETERS:
        assert np.all(section_influence(profile, name, [0.0, 1.0]) == 0.0)
    neutral = chain(ShapeParameters(1.0, 3.0, 1.0, 0.7))
    assert np.all(quartic_rates(neutral, "omega") == 0.0)


def test_there_is_no_such_segment():
    with pytest.raises(IndexError, match="no segment 2"):
        quartic_rates(chain(ShapeParameters()), "omega", 2)
