from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sgb_core.curves.continuity import measure_joints
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import ShapeParameters
from sgb_core.design.locks.dimension import Dimension
from sgb_core.document import edits
from sgb_core.document.edits import EditError
from sgb_core.document.guides import Guide
from sgb_core.document.model import Document, Unit
from sgb_core.document.reference import Reference
from sgb_core.surfaces import measures
from sgb_core.surfaces.variation import Law
from tests.sgb_core.document import samples

calm = settings(deadline=None, suppress_health_check=list(HealthCheck))
VASE = samples.document(rules=("G1", "C1"), shape=ShapeParameters(0.5, 4.0, 2.0, 0.7))


def test_scaling_scales_the_volume_by_the_cube() -> None:
    scaled = edits.scale(VASE, 2.5)
    expected = measures.volume(VASE.surface) * 2.5**3
    assert measures.volume(scaled.surface) == pytest.approx(expected, rel=1e-13)
    assert scaled.solid == VASE.solid
    assert edits.scale(VASE, 1.0) is VASE


@calm
@given(st.floats(1e-3, 1e6), st.floats(1e-3, 1e6))
def test_height_and_diameter_are_what_was_asked_for(height: float, diameter: float) -> None:
    sized = edits.set_largest_diameter(edits.set_height(VASE, height), diameter)
    low, high = sized.profile.bounds()
    assert high[1] - low[1] == pytest.approx(height, rel=1e-12)
    assert 2.0 * high[0] == pytest.approx(diameter, rel=1e-12)
    assert low[1] == pytest.approx(VASE.profile.bounds()[0][1], abs=1e-12 * height)
    smooth = edits.set_rule(VASE, 1, "C1")
    kept = edits.set_largest_diameter(edits.set_height(smooth, height), diameter)
    assert all(joint.holds for joint in measure_joints(kept.profile))


def test_what_has_no_height_or_width_cannot_be_sized() -> None:
    with pytest.raises(EditError, match="flat profile"):
        edits.set_height(samples.document([[[0, 1], [1, 1], [2, 1], [3, 1]]]), 2.0)
    with pytest.raises(EditError, match="on the axis"):
        edits.set_largest_diameter(samples.document([[[0, 1], [0, 2], [0, 3], [0, 4]]]), 2.0)
    for edit in (edits.scale, edits.set_height, edits.set_largest_diameter):
        with pytest.raises(EditError, match="positive number"):
            edit(VASE, 0.0)
        with pytest.raises(EditError, match="finite number"):
            edit(VASE, float("inf"))
        with pytest.raises(EditError, match="1e9"):
            edit(VASE, 1e12)


def test_mirroring_turns_upside_down_in_place() -> None:
    once = edits.mirror_height(VASE)
    np.testing.assert_allclose(once.profile.bounds(), VASE.profile.bounds(), atol=1e-14)
    assert once.profile.segments[0].points[0, 1] == pytest.approx(10.0)
    twice = edits.mirror_height(once)
    np.testing.assert_allclose(
        twice.profile.control_points, VASE.profile.control_points, atol=1e-14
    )


def test_units_convert_all_lengths_or_none() -> None:
    start = edits.set_placement(VASE, translation=(10, 0, 20))
    start = edits.set_solid(start, wall=2, drain_hole=5, foot_ring=4)
    inches = edits.set_unit(start, "in", convert=True)
    assert inches.unit is Unit.IN
    assert inches.solid.wall == pytest.approx(2 / 25.4)
    assert inches.solid.drain_hole == pytest.approx(5 / 25.4)
    assert inches.solid.foot_ring == pytest.approx(4 / 25.4)
    assert inches.placement.translation == pytest.approx((10 / 25.4, 0, 20 / 25.4))
    assert measures.volume(inches.surface) == pytest.approx(
        measures.volume(start.surface) / 25.4**3, rel=1e-13
    )
    named = edits.set_unit(start, Unit.CM, convert=False)
    assert (named.unit, named.profile, named.solid) == (Unit.CM, start.profile, start.solid)
    assert edits.set_unit(start, "mm", convert=True) is start
    with pytest.raises(EditError, match="no unit 'm'; allowed is mm, cm, in"):
        edits.set_unit(start, "m", convert=True)


def test_the_turn_is_set_as_the_file_allows() -> None:
    turned = edits.set_revolution(VASE, axis="x", start_deg=-30, sweep_deg=90)
    assert (turned.revolution.axis, turned.revolution.sweep_deg) == ("x", 90.0)
    assert turned.surface.start == pytest.approx(np.deg2rad(-30.0))
    assert edits.set_revolution(VASE, sweep_deg=360.0) is VASE
    with pytest.raises(EditError, match=r"revolution.sweep_deg is 0.0; allowed is a number above"):
        edits.set_revolution(VASE, sweep_deg=0.0)
    with pytest.raises(EditError, match=r"revolution.axis is \"w\""):
        edits.set_revolution(VASE, axis="w")
    with pytest.raises(EditError, match=r"revolution\.start_deg is NaN"):
        edits.set_revolution(VASE, start_deg=float("nan"))
    with pytest.raises(TypeError, match="turns"):
        edits.set_revolution(VASE, turns=2)


def test_body_and_place_are_set_as_the_file_allows() -> None:
    vessel = edits.set_solid(VASE, kind="vessel", wall=2.0, rim="round")
    assert (vessel.solid.kind, vessel.solid.wall, vessel.solid.rim) == ("vessel", 2.0, "round")
    assert edits.set_solid(vessel, wall=2.0) is vessel
    with pytest.raises(EditError, match=r"solid.wall is 0; allowed is a positive number"):
        edits.set_solid(VASE, wall=0)
    placed = edits.set_placement(VASE, rotation_deg=[90, 0, 0])
    assert placed.placement.rotation_deg == (90.0, 0.0, 0.0)
    with pytest.raises(EditError, match=r"placement.translation\[2\] is"):
        edits.set_placement(VASE, translation=(0, 0, 1e10))
    with pytest.raises(EditError, match="allowed is a list of 3 numbers"):
        edits.set_placement(VASE, translation=3)


def test_laws_are_set_as_the_file_allows() -> None:
    law = Law("omega", "paper", 0.0, 1.0, (1,))
    varied = edits.set_variation(VASE, [law])
    assert varied.variation == (law,)
    assert edits.set_variation(varied, (law,)) is varied
    with pytest.raises(EditError, match=r"variation\[0\].segments\[0\] is 3"):
        edits.set_variation(VASE, [Law("omega", "paper", 0.0, 1.0, (3,))])
    with pytest.raises(ValueError, match=r"law.to is 2.0; allowed is a number from 0 to 1"):
        Law("omega", "paper", 0.0, 2.0)


def test_names() -> None:
    assert edits.rename(VASE, "Krug").name == "Krug"
    assert edits.rename(VASE, VASE.name) is VASE
    with pytest.raises(EditError, match="half a character"):
        edits.rename(VASE, "\ud800")


@pytest.mark.parametrize(
    "part",
    [
        {"reference": Reference("scan", points=((9e8, 0.0),))},
        {"guides": (Guide("h", 9e8),)},
        {"dimensions": (Dimension("diameter_at", height=9e8),)},
    ],
)
def test_what_would_be_too_large_in_another_unit_is_refused(part) -> None:
    tube = Document(Profile.of([line((10, 0), (10, 60))]), unit=Unit.CM, **part)
    with pytest.raises(EditError, match="1e9"):
        edits.set_unit(tube, "mm", convert=True)
    assert edits.set_unit(tube, "mm", convert=False).unit is Unit.MM
