"""The drawn surface as a printer sees it: in millimetres, upright, standing at height 0."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.solid import BodyKind, WallSide
from sgb_core.document.manufacture import Stage
from sgb_core.document.model import Document
from sgb_core.findings.toolpaths import CrossesAxis, FallingWall, NoPath
from sgb_core.surfaces.normals import surface_normals
from sgb_core.surfaces.sections import Sections
from sgb_core.surfaces.twist import Twisting
from sgb_core.toolpaths.errors import ToolpathError
from sgb_core.toolpaths.raised import Raised
from sgb_core.values import dataclass

# Angles at which a surface with laws is looked at before its path is made.
LOOKS = 240
# Places along each segment at which it is looked at.
_NODES = np.linspace(0.0, 1.0, 97)


@dataclass(frozen=True, slots=True, eq=False)
class Drawn:
    """Sections at some angles, run upwards: from the foot of the wall to its rim.

    ``sections`` have the shape (m, n), m the number of angles or 1
    where no law holds; ``numbers`` are the document's numbers of the n segments and ``first`` the
    s of the lowest of them at which the wall starts, ``scale`` is what the document's lengths were
    multiplied by, ``ground`` the height, so scaled, that lies at 0, and ``size`` the diagonal of
    the box around the profile. ``twisting`` turns the slices; None where that shows nothing.
    ``raised`` is the relief, ``theta`` (m,) the sections' angles from the start, ``backwards``
    tells that the segments are run against the document's.
    """

    sections: Sections
    numbers: tuple[int, ...]
    first: float
    scale: float
    ground: float
    size: float
    theta: Floats
    backwards: bool
    twisting: Twisting | None = None
    raised: Raised | None = None

    @property
    def rim(self) -> float:
        """The height of the rim."""
        return float(self.sections.quartics[0, -1, 4, 1])

    def moved(self, row: np.ndarray, segment: np.ndarray, s: Floats, distance: float) -> Floats:
        """Return points of the surface moved inwards along its normal, shape (k, 4).

        ``row``, ``segment`` and ``s``, shape (k,), say at which angle and where on its section.
        The first three are the distances from the axis, along the turn and along the axis, of the
        half-plane at that angle: with laws the normal has a part along the turn. The fourth is
        by how many radians a twist turns that half-plane.
        """
        curves = self.sections[row, segment]
        point, tangent = curves.of_each(s), curves.tangents_of_each(s, self.size)
        slip = np.zeros(len(s))
        if self.sections.rates.any():
            change = curves.changes_of_each(s)
            slip = change[:, 0] * tangent[:, 1] - change[:, 1] * tangent[:, 0]
        normal = surface_normals(tangent, slip, point[:, 0], np.ones(len(s)), self.size)
        if self.twisting is not None:
            normal = self.twisting.normals(normal, point)
        flat = np.stack([point[:, 0], np.zeros(len(s)), point[:, 1]], axis=-1)
        inwards = distance - self.heights(row, segment, s)
        return np.column_stack([flat - inwards[:, None] * normal, self.turned(point[:, 1])])

    def heights(self, row: np.ndarray, segment: np.ndarray, s: Floats) -> Floats:
        """Return how far the relief raises places of sections, in mm, shape (k,)."""
        if self.raised is None:
            return np.zeros(len(s))
        places = 1.0 - s if self.backwards else s
        shares = self.theta[row] / (2.0 * pi)
        return self.scale * self.raised.at(shares, np.asarray(self.numbers)[segment], places)

    def turned(self, height: Floats) -> Floats:
        """Return by how many radians the slices at heights (mm) of the surface are turned."""
        if self.twisting is None:
            return np.zeros(len(height))
        return self.twisting.angle(height)

    def tangents(self, row: np.ndarray, segment: int, s: Floats) -> Floats:
        """Return unit tangents of a segment at angles of numbers ``row``, each at its own s."""
        return self.sections[row, segment].tangents_of_each(s, self.size)


def scale_of(document: Document, stage: Stage) -> float:
    """Return how many mm a length of 1 is at a stage."""
    return document.unit.millimetres * document.manufacture.shrinkage.factor(stage)


def drawn(document: Document, theta: Floats, stage: Stage, raised: Raised | None = None) -> Drawn:
    """Return the wall of a document at angles θ (radians from the start), at a stage's size.

    Without laws and relief one section stands for all angles. Raises ToolpathError for what has
    no wall that can be climbed: a part turn, a ring, a gap, a profile across the axis or one that
    falls.
    """
    profile, laws = document.profile, document.variation
    refuse_open(document)
    scale = scale_of(document, stage)
    surface = document.surface
    theta = np.mod(theta, 2.0 * pi)
    sections = surface.sections(theta) if laws else surface.section[None]
    if raised is not None and not laws:
        sections = sections[np.zeros(len(theta), dtype=np.intp)]
    sections = sections.moved(scale, 0.0)
    numbers = np.arange(len(profile))
    backwards = bool(sections.quartics[0, -1, 4, 1] < sections.quartics[0, 0, 0, 1])
    if backwards:
        sections, numbers = sections.backwards(), numbers[::-1]
    points = sections.on(_NODES)
    _refuse_crossing(points, numbers, profile.size * scale)
    foot = float(sections.quartics[0, 0, 0, 1])
    ground = _ground(document, float(points[..., 1].min()), foot, scale)
    segment, first = _wall_start(points)
    return Drawn(
        sections[:, segment:].moved(1.0, -ground),
        tuple(numbers[segment:].tolist()),
        first,
        scale,
        ground,
        profile.size * scale,
        theta,
        backwards,
        _twisting(document, scale, ground) if laws or raised is not None else None,
        raised,
    )


def refuse_open(document: Document) -> None:
    """Raise ToolpathError for what is no one wall, closed around the axis, from foot to rim."""
    profile = document.profile
    if document.revolution.sweep_deg != 360.0:
        raise ToolpathError(NoPath.PART_TURN)
    if profile.closed:
        raise ToolpathError(NoPath.RING)
    if any(gap > 1e-9 * profile.size for gap in profile.gaps):
        raise ToolpathError(NoPath.GAP)


def _twisting(document: Document, scale: float, ground: float) -> Twisting | None:
    """Return the twist in millimetres."""
    found = document.surface.twisting
    if found is None:
        return None
    return replace(found, low=scale * found.low - ground, high=scale * found.high - ground)


def _ground(document: Document, lowest: float, foot: float, scale: float) -> float:
    solid = document.solid
    if solid.kind is BodyKind.VESSEL and solid.side is WallSide.OUTSIDE:
        return min(lowest, foot - solid.base * scale)
    return lowest


def _refuse_crossing(points: Floats, numbers: np.ndarray, size: float) -> None:
    r = points[..., 0]
    if (r < -1e-9 * size).any():
        _, segment, node = np.unravel_index(int(r.argmin()), r.shape)
        raise ToolpathError(CrossesAxis(int(numbers[segment]), float(_NODES[node])))


def _wall_start(points: Floats) -> tuple[int, float]:
    """Return (segment, s) above which every section climbs all the way to its rim.

    ``points`` has the shape (m, n, k, 2). What lies below, a level or hollow bottom, is no wall.
    """
    heights = points[..., 1].reshape(len(points), -1)
    size = float(np.ptp(points.reshape(-1, 2), axis=0).max())
    falls = np.asarray((np.diff(heights, axis=1) <= 1e-12 * size).any(axis=0))
    # Between two segments the height stays.
    per_segment = len(_NODES)
    falls[per_segment - 1 :: per_segment] = False
    bad = np.flatnonzero(falls)
    start = int(bad[-1]) + 1 if len(bad) else 0
    if start >= heights.shape[1] - 1:
        raise ToolpathError(NoPath.FALLS_AT_RIM)
    segment, node = divmod(start, per_segment)
    if node == per_segment - 1:
        segment, node = segment + 1, 0
    return segment, float(_NODES[node])


def refuse_falling(wall: Drawn, start: float) -> None:
    """Raise ToolpathError where the wall does not climb from height ``start`` on."""
    at = np.array([wall.first])
    zero = np.zeros(1, dtype=np.intp)
    foot = float(wall.moved(zero, zero, at, 0.0)[0, 2])
    if foot > start + 2e-3 * wall.size:
        raise ToolpathError(FallingWall(wall.numbers[0], foot))
