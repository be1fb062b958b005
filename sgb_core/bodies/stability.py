"""How a body stands and how it prints: centre of mass, foot, overhang. From a closed mesh."""

from __future__ import annotations

from math import atan2, degrees, radians, sin

import numpy as np
import shapely

from sgb_core.arrays import Floats
from sgb_core.findings.bodies import NoBody
from sgb_core.findings.errors import FindingError
from sgb_core.surfaces.mesh import Mesh
from sgb_core.values import dataclass

# What is within this share of the size of the lowest point touches the ground.
GROUND = 1e-3


@dataclass(frozen=True, slots=True)
class Stand:
    """A body on level ground.

    ``centre`` (3,) is its centre of mass, ``height`` how far that is above the ground, ``margin``
    the distance in the plane from under it to the nearest edge of what touches the ground (below
    0 outside), ``tip_deg`` by how far the body can be tilted before it falls.
    """

    centre: Floats
    height: float
    margin: float
    tip_deg: float

    @property
    def stands(self) -> bool:
        """Whether the centre of mass is over the foot."""
        return self.margin > 0.0


def centre_of_mass(mesh: Mesh) -> Floats:
    """Return the centre of what a closed mesh encloses, shape (3,): that of its tetrahedra.

    Raises FindingError for a mesh that encloses nothing.
    """
    low, high = mesh.bounds
    middle = (low + high) / 2.0
    a, b, c = np.moveaxis(mesh.positions[mesh.faces] - middle, 1, 0)
    volumes = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6.0
    total = float(volumes.sum())
    if abs(total) <= 1e-12 * float(np.linalg.norm(high - low)) ** 3:
        raise FindingError(NoBody.WEIGHTLESS)
    return np.asarray(middle + (volumes[:, None] * (a + b + c) / 4.0).sum(axis=0) / total)


def stand(mesh: Mesh, directions: Floats) -> Stand:
    """Return how a closed mesh stands; ``directions`` (3, 3) are two level ones, then up.

    The foot is the convex hull of all that lies within 1e-3 of the size above the lowest point.
    """
    centre = centre_of_mass(mesh)
    heights = mesh.positions @ directions[2]
    low = float(heights.min())
    size = float(np.ptp(mesh.positions, axis=0).max())
    level = mesh.positions[heights <= low + GROUND * size] @ directions[:2].T
    foot = shapely.convex_hull(shapely.multipoints(level))
    under = shapely.Point(*(directions[:2] @ centre))
    inside = isinstance(foot, shapely.Polygon) and bool(foot.contains(under))
    edge = foot.exterior if isinstance(foot, shapely.Polygon) else foot
    margin = float(edge.distance(under)) * (1.0 if inside else -1.0)
    height = float(directions[2] @ centre) - low
    # Nearer than what the mesh resolves is a foot that is only a point.
    margin = 0.0 if abs(margin) < GROUND * size else margin
    return Stand(centre, height, margin, max(0.0, degrees(atan2(margin, height))))


def overhang(mesh: Mesh, up: Floats, limit_deg: float) -> float:
    """Return the share of the area that leans over by more than an angle from the vertical.

    0° counts all that faces down, 90° only what faces straight down. What lies on the ground is
    printed on the bed and does not count as overhang.
    """
    heights = mesh.positions @ up
    size = float(np.ptp(heights)) or 1.0
    on_bed = (heights[mesh.faces] <= heights.min() + 1e-6 * size).all(axis=1)
    doubled = np.linalg.norm(mesh.triangle_normals, axis=1)
    down = -(mesh.triangle_normals @ up)
    leaning = (down > sin(radians(limit_deg)) * doubled + 1e-9 * doubled) & ~on_bed
    total = float(doubled.sum())
    return float(doubled[leaning].sum()) / total if total > 0.0 else 0.0
