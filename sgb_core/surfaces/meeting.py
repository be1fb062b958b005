"""Whether a surface that was moved outwards meets itself, told from its sections."""

from __future__ import annotations

import numpy as np
import shapely

from sgb_core.arrays import Floats
from sgb_core.surfaces.revolution import RevolutionSurface

# Columns looked at at a time, which bounds the memory.
_COLUMNS = 64


def meeting(
    before: Floats, after: Floats, surface: RevolutionSurface, depth: float
) -> float | None:
    """Return the height at which moved rows (R, C, 3) cross those of their column; None: nowhere.

    They were moved out by at most ``depth``. Where they crossed before nothing is told.
    """
    for first in range(0, before.shape[1], _COLUMNS):
        part = slice(first, first + _COLUMNS)
        same = np.abs(after[:, part] - before[:, part]).max(axis=(0, 2)) == 0.0
        if same.all():
            continue
        lines, smooth = (
            shapely.linestrings(_half_planes(rows[:, part][:, ~same], surface))
            for rows in (after, before)
        )
        narrow = ~_is_wide(smooth, depth)
        bad = np.flatnonzero(narrow)[~shapely.is_simple(lines[narrow])]
        bad = bad[shapely.is_simple(smooth[bad])]
        if len(bad):
            line = lines[bad[0]]
            pieces = shapely.get_coordinates(shapely.node(line))
            known = {tuple(point) for point in shapely.get_coordinates(line).tolist()}
            crossings = [point for point in pieces.tolist() if tuple(point) not in known]
            return float(crossings[0][1]) if crossings else float(pieces[0, 1])
    return None


def _is_wide(lines: np.ndarray, depth: float) -> np.ndarray:
    """Return which closed lines leave room outside for more than twice the depth everywhere."""
    nowhere = np.zeros(len(lines), dtype=bool)
    if not shapely.is_closed(lines).all():
        return nowhere
    body = shapely.polygons(shapely.get_coordinates(lines[0]))
    if not shapely.is_valid(body):
        return nowhere
    grown = shapely.buffer(body, 1.1 * depth).buffer(-1.1 * depth)
    wide = grown.area - body.area <= 1e-4 * body.area
    alike = [shapely.equals_exact(line, lines[0], 1e-6 * depth) for line in lines]
    return np.asarray(np.array(alike) & wide)


def _half_planes(rows: Floats, surface: RevolutionSurface) -> Floats:
    """Return the columns of rows (R, C, 3) as lines in their half-planes, (C, R, 2)."""
    up = surface.directions(np.array(0.0))[2]
    away = rows - np.asarray(surface.placement.translation)
    h = away @ up
    r = np.linalg.norm(away - h[..., None] * up, axis=-1)
    return np.stack([r, h], axis=-1).transpose(1, 0, 2)
