"""Locks hold through every edit: random gestures, boundaries, files, renumbering, undo."""

from __future__ import annotations

import os
from dataclasses import replace

import numpy as np
import pytest
from numpy.random import Generator

import sgb_core as sgb
from sgb_core.curves.continuity import measure_joints
from sgb_core.design.solving.goals import Goal
from sgb_core.document.dimensions import dimension_value, missed_locks
from sgb_core.document.edits import EditError
from sgb_core.document.edits.fair import fair_profile
from sgb_core.document.edits.solve import solve_targets
from sgb_core.document.live_fair import LiveFair, beside
from sgb_core.document.session import Session
from tests.sgb_core.design.locks.samples import locked, pot, wavy

# A thousand by hand: LOCK_GESTURES=1000.
GESTURES = int(os.environ.get("LOCK_GESTURES", "8"))
LENGTHS = (
    "height",
    "max_diameter",
    "rim_diameter",
    "foot_diameter",
    "neck_diameter",
    "max_diameter_height",
)
VOLUMES = ("capacity", "volume", "material", "mass")


def gesture(session: Session, random: Generator) -> None:
    """Drag a random point, slider or quartic point some way, in a few ticks."""
    profile = session.document.profile
    segment = int(random.integers(len(profile)))
    what, index = int(random.integers(3)), int(random.integers(4))
    way = random.normal(size=2) * 0.08 * profile.size
    start = np.array(profile[segment].points[index])
    share, omega = float(random.random()), float(random.random())
    # Every other drag of a point has live fair on.
    fair = LiveFair(beside(profile, [(segment, index)])) if random.random() < 0.5 else None
    session.begin("drag")
    for part in (0.3, 0.7, 1.0):
        try:
            if what == 0:
                place = start + part * way
                session.apply(
                    lambda d, p=place: sgb.edits.move_point(d, segment, index, p), refining=fair
                )
            elif what == 1:
                session.apply(
                    lambda d, w=index % 3: sgb.edits.set_leg_fraction(d, segment, w, share)
                )
            else:
                session.apply(lambda d: sgb.edits.set_shape_parameter(d, segment, "omega", omega))
        except EditError:
            break
    session.commit()


def assert_holds(document: sgb.Document) -> None:
    for each in document.dimensions:
        value = dimension_value(document, each)
        assert None not in (each.value, value), each
        if each.kind in VOLUMES:
            # A tenth of a millilitre, or of what weighs so much.
            assert abs(value - each.value) <= 100.0, each
            assert value == pytest.approx(each.value, rel=1e-8)
        else:
            assert abs(value - each.value) <= 1e-6, each


@pytest.mark.parametrize("seed", range(2))
def test_random_gestures_leave_random_locks_as_they_are(seed: int) -> None:
    random = np.random.default_rng(seed)
    start = pot(int(random.integers(3, 6)))
    count = 0
    while count < GESTURES:
        kinds = list(random.choice(LENGTHS, int(random.integers(0, 4)), replace=False))
        kinds += list(random.choice(VOLUMES, 1))
        session = Session(locked(start, *map(str, kinds)))
        first = session.document
        smooth = [report.joint for report in first.joints if report.holds]
        for _ in range(8):
            gesture(session, random)
            count += 1
            assert_holds(session.document)
        kept = {report.joint for report in session.document.joints if report.holds}
        assert kept.issuperset(smooth)
        while session.undo():
            pass
        assert session.document is first


def test_a_dimension_takes_the_value_asked_for_and_says_what_moved() -> None:
    start = locked(pot(4), "capacity", "rim_diameter")
    told = sgb.edits.add_dimension(start, sgb.Dimension("height"))
    reached = sgb.edits.set_dimension(told, 2, 165.0)
    assert reached.document.height == pytest.approx(165.0, abs=1e-9)
    assert reached.moved
    assert reached.in_the_way is None
    assert not reached.document.dimensions[2].locked
    assert_holds(sgb.edits.remove_dimension(reached.document, 2))
    assert missed_locks(reached.document) == ()


def test_a_rim_takes_as_much_of_the_curve_along_however_many_segments_there_are() -> None:
    many = pot()
    for _ in range(4):
        for k in reversed(range(len(many.profile))):
            many = sgb.edits.split_segment(many, k, 0.5)[0]
    rim = sgb.Dimension("rim_diameter")
    told = sgb.edits.add_dimension(many, rim)
    now = dimension_value(many, rim)
    assert now is not None
    reached = sgb.edits.set_dimension(told, len(told.dimensions) - 1, now + 12.0).document
    assert dimension_value(reached, rim) == pytest.approx(now + 12.0)
    away = np.abs(reached.profile.sample(3) - many.profile.sample(3)).max(axis=(1, 2))
    lengths = np.hypot(*np.diff(many.profile.sample(9), axis=1).T).sum(axis=0)
    # The rim goes out by 6 mm: some 24 mm of the curve go along, bent less and less.
    assert lengths[away > 1e-6].sum() == pytest.approx(24.0, abs=2.0 * lengths.max())
    before, after = measure_joints(many.profile), measure_joints(reached.profile)
    assert [each.holds for each in after] == [each.holds for each in before]


@pytest.mark.parametrize("height", [156.0, 170.0])
def test_a_value_that_was_reached_stops_nobody_s_hand(height: float) -> None:
    start = locked(pot(4), "capacity", "rim_diameter")
    start = sgb.edits.add_dimension(start, sgb.Dimension("height"))
    session = Session(start)
    session.begin("height")
    session.apply(lambda d: sgb.edits.set_dimension(d, 2, height).document)
    assert session.document.height == pytest.approx(height, abs=1e-9)
    assert session.in_the_way is None
    session.commit()
    assert session.document.height == pytest.approx(height, abs=1e-9)
    assert session.in_the_way is None
    assert_holds(sgb.edits.remove_dimension(session.document, 2))


def test_a_hand_beyond_its_boundary_stays_where_it_got_and_comes_back() -> None:
    document = locked(sgb.Document(wavy(6)), "max_diameter", "rim_diameter", "height", "volume")
    session = Session(document)
    session.begin("drag")
    top = document.profile[5].points[3].copy()
    for part in (0.02, 0.3, 0.6, 1.0, 0.6, 0.3, 0.0):
        session.apply(
            lambda d, p=part: sgb.edits.move_point(d, 5, 3, (top[0] - 60.0 * p, top[1] - 90.0 * p))
        )
        assert_holds(session.document)
    assert session.document.profile[5].points[3] == pytest.approx(top, abs=1e-6)
    session.cancel()
    # Another gesture from the same start knows nothing of where that one was.
    session.begin("slide")
    session.apply(lambda d: sgb.edits.set_shape_parameter(d, 0, "omega", 0.5))
    assert session.document.profile[5].points[3] == pytest.approx(top, abs=1e-6)
    assert_holds(session.document)


def test_a_locked_value_can_be_typed_anew() -> None:
    start = locked(pot(4), "neck_diameter")
    reached = sgb.edits.set_dimension(start, 0, 42.0)
    assert reached.document.dimensions[0].value == 42.0
    assert_holds(reached.document)


def test_wall_floor_and_fill_line_are_dimensions_too() -> None:
    start = locked(sgb.edits.set_fill(pot(4), 90.0), "wall", "base", "fill_line", "capacity")
    thicker = sgb.edits.set_dimension(start, 0, 4.0).document
    assert (thicker.solid.wall, thicker.solid.base) == (4.0, 4.0)
    assert_holds(thicker)
    session = Session(thicker)
    session.do("wall", lambda d: sgb.edits.set_solid(d, wall=9.0))
    assert session.document.solid.wall == 4.0
    assert session.in_the_way is not None
    assert session.in_the_way.numbers == (0,)


def test_the_hand_stops_at_the_boundary_and_is_told_which_lock() -> None:
    document = locked(sgb.Document(wavy(3)), "rim_diameter")
    document = sgb.edits.add_dimension(document, sgb.Dimension("height"))
    session = Session(document)
    session.begin("drag")
    last = document.profile[2].points[3]
    session.apply(lambda d: sgb.edits.move_point(d, 2, 3, (last[0] + 20.0, last[1] + 5.0)))
    point = session.document.profile[2].points[3]
    # It goes along with the height, which nothing holds, and not with the radius.
    assert point.tolist() == pytest.approx([last[0], last[1] + 5.0], abs=1e-9)
    assert session.in_the_way is not None
    assert session.in_the_way.stopped
    assert sgb.say(session.in_the_way).startswith("stopped by a lock: Rim diameter")
    session.commit()
    assert session.in_the_way is not None
    session.do("reshape", lambda d: sgb.edits.set_shape_parameter(d, 0, "omega", 0.4))
    assert session.in_the_way is None


def test_the_belly_cannot_pass_a_locked_greatest_diameter() -> None:
    # The rim is the widest; a belly that is pulled out would become so.
    document = locked(sgb.Document(wavy(6)), "max_diameter", "rim_diameter")
    session = Session(document)
    session.begin("drag")
    belly = document.profile[1].points[0]
    for part in (0.25, 0.5, 0.75, 1.0):
        session.apply(
            lambda d, p=part: sgb.edits.move_point(d, 1, 0, (belly[0] + 60.0 * p, belly[1]))
        )
        assert_holds(session.document)
    assert session.in_the_way is not None
    assert session.document.profile[1].points[0][0] > belly[0] + 0.5


def test_a_locked_whole_is_not_scaled() -> None:
    session = Session(locked(pot(4), "height"))
    with pytest.raises(EditError, match="Height 150 mm is locked and cannot hold with this"):
        session.do("scale", lambda d: sgb.edits.scale(d, 2.0))
    assert len(session.history) == 1


def test_locked_points_and_joints_stay() -> None:
    document = sgb.edits.add_dimension(pot(4), sgb.Dimension("point", points=((1, 3),)))
    rule = document.profile.rules[1]
    document = sgb.edits.add_dimension(document, sgb.Dimension("joint", joint=1, rule=rule))
    for number in (0, 1):
        document = sgb.edits.set_lock(document, number, True)
    session = Session(document)
    place = document.profile[1].points[3]
    session.do("drag", lambda d: sgb.edits.move_point(d, 1, 3, place + 9.0))
    assert np.array_equal(session.document.profile[1].points[3], place)
    assert session.in_the_way is not None
    assert session.in_the_way.numbers == (0,)
    free = session.document.profile[2].points[1] + (6.0, -4.0)
    session.do("break", lambda d: sgb.edits.move_point(d, 2, 1, free, keep_rules=False))
    assert session.document.profile.rules[1] is rule
    assert session.document.joints[1].holds
    assert np.array_equal(session.document.profile[1].points[3], place)


def test_a_slider_in_the_hand_stays_where_it_is_put() -> None:
    session = Session(locked(pot(4), "volume"))
    session.do("slide", lambda d: sgb.edits.set_shape_parameter(d, 1, "omega", 0.5))
    session.do("slide", lambda d: sgb.edits.set_shape_parameter(d, 1, "lambda1", 2.5))
    shape = session.document.profile[1].shape
    assert (shape.lambda1, shape.omega) == (2.5, 0.5)
    assert_holds(session.document)


def test_locks_hold_under_laws() -> None:
    law = sgb.Law("omega", "cosine", 0.0, 0.6, (1,), count=3)
    document = locked(sgb.edits.add_law(pot(4), law), "volume", "rim_diameter")
    session = Session(document)
    place = document.profile[2].points[0] + (5.0, 3.0)
    session.do("drag", lambda d: sgb.edits.move_point(d, 2, 0, place))
    assert np.allclose(session.document.profile[2].points[0], place)
    assert_holds(session.document)
    assert session.document.variation == document.variation


def test_dimensions_are_saved_and_loaded() -> None:
    document = locked(pot(4), "capacity", "height")
    document = sgb.edits.add_dimension(document, sgb.Dimension("radius", segment=1, s=0.25))
    document = sgb.edits.add_dimension(document, sgb.Dimension("joint", joint=0, rule="G1"))
    assert sgb.loads(sgb.dumps(document)) == document


def test_a_file_whose_dimension_is_out_of_reach_is_refused() -> None:
    data = sgb.dumps(sgb.edits.add_dimension(pot(2), sgb.Dimension("point", points=((1, 0),))))
    with pytest.raises(sgb.FileError, match=r"dimensions\[0\]\.points\[0\]\[0\] is 7"):
        sgb.loads(data.replace(b"[1, 0]", b"[7, 0]") if isinstance(data, bytes) else data)


def test_dimensions_follow_their_segments() -> None:
    document = sgb.edits.add_dimension(pot(4), sgb.Dimension("point", points=((2, 1),)))
    document = sgb.edits.add_dimension(document, sgb.Dimension("joint", joint=2, rule="G1"))
    longer = sgb.edits.insert_segment(document, 0)
    assert longer.dimensions[0].points == ((3, 1),)
    assert longer.dimensions[1].joint == 3
    turned = sgb.edits.reverse_profile(document)
    assert turned.dimensions[0].points == ((1, 2),)
    assert turned.dimensions[1].joint == 0
    halves = sgb.edits.split_segment(document, 1, 0.5)[0]
    assert halves.dimensions[0].points == ((3, 1),)
    shorter = sgb.edits.remove_segment(document, 2)
    assert [each.kind for each in shorter.dimensions] == []


def test_a_change_of_unit_keeps_the_locks() -> None:
    document = locked(pot(4), "capacity", "rim_diameter", "mass")
    inches = sgb.edits.set_unit(document, "in", convert=True)
    assert missed_locks(inches) == ()
    assert inches.dimensions[2].value == document.dimensions[2].value


def test_what_is_not_there_cannot_be_dimensioned() -> None:
    cone = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (40, 60))]))
    for kind in ("capacity", "neck_diameter", "wall"):
        with pytest.raises(EditError, match="has no such dimension"):
            sgb.edits.add_dimension(cone, sgb.Dimension(kind))
    bent = sgb.edits.add_dimension(
        sgb.edits.set_rule(pot(3), 0, "free"), sgb.Dimension("joint", joint=1, rule="G1")
    )
    assert sgb.edits.set_lock(bent, 0, True).dimensions[0].locked


def test_a_lock_that_does_not_hold_is_a_warning() -> None:
    document = locked(pot(3), "height")
    moved = sgb.edits.set_height(document, 100.0)
    assert [each.number for each in missed_locks(moved)] == [0]
    assert "Height 150 mm is locked but is 100" in sgb.say(missed_locks(moved)[0])


def test_a_profile_is_made_fair_within_its_locks() -> None:
    document = locked(pot(3), "volume", "max_diameter")
    reshaped = sgb.edits.set_shape_parameter(document, 0, "omega", 1.0)
    session = Session(document)
    session.do("reshape", lambda d: sgb.edits.set_shape_parameter(reshaped, 0, "lambda1", 3.0))
    before = session.document
    fairer, found = fair_profile(before)
    assert found.after is not None
    assert found.before is not None
    assert found.after < found.before
    assert np.array_equal(fairer.profile.control_points, before.profile.control_points)
    assert missed_locks(fairer) == ()
    session.do("fair", lambda _: fairer)
    assert session.document.profile == fairer.profile


def test_a_flat_bottom_stays_flat_whatever_is_wished_for() -> None:
    bottom = sgb.line((0.0, 0.0), (40.0, 0.0))
    document = replace(pot(4), profile=sgb.Profile.of([bottom, *wavy(4)], ["G0"] + ["G1"] * 3))
    document = locked(document, "capacity", "rim_diameter")
    document = sgb.edits.add_dimension(document, sgb.Dimension("height"))
    typed = sgb.edits.set_dimension(document, 2, 160.0).document
    wished = solve_targets(document, {Goal.VOLUME: 1.1 * document.volume, Goal.HEIGHT: 155.0})[0]
    for each, height in ((typed, 160.0), (wished, 155.0)):
        assert each.height == pytest.approx(height, rel=1e-9)
        assert (each.profile[0].points[:, 1] == 0.0).all()
        assert missed_locks(each) == ()
