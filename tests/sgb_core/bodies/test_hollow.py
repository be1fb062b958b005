import numpy as np
import pytest

from sgb_core.bodies.flux import flux
from sgb_core.bodies.hollow import cut_below
from sgb_core.bodies.outline import Line, Role, line
from sgb_core.bodies.region import Outline


def box(left, right, low, high, clockwise=False):
    """A rectangle's outline, material on its left unless clockwise."""
    corners = np.array([(left, low), (right, low), (right, high), (left, high)], float)
    corners = corners[::-1] if clockwise else corners
    return tuple(line(Role.WALL, corners[k], corners[(k + 1) % 4]) for k in range(4))


# A box from the axis with a hole in it, and a second box beside the first.
OUTLINES = (
    Outline(box(0, 4, 0, 5), (box(1, 2, 2, 4, clockwise=True),)),
    Outline(box(6, 7, 1, 3)),
)


def swept(outlines):
    return sum(flux(ring) for outline in outlines for ring in outline.rings)


@pytest.mark.parametrize(("height", "count"), [(0.5, 1), (2.5, 2), (3.5, 2), (9.0, 2)])
def test_what_lies_below_a_height_has_the_volume_of_its_boxes(height, count):
    def below(left, right, low, high):
        return (right**2 - left**2) * max(min(height, high) - low, 0.0)

    found = cut_below(OUTLINES, height, {}, 7.0)
    assert len(found) == count
    expected = below(0, 4, 0, 5) - below(1, 2, 2, 4) + below(6, 7, 1, 3)
    assert swept(found) == pytest.approx(expected, rel=1e-12)


def test_a_level_line_closes_it_where_it_is_cut_and_nowhere_else():
    (found,) = cut_below(OUTLINES, 0.5, {}, 7.0)
    levels = [piece for piece in found.exterior if piece.role is Role.LEVEL]
    assert len(levels) == 1
    assert isinstance(levels[0], Line)
    np.testing.assert_allclose(levels[0].ends, [(4.0, 0.5), (0.0, 0.5)], atol=1e-12)
    whole = cut_below(OUTLINES, 9.0, {}, 7.0)
    assert not any(p.role is Role.LEVEL for each in whole for ring in each.rings for p in ring)


def test_nothing_is_below_the_lowest_point_or_in_nothing():
    assert cut_below(OUTLINES, 0.0, {}, 7.0) == ()
    assert cut_below((), 1.0, {}, 7.0) == ()
