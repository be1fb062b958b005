"""Outlines as cubics: within the tolerance of the exact pieces, end to end."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
import shapely

from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.outline_cubics import outline_cubics
from sgb_core.findings.errors import FindingError
from tests.sgb_core.drawings.shapes import OTHERS

SOLID = ["cup", "bent", "bent, wall outside", "foot ring", "closed", "filled"]


def along(piece: np.ndarray, count: int = 400) -> np.ndarray:
    t = np.linspace(0.0, 1.0, count)[:, None]
    if len(piece) == 2:
        return piece[0] * (1 - t) + piece[1] * t
    a, b, c, d = piece
    return (1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t * t * c + t**3 * d


@pytest.mark.parametrize("name", SOLID)
@pytest.mark.parametrize("tolerance", [0.05, 1e-4])
def test_they_follow_the_exact_outline(name: str, tolerance: float) -> None:
    document = OTHERS[name]
    for outline in cross_section(document.surface, document.solid).outlines:
        for ring in outline.rings:
            pieces = outline_cubics(ring, tolerance)
            drawn = np.concatenate([along(piece) for piece in pieces])
            exact = np.concatenate(
                [piece.points(np.linspace(piece.start, piece.end, 3001)) for piece in ring]
            )
            # Chords of the samples add their own sag, far below the tolerance.
            for first, last in ((drawn, exact), (exact, drawn)):
                away = shapely.distance(shapely.LineString(last), shapely.points(first))
                assert away.max() <= tolerance + 1e-5
            for before, after in pairwise((*pieces, pieces[0])):
                assert np.allclose(before[-1], after[0], atol=1e-9)


def test_a_finer_tolerance_takes_more_pieces() -> None:
    document = OTHERS["bent"]
    ring = cross_section(document.surface, document.solid).outlines[0].exterior
    counts = [len(outline_cubics(ring, tolerance)) for tolerance in (1.0, 1e-3, 1e-6)]
    assert counts == sorted(set(counts))


def test_a_tolerance_of_nothing_is_refused() -> None:
    with pytest.raises(FindingError, match="tolerance"):
        outline_cubics((), 0.0)
