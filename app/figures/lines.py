"""The curves of a surface panel in space: generatrix, polygon, circles, axis, as polylines."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import pi

import numpy as np

from app.figures.plate import BLUE, GREY, ORANGE, PURPLE, VERMILION, Array, Mark, SurfacePanel
from app.scene import shapes
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

PER_SEGMENT = 160
PER_CIRCLE = 360


@dataclass(frozen=True, slots=True, eq=False)
class SpaceLine:
    """A polyline (N, 3) with its look; with a mark, single marks at its points instead.

    ``layer`` orders what is drawn above what.
    """

    kind: str
    points: Array
    colour: str
    width: float
    mark: Mark = ""
    dashes: tuple[float, ...] = ()
    layer: int = 0


def space_lines(panel: SurfacePanel) -> list[SpaceLine]:
    """Return all lines and marks of a panel, those below first."""
    surface = panel.document.surface
    lines = [*_outlines(panel, surface)]
    if "axes" in panel.show:
        lines.append(_axis(surface))
    if "circles" in panel.show:
        lines += _circles(surface)
    if "polygon" in panel.show:
        lines += _polygon(surface)
    if "generatrix" in panel.show:
        lines += _generatrix(surface)
    return lines


def surface_cloud(surface: RevolutionSurface) -> Array:
    """Return points all over the surface, to fit a camera to, shape (P, 3)."""
    s, angles = np.linspace(0.0, 1.0, 24), surface.angles(48)
    clouds = [
        surface.point(k, s[:, None], angles[None, :]).reshape(-1, 3)
        for k in range(len(surface.profile))
    ]
    return np.concatenate(clouds)


def _generatrix(surface: RevolutionSurface) -> Iterator[SpaceLine]:
    # Where the section changes with the angle, the one at θ = 0, as the profile editor shows it.
    for section in surface.section.on(np.linspace(0.0, 1.0, PER_SEGMENT)):
        points = shapes.in_profile_plane(surface, section)
        yield SpaceLine("generatrix", points, ORANGE, 1.6, layer=4)


def _polygon(surface: RevolutionSurface) -> Iterator[SpaceLine]:
    for points in surface.profile.control_points:
        corners = shapes.in_profile_plane(surface, points)
        steps = np.linspace(0.0, 1.0, 60, endpoint=False)[:, None]
        legs = [a + steps * (b - a) for a, b in pairwise(corners)]
        yield SpaceLine("polygon", np.concatenate([*legs, corners[3:]]), BLUE, 0.9, layer=3)
        yield SpaceLine("polygon", corners[[0, 3]], BLUE, 0.9, ".", layer=5)
        yield SpaceLine("polygon", corners[1:2], VERMILION, 0.9, "*", layer=5)
        yield SpaceLine("polygon", corners[2:3], PURPLE, 0.9, "o", layer=5)


def _circles(surface: RevolutionSurface) -> Iterator[SpaceLine]:
    marks = shapes.circle_marks(surface)
    angles = surface.angles(max(24, round(PER_CIRCLE * surface.sweep / (2 * pi))))
    inner = surface.profile.control_points[:, 1:3]
    looks: tuple[tuple[Mark, str], ...] = (("*", VERMILION), ("o", PURPLE))
    for which, (mark, colour) in enumerate(looks):
        for segment, points in enumerate(inner[:, which]):
            if points[0] == 0.0:
                continue
            line = shapes.place(surface, points[:1], points[1:], angles)
            yield SpaceLine("circles", line, colour, 0.5, layer=1)
            yield SpaceLine("circles", marks[which, segment], colour, 0.6, mark, layer=2)


def _axis(surface: RevolutionSurface) -> SpaceLine:
    points = surface.profile.control_points.reshape(-1, 2)
    low, high = points[:, 1].min(), points[:, 1].max()
    reach = 0.1 * max(high - low, np.abs(points[:, 0]).max())
    heights = np.linspace(low - reach, high + reach, 200)
    line = shapes.place(surface, np.zeros(1), heights, np.zeros(1))
    return SpaceLine("axes", line, GREY, 0.6, dashes=(8.0, 2.0, 1.5, 2.0))


def _outlines(panel: SurfacePanel, surface: RevolutionSurface) -> Iterator[SpaceLine]:
    for curve in panel.outline:
        points = shapes.in_profile_plane(surface, curve)
        yield SpaceLine("outline", points, "#000000", 0.9, dashes=(3.0, 2.0), layer=6)
