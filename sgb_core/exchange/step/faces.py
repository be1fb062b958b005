"""Faces of the CAD kernel: curves turned about the axis, and the flat ends of a part turn."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from functools import partial
from typing import Any

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.exchange.step.curves import Circular, Curve, Spline
from sgb_core.exchange.step.parts import Run, StepPart
from sgb_core.exchange.step.topology import Sides, Topology
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

# Edges this near, in mm, are one: what the kernel itself takes for one point, and no less than
# rounding leaves of large coordinates.
_SAME, _SAME_PART = 1e-7, 1e-12


@dataclass(frozen=True, slots=True)
class Turning:
    """Where the profile's half-plane stands: a surface's frame, with lengths times ``scale``."""

    surface: RevolutionSurface
    scale: float

    def place(self, points: Floats, angle: float) -> Floats:
        """Return points (k, 2) in space, turned by ``angle`` from the start, shape (k, 3)."""
        radial, _, axial = self.surface.directions(np.array(self.surface.start + angle))
        placed = points[:, :1] * radial + points[:, 1:] * axial
        return np.asarray((placed + np.asarray(self.surface.placement.translation)) * self.scale)

    @property
    def same(self) -> float:
        """The distance within which edges are one."""
        points = self.surface.profile.control_points
        far = np.abs(self.surface.placement.translation).max() + np.abs(points).max()
        return max(_SAME, _SAME_PART * float(far) * self.scale)


class TurnedFaces:
    """The faces of one part: each curve's, and the ends where the turn is a part of one."""

    def __init__(self, part: StepPart, turning: Turning) -> None:
        self._part = part
        self._turning = turning
        self._topology = Topology(turning.same)
        self._whole = turning.surface.is_full_turn

    def run(self, number: int) -> list[Any]:
        """Return the faces that the curves of one of the part's runs sweep."""
        run = self._part.runs[number]
        return [self._face(number, k) for k in range(len(run))]

    def ends(self) -> list[Any]:
        """Return the flat faces at the start and the end of a part turn."""
        loops = self._part.loops()
        outside = np.concatenate([_sketch(curve) for curve in loops[0]])
        r, h = outside.T
        left = bool(r @ np.roll(h, -1) - h @ np.roll(r, -1) > 0.0)
        return [self._end(loops, left, at_end) for at_end in (False, True)]

    def _end(self, loops: Sequence[Run], left: bool, at_end: bool) -> Any:
        from OCP.Geom import Geom_Plane

        angle = float(self._turning.surface.sweep) if at_end else 0.0
        radial, around, _ = self._turning.surface.directions(
            np.array(self._turning.surface.start + angle)
        )
        # Out of the material, which begins after the start and lies before the end.
        normal = around if at_end == left else -around
        origin = self._turning.place(np.zeros((1, 2)), angle)[0]
        wires = []
        for loop in loops:
            edges = [self._meridian(curve, at_end) for curve in loop]
            wires.append([(edge, not at_end) for edge in (edges[::-1] if at_end else edges)])
        return self._topology.flat(Geom_Plane(_frame(origin, normal, radial)), wires)

    # Corners, and the edges between and around them.

    def _corner(self, point: Floats, key: Hashable, at_end: bool) -> Any:
        """Return the vertex of a corner; one on the axis is the same all round."""
        if point[0] == 0.0:
            key, angle = ("axis", float(point[1])), 0.0
        else:
            turned = at_end and not self._whole
            key, angle = (key, turned), self._turning.surface.sweep if turned else 0.0
        return self._topology.vertex(key, self._turning.place(point[None], angle)[0])

    def _named(self, curve: Curve) -> tuple[Hashable, Hashable]:
        """Return the keys of the corners that a curve runs between."""
        for number, run in enumerate(self._part.runs):
            for k, other in enumerate(run):
                if other is curve:
                    ring = run[0].ends[0, 0] != 0.0 and self._part.solid
                    after = (k + 1) % len(run) if ring or self._rings(run) else k + 1
                    return (number, k), (number, after)
        # A line along the axis, whose corners are named by their place.
        return None, None

    def _rings(self, run: Run) -> bool:
        """Whether the run of a surface ends where it begins."""
        return bool(np.abs(run[-1].ends[1] - run[0].ends[0]).max() == 0.0)

    def _meridian(self, curve: Curve, at_end: bool) -> Any:
        """Return the edge along a curve, at the start or at the end of the turn."""
        turned = at_end and not self._whole and not curve.on_axis
        angle = float(self._turning.surface.sweep) if turned else 0.0
        first, last = self._named(curve)
        ends = (
            self._corner(curve.ends[0], first, at_end),
            self._corner(curve.ends[1], last, at_end),
        )
        key = ("meridian", id(curve), turned)
        return self._topology.edge(key, ends, partial(_placed, curve, self._turning, angle))

    def _parallel(self, point: Floats, key: Hashable) -> Any:
        """Return the edge around the axis through a corner; at a pole one without length."""
        sweep = float(self._turning.surface.sweep)
        if point[0] == 0.0:
            return self._topology.point_edge(self._corner(point, key, False), 0.0, sweep)
        ends = self._corner(point, key, False), self._corner(point, key, True)
        return self._topology.edge(
            ("parallel", key), ends, partial(_circle_around, point, self._turning)
        )

    def _face(self, number: int, k: int) -> Any:
        curve = self._part.runs[number][k]
        first, last = self._named(curve)
        sides = Sides(
            self._parallel(curve.ends[0], first),
            self._parallel(curve.ends[1], last),
            self._meridian(curve, at_end=False),
            self._meridian(curve, at_end=True),
        )
        if isinstance(curve, Spline) and curve.degree == 1 and curve.ends[0, 1] == curve.ends[1, 1]:
            return self._level(curve, sides)
        from OCP.Geom import Geom_SurfaceOfRevolution

        placed = _placed(curve, self._turning, 0.0)
        surface = Geom_SurfaceOfRevolution(placed, _axis(self._turning))
        spans = (
            (0.0, float(self._turning.surface.sweep)),
            (placed.FirstParameter(), placed.LastParameter()),
        )
        return self._topology.rectangle(surface, spans, sides)

    def _level(self, curve: Spline, sides: Sides) -> Any:
        """Return the face of a level line: part of a plane."""
        from OCP.Geom import Geom_Plane

        (r0, h), (r1, _) = curve.ends.tolist()
        radial, _, axial = self._turning.surface.directions(np.array(self._turning.surface.start))
        normal = -axial if r1 > r0 else axial
        origin = self._turning.place(np.array([(0.0, h)]), 0.0)[0]
        loop = [(sides.first, True, r0), (sides.last, False, r1)]
        wires = [[(edge, forward)] for edge, forward, r in loop if r != 0.0]
        if abs(r0) > abs(r1):
            wires.reverse()
        if not self._whole:
            around = [side for side, r in zip(sides.loop, (r0, 1.0, r1, 1.0), strict=True) if r]
            wires = [around]
        return self._topology.flat(Geom_Plane(_frame(origin, normal, radial)), wires[::-1])


def _sketch(curve: Curve) -> Floats:
    """Return points (k, 2) along a curve, for the sense in which a loop of curves runs."""
    shares = np.linspace(0.0, 1.0, 65)[:-1]
    if isinstance(curve, Circular):
        angles = curve.low + (curve.high - curve.low) * shares
        spokes = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        return np.asarray(np.asarray(curve.centre) + curve.radius * spokes)
    # Late, as in the fits: most commands write no STEP.
    from scipy.interpolate import BSpline

    return np.asarray(BSpline(curve.knots, curve.poles, curve.degree)(shares))


def _frame(origin: Floats, normal: Floats, across: Floats) -> Any:
    from OCP.gp import gp_Ax3, gp_Dir, gp_Pnt

    return gp_Ax3(gp_Pnt(*origin.tolist()), gp_Dir(*normal.tolist()), gp_Dir(*across.tolist()))


def _axis(turning: Turning) -> Any:
    from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt

    foot = turning.place(np.zeros((1, 2)), 0.0)[0]
    up = turning.surface.directions(np.array(0.0))[2]
    return gp_Ax1(gp_Pnt(*foot.tolist()), gp_Dir(*up.tolist()))


def _placed(curve: Curve, turning: Turning, angle: float) -> Any:
    """Return the kernel's curve in space, in the half-plane at an angle from the start."""
    if isinstance(curve, Circular):
        return _circle(curve, turning, angle)
    return spline_curve(turning.place(curve.poles, angle), curve)


def spline_curve(poles: Floats, curve: Spline) -> Any:
    """Return the kernel's B-spline of poles (k, 3) over a curve's knots."""
    from OCP.collections import Array1_double, Array1_gp_Pnt, Array1_int
    from OCP.Geom import Geom_BSplineCurve
    from OCP.gp import gp_Pnt

    points = Array1_gp_Pnt(1, len(poles))
    for number, pole in enumerate(poles.tolist(), start=1):
        points.SetValue(number, gp_Pnt(*pole))
    values, counts = np.unique(curve.knots, return_counts=True)
    knots, multiplicities = Array1_double(1, len(values)), Array1_int(1, len(values))
    for number, (value, count) in enumerate(zip(values.tolist(), counts.tolist(), strict=True), 1):
        knots.SetValue(number, value)
        multiplicities.SetValue(number, count)
    return Geom_BSplineCurve(points, knots, multiplicities, curve.degree)


def _circle(curve: Circular, turning: Turning, angle: float) -> Any:
    """Return part of a circle; one that runs clockwise is that about the opposite normal."""
    from OCP.Geom import Geom_TrimmedCurve

    radial, around, _ = turning.surface.directions(np.array(turning.surface.start + angle))
    centre = turning.place(np.array([curve.centre]), angle)[0]
    way = 1.0 if curve.high >= curve.low else -1.0
    # Angles count from the radial direction towards the axial one, which are at −around.
    circle = _geometric_circle(centre, -way * around, radial, curve.radius * turning.scale)
    return Geom_TrimmedCurve(circle, way * curve.low, way * curve.high)


def _circle_around(point: Floats, turning: Turning) -> Any:
    """Return the parallel of a point (2,) off the axis, over the sweep."""
    from OCP.Geom import Geom_TrimmedCurve

    radial, _, axial = turning.surface.directions(np.array(turning.surface.start))
    centre = turning.place(np.array([(0.0, point[1])]), 0.0)[0]
    out = radial if point[0] > 0.0 else -radial
    circle = _geometric_circle(centre, axial, out, abs(float(point[0])) * turning.scale)
    if turning.surface.is_full_turn:
        return circle
    return Geom_TrimmedCurve(circle, 0.0, float(turning.surface.sweep))


def _geometric_circle(centre: Floats, normal: Floats, across: Floats, radius: float) -> Any:
    from OCP.Geom import Geom_Circle
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt

    frame = gp_Ax2(gp_Pnt(*centre.tolist()), gp_Dir(*normal.tolist()), gp_Dir(*across.tolist()))
    return Geom_Circle(frame, radius)
