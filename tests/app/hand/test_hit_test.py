import numpy as np
import pytest

from app.hand.coordinates import Area, ScreenPoint, Transform
from app.hand.hit_test import (
    ASIDE,
    Handle,
    Target,
    canonical,
    distinct_points,
    pick,
    points_in,
    twin,
)
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters

TRANSFORM = Transform(10.0, 100.0, 400.0)


def chain(closed=False):
    first = Segment(np.array([(10.0, 0), (20, 0), (20, 20), (10, 20)]))
    second = Segment(np.array([(10.0, 20), (5, 20), (5, 0), (10, 0)]))
    return Profile.of([first, second], closed=closed)


def press(profile, pair, selected=0, **options):
    x, y = TRANSFORM.map(np.array(pair)).tolist()
    options = {"quartics": True, **options}
    return pick(profile, TRANSFORM, ScreenPoint(x + 1.0, y - 1.0), selected=selected, **options)


def test_points_come_before_quartic_points_and_these_before_curves():
    profile = chain()
    assert press(profile, (20, 0)) == Handle(Target.POINT, 0, 1)
    assert press(profile, (17.5, 0)) == Handle(Target.QUARTIC, 0, 0)
    assert press(profile, (17.5, 0), quartics=False) is None
    handle = press(profile, profile.point(1, 0.3))
    assert (handle.target, handle.segment) == (Target.CURVE, 1)
    assert handle.s == pytest.approx(0.3, abs=0.02)
    assert press(profile, (40, 40)) is None


@pytest.mark.parametrize(("selected", "expected"), [(0, (0, 3)), (1, (1, 0))])
def test_a_joint_is_grabbed_by_the_selected_segment(selected, expected):
    handle = press(chain(), (10, 20), selected=selected)
    assert (handle.segment, handle.index) == expected


def test_a_quartic_point_on_an_end_is_grabbed_beside_it():
    shape = ShapeParameters(4.0, 3.0, 1.0, 1.0)
    profile = Profile.of([Segment(chain().segments[0].points, shape)])
    assert press(profile, (10, 0)) == Handle(Target.POINT, 0, 0)
    aside = ScreenPoint(100.0 + 10 * 10.0 + ASIDE, 400.0)
    handle = pick(profile, TRANSFORM, aside, selected=0, quartics=True)
    assert handle == Handle(Target.QUARTIC, 0, 0)


def test_a_joint_counts_once_open_and_closed():
    assert len(distinct_points(chain())) == 7
    assert len(distinct_points(chain(closed=True))) == 6
    assert twin(chain(), (0, 3)) == (1, 0)
    assert twin(chain(), (1, 3)) is None
    assert twin(chain(closed=True), (1, 3)) == (0, 0)
    assert twin(chain(closed=True), (0, 0)) == (1, 3)
    assert canonical(chain(), {(1, 0), (0, 3), (1, 2)}) == [(0, 3), (1, 2)]


def test_ends_that_have_parted_are_two_points():
    first, second = chain().segments
    moved = second.with_points(second.points + [(1.0, 0.0)] * 4)
    profile = Profile.of([first, moved], ["free"])
    assert len(distinct_points(profile)) == 8
    assert twin(profile, (0, 3)) is None


def test_a_box_takes_what_lies_inside():
    lower, upper = TRANSFORM.map(np.array([(4.0, 21.0), (11.0, -1.0)])).tolist()
    found = points_in(chain(), TRANSFORM, Area(lower[0], lower[1], upper[0], upper[1]))
    assert found == {(0, 0), (0, 3), (1, 1), (1, 2), (1, 3)}
