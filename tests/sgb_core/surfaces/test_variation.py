from __future__ import annotations

from itertools import pairwise
from math import pi, radians

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves.segment import PARAMETER_RANGES
from sgb_core.surfaces.variation import (
    Law,
    parameters,
    radius_factors,
    varying_quartics,
)
from tests.sgb_core.surfaces.chains import BALL, KEYS, LAWS, PAPER, SHAPE_LAWS, TOWER, WAVE, chain


def test_the_laws_have_the_values_of_their_formulas() -> None:
    theta = np.array([0.0, pi / 2, pi, 3 * pi / 2, 2 * pi])
    np.testing.assert_allclose(PAPER.fraction(theta), [0, 0.5, 1, 0.5, 0], atol=1e-15)
    raised = Law("omega", "raised-cosine", 0, 1)
    np.testing.assert_allclose(raised.fraction(theta), [0, 0.5, 1, 0.5, 0], atol=1e-15)
    np.testing.assert_allclose(WAVE.fraction([0, pi / 3, 2 * pi / 3]), [0, 1, 0], atol=1e-15)
    keys = KEYS.fraction(np.deg2rad([0, 90, 200, 360, -160]))
    np.testing.assert_allclose(keys, [0, 1, 0.3, 0, 0.3], atol=1e-15)


@given(LAWS, st.floats(0.0, 2 * pi))
def test_rates_are_the_slopes(laws: tuple[Law, ...], theta: float) -> None:
    step = 1e-6
    for law in laws:
        if any(abs(theta - b) < 1e-3 for b in (*law.breaks, 2 * pi)):
            continue
        slope = (law.fraction(theta + step) - law.fraction(theta - step)) / (2 * step)
        assert law.fraction_rate(theta) == pytest.approx(slope, abs=1e-7)


def test_the_papers_crease_has_two_slopes() -> None:
    assert PAPER.fraction_rate(pi, -1) == pytest.approx(0.5)
    assert PAPER.fraction_rate(pi, +1) == pytest.approx(-0.5)
    assert PAPER.fraction_rate(2 * pi, -1) == pytest.approx(-0.5)


@given(
    st.lists(
        st.tuples(st.integers(0, 359), st.floats(0, 1)),
        min_size=1,
        max_size=6,
        unique_by=lambda key: key[0],
    )
)
def test_keyframes_stay_between_their_neighbours_and_are_smooth(
    keys: list[tuple[float, float]],
) -> None:
    law = Law("omega", "keyframes", 0, 1, keyframes=tuple(keys))
    ordered = sorted(keys)
    around = [*ordered, (ordered[0][0] + 360, ordered[0][1])]
    for (d0, f0), (d1, f1) in pairwise(around):
        theta = np.deg2rad(np.linspace(d0, d1, 50))
        values = law.fraction(theta[1:-1])
        assert (values >= min(f0, f1) - 1e-12).all()
        assert (values <= max(f0, f1) + 1e-12).all()
        steps = np.diff(values) * np.sign(f1 - f0)
        assert (steps >= -1e-12).all()
    for degrees, f in keys:
        angle = radians(degrees)
        assert law.fraction(angle) == pytest.approx(f, abs=1e-12)
        before, after = law.fraction_rate([angle - 1e-12, angle + 1e-12])
        assert before == pytest.approx(after, abs=1e-5)


@given(SHAPE_LAWS)
def test_values_stay_in_range_and_the_later_law_wins(laws: tuple[Law, ...]) -> None:
    profile = chain(TOWER)
    theta = np.linspace(0, 2 * pi, 101)
    values, _ = parameters(profile, laws, theta)
    for k, name in enumerate(("lambda1", "lambda2", "lambda3", "omega")):
        low, high = PARAMETER_RANGES[name]
        assert (values[..., k] >= low).all()
        assert (values[..., k] <= high).all()
    last = Law(laws[-1].parameter, "raised-cosine", 0.25, 0.25, segments=(1,))
    index = ("lambda1", "lambda2", "lambda3", "omega").index(last.parameter)
    both, _ = parameters(profile, (*laws, last), theta)
    assert (both[:, 1, index] == 0.25).all()
    np.testing.assert_array_equal(both[:, 0], values[:, 0])


@given(LAWS, st.floats(0.01, 6.2))
def test_sections_are_those_of_the_segments_with_these_parameters(
    laws: tuple[Law, ...], theta: float
) -> None:
    profile = chain(BALL, (2, 1, 3, 0.6))
    values, _ = parameters(profile, laws, theta)
    quartics, rates = varying_quartics(profile, laws, theta)
    expected = profile.segments[0].with_shape(type(profile.segments[0].shape)(*values[0]))
    factor = radius_factors(profile, laws, theta)[0][0]
    np.testing.assert_allclose(quartics[0], expected.quartic * (factor, 1.0), atol=1e-15)
    if all(abs(theta - b) > 1e-3 for law in laws for b in law.breaks):
        ahead, behind = (varying_quartics(profile, laws, theta + d)[0] for d in (1e-6, -1e-6))
        np.testing.assert_allclose(rates, (ahead - behind) / 2e-6, atol=1e-6)
