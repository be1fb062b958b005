"""Other programs' tracers, and our own held to plain cubics, for outlines side by side."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from unittest.mock import patch

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw
from scipy.interpolate import splev, splprep
from scipy.spatial import cKDTree

from sgb_core.arrays import Floats
from sgb_core.design.tracing import chain, curvature, search, solver, start

_GIVEN = [chain.SHARE, chain.START_PUSH, chain.END_PUSH]
# kurbo fits curves, not points: the spline near the points leaves this part of the tolerance.
_NOISE = 0.25
# Pixels around a silhouette, and how near to the outline a segment of it ends.
_MARGIN, _NEAR = 4, 3.0


def _cubic(frames: Floats) -> Floats:
    """Return frames of cubics, raised in degree: b = ½, p = u0 / 6, q = u4 / 6."""
    cubic = frames.copy()
    cubic[:, chain.SHARE] = 0.5
    cubic[:, chain.START_PUSH] = frames[:, chain.START_PULL] / 6.0
    cubic[:, chain.END_PUSH] = frames[:, chain.END_PULL] / 6.0
    return cubic


@contextmanager
def plain_cubics() -> Iterator[None]:
    """Hold the tracer to chains of plain cubics: without the three numbers that make the shape."""
    quartics, slopes, numbering = chain.quartics, chain.slopes, chain._numbering
    frames_of = chain.frames_of

    def cubic_quartics(frames: Floats, straight: frozenset[int] = frozenset()) -> Floats:
        return quartics(_cubic(frames), straight)

    def cubic_slopes(frames: Floats, straight: frozenset[int] = frozenset()) -> Floats:
        found = slopes(_cubic(frames), straight)
        found[:, :, chain.START_PULL] += found[:, :, chain.START_PUSH] / 6.0
        found[:, :, chain.END_PULL] += found[:, :, chain.END_PUSH] / 6.0
        found[:, :, _GIVEN] = 0.0
        return found

    def cubic_numbering(layout: chain.Layout) -> NDArray[np.intp]:
        found = numbering(layout).copy()
        found[:, _GIVEN] = -1
        free = np.unique(found[found >= 0])
        return np.where(found >= 0, np.searchsorted(free, found), -1)

    def cubic_frames(points: Floats) -> Floats:
        return _cubic(frames_of(points))

    with (
        patch.object(chain, "quartics", cubic_quartics),
        patch.object(chain, "_numbering", cubic_numbering),
        patch.object(solver, "slopes", cubic_slopes),
        patch.object(curvature, "slopes", cubic_slopes),
        patch.object(search, "frames_of", cubic_frames),
        patch.object(start, "frames_of", cubic_frames),
    ):
        yield


class _Smooth:
    """The cubic spline near points, asked as kurbo asks a curve."""

    def __init__(self, points: Floats, tolerance: float) -> None:
        squares = len(points) * (_NOISE * tolerance) ** 2
        self._spline, _ = splprep(points.T, s=squares, k=3)

    def sample_pt_deriv(self, t: float) -> tuple[object, object]:
        from kurbopy import Point, Vec2

        place, slope = (splev(t, self._spline, der=order) for order in (0, 1))
        return Point(*map(float, place)), Vec2(*map(float, slope))

    def sample_pt_tangent(self, t: float, _sign: float) -> tuple[object, object]:
        return self.sample_pt_deriv(t)

    def break_cusp(self, _start: float, _end: float) -> None:
        return None


def kurbo_joints(points: Floats, tolerance: float) -> Floats:
    """Return where the cubics of kurbo's ``fit_to_bezpath`` begin and end, one more than cubics."""
    from kurbopy import fit_to_bezpath

    segments = fit_to_bezpath(_Smooth(points, tolerance), tolerance).segments()
    ends = [segments[0].start(), *(segment.end() for segment in segments)]
    return np.array([(end.x, end.y) for end in ends])


def potrace_joints(points: Floats, tolerance: float) -> Floats:
    """Return where potrace's cubics and lines along one side of a filled silhouette end.

    There are as many as there are cubics and lines.
    """
    from potrace import Bitmap

    low = points[:, 1].min()
    places = (points - [0.0, low]) / tolerance + _MARGIN
    size = tuple((np.ceil(places.max(axis=0)).astype(int) + _MARGIN).tolist())
    axis = [(_MARGIN, places[-1, 1]), (_MARGIN, places[0, 1])]
    picture = Image.new("1", size)
    outline = [(float(x), float(y)) for x, y in [*places.tolist(), *axis]]
    ImageDraw.Draw(picture).polygon(outline, fill=1)
    near, joints = cKDTree(places), []
    for curve in Bitmap(np.asarray(picture)).trace(opttolerance=1.0):
        for segment in curve.segments:
            own = [segment.c] if segment.is_corner else []
            ends = np.array([(float(at.x), float(at.y)) for at in [*own, segment.end_point]])
            # Rows may count from either end.
            for rows in (ends, ends * [1.0, -1.0] + [0.0, size[1]]):
                if near.query(rows[-1])[0] < _NEAR:
                    joints += rows.tolist()
                    break
    return (np.array(joints) - _MARGIN) * tolerance + [0.0, low]
