"""Textures on the surface: the document's paint and its maps, with coordinates kept in place."""

from __future__ import annotations

from collections.abc import Callable
from math import ceil
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkTexture

# Imported for its side effect: it says where textures come from.
import resources.library  # noqa: F401
from app.scene.actors import Array, SurfacePart
from sgb_core.bodies.solid import Solid
from sgb_core.document.appearance import pictures
from sgb_core.document.appearance.colour_maps import map_limits, map_values, shares_of, title_of
from sgb_core.document.appearance.colour_tables import scale_of, table
from sgb_core.document.appearance.model import Appearance, ColourMap
from sgb_core.document.appearance.relief import PaintedRelief, relief_of
from sgb_core.document.appearance.texture_painting import (
    follows_shape,
    is_painted,
    paint,
    parts_alike,
    varies_around,
)
from sgb_core.document.body_state import BodyState
from sgb_core.document.evaluation import Evaluation
from sgb_core.exchange.skin import Skin
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.uv import UVMap, uv_map_of

# Width and height of the painted picture, while the hand moves and when it rests.
QUICK, FULL = 512, 1536
# A picture of one part of the turn is at least so wide: less could not be filtered.
NARROW = 64
# Steps of s in a segment from which a picture is painted, whatever the level it lies on.
_STEPS = 48
# Rows of a picture that is the same all around.
ROWS = 1024


class PaintCoat:
    """The painted picture of a document as a texture, made anew only when it changes.

    Where all of it repeats around the turn it holds one of the ``parts`` that are alike. Its alpha
    is how high the relief stands, from its lowest to its highest, ``depth`` apart in the unit;
    without relief the depth is 0 and there is no alpha.
    """

    def __init__(self) -> None:
        self._quick, self._full = _Painted(QUICK), _Painted(FULL)
        self._shown = self._quick
        self.depth = 0.0
        self.parts = 1
        # The fine picture that was painted aside, and of what.
        self._ready: tuple[object, Array] | None = None

    @property
    def texture(self) -> Any:
        """The texture that was written last."""
        return self._shown.texture

    def write(
        self, level: SurfacePart, evaluation: Evaluation, fine: bool, hurried: bool = False
    ) -> None:
        """Lay the document's paint on a level; coordinates follow the arc length in place.

        A finer picture than is needed stays, but while ``hurried``: its filter costs more than all
        else of the shading.
        """
        appearance = evaluation.document.appearance
        self.parts = _parts_of(appearance)
        uv_map = uv_map_of(evaluation.surface, level.shape[1])
        uv = level.coordinates()
        grid = uv.reshape(level.grid.rows, level.grid.columns, 2)
        grid[..., 0] = np.linspace(0.0, self.parts, level.grid.columns)
        grid[..., 1] = uv_map.shares[:, None]
        level.coordinates_written()
        relief = relief_of(appearance)
        self.depth = 0.0 if relief is None else relief.reach[1] - relief.reach[0]
        coarse_map = uv_map_of(evaluation.surface, _STEPS)
        key = _key_of(appearance, coarse_map)
        full = fine or (key == self._full.key and not hurried)
        self._shown = self._full if full else self._quick
        if self._shown.key != key:
            ready, self._ready = (self._ready, None) if full else (None, self._ready)
            if ready is not None and ready[0] == key:
                self._shown.take(*ready)
            else:
                self._shown.take(key, _painted(appearance, coarse_map, self._shown.side))

    def fine_work(self, evaluation: Evaluation) -> Callable[[], None] | None:
        """Return what may be run aside so that a fine ``write`` is quick; None where it is."""
        appearance = evaluation.document.appearance
        uv_map = uv_map_of(evaluation.surface, _STEPS)
        key = _key_of(appearance, uv_map)
        if key == self._full.key or (self._ready is not None and self._ready[0] == key):
            return None

        def work() -> None:
            self._ready = (key, _painted(appearance, uv_map, FULL))

        return work


class _Painted:
    """A texture that holds a painted picture so many pixels wide and high, and of what it is."""

    def __init__(self, side: int) -> None:
        self.side = side
        self.texture = _texture()
        self.key: object = None

    def take(self, key: object, pixels: Array) -> None:
        """Show a picture of what ``key`` tells apart."""
        self.key = key
        _set_pixels(self.texture, pixels)


def _parts_of(appearance: Appearance) -> int:
    """Return of how many parts alike around the turn a picture holds one."""
    alike = parts_alike(appearance)
    return max(parts for parts in range(1, QUICK // NARROW + 1) if alike % parts == 0)


def _key_of(appearance: Appearance, uv_map: UVMap) -> object:
    """Return what a painted picture depends on."""
    raised = relief_of(appearance) is not None
    shape = _fingerprint(uv_map) if raised or follows_shape(appearance) else b""
    painted = (appearance.material, appearance.color, appearance.textures, appearance.drawing)
    return *painted, appearance.paint, shape


def needs_picture(appearance: Appearance) -> bool:
    """Whether a look is drawn by a picture: it is painted, or raised."""
    return is_painted(appearance) or relief_of(appearance) is not None


def _painted(appearance: Appearance, uv_map: UVMap, side: int) -> Array:
    relief = relief_of(appearance)
    around = varies_around(appearance) or (relief is not None and relief.varies_around)
    parts = _parts_of(appearance)
    size = (ceil(side / parts), side) if around else (4, ROWS)
    try:
        pixels = paint(appearance, uv_map, size, parts)
        if relief is None:
            return pixels
        heights = _height_map(relief, uv_map, size, parts)
        # A colour of 255 is as full as a height of 65535.
        return np.concatenate([pixels * np.uint16(257), heights[..., None]], axis=2)
    except pictures.PictureError:
        # A texture of another version of the program: the colour below it is shown.
        return np.full((4, 4, 3), 160, np.uint8)


def _height_map(relief: PaintedRelief, uv_map: UVMap, size: tuple[int, int], parts: int) -> Array:
    """Return the heights of a relief from its lowest, 0, to its highest, 65535; (height, width).

    Light that falls along a surface would show the steps of fewer.
    """
    around, rows = parts * size[0], size[1]
    u, v = (np.arange(size[0]) + 0.5) / around, (np.arange(rows) + 0.5) / rows
    low, high = relief.reach
    # No edge is sharper than a pixel is wide.
    least = max(uv_map.width / around, uv_map.length / rows) if relief.varies_around else 0.0
    sweep = uv_map.width / max(float(np.abs(uv_map.points[:, 0]).max()), 1e-300)
    heights = relief.heights(uv_map, sweep, u, v, least, parts)
    return np.asarray(np.rint(65535.0 * (heights - low) / (high - low)), dtype=np.uint16)


def _fingerprint(uv_map: UVMap) -> bytes:
    """Return what of a UV map shows in a picture, to a thousandth."""
    places = np.concatenate([uv_map.borders, [uv_map.width / max(uv_map.length, 1e-300)]])
    middle = np.interp(np.linspace(0.0, 1.0, 33), uv_map.shares, uv_map.heights)
    return np.rint(1000.0 * np.concatenate([places, middle])).astype(np.int64).tobytes()


class MapCoat:
    """A map as a texture of its colours; ``low``, ``high`` and ``title`` are for the bar."""

    def __init__(self) -> None:
        self.texture = _texture()
        self.title = ""
        self.low, self.high = 0.0, 1.0
        self.colours: Array | None = None
        # What the limits are of.
        self._limited: tuple[RevolutionSurface, ColourMap, Solid] | None = None
        self.texture.SetWrap(vtkTexture.ClampToEdge)

    def write(self, level: SurfacePart, evaluation: Evaluation, shown: ColourMap) -> None:
        """Colour a level by the values of a map."""
        surface, solid = evaluation.surface, evaluation.document.solid
        limited = (surface, shown, solid)
        if limited != self._limited:
            self._limited = limited
            self.low, self.high = map_limits(surface, shown, solid)
        _, per_segment, around = level.shape
        values = map_values(surface, shown, per_segment, around, solid)
        self.title = title_of(shown, evaluation.document.unit.value)
        colours = table(scale_of(shown, self.low, self.high))
        if colours is not self.colours:
            self.colours = colours
            _set_pixels(self.texture, np.repeat(colours[None], 2, axis=0))
        uv = level.coordinates()
        grid = uv.reshape(level.grid.rows, level.grid.columns, 2)
        # From the middle of the first pixel to that of the last.
        width = len(colours)
        grid[..., 0] = (0.5 + shares_of(values, self.low, self.high) * (width - 1)) / width
        grid[..., 1] = 0.5
        level.coordinates_written()


class BodyCoat:
    """Texture coordinates of a body: those of the nearest point of the generatrix."""

    def __init__(self) -> None:
        self._key: tuple[object, ...] = ()

    def write(
        self, state: BodyState, level: SurfacePart, actor: Any, mapped: bool, parts: int
    ) -> None:
        """Lay paint, or a map's colours, on a body as they lie on its surface.

        The picture of the paint holds one of so many ``parts`` of the turn.
        """
        look = state.document.appearance
        painted = (look.textures, look.drawing, look.material, parts)
        key = (state, level.shape, mapped, look.map, *painted)
        if key == self._key or state.mesh is None:
            return
        self._key = key
        mesh, per_segment = state.mesh, level.shape[1]
        uv_map = uv_map_of(state.surface, per_segment)
        uv = Skin(state.document, uv_map, None).coordinates(mesh)
        if mapped:
            # The nearest of the rows, whose values the level has as coordinates.
            rows = np.abs(np.subtract.outer(uv[:, 1], uv_map.shares)).argmin(axis=1)
            columns = np.rint(uv[:, 0] * (level.grid.columns - 1)).astype(np.intp)
            grid = level.coordinates().reshape(level.grid.rows, level.grid.columns, 2)
            uv = grid[rows, columns]
        else:
            uv = uv * (parts, 1)
        flat = numpy_to_vtk(np.ascontiguousarray(uv, np.float32), deep=True)
        data = actor.GetMapper().GetInput()
        data.GetPointData().SetTCoords(flat)
        data.Modified()


def _texture() -> Any:
    texture = vtkTexture()
    texture.InterpolateOn()
    texture.SetWrap(vtkTexture.Repeat)
    texture.SetColorModeToDirectScalars()
    # The shader reads it as its slant needs.
    texture.SetMaximumAnisotropicFiltering(1)
    return texture


def _set_pixels(texture: Any, pixels: Array) -> None:
    height, width = pixels.shape[:2]
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    flat = np.ascontiguousarray(pixels).reshape(-1, pixels.shape[2])
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    # Mip levels of a picture a few pixels wide would mix what lies far apart along it.
    texture.SetMipmap(width >= NARROW and height >= NARROW)
    texture.SetInputData(image)
