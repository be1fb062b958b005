"""From the cursor in the viewport to the profile's half-plane in space, and back.

Places on the screen are logical pixels from the widget's top left. Nothing here draws.
"""

from __future__ import annotations

from math import cos, hypot, radians, sin, tau

import numpy as np
from numpy.typing import ArrayLike

from app.hand.coordinates import DesignPoint, ScreenPoint
from app.scene.camera import Pose
from sgb_core.arrays import Floats
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

# Seen at a smaller angle than this the half-plane counts as seen edge-on: a pixel of the hand
# would lead ten times as far into the depth.
EDGE_ON = sin(radians(6.0))
# A direction seen so nearly along one of the plane's own is taken to be it.
NEARLY = cos(radians(25.0))
# Where points behind the viewer are put: far from every cursor.
NOWHERE = 1e7


@dataclass(frozen=True, slots=True)
class Lens:
    """A pose and the picture's size in logical pixels: from space to the screen and back."""

    pose: Pose
    width: float
    height: float

    def to_screen(self, points: ArrayLike) -> Floats:
        """Return the pixels, shape (..., 2), where points of shape (..., 3) are seen."""
        pose = self.pose
        eye = (np.asarray(points, dtype=np.float64) - np.asarray(pose.focal)) @ pose.basis.T
        depth = np.ones(eye.shape[:-1]) if pose.parallel else 1.0 - eye[..., 2] / pose.eye_distance
        behind = depth < 1e-6
        scale = self.height / 2.0 / (np.where(behind, 1.0, depth) * pose.parallel_scale)
        places = np.stack(
            [self.width / 2.0 + eye[..., 0] * scale, self.height / 2.0 - eye[..., 1] * scale],
            axis=-1,
        )
        places[behind] = NOWHERE
        return places

    def ray(self, at: ScreenPoint) -> tuple[Floats, Floats]:
        """Return a point of the line of sight through a pixel and its unit direction inwards."""
        pose = self.pose
        half = self.height / 2.0
        x, y = (at.x - self.width / 2.0) / half, 1.0 - at.y / half
        right, up, back = pose.basis
        seen = np.asarray(pose.focal) + (right * x + up * y) * pose.parallel_scale
        if pose.parallel:
            return seen, -back
        eye = pose.position
        return eye, (seen - eye) / np.linalg.norm(seen - eye)


@dataclass(frozen=True, slots=True, eq=False)
class SpacePaper:
    """The profile's half-plane in space as seen on the screen: the 3-D counterpart of Transform.

    ``across`` and ``up`` are the directions of r and h. Where the plane is seen edge-on,
    ``held`` is the (r, h) direction along which things move instead, through ``anchor``.
    ``scale`` is pixels per unit at the anchor.
    """

    lens: Lens
    origin: Floats
    across: Floats
    up: Floats
    anchor: DesignPoint
    scale: float
    held: tuple[float, float] | None

    @classmethod
    def of(cls, surface: RevolutionSurface, lens: Lens, anchor: DesignPoint) -> SpacePaper:
        """Return the half-plane where the sweep starts, for dragging from ``anchor``."""
        across, _, up = surface.directions(np.asarray(surface.start))
        origin = np.asarray(surface.placement.translation, dtype=np.float64)
        place = origin + anchor.r * across + anchor.h * up
        step = 1e-3 * lens.pose.distance
        seen = lens.to_screen(np.stack([place, place + step * across, place + step * up]))
        scale = float(np.hypot(*(seen[1:] - seen[0]).T).max()) / step
        _, inwards = lens.ray(ScreenPoint(*seen[0].tolist()))
        held = None
        if abs(float(inwards @ np.cross(across, up))) < EDGE_ON:
            held = _across_view(float(inwards @ across), float(inwards @ up))
        return cls(lens, origin, across, up, anchor, max(scale, 1e-12), held)

    def in_space(self, points: ArrayLike) -> Floats:
        """Return (r, h) pairs of shape (..., 2) as points of space, shape (..., 3)."""
        pairs = np.asarray(points, dtype=np.float64)
        return np.asarray(self.origin + pairs[..., :1] * self.across + pairs[..., 1:] * self.up)

    def map(self, points: ArrayLike) -> Floats:
        """Return the pixels where (r, h) pairs are seen, both of shape (..., 2)."""
        return self.lens.to_screen(self.in_space(points))

    def to_design(self, point: ScreenPoint) -> DesignPoint:
        """Return the (r, h) under a pixel; where the plane is not under it, the anchor."""
        if self.held is not None:
            return self._along_held(point, self.held)
        start, inwards = self.lens.ray(point)
        normal = np.cross(self.across, self.up)
        slope = float(inwards @ normal)
        way = float((self.origin - start) @ normal) / slope if slope else 0.0
        if slope == 0.0 or (way <= 0.0 and not self.lens.pose.parallel):
            return self.anchor
        found = start + way * inwards - self.origin
        return DesignPoint(float(found @ self.across), float(found @ self.up))

    def _along_held(self, point: ScreenPoint, held: tuple[float, float]) -> DesignPoint:
        """Return the point of the line through the anchor that is seen nearest to a pixel."""
        base = self.in_space(self.anchor.pair)
        line = held[0] * self.across + held[1] * self.up
        step = 1e-3 * self.lens.pose.distance
        first, second = self.lens.to_screen(np.stack([base, base + step * line]))
        way = second - first
        squared = float(way @ way)
        if squared < 1e-18:
            return self.anchor
        reached = float((np.array((point.x, point.y)) - first) @ way) / squared
        foot = first + way * reached
        start, inwards = self.lens.ray(ScreenPoint(*foot.tolist()))
        # Where the line comes nearest to the line of sight through the foot.
        across = line - (line @ inwards) * inwards
        along = float((start - base) @ across) / float(across @ across)
        r, h = self.anchor.pair
        return DesignPoint(r + along * held[0], h + along * held[1])


def _across_view(r: float, h: float) -> tuple[float, float]:
    """Return the direction of the half-plane that lies across a view along (r, h)."""
    length = hypot(r, h)
    if length == 0.0:
        return 1.0, 0.0
    found = (-h / length, r / length)
    for own in ((1.0, 0.0), (0.0, 1.0)):
        if abs(found[0] * own[0] + found[1] * own[1]) > NEARLY:
            return own
    return found


@dataclass(frozen=True, slots=True, eq=False)
class Ring:
    """A circle about the surface's axis, on which the ends of the turn are grabbed."""

    centre: Floats
    cosine: Floats
    sine: Floats
    radius: float

    @classmethod
    def of(cls, surface: RevolutionSurface, radius: float, height: float) -> Ring:
        """Return the circle of a radius at a height of the profile."""
        across, around, up = surface.directions(np.asarray(0.0))
        centre = np.asarray(surface.placement.translation) + height * up
        return cls(centre, across, around, radius)

    def in_space(self, angles: ArrayLike) -> Floats:
        """Return the points at absolute angles in radians, shape (..., 3)."""
        angle = np.asarray(angles, dtype=np.float64)[..., None]
        turned = np.cos(angle) * self.cosine + np.sin(angle) * self.sine
        return np.asarray(self.centre + self.radius * turned)

    def angle_at(self, lens: Lens, at: ScreenPoint, near: float) -> float:
        """Return the angle in radians under a pixel, the turn of it that is nearest to ``near``.

        Seen edge-on it is the circle's point seen nearest to the pixel, on the side of ``near``.
        """
        start, inwards = lens.ray(at)
        normal = np.cross(self.cosine, self.sine)
        slope = float(inwards @ normal)
        found: float | None = None
        if abs(slope) > 2.0 * EDGE_ON:
            way = float((self.centre - start) @ normal) / slope
            if way > 0.0 or lens.pose.parallel:
                place = start + way * inwards - self.centre
                found = float(np.arctan2(place @ self.sine, place @ self.cosine))
        if found is None:
            angles = near + np.linspace(-1.2, 1.2, 481)
            away = lens.to_screen(self.in_space(angles)) - (at.x, at.y)
            found = float(angles[np.hypot(*away.T).argmin()])
        return near + (found - near + tau / 2.0) % tau - tau / 2.0
