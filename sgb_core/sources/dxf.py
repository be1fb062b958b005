"""DXF drawings: lines, arcs, polylines with bulges, ellipses and splines, in blocks and layers."""

from __future__ import annotations

import io
from collections.abc import Iterator
from math import radians
from typing import Any

import numpy as np

from sgb_core.findings.sources import NoSource, TooMuch, Unreadable
from sgb_core.sources.drawing import Drawing
from sgb_core.sources.errors import SourceError
from sgb_core.sources.pieces import Arc, Bezier, Piece, Sampled, are_places, chained, upright_line

_MOST_PIECES = 50_000
_DEEPEST = 16
# Millimetres of the units that $INSUNITS names.
_MILLIMETRES = {1: 25.4, 2: 304.8, 4: 1.0, 5: 10.0, 6: 1000.0, 8: 2.54e-5, 9: 0.0254, 13: 1e-3}
_GENERATRIX, _AXIS = "GENERATRIX", "AXIS"
_JOINED = 1e-6
# Points of a spline that is neither polynomial of degree four at most nor a plain arc.
_SPLINE_POINTS = 64


def parse_dxf(data: bytes) -> Drawing:
    """Return the paths that a DXF file draws.

    Its unit is that which $INSUNITS names. What is on a layer
    GENERATRIX is taken before the longest chain; a line on a layer AXIS is the axis. Raises
    SourceError for what is no DXF, too large, or has no path.
    """
    drawing = _drawing(data)
    millimetres = _MILLIMETRES.get(int(drawing.header.get("$INSUNITS", 0)))
    layers: dict[str, list[Piece]] = {}
    for number, (layer, piece) in enumerate(_pieces(drawing)):
        layers.setdefault(layer, []).append(piece)
        if number >= _MOST_PIECES:
            raise SourceError(TooMuch("lines and curves", _MOST_PIECES))
    axis = upright_line(layers.pop(_AXIS, []))
    pieces = layers.get(_GENERATRIX) or [piece for found in layers.values() for piece in found]
    if not pieces:
        raise SourceError(NoSource.NO_PATH)
    ends = np.concatenate([piece.ends for piece in pieces])
    paths = chained(pieces, _JOINED * float(np.hypot(*np.ptp(ends, axis=0))))
    return Drawing(tuple(paths), axis, millimetres, False)


def _drawing(data: bytes) -> Any:
    # Imported late: it takes as long to load as everything else together.
    import ezdxf
    from ezdxf import recover

    if b"\0" in data[:4096] and not data.startswith(b"AutoCAD Binary DXF"):
        raise SourceError(Unreadable("DXF", ""))
    try:
        drawing, _ = recover.read(io.BytesIO(data))
    except (ezdxf.DXFError, OSError, ValueError, KeyError, TypeError, IndexError) as error:
        raise SourceError(Unreadable("DXF", str(error))) from None
    return drawing


def _pieces(drawing: Any) -> Iterator[tuple[str, Piece]]:
    hidden = {layer.dxf.name for layer in drawing.layers if layer.is_off() or layer.is_frozen()}
    _Sizes(drawing).size(drawing.modelspace(), 0)
    for entity in _flattened(drawing.modelspace()):
        layer = str(entity.dxf.get("layer", "0"))
        if layer in hidden or entity.dxf.get("invisible", 0):
            continue
        for piece in _of_entity(entity):
            if not are_places(piece.ends):
                raise SourceError(NoSource.NOT_FINITE)
            yield layer, piece


class _Sizes:
    """How many entities there are in a block, with those of the blocks inserted there."""

    def __init__(self, drawing: Any) -> None:
        self._blocks = drawing.blocks
        self._known: dict[str, int] = {}

    def size(self, entities: Any, depth: int) -> int:
        """Return how many entities there are; SourceError where they are too many."""
        if depth > _DEEPEST:
            raise SourceError(TooMuch("blocks inside each other", _DEEPEST))
        total = 0
        for entity in entities:
            total += 1 if entity.dxftype() != "INSERT" else self._inserted(entity, depth)
            if total > _MOST_PIECES:
                raise SourceError(TooMuch("lines and curves", _MOST_PIECES))
        return total

    def _inserted(self, entity: Any, depth: int) -> int:
        name = str(entity.dxf.name)
        if name not in self._known:
            block = self._blocks.get(name)
            self._known[name] = 0 if block is None else self.size(block, depth + 1)
        return max(int(entity.mcount), 1) * self._known[name]


def _flattened(entities: Any) -> Iterator[Any]:
    """Yield the entities with those of inserted blocks, in place."""
    for entity in entities:
        if entity.dxftype() != "INSERT":
            yield entity
            continue
        for single in entity.multi_insert() if entity.mcount > 1 else (entity,):
            yield from _flattened(single.virtual_entities())


def _of_entity(entity: Any) -> Iterator[Piece]:
    kind = entity.dxftype()
    if kind == "LINE":
        points = np.array([_flat(entity.dxf.start), _flat(entity.dxf.end)])
        if np.ptp(points, axis=0).any():
            yield Bezier(points)
    elif kind in ("LWPOLYLINE", "POLYLINE"):
        for part in entity.virtual_entities():
            yield from _of_entity(part)
    elif kind == "CIRCLE":
        yield _circle(entity, 0.0, 360.0)
    elif kind == "ARC":
        yield _circle(entity, entity.dxf.start_angle, entity.dxf.end_angle)
    elif kind == "ELLIPSE":
        yield _ellipse(entity)
    elif kind == "SPLINE":
        yield from _spline(entity)


def _circle(entity: Any, start: float, end: float) -> Piece:
    first, last = radians(start), radians(end)
    if last <= first:
        last += 2.0 * np.pi
    center = np.array(_flat(entity.ocs().to_wcs(entity.dxf.center)))
    frame = float(entity.dxf.radius) * np.eye(2)
    if entity.dxf.extrusion.z < 0.0:
        # Seen from behind, as mirrored blocks are: x runs the other way.
        frame = frame * np.array([[-1.0], [1.0]])
    return Arc(center, frame, first, last)


def _ellipse(entity: Any) -> Piece:
    major = np.array(_flat(entity.dxf.major_axis))
    minor = np.array(_flat(entity.minor_axis))
    first, last = float(entity.dxf.start_param), float(entity.dxf.end_param)
    if last <= first:
        last += 2.0 * np.pi
    center = np.array(_flat(entity.dxf.center))
    return Arc(center, np.column_stack([major, minor]), first, last)


def _spline(entity: Any) -> list[Piece]:
    """Return a spline's Bézier pieces; where it is rational or of high degree, chords."""
    if max(entity.control_point_count(), entity.fit_point_count()) > _MOST_PIECES:
        raise SourceError(TooMuch("points of a spline", _MOST_PIECES))
    curve = entity.construction_tool()
    if not curve.is_rational and curve.degree <= 4 and curve.is_clamped:
        parts = [
            np.array([_flat(point) for point in points]) for points in curve.bezier_decomposition()
        ]
        return [Bezier(points) for points in parts if np.ptp(points, axis=0).any()]
    points = np.array([_flat(point) for point in curve.approximate(_SPLINE_POINTS)])
    return [Sampled(points)]


def _flat(point: Any) -> tuple[float, float]:
    return float(point.x), float(point.y)
