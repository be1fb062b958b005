"""Speed, turning and energies near a standstill, against arithmetic of forty digits."""

from __future__ import annotations

from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.surfaces.energy import bending_energy
from sgb_core.surfaces.measures import area, generatrix_length, segment_lengths
from sgb_core.surfaces.pace import halves
from sgb_core.surfaces.revolution import RevolutionSurface
from tests.sgb_core.curves.strategies import segments

DIGITS = 40


def quartic(segment: Segment) -> list[tuple[mp.mpf, mp.mpf]]:
    """Return Q0..Q4, from the printed leg fractions."""
    p = [[mp.mpf(float(x)) for x in row] for row in segment.points]
    names = ("lambda1", "lambda2", "lambda3", "omega")
    l1, l2, l3, w = (mp.mpf(getattr(segment.shape, name)) for name in names)
    legs = (((3 + w * (1 - l1)) / 4, 0, 1), ((3 + w * (l2 - 3)) / 6, 2, 1))
    legs += (((3 + w * (1 - l3)) / 4, 3, 2),)
    inner = [
        [p[near][k] + part * (p[far][k] - p[near][k]) for k in (0, 1)] for part, near, far in legs
    ]
    return [p[0], *inner, p[3]]


def derivative(control: list, order: int, s: mp.mpf) -> list[mp.mpf]:
    factor, degree = mp.mpf(1), 4
    for _ in range(order):
        control = [[b[k] - a[k] for k in (0, 1)] for a, b in pairwise(control)]
        factor, degree = factor * degree, degree - 1
    terms = [mp.binomial(degree, j) * s**j * (1 - s) ** (degree - j) for j in range(degree + 1)]
    return [factor * mp.fsum(t * c[k] for t, c in zip(terms, control, strict=True)) for k in (0, 1)]


def exact(segment: Segment, density) -> mp.mpf:
    """Return ∫ density(|L'|, L' × L'', r) ds over panels that shrink towards 0, ½ and 1."""
    q = quartic(segment)

    def at(s: mp.mpf) -> mp.mpf:
        v, u = derivative(q, 1, s), derivative(q, 2, s)
        return density(mp.hypot(*v), v[0] * u[1] - v[1] * u[0], derivative(q, 0, s)[0])

    shrinking = [mp.mpf(4) ** -k for k in range(20, 0, -1)]
    low = [mp.mpf(0), *shrinking[:-1], *(mp.mpf(1) / 2 - step for step in reversed(shrinking))]
    edges = sorted({*low, mp.mpf(1) / 2, *(1 - s for s in low)})
    nodes, weights = np.polynomial.legendre.leggauss(14)
    return mp.fsum(
        (high - low) / 2 * mp.mpf(w) * at(low + (high - low) * (1 + mp.mpf(x)) / 2)
        for low, high in pairwise(edges)
        for x, w in zip(nodes.tolist(), weights.tolist(), strict=True)
    )


def bending(pace: mp.mpf, turn: mp.mpf, _r: mp.mpf) -> mp.mpf:
    return turn**2 / pace**5


@pytest.mark.parametrize("off", [1e-3, 1e-7, 1e-11])
def test_just_short_of_a_vanishing_end_the_energy_keeps_its_digits(off: float) -> None:
    points = np.array([(3.0, 0.0), (7.5, 1.0), (2.0, 5.5), (6.0, 9.0)])
    shapes = (ShapeParameters(4, 2, 4, 1 - off), ShapeParameters(4 - off, 2, 1, 1))
    for shape in shapes:
        segment = Segment(points, shape)
        with mp.workdps(DIGITS):
            wanted = float(exact(segment, bending))
        assert bending_energy(Profile.of([segment])) == pytest.approx(wanted, rel=1e-9)
        assert bending_energy(Profile.of([segment.reversed()])) == pytest.approx(wanted, rel=1e-9)


@pytest.mark.parametrize("off", [1e-3, 1e-6])
def test_near_a_cusp_inside_the_energy_keeps_its_digits(off: float) -> None:
    segment = Segment(np.array([(5.0, 0.0), (6.0 + off, 1.0), (5.0, 1.0), (6.0, 0.0)]))
    with mp.workdps(DIGITS):
        wanted = float(exact(segment, bending))
    assert bending_energy(Profile.of([segment])) == pytest.approx(wanted, rel=2e-9)


def test_a_cusp_inside_has_no_energy() -> None:
    cusp = Segment(np.array([(5.0, 0.0), (6.0, 1.0), (5.0, 1.0), (6.0, 0.0)]))
    assert bending_energy(Profile.of([cusp])) is None


@given(segments())
def test_a_half_moves_as_the_segment_does(segment: Segment) -> None:
    size = segment.size
    if size == 0.0:
        return
    both = halves(Profile.of([segment]), size)
    s = np.linspace(0.0, 0.5, 9)
    for number, whole in enumerate((segment, segment.reversed())):
        k = np.full(len(s), number)
        first, second = whole.derivative(s) / size, whole.derivative(s, 2) / size
        pace = np.hypot(*first.T)
        np.testing.assert_allclose(both.speed(s, k), pace, atol=1e-9)
        np.testing.assert_allclose(both.radius(s, k), whole.point(s)[:, 0] / size, atol=1e-12)
        np.testing.assert_allclose(both.climb(s, k), first[:, 1], atol=1e-11)
        np.testing.assert_allclose(
            both.derivative(s, k, 2), second @ [1.0, 1j], atol=1e-9 * (1.0 + np.abs(second).max())
        )
        clear = pace > 1e-2
        turn = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
        np.testing.assert_allclose(
            (both.turning(s, k) * pace**2)[clear], turn[clear], atol=1e-7 * (1 + np.abs(turn).max())
        )


@given(st.lists(segments(), min_size=2, max_size=5))
def test_many_segments_are_measured_as_each_alone(several: list[Segment]) -> None:
    profile = Profile.of(several)
    if profile.size == 0.0:
        return
    size = profile.size
    together, alone = halves(profile, size), [halves(Profile.of([each]), size) for each in several]
    for name in ("radii", "velocity", "lead", "zeros", "singular"):
        parts = np.concatenate([getattr(half, name) for half in alone])
        np.testing.assert_array_equal(getattr(together, name), parts)
    lengths = [segment_lengths(Profile.of([each]))[0] for each in several]
    np.testing.assert_allclose(segment_lengths(profile), lengths, rtol=1e-12, atol=1e-13 * size)
    low, high, which = together.panels()
    for number in range(2 * len(several)):
        ours = which == number
        # The panels of a half follow each other from its end to the middle.
        np.testing.assert_array_equal(high[ours], [*low[ours][1:], 0.5])
        assert low[ours][0] == 0.0


@given(st.floats(0.0, 4.0), st.floats(0.0, 6.0), st.floats(0.0, 4.0), st.floats(0.0, 1.0))
def test_length_and_area_of_any_bend(l1: float, l2: float, l3: float, omega: float) -> None:
    points = [(3.0, 0.0), (9.0, 8.0), (2.0, 7.5), (6.0, -1.0)]
    profile = Profile.of([Segment(np.array(points), ShapeParameters(l1, l2, l3, omega))])
    nodes, weights = np.polynomial.legendre.leggauss(40)
    edges = np.linspace(0.0, 1.0, 400)
    s = (edges[:-1, None] + np.diff(edges)[:, None] * (nodes + 1) / 2).ravel()
    weight = np.repeat(np.diff(edges), 40) * np.tile(weights / 2, 399)
    pace = np.hypot(*profile.segments[0].derivative(s).T)
    assert generatrix_length(profile) == pytest.approx(weight @ pace, rel=1e-10)
    swept = 2 * np.pi * weight @ (np.abs(profile.segments[0].point(s)[:, 0]) * pace)
    assert area(RevolutionSurface(profile)) == pytest.approx(swept, rel=1e-9)


@pytest.mark.parametrize("height", [5e-324, 2.2e-313, 1e-300])
def test_the_smallest_of_numbers_overflow_nothing(height: float) -> None:
    tiny = RevolutionSurface(Profile.of([Segment([(0, 0), (0, 0), (0, 0), (0, height)])]))
    assert generatrix_length(tiny) == pytest.approx(height, rel=1e-9, abs=0.0)
    assert area(tiny) == 0.0
