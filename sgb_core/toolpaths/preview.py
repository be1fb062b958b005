"""A small picture of what a path builds, for the head of its file."""

from __future__ import annotations

from io import BytesIO

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.toolpaths.printer import Firmware
from sgb_core.toolpaths.strand import Part
from sgb_core.toolpaths.toolpath import Toolpath

# The side in pixels that interfaces of Klipper and RepRapFirmware show large; drawn finer.
_SIDE, _FINER = 300, 2
_MARGIN = 0.06
# From where it is seen, radians above the bed and around the axis; where the light is from.
_ELEVATION, _AZIMUTH = 0.42, -0.6
_LIGHT = np.array([-0.55, 0.45])
_DARKEST, _COLOUR = 0.35, np.array([214.0, 152.0, 104.0])
_MOST_POINTS = 2_000_000


def preview(path: Toolpath) -> bytes | None:
    """Return a PNG of the printed body, 300 by 300 on a clear ground.

    None where the printer's firmware reads no picture.
    """
    if path.plan.printer.firmware is Firmware.MARLIN:
        return None
    from PIL import Image

    side = _SIDE * _FINER
    spots, depth, shade = _spots(path, side)
    pixels = np.zeros((side, side, 4), np.uint8)
    # What is nearer is written later, over what it hides.
    order = np.argsort(-depth, kind="stable")
    column, row = np.clip(spots[order].astype(np.intp), 0, side - 1).T
    pixels[row, column, :3] = np.rint(shade[order, None] * _COLOUR)
    pixels[row, column, 3] = 255
    stream = BytesIO()
    small = Image.fromarray(pixels).resize((_SIDE, _SIDE), Image.Resampling.BOX)
    small.save(stream, "PNG", optimize=True)
    return stream.getvalue()


def _spots(path: Toolpath, side: int) -> tuple[Floats, Floats, Floats]:
    """Return places in pixels (k, 2), how far away (k,), and brightness from 0 to 1 (k,)."""
    body = path.points[(path.parts == Part.WALL) | (path.parts == Part.FLOOR)]
    cosine, sine = np.cos(_AZIMUTH), np.sin(_AZIMUTH)
    right = body[:, 0] * cosine - body[:, 1] * sine
    away = body[:, 0] * sine + body[:, 1] * cosine
    up = body[:, 2] * np.cos(_ELEVATION) + away * np.sin(_ELEVATION)
    depth = away * np.cos(_ELEVATION) - body[:, 2] * np.sin(_ELEVATION)
    flat = np.column_stack([right, -up])
    low, size = flat.min(axis=0), np.ptp(flat, axis=0)
    scale = (1.0 - 2.0 * _MARGIN) * side / max(float(size.max()), 1e-9)
    flat = (flat - low - size / 2.0) * scale + side / 2.0
    ahead = np.gradient(np.column_stack([right, away]), axis=0)
    speed = np.hypot(ahead[:, 0], ahead[:, 1])
    # Square to the way, on the side that faces the eye, as a wall does.
    normal = np.column_stack([ahead[:, 1], -ahead[:, 0]])
    normal /= np.where(speed > 0.0, speed, 1.0)[:, None]
    normal *= np.where(normal[:, 1] > 0.0, -1.0, 1.0)[:, None]
    lit = np.clip(normal @ (_LIGHT * (1.0, -1.0)) / np.hypot(*_LIGHT), 0.0, 1.0)
    return _filled(flat, depth, _DARKEST + (1.0 - _DARKEST) * lit, path.plan.layer * scale)


def _filled(
    flat: Floats, depth: Floats, shade: Floats, thick: float
) -> tuple[Floats, Floats, Floats]:
    """Return so many places along the way, and as high as a layer, that no gap is seen."""
    steps = np.abs(np.diff(flat, axis=0)).max(axis=1)
    # Where the wall leans its turns lie further apart than a layer.
    high = int(np.ceil(1.8 * thick)) + 2
    way = np.concatenate([[0.0], np.cumsum(steps)])
    count = int(min(max(way[-1] / 0.7, 2.0), _MOST_POINTS / high))
    at = np.linspace(0.0, way[-1], count)
    x, y, far, bright = (np.interp(at, way, row) for row in (*flat.T, depth, shade))
    below = np.arange(high)[:, None]
    places = np.stack(np.broadcast_arrays(x, y + below), axis=-1).reshape(-1, 2)
    return places, np.tile(far, high), np.tile(bright, high)
