"""Faces of the CAD kernel that share their edges: rectangles of a surface's parameters.

Edges and vertices are made once and named by keys, so that nothing has to be sewn by place.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import field
from typing import Any

from sgb_core.arrays import Floats
from sgb_core.values import dataclass


@dataclass(slots=True)
class Topology:
    """The vertices and edges of one shape; ``same`` is the distance that is none, in mm."""

    same: float
    _vertices: dict[Hashable, Any] = field(default_factory=dict)
    _edges: dict[Hashable, Any] = field(default_factory=dict)

    def vertex(self, key: Hashable, point: Floats) -> Any:
        """Return the vertex of a key; ``point`` (3,) is where it lies."""
        from OCP.BRep import BRep_Builder
        from OCP.gp import gp_Pnt
        from OCP.TopoDS import TopoDS_Vertex

        if key not in self._vertices:
            made = TopoDS_Vertex()
            BRep_Builder().MakeVertex(made, gp_Pnt(*point.tolist()), self.same)
            self._vertices[key] = made
        return self._vertices[key]

    def edge(self, key: Hashable, ends: tuple[Any, Any], curve: Callable[[], Any]) -> Any:
        """Return the edge of a key, which runs from one vertex to another along a curve."""
        from OCP.TopoDS import TopoDS_Edge

        if key not in self._edges:
            along, made = curve(), TopoDS_Edge()
            _builder().MakeEdge(made, along, self.same)
            self._bound(made, ends, along.FirstParameter(), along.LastParameter())
            self._edges[key] = made
        return self._edges[key]

    def point_edge(self, vertex: Any, low: float, high: float) -> Any:
        """Return the edge without length that stands for a side of a rectangle at a pole."""
        from OCP.TopoDS import TopoDS_Edge

        made = TopoDS_Edge()
        _builder().MakeEdge(made)
        _builder().Degenerated(made, True)
        self._bound(made, (vertex, vertex), low, high)
        return made

    def _bound(self, edge: Any, ends: tuple[Any, Any], low: float, high: float) -> None:
        builder = _builder()
        builder.Add(edge, _turned_as(ends[0], forward=True))
        builder.Add(edge, _turned_as(ends[1], forward=False))
        builder.Range(edge, low, high)

    def rectangle(
        self, surface: Any, spans: tuple[tuple[float, float], tuple[float, float]], sides: Sides
    ) -> Any:
        """Return the face of a surface over a rectangle of its parameters (u, v)."""
        from OCP.TopoDS import TopoDS_Face, TopoDS_Wire

        builder, face, wire = _builder(), TopoDS_Face(), TopoDS_Wire()
        builder.MakeFace(face, surface, self.same)
        (u0, u1), (v0, v1) = spans
        for edges, lines in (
            ((sides.first, sides.last), (_line(0.0, v0, 1.0, 0.0), _line(0.0, v1, 1.0, 0.0))),
            ((sides.end, sides.start), (_line(u1, 0.0, 0.0, 1.0), _line(u0, 0.0, 0.0, 1.0))),
        ):
            if edges[0].IsSame(edges[1]):
                builder.UpdateEdge(edges[0], *lines, face, self.same)
                continue
            for edge, along in zip(edges, lines, strict=True):
                builder.UpdateEdge(edge, along, face, self.same)
        builder.MakeWire(wire)
        for edge, forward in sides.loop:
            builder.Add(wire, _turned_as(edge, forward))
        builder.Add(face, wire)
        return face

    def flat(self, plane: Any, loops: Sequence[Sequence[tuple[Any, bool]]]) -> Any:
        """Return the face of a plane within loops of edges, each with whether it runs forward.

        The loops have the face on their left, seen against the plane's normal.
        """
        from OCP.TopoDS import TopoDS_Face, TopoDS_Wire

        builder, face = _builder(), TopoDS_Face()
        builder.MakeFace(face, plane, self.same)
        for loop in loops:
            wire = TopoDS_Wire()
            builder.MakeWire(wire)
            for edge, forward in loop:
                builder.Add(wire, _turned_as(edge, forward))
            wire.Closed(True)
            builder.Add(face, wire)
        return face


@dataclass(frozen=True, slots=True)
class Sides:
    """The edges of a rectangle in (u, v): v least and greatest, u least and greatest.

    ``first`` and ``last`` run along u, ``start`` and ``end`` along v.
    """

    first: Any
    last: Any
    start: Any
    end: Any

    @property
    def loop(self) -> tuple[tuple[Any, bool], ...]:
        """Once around, the face on the left: each edge with whether it runs forward."""
        return (self.first, True), (self.end, True), (self.last, False), (self.start, False)


def shell_of(faces: Sequence[Any], closed: bool) -> Any:
    """Return the shell of faces that share their edges."""
    from OCP.TopoDS import TopoDS_Shell

    builder, shell = _builder(), TopoDS_Shell()
    builder.MakeShell(shell)
    for face in faces:
        builder.Add(shell, face)
    shell.Closed(closed)
    return shell


def _builder() -> Any:
    from OCP.BRep import BRep_Builder

    return BRep_Builder()


def _line(u: float, v: float, du: float, dv: float) -> Any:
    from OCP.Geom2d import Geom2d_Line
    from OCP.gp import gp_Dir2d, gp_Pnt2d

    return Geom2d_Line(gp_Pnt2d(u, v), gp_Dir2d(du, dv))


def _turned_as(shape: Any, forward: bool) -> Any:
    from OCP.TopAbs import TopAbs_Orientation

    way = TopAbs_Orientation.TopAbs_FORWARD if forward else TopAbs_Orientation.TopAbs_REVERSED
    return shape.Oriented(way)
