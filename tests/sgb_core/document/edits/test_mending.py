"""One step mends: points beyond the axis, a wall that does not fit, a hole without a floor."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.vessel import vessel_measures
from sgb_core.curves.crossings import axis_crossings
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.edits import EditError
from sgb_core.document.model import Document
from sgb_core.findings.bodies import TightCurve

near = st.floats(-60.0, 60.0)


def made(document: Document) -> bool:
    try:
        vessel_measures(document.surface, document.solid)
    except SolidError:
        return False
    return True


@given(near, near, near, st.sampled_from(["G0", "G1", "C1", "G2"]))
def test_pushed_inside_the_profile_crosses_no_more(r1, r2, r3, rule) -> None:
    legs = [
        Segment([(30, 0), (r1, 20), (r2, 40), (40, 60)]),
        Segment([(40, 60), (r3, 80), (25, 100), (30, 120)]),
    ]
    document = edits.set_rule(Document(Profile.of(legs)), 0, rule)
    inside = edits.push_inside_axis(document)
    assert axis_crossings(inside.profile) == ()
    points = document.profile.control_points
    if points[..., 0].min() >= 0.0:
        assert inside is document
    # Each joint is at least what its rule says.
    assert all(
        each.holds or not before.holds
        for each, before in zip(inside.joints, document.joints, strict=True)
    )


def test_the_mirror_image_is_pushed_to_its_own_side() -> None:
    wall = Segment([(-20, 0), (30, 20), (-30, 40), (-20, 60)])
    inside = edits.push_inside_axis(Document(Profile.of([wall])))
    assert inside.profile.control_points[..., 0].max() <= 0.0
    assert np.array_equal(inside.profile[0].points[[0, 3]], wall.points[[0, 3]])


@pytest.mark.parametrize("radius", [3.0, 20.0, 150.0])
def test_the_largest_wall_fits_and_hardly_a_larger_one(radius) -> None:
    cup = Document(Profile.of([line((radius, 0), (radius, 4.0 * radius))]))
    thick = edits.set_solid(cup, kind="vessel", wall=5.0 * radius, base=1.0)
    assert not made(thick)
    fitted = edits.fit_wall(thick)
    assert made(fitted)
    # A cylinder has a hollow as long as its wall is thinner than its radius.
    assert 0.9 * radius <= fitted.solid.wall <= radius
    assert edits.fit_wall(fitted) is fitted
    assert float(f"{fitted.solid.wall:.2g}") == fitted.solid.wall


def test_a_wall_is_as_thick_all_along_as_it_says() -> None:
    bent = Segment([(20, 0), (60, 30), (60, 30), (20, 60)])
    jar = edits.set_solid(Document(Profile.of([bent])), kind="vessel", wall=12.0)
    doubts = vessel_measures(jar.surface, jar.solid).findings
    assert any(isinstance(each, TightCurve) for each in doubts)
    fitted = edits.fit_wall(jar)
    assert 0.0 < fitted.solid.wall < 12.0
    doubts = vessel_measures(fitted.surface, fitted.solid).findings
    assert not any(isinstance(each, TightCurve) for each in doubts)


def test_where_no_wall_fits_that_is_said() -> None:
    crossing = Segment([(20, 0), (-60, 20), (-60, 40), (20, 60)])
    jar = edits.set_solid(Document(Profile.of([crossing])), kind="vessel")
    with pytest.raises(EditError, match="no wall fits"):
        edits.fit_wall(jar)


def test_a_hole_wider_than_the_floor_goes() -> None:
    tube = Document(Profile.of([line((20, 0), (20, 60))]))
    drilled = edits.set_solid(tube, kind="vessel", drain_hole=60.0)
    assert not made(drilled)
    assert made(edits.no_drain_hole(drilled))
