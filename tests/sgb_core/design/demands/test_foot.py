"""Where chains stand, and how the foot's diameter goes with their points."""

import numpy as np
import pytest

import sgb_core as sgb
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.foot import foot_of
from sgb_core.design.demands.measures import end_diameter
from sgb_core.design.locks.gauge import Gauge
from sgb_core.design.locks.readings import read
from sgb_core.document.dimensions import dimension_value, setting_of

WALL = sgb.line((30, 5), (45, 80))
RISEN = [sgb.line((0, 3), (30, 5)), WALL]
LEVEL = [sgb.line((0, 0), (12, 0)), sgb.line((12, 0), (25, 0)), sgb.line((25, 0), (45, 80))]
RING = [sgb.line((0, 6), (20, 6)), sgb.line((20, 6), (22, 0)), sgb.line((22, 0), (45, 80))]
# Pushed in from below, round where it stands.
PUSHED = [sgb.Segment([(0, 8), (14, 8), (20, -14), (34, 6)]), sgb.line((34, 6), (45, 80))]
SHARP = [sgb.line((0, 0), (8, 20)), sgb.line((8, 20), (45, 80))]
BALL = [sgb.Segment([(0, 0), (40, 0), (40, 30), (20, 60)])]
TUBE = [sgb.line((20, 0), (20, 60))]

DIAMETERS = [(RISEN, 60.0), (LEVEL, 50.0), (RING, 44.0), (SHARP, 0.0), (BALL, 0.0), (TUBE, 40.0)]


def of(segments, turned=False):
    document = sgb.Document(sgb.Profile.of(segments))
    return sgb.edits.reverse_profile(document) if turned else document


@pytest.mark.parametrize("turned", [False, True], ids=["upwards", "downwards"])
@pytest.mark.parametrize(("segments", "diameter"), DIAMETERS)
def test_a_closed_bottom_stands_where_it_ends(segments, diameter, turned):
    document = of(segments, turned)
    assert dimension_value(document, sgb.Dimension("foot_diameter")) == pytest.approx(diameter)


@pytest.mark.parametrize("turned", [False, True], ids=["upwards", "downwards"])
def test_a_hollow_bottom_stands_on_its_lowest_ring(turned):
    document = of(PUSHED, turned)
    points = np.concatenate([each.point(np.linspace(0, 1, 4001)) for each in document.profile])
    lowest = points[points[:, 1].argmin()]
    found = dimension_value(document, sgb.Dimension("foot_diameter"))
    assert found == pytest.approx(2.0 * lowest[0], rel=1e-3)
    assert foot_of(Chain.of(document.profile).quartics).after is None


@pytest.mark.parametrize("turned", [False, True], ids=["upwards", "downwards"])
@pytest.mark.parametrize("segments", [RISEN, RING, PUSHED, TUBE])
def test_its_slope_is_that_of_differences(segments, turned):
    document = of(segments, turned)
    chain, setting = Chain.of(document.profile), setting_of(document)
    way = np.random.default_rng(3).normal(size=chain.blocks.shape)
    # A bottom goes on being closed.
    end, point = (-1, 3) if turned else (0, 0)
    way[end, 3 + 2 * point] = 0.0

    def at(step):
        moved = chain.with_blocks(chain.blocks + step * way)
        found = read(Gauge(moved), sgb.Dimension("foot_diameter"), setting)
        assert found is not None
        assert found.value / chain.size == pytest.approx(end_diameter(moved.quartics, False).value)
        return found.value

    found = read(Gauge(chain), sgb.Dimension("foot_diameter"), setting)
    assert found is not None
    expected = (at(1e-6) - at(-1e-6)) / 2e-6
    assert float(found.slope @ way.ravel()) == pytest.approx(expected, rel=1e-5)
    # The same by the quartic points alone.
    quartics = chain.quartics
    drift = np.random.default_rng(4).normal(size=quartics.shape)
    drift[end, -1 if turned else 0, 0] = 0.0
    wide, narrow = (end_diameter(quartics + h * drift, False).value for h in (1e-6, -1e-6))
    slope = end_diameter(quartics, False).slope.ravel() @ drift.ravel()
    assert slope == pytest.approx((wide - narrow) / 2e-6, rel=1e-5)


@pytest.mark.parametrize("turned", [False, True], ids=["upwards", "downwards"])
@pytest.mark.parametrize("segments", [RISEN, LEVEL, RING, PUSHED])
def test_the_foot_takes_a_value_and_the_ends_stay(segments, turned):
    document = sgb.edits.add_dimension(of(segments, turned), sgb.Dimension("foot_diameter"))
    reached = sgb.edits.set_dimension(document, 0, 70.0)
    assert reached.in_the_way is None
    changed = reached.document
    assert dimension_value(changed, sgb.Dimension("foot_diameter")) == pytest.approx(70.0)
    if segments is not PUSHED:
        ends = [each.profile.control_points[[0, -1], [0, 3]] for each in (document, changed)]
        assert ends[1] == pytest.approx(ends[0], abs=1e-6)


def test_a_round_bottom_has_no_foot_to_set():
    document = sgb.edits.add_dimension(of(BALL), sgb.Dimension("foot_diameter"))
    with pytest.raises(sgb.EditError, match="without a rim or a foot"):
        sgb.edits.set_dimension(document, 0, 30.0)
