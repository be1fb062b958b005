"""What an exported mesh looks like: its material, and the painted picture laid around it."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.bodies.solid import BodyKind
from sgb_core.document.appearance.colour_maps import map_limits, map_values, shares_of, title_of
from sgb_core.document.appearance.colour_tables import scale_of, table
from sgb_core.document.appearance.finishes import FINISHES, Finish, base_color
from sgb_core.document.appearance.model import PLAIN, Appearance, MapKind
from sgb_core.document.appearance.pictures import PictureError, Pixels, encode_png
from sgb_core.document.appearance.texture_painting import is_painted, paint, sample, varies_around
from sgb_core.document.model import Document
from sgb_core.exchange.errors import ExportError
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.uv import UVMap, uv_map_of
from sgb_core.values import dataclass

# Side of an exported picture in pixels, and its height where it is the same all around.
_SIDE, _ROWS = 2048, 2048
# Steps of s in a segment with which the generatrix is looked up.
_STEPS = 128
# Height in pixels of the picture of a map's colours.
_THICK = 4
# Columns at which a map is looked up where it differs around.
_COLUMNS = 256
# What a map is laid on: nothing that shines or tints it.
_SHEET = Finish("Map", "#ffffff", 1.0)


@dataclass(frozen=True)
class Skin:
    """The look of a document for a file; ``picture`` None where nothing is painted."""

    document: Document
    uv_map: UVMap
    picture: Pixels | None

    @property
    def material(self) -> Finish:
        """The numbers of the material."""
        return FINISHES[self.document.appearance.material]

    @property
    def color(self) -> tuple[float, float, float]:
        """The colour where nothing is painted, sRGB from 0 to 1."""
        text = base_color(self.document.appearance)
        red, green, blue = (int(text[k : k + 2], 16) / 255.0 for k in (1, 3, 5))
        return red, green, blue

    @property
    def linear_color(self) -> tuple[float, float, float]:
        """The same in linear light."""
        red, green, blue = (
            c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in self.color
        )
        return red, green, blue

    @cached_property
    def png(self) -> bytes:
        """The painted picture as a PNG file; empty where there is none."""
        return b"" if self.picture is None else encode_png(self.picture)

    def coordinates(self, mesh: Mesh) -> Floats:
        """Return where on the picture each corner lies, shape (V, 2).

        What is not the drawn surface itself, such as an inner wall, takes the paint of the
        nearest point of the generatrix.
        """
        # Imported late: it takes longer to load than all the rest of the core.
        from scipy.spatial import cKDTree

        if self.document.solid.kind is BodyKind.SURFACE:
            return mesh.uv
        surface = self.document.surface
        r, h, turn = _cylindrical(surface, mesh.positions)
        places = np.stack([r, h], axis=-1)
        nearest = cKDTree(self.uv_map.points).query(places)[1]
        shares = _between_rows(self.uv_map, places, nearest)
        uv = np.stack([mesh.uv[:, 0], shares[mesh.corner_positions]], axis=-1)
        angle = turn[mesh.corner_positions]
        off = np.abs(np.mod(angle - uv[:, 0] + 0.5, 1.0) - 0.5) > 1e-3
        uv[off & (r > 0.0)[mesh.corner_positions], 0] = angle[
            off & (r > 0.0)[mesh.corner_positions]
        ]
        return uv

    def position_colors(self, mesh: Mesh) -> Pixels:
        """Return a colour for each position, shape (P, 3)."""
        if self.picture is None:
            plain = np.rint(255.0 * np.asarray(self.color)).astype(np.uint8)
            return np.broadcast_to(plain, mesh.positions.shape).copy()
        first = np.zeros(len(mesh.positions), dtype=np.intp)
        first[mesh.corner_positions[::-1]] = np.arange(len(mesh.corner_positions))[::-1]
        return sample(self.picture, self.coordinates(mesh)[first])


@dataclass(frozen=True)
class MapSkin(Skin):
    """A map for a file: ``picture`` is its colours from low to high, looked up by the value.

    So each value has its colour also between the corners of the mesh. ``values`` are those of the
    UV map's rows, shape (rows, columns).
    """

    values: Floats
    low: float
    high: float

    @property
    def material(self) -> Finish:
        """A dull white one, whose name says what the colours mean."""
        shown = self.document.appearance.map
        assert shown is not None
        title = title_of(shown, self.document.unit.value)
        return replace(_SHEET, title=f"{title}, {self.low:.4g} to {self.high:.4g}")

    def coordinates(self, mesh: Mesh) -> Floats:
        """Return where in the colours each corner's value lies, shape (V, 2)."""
        u, v = super().coordinates(mesh).T
        rows, columns = self.values.shape
        # A joint has two rows; it takes the later one.
        row = np.clip(np.searchsorted(self.uv_map.shares, v, side="right") - 1, 0, rows - 2)
        step = self.uv_map.shares[row + 1] - self.uv_map.shares[row]
        part = np.clip((v - self.uv_map.shares[row]) / np.where(step > 0.0, step, 1.0), 0.0, 1.0)
        column = np.rint(u * (columns - 1)).astype(np.intp)
        shares = shares_of(self.values, self.low, self.high)
        share = shares[row, column] * (1.0 - part) + shares[row + 1, column] * part
        width = len(self.picture[0]) if self.picture is not None else 1
        # From the middle of the first pixel to that of the last.
        across = (0.5 + share * (width - 1)) / width
        return np.stack([across, np.full_like(across, 0.5)], axis=-1)


def _between_rows(uv_map: UVMap, places: Floats, nearest: NDArray[np.intp]) -> Floats:
    """Return the shares of the nearest points of the generatrix' chords, (P,).

    ``nearest`` are the rows nearest to the places (P, 2).
    """
    best, found = np.full(len(places), np.inf), np.zeros(len(places))
    for first in (nearest - 1, nearest):
        first = np.clip(first, 0, len(uv_map.points) - 2)
        start, step = uv_map.points[first], uv_map.points[first + 1] - uv_map.points[first]
        square = (step * step).sum(axis=1)
        part = ((places - start) * step).sum(axis=1) / np.where(square > 0.0, square, 1.0)
        part = np.clip(part, 0.0, 1.0)
        off = ((places - start - part[:, None] * step) ** 2).sum(axis=1)
        share = uv_map.shares[first] + part * np.diff(uv_map.shares)[first]
        found, best = np.where(off < best, share, found), np.minimum(off, best)
    return found


def _cylindrical(surface: RevolutionSurface, positions: Floats) -> tuple[Floats, Floats, Floats]:
    """Return radius, height and the share of the sweep of positions, each shape (P,)."""
    frame = surface.directions(np.array([surface.start]))[0]
    local = (positions - np.asarray(surface.placement.translation)) @ frame.T
    turn = np.mod(np.arctan2(local[:, 1], local[:, 0]), 2.0 * np.pi) / surface.sweep
    # Rounding puts what lies on the start just before it.
    turn = np.where(turn > (1.0 + 2.0 * np.pi / surface.sweep) / 2.0, 0.0, turn)
    return np.hypot(local[:, 0], local[:, 1]), local[:, 2], np.minimum(turn, 1.0)


def has_skin(appearance: Appearance) -> bool:
    """Whether the look differs from plain clay in what a file can hold."""
    plain = PLAIN
    return (
        appearance.material is not plain.material
        or appearance.color is not None
        or is_painted(appearance)
        or is_mapped(appearance)
    )


def is_mapped(appearance: Appearance) -> bool:
    """Whether a map colours the surface; zebra stripes are no colours of it."""
    return appearance.map is not None and appearance.map.of is not MapKind.ZEBRA


def has_picture(appearance: Appearance) -> bool:
    """Whether a picture is laid around the surface: its paint, or the colours of a map."""
    return is_painted(appearance) or is_mapped(appearance)


def look_words(appearance: Appearance) -> str:
    """Return in words what of the look a file holds; empty where it is plain."""
    if not has_skin(appearance):
        return ""
    if is_mapped(appearance):
        return "the map's colours"
    return "material and paint" if is_painted(appearance) else "material"


def skin_of(document: Document) -> Skin | None:
    """Return the look of a document, None where it is plain; raises ExportError."""
    appearance = document.appearance
    if not has_skin(appearance):
        return None
    uv_map = uv_map_of(document.surface, _STEPS)
    shown = appearance.map
    if shown is not None and is_mapped(appearance):
        values = map_values(document.surface, shown, _STEPS, _COLUMNS, document.solid)
        low, high = map_limits(document.surface, shown, document.solid)
        colours = np.repeat(table(scale_of(shown, low, high))[None], _THICK, axis=0)
        return MapSkin(document, uv_map, colours, values, low, high)
    if not is_painted(appearance):
        return Skin(document, uv_map, None)
    size = (_SIDE, _SIDE) if varies_around(appearance) else (4, _ROWS)
    try:
        return Skin(document, uv_map, paint(appearance, uv_map, size))
    except PictureError as error:
        raise ExportError(error.finding) from None
