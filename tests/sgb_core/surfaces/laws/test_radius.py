from __future__ import annotations

from itertools import pairwise
from math import cos, pi, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from sgb_core.arrays import Floats
from sgb_core.bodies.body import Body
from sgb_core.bodies.solid import Solid
from sgb_core.curves.continuity import JointClass
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.model import Document
from sgb_core.findings.refusal import RefusalError
from sgb_core.surfaces import measures
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.tessellation import tessellate
from sgb_core.surfaces.turn import column_angles
from sgb_core.surfaces.turning_joints import measure_turning_joints
from tests.sgb_core.surfaces.chains import RADIUS_LAWS

TUBE = Profile.of([line((20, 0), (20, 60))])
CONE = Profile.of([line((20, 0), (35, 40)), line((35, 40), (30, 70))])
HEXAGON = Law("radius", "polygon", 0.0, 1.0, count=6)


def _integral(laws: tuple[Law, ...], power: int) -> float:
    """∫ mᵖ dθ over a turn, by another program's adaptive rule between all breaks."""
    edges = np.unique(
        [0.0, 2.0 * pi, *(b for law in laws for b in law.breaks), *np.arange(0.0, 6.2, 0.1)]
    )

    def density(theta: float) -> float:
        values = [law.start + (law.end - law.start) * float(law.fraction(theta)) for law in laws]
        return float(np.prod(values)) ** power

    return sum(quad(density, a, b, epsabs=1e-13, epsrel=1e-12)[0] for a, b in pairwise(edges))


@settings(max_examples=60)
@given(RADIUS_LAWS, st.floats(0.0, 6.28))
def test_rates_are_the_derivatives(law: Law, theta: float) -> None:
    step = 1e-5
    if any(abs((theta - b + pi) % (2 * pi) - pi) < 2 * step for b in law.breaks):
        return
    slope = (law.fraction(theta + step) - law.fraction(theta - step)) / (2 * step)
    assert float(law.fraction_rate(theta)) == pytest.approx(float(slope), abs=1e-3 * law.count)


@settings(max_examples=60)
@given(RADIUS_LAWS)
def test_curves_are_continuous_stay_in_their_span_and_crease_only_where_they_say(law: Law) -> None:
    theta = np.linspace(0.0, 2.0 * pi, 20_001)
    f = law.fraction(theta)
    low, high = law.shape.span(law)
    assert f.min() >= low - 1e-12
    assert f.max() <= high + 1e-12
    assert 0.0 <= low <= high <= 1.0 + 1e-15
    # Steepest are flanks of 5 degrees.
    assert np.abs(np.diff(f)).max() <= 2.0 * pi / 20_000 * max(180.0 / pi / 5.0, law.count) * 1.01
    for crease in law.creases:
        before, after = law.fraction_rate(crease, -1), law.fraction_rate(crease, 1)
        assert abs(float(after) - float(before)) > 1e-9 or law.sharp < 1e-6
    for smooth in set(law.breaks) - set(law.creases):
        before, after = law.fraction_rate(smooth, -1), law.fraction_rate(smooth, 1)
        assert float(after) == pytest.approx(float(before), abs=1e-6)


def test_a_hexagons_section_is_one_on_the_mesh() -> None:
    mesh = tessellate(RevolutionSurface(TUBE, laws=(HEXAGON,)), tolerance=0.01)
    foot = mesh.positions[np.abs(mesh.positions[:, 2]) < 1e-9][:, :2]
    # Every point lies on one of the six lines, and the six corners are among them.
    normals = np.array([(np.cos(a), np.sin(a)) for a in pi / 6 + pi / 3 * np.arange(6)])
    reach = (foot @ normals.T).max(axis=1)
    np.testing.assert_allclose(reach, 20.0 * cos(pi / 6), atol=1e-9)
    for k in range(6):
        corner = 20.0 * np.array([np.cos(k * pi / 3), np.sin(k * pi / 3)])
        assert np.linalg.norm(foot - corner, axis=1).min() < 1e-9
    # The crease is kept: no normal there lies between those of the two sides.
    sideways = mesh.normals[:, :2] @ normals.T
    np.testing.assert_allclose(sideways.max(axis=1), 1.0, atol=1e-9)


def test_a_rounded_polygon_has_arcs_of_the_radius_said() -> None:
    law = Law("radius", "polygon", 0.0, 1.0, count=4, round=0.3)
    theta = np.linspace(-0.05, 0.05, 11)
    r = law.fraction(theta)
    points = np.stack([r * np.cos(theta), r * np.sin(theta)], axis=1)
    centre = np.array([1.0 - 0.3 * sqrt(2.0), 0.0])
    np.testing.assert_allclose(np.linalg.norm(points - centre, axis=1), 0.3, atol=1e-12)


@settings(max_examples=25, deadline=None)
@given(st.lists(RADIUS_LAWS, min_size=1, max_size=2).map(tuple))
def test_volume_capacity_and_area_are_those_of_independent_quadrature(
    laws: tuple[Law, ...],
) -> None:
    surface = RevolutionSurface(CONE, laws=laws)
    square = _integral(laws, 2)
    plain = measures.volume(RevolutionSurface(CONE)) / (2.0 * pi)
    assert measures.volume(surface) == pytest.approx(plain * square, rel=1e-10)
    tube = RevolutionSurface(TUBE, laws=laws)
    m1, m2 = _integral(laws, 1), square
    held = Body(tube, Solid(kind="vessel", wall=3.0, base=4.0))
    # (20 m − 3)² over the turn.
    inner = 0.5 * 56.0 * (400.0 * m2 - 120.0 * m1 + 9.0 * 2.0 * pi)
    assert held.capacity == pytest.approx(inner, rel=1e-9)
    assert held.material_volume == pytest.approx(0.5 * 60.0 * 400.0 * m2 - inner, rel=1e-8)
    assert measures.area(tube) == pytest.approx(60.0 * _length(laws, 20.0), rel=1e-9)


def _length(laws: tuple[Law, ...], radius: float) -> float:
    """The length of the curve r = radius · m(θ)."""
    edges = np.unique(
        [0.0, 2.0 * pi, *(b for law in laws for b in law.breaks), *np.arange(0.0, 6.2, 0.1)]
    )

    def speed(theta: Floats) -> float:
        factor, rate = 1.0, 0.0
        for law in laws:
            span = law.end - law.start
            value = law.start + span * float(law.fraction(theta))
            slope = span * float(law.fraction_rate(theta))
            factor, rate = factor * value, rate * value + factor * slope
        return radius * float(np.hypot(factor, rate))

    return sum(quad(speed, a, b, epsabs=1e-12, epsrel=1e-12)[0] for a, b in pairwise(edges))


def test_joints_are_those_of_the_stretched_section() -> None:
    law = Law("radius", "cosine", 0.5, 2.0, count=2)
    (report,) = measure_turning_joints(RevolutionSurface(CONE, laws=(law,)))
    kinks = []
    for factor in np.linspace(0.5, 2.0, 20_001):
        a, b = np.array([15.0 * factor, 40.0]), np.array([-5.0 * factor, 30.0])
        kinks.append(np.degrees(np.arccos(a @ b / np.linalg.norm(a) / np.linalg.norm(b))))
    assert report.kink_deg == pytest.approx(max(kinks), abs=1e-6)
    torn = Law("radius", "cosine", 1.0, 1.2, segments=(0,), count=2)
    (report,) = measure_turning_joints(RevolutionSurface(CONE, laws=(torn,)))
    assert report.measured is JointClass.GAP


@pytest.mark.parametrize(
    "wrong",
    [
        {"kind": "lobes", "start": 0.0, "end": 1.0},
        {"kind": "lobes", "start": 1.0, "end": -0.1},
        {"kind": "polygon", "start": 0.0, "end": 1.0, "count": 2},
        {"kind": "keyframes", "start": 1.0, "end": 0.0, "keyframes": ((0.0, 1.0),)},
    ],
)
def test_what_leaves_no_radius_is_refused(wrong: dict[str, object]) -> None:
    with pytest.raises(RefusalError):
        Law("radius", **wrong)  # type: ignore[arg-type]


def test_columns_stand_on_every_crease() -> None:
    surface = RevolutionSurface(TUBE, laws=(Law("radius", "square", 0.9, 1.0, count=5),))
    angles = column_angles(surface, 64)
    assert len(angles) == 65
    assert np.all(np.diff(angles) > 0.0)
    for crease in surface.laws[0].creases:
        assert crease in angles


def test_a_shape_brings_what_it_needs() -> None:
    lobed = Law("radius", "lobes", 0.95, 1.05, count=8)
    shape = HEXAGON.shape
    sided = edits.with_shape(lobed, shape)
    assert (sided.start, sided.end, sided.count) == (0.0, 1.0, 8)
    assert edits.with_shape(Law("radius", "raised-cosine", 0.95, 1.05), shape).count == 6
    document = edits.add_law(Document(TUBE), sided)
    assert document.variation == (sided,)
