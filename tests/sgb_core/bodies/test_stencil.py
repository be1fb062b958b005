"""What is cut out of a wall leaves it in one piece, with bridges as wide as asked for."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from sgb_core.bodies.stencil import Shapes, stencil_of
from sgb_core.lettering.fonts import FontName
from sgb_core.lettering.outlines import text_letters

HEIGHT, BRIDGE = 15.0, 1.5


def check_held(stencil, bridge: float) -> None:
    """Assert that the wall around is one piece, wherever it is cut at half a bridge's width."""
    assert all(piece.is_valid and not piece.interiors for piece in stencil.pieces)
    reach = max(stencil.width, stencil.height)
    wall = shapely.box(-reach, -reach, reach, reach).difference(stencil.shapes)
    left = shapely.get_parts(wall.buffer(-0.48 * bridge))
    crumbs = sum(sorted(part.area for part in left)[:-1])
    assert crumbs < bridge**2
    for number, piece in enumerate(stencil.pieces):
        for other in stencil.pieces[:number]:
            assert piece.distance(other) > 0.98 * bridge


@pytest.mark.parametrize("font", FontName)
def test_the_islands_of_letters_are_held(font: FontName) -> None:
    letters = Shapes(text_letters("OAB@&8ij%ÄŒégQ4#", font))
    stencil = stencil_of(letters, HEIGHT, BRIDGE, True)
    assert stencil is not None
    check_held(stencil, BRIDGE)
    # Bridges take a part of the letters and no letter whole.
    whole = HEIGHT**2 * sum(letter.area for letter in letters.parts)
    assert 0.6 * whole < stencil.shapes.area < whole


def test_letters_without_islands_stay_as_they_are() -> None:
    letters = Shapes(text_letters("LIVE", FontName.SANS))
    stencil = stencil_of(letters, HEIGHT, 0.5, True)
    assert stencil is not None
    assert len(stencil.pieces) == 4
    assert stencil.shapes.area == pytest.approx(
        HEIGHT**2 * sum(letter.area for letter in letters.parts), rel=1e-3
    )
    assert stencil.height == pytest.approx(HEIGHT)


def test_letters_stand_as_far_apart_as_bridges_ask() -> None:
    letters = Shapes(text_letters("HHHH", FontName.SANS_BOLD))
    stencil = stencil_of(letters, HEIGHT, 6.0, True)
    assert stencil is not None
    starts = sorted(piece.bounds[0] for piece in stencil.pieces)
    ends = sorted(piece.bounds[2] for piece in stencil.pieces)
    assert np.allclose(np.subtract(starts[1:], ends[:-1]), 6.0, atol=0.01)


def test_without_a_bridge_an_island_is_refused_and_nothing_else() -> None:
    assert stencil_of(Shapes(text_letters("O", FontName.SANS)), HEIGHT, 0.0, True) is None
    assert stencil_of(Shapes(text_letters("L", FontName.SANS)), HEIGHT, 0.0, True) is not None
    nothing = stencil_of(Shapes(()), HEIGHT, 1.0, True)
    assert nothing is not None
    assert nothing.pieces == ()


def test_what_hangs_on_a_neck_is_held_too() -> None:
    # A ring that is nearly closed: its middle hangs on 0.4 where 2 is asked for.
    ring = shapely.Point(0, 0).buffer(20.0).difference(shapely.Point(0, 0).buffer(14.0))
    open_ring = ring.difference(shapely.box(0.0, -0.2, 30.0, 0.2))
    check_held(stencil_of(Shapes((open_ring,)), 1.0, 2.0, False), 2.0)


def test_random_blots_are_held_or_refused() -> None:
    generator = np.random.default_rng(3)
    held = 0
    for _ in range(25):
        spots = [
            shapely.Point(*generator.uniform(-30, 30, 2)).buffer(generator.uniform(2, 14)).boundary
            for _ in range(9)
        ]
        blots = shapely.union_all(spots).buffer(generator.uniform(0.5, 2.5))
        stencil = stencil_of(Shapes((blots,)), 1.0, 1.5, False)
        if stencil is not None:
            held += 1
            check_held(stencil, 1.5)
    assert held > 15
