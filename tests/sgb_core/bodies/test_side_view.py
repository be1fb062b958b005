"""What shows of a body from the side: against known views, and against its section."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.side_view import SideView, circles_of, side_view
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.document.model import Document
from tests.sgb_core.drawings.shapes import OTHERS, chain


def seen(document: Document) -> SideView:
    outlines = cross_section(document.surface, document.solid).outlines
    rings = [ring for outline in outlines for ring in outline.rings]
    return side_view(rings, document.profile.size)


def filled(*points: tuple[float, float]) -> Document:
    document = chain(*points)
    return Document(document.profile, solid=Solid(BodyKind.FILLED))


def ends(view: SideView) -> list[list[tuple[float, float]]]:
    return [
        sorted((round(r, 6), round(h, 6)) for r, h in part.ends.tolist()) for part in view.stretches
    ]


def test_steps_show_as_level_lines_and_walls_as_upright_ones() -> None:
    view = seen(filled((0, 0), (30, 0), (30, 10), (12, 10), (12, 40), (20, 40), (20, 50), (0, 50)))
    assert sorted(ends(view)) == [
        [(12.0, 10.0), (12.0, 40.0)],
        [(20.0, 40.0), (20.0, 50.0)],
        [(30.0, 0.0), (30.0, 10.0)],
    ]
    # Each corner's circle; where two lie at one height the wider hides the other.
    assert [(round(r, 6), round(h, 6)) for r, h in view.edges] == [
        (30.0, 0.0),
        (30.0, 10.0),
        (20.0, 40.0),
        (20.0, 50.0),
    ]


def test_what_lies_behind_a_lip_is_hidden() -> None:
    # A lip that hangs down outside: the neck above its edge does not show.
    view = seen(filled((0, 0), (20, 0), (20, 50), (30, 35), (30, 55), (0, 55)))
    shown = ends(view)
    assert [(20.0, 0.0), (20.0, 35.0)] in shown
    assert [(30.0, 35.0), (30.0, 55.0)] in shown
    assert len(shown) == 2
    assert (30.0, 35.0) in [(round(r, 6), round(h, 6)) for r, h in view.edges]


@pytest.mark.parametrize("name", ["cup", "bent", "bent, wall outside", "foot ring", "closed"])
def test_the_view_is_as_wide_as_the_section_at_each_height(name: str) -> None:
    document = OTHERS[name]
    size = document.profile.size
    positions = document.body().mesh(tolerance=1e-4 * size).positions
    radii, heights = np.hypot(positions[:, 0], positions[:, 1]), positions[:, 2]
    view = seen(document)
    drawn = shapely.union_all(
        [
            shapely.LineString(part.points(np.linspace(part.start, part.end, 200)))
            for part in view.stretches
        ]
        + [shapely.LineString([(0.0, h), (r, h)]) for r, h in view.edges]
    )
    for level in np.linspace(heights.min(), heights.max(), 40)[1:-1].tolist():
        met = shapely.intersection(
            drawn, shapely.LineString([(0.0, level), (2.0 * radii.max(), level)])
        )
        widest = float(shapely.get_coordinates(met)[:, 0].max())
        exact = shapely.intersection(
            shapely.LineString([(0.0, level), (2.0 * radii.max(), level)]),
            shapely.union_all(
                [
                    shapely.Polygon(each.exterior, each.holes)
                    for each in document.body().section(tolerance=1e-5 * size)
                ]
            ),
        )
        assert widest == pytest.approx(exact.bounds[2], abs=1e-3 * size)


def test_the_top_and_the_bottom_of_a_ring_are_circles_that_show() -> None:
    ring = chain((20, 0), (30, 10), (20, 20), (10, 10), (20, 0))
    solid = Document(ring.profile, solid=Solid(BodyKind.FILLED))
    view = seen(solid)
    assert [(round(r, 6), round(h, 6)) for r, h in view.edges] == [
        (20.0, 0.0),
        (30.0, 10.0),
        (20.0, 20.0),
    ]


def test_circles_are_all_corners_off_the_axis() -> None:
    document = filled((0, 0), (30, 0), (25, 40), (0, 40))
    outlines = cross_section(document.surface, document.solid).outlines
    found = {(round(r, 6), round(h, 6)) for r, h in circles_of([outlines[0].exterior], 50.0)}
    assert found == {(30.0, 0.0), (25.0, 40.0)}
