"""Where the viewer stands: a turntable about the rotation axis, as a frozen value.

Lengths are in the document's unit, angles in radians. Nothing here draws.
"""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from math import cos, pi, radians, sin, tan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.scene.standard_views import STANDARD_VIEWS
from sgb_core.surfaces.revolution import Axis
from sgb_core.values import dataclass

Vector = NDArray[np.float64]

VIEW_ANGLE = radians(28.0)
# Part of the picture that a fitted object leaves free, on all sides together.
MARGIN = 0.14


@dataclass(frozen=True, slots=True)
class Part:
    """A part of the picture: its sides from -1 to 1, as shares of the way from the middle."""

    left: float = -1.0
    right: float = 1.0
    bottom: float = -1.0
    top: float = 1.0


WHOLE = Part()


def axis_frame(axis: Axis) -> Vector:
    """Return the unit vectors of θ = 0, θ = 90° and height as the rows of a (3, 3) array."""
    height, u, v = axis.frame
    return np.eye(3)[[u, v, height]]


@lru_cache(maxsize=32)
def _basis(axis: Axis, azimuth: float, elevation: float) -> Vector:
    """Return right, up and back, read-only: asked for many times for one picture."""
    u, v, height = axis_frame(axis)
    outward = cos(azimuth) * u + sin(azimuth) * v
    back = cos(elevation) * outward + sin(elevation) * height
    up = cos(elevation) * height - sin(elevation) * outward
    basis = np.stack([np.cross(up, back), up, back])
    basis.flags.writeable = False
    return basis


@dataclass(frozen=True, slots=True)
class Pose:
    """A camera that looks at ``focal`` from ``distance``, and turns about ``pivot``.

    The parallel projection's scale follows from the distance, so that changing the projection
    keeps the size of what lies at the focal point. ``opening`` is the part of the view angle that
    is used: less than 1 only on the way from one projection to the other.
    """

    axis: Axis
    azimuth: float
    elevation: float
    distance: float
    focal: tuple[float, float, float]
    pivot: tuple[float, float, float]
    parallel: bool = False
    opening: float = 1.0

    @property
    def basis(self) -> Vector:
        """The picture's right, its up, and the direction to the viewer: rows of (3, 3)."""
        return _basis(self.axis, self.azimuth, self.elevation)

    @property
    def eye_distance(self) -> float:
        """How far the eye is from the focal point."""
        if self.opening == 1.0:
            return self.distance
        return self.parallel_scale / tan(VIEW_ANGLE * self.opening / 2.0)

    @property
    def position(self) -> Vector:
        """Where the viewer's eye is."""
        back: Vector = self.basis[2]
        return np.asarray(self.focal) + self.eye_distance * back

    @property
    def parallel_scale(self) -> float:
        """Half the height of the picture, measured at the focal point."""
        return self.distance * tan(VIEW_ANGLE / 2.0)

    def widened(self, aspect: float, other: float) -> Pose:
        """Return the pose that shows in another picture what fits across one.

        ``aspect`` and ``other`` are width over height of the one and of the other.
        """
        return replace(self, distance=self.distance * max(1.0, aspect / other))

    def enlarged(self, factor: float) -> Pose:
        """Return the pose that shows what was enlarged about the origin as it was seen before."""
        if factor == 1.0:
            return self
        focal, pivot = (
            (factor * x, factor * y, factor * z) for x, y, z in (self.focal, self.pivot)
        )
        return replace(self, distance=factor * self.distance, focal=focal, pivot=pivot)

    def orbited(self, azimuth: float, elevation: float) -> Pose:
        """Return the pose turned about its pivot, which keeps its place in the picture."""
        limit = pi / 2
        turned = replace(
            self,
            azimuth=self.azimuth + azimuth,
            elevation=min(limit, max(-limit, self.elevation + elevation)),
        )
        return self._about_pivot(turned)

    def turned_to(self, azimuth: float, elevation: float) -> Pose:
        """Return the pose looking from another direction, turned about its pivot."""
        return self._about_pivot(replace(self, azimuth=azimuth, elevation=elevation))

    def _about_pivot(self, turned: Pose) -> Pose:
        offset = self.basis @ (np.asarray(self.focal) - np.asarray(self.pivot))
        return replace(turned, focal=_triple(np.asarray(self.pivot) + offset @ turned.basis))

    def panned(self, dx: float, dy: float) -> Pose:
        """Return the pose moved so that the picture follows a hand by (dx, dy) half-heights."""
        right, up, _ = self.basis
        step = (right * dx + up * dy) * self.parallel_scale
        return replace(self, focal=_triple(np.asarray(self.focal) - step))

    def zoomed(self, factor: float, x: float, y: float) -> Pose:
        """Return the pose at ``factor`` times the distance; (x, y), in half-heights, stays."""
        right, up, _ = self.basis
        fixed = np.asarray(self.focal) + (right * x + up * y) * self.parallel_scale
        focal = fixed + (np.asarray(self.focal) - fixed) * factor
        return replace(self, focal=_triple(focal), distance=self.distance * factor)

    def fitted(self, points: NDArray[Any], aspect: float, part: Part = WHOLE) -> Pose:
        """Return the pose moved, not turned, so that all ``points`` (P, 3) are seen with a margin.

        ``aspect`` is width over height, ``part`` what of the picture is to hold them. Exact in both
        projections: each side of the part is a plane that some point touches.
        """
        # Coordinate by coordinate: over rows of three numpy takes five times as long, and a product
        # of matrices waits for threads wherever other programs are at work.
        coordinates = np.ascontiguousarray(np.asarray(points).T, dtype=np.float64)
        least, most = coordinates.min(axis=1), coordinates.max(axis=1)
        centre = (least + most) / 2.0
        coordinates -= centre[:, None]
        across, along, back = self.basis
        depth = np.zeros(3) if self.parallel else back
        slope = tan(VIEW_ANGLE / 2.0) * (1.0 - MARGIN)
        # Of the part's sides, from the middle of the picture outwards.
        to_right, to_left = part.right * slope * aspect, -part.left * slope * aspect
        to_top, to_bottom = part.top * slope, -part.bottom * slope
        x, y, z = coordinates
        right, left, top, bottom = (
            float((side[0] * x + side[1] * y + side[2] * z).max())
            for side in (
                across + to_right * depth,
                to_left * depth - across,
                along + to_top * depth,
                to_bottom * depth - along,
            )
        )
        size = float(np.linalg.norm(most - least)) or 1.0
        wide, high = (right + left) / (to_right + to_left), (top + bottom) / (to_top + to_bottom)
        distance = max(wide, high, 1e-3 * size)
        aside = (right - left - (to_right - to_left) * distance) / 2.0
        up = (top - bottom - (to_top - to_bottom) * distance) / 2.0
        focal = centre + aside * across + up * along
        return replace(self, focal=_triple(focal), distance=float(distance), pivot=_triple(centre))

    def places(self, points: NDArray[Any]) -> NDArray[Any]:
        """Return where points (P, 3) are seen, in half-heights from the middle, shape (P, 2)."""
        eye = self.basis @ (np.asarray(points, dtype=np.float64) - np.asarray(self.focal)).T
        depth = 1.0 if self.parallel else 1.0 - eye[2] / self.distance
        return np.asarray((eye[:2] / (depth * self.parallel_scale)).T)

    def holds(self, points: NDArray[Any], aspect: float) -> bool:
        """Return whether all ``points`` (P, 3) lie within the picture."""
        eye = self.basis @ (np.asarray(points, dtype=np.float64) - np.asarray(self.focal)).T
        depth = 1.0 if self.parallel else 1.0 - eye[2] / self.distance
        reach = depth * self.parallel_scale
        inside = (np.abs(eye[0]) <= aspect * reach) & (np.abs(eye[1]) <= reach)
        return bool(inside.all())

    def seen_at(
        self, points: NDArray[Any], quads: NDArray[Any], x: float, y: float
    ) -> tuple[float, float, float] | None:
        """Return the nearest point of a mesh at (x, y), in half-heights from the middle.

        ``points`` (P, 3) and ``quads`` (Q, 4). It is seen just there, as far away as the middle
        of the quad, which is enough to turn about. None where the mesh is not.
        """
        eye = self.basis @ (points.astype(np.float64) - np.asarray(self.focal)).T
        depth = 1.0 if self.parallel else 1.0 - eye[2] / self.distance
        seen = eye[:2] / (depth * self.parallel_scale) - np.array([[x], [y]])
        corners = seen[:, quads]
        inside = ((corners.min(axis=2) <= 0.0) & (corners.max(axis=2) >= 0.0)).all(axis=0)
        if not inside.any():
            return None
        z = float(eye[2][quads[inside]].mean(axis=1).max())
        scale = self.parallel_scale * (1.0 if self.parallel else 1.0 - z / self.distance)
        return _triple(np.asarray(self.focal) + (x * scale, y * scale, z) @ self.basis)

    def carried_to(self, axis: Axis) -> Pose:
        """Return the pose that sees an object turned to another axis as this one saw it before."""
        turn = axis_frame(axis).T @ axis_frame(self.axis)
        focal, pivot = turn @ np.asarray(self.focal), turn @ np.asarray(self.pivot)
        return replace(self, axis=axis, focal=_triple(focal), pivot=_triple(pivot))

    def apply(self, camera: Any, centre: Vector, radius: float) -> None:
        """Set a vtkCamera to this pose, clipped to the ball that holds everything drawn."""
        camera.SetFocalPoint(*self.focal)
        camera.SetPosition(*self.position)
        camera.SetViewUp(*self.basis[1])
        camera.SetViewAngle(np.degrees(VIEW_ANGLE * self.opening))
        camera.SetParallelProjection(self.parallel)
        camera.SetParallelScale(self.parallel_scale)
        depth = float(self.basis[2] @ (self.position - centre))
        reach = 1.02 * radius
        if self.parallel:
            camera.SetClippingRange(depth - reach, depth + reach)
        else:
            # Nearer than this part of the range the depth buffer would lose its precision.
            far = max(depth + reach, 1e-3 * reach)
            camera.SetClippingRange(max(depth - reach, 1e-3 * far), far)


def standard_pose(axis: Axis, view: str = "iso", parallel: bool = False) -> Pose:
    """Return a pose with one of the directions of :data:`STANDARD_VIEWS`, to be fitted."""
    azimuth, elevation = STANDARD_VIEWS[view].direction
    return Pose(axis, azimuth, elevation, 1.0, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), parallel)


def _triple(vector: Vector) -> tuple[float, float, float]:
    return float(vector[0]), float(vector[1]), float(vector[2])
