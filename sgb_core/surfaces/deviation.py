"""How far a mesh lies from the surface it stands for, measured apart from how it was made."""

from __future__ import annotations

from math import pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sections import Sections

# Samples of each segment that the search for the nearest point starts from.
COARSE = 64
CHUNK = 2048


def deviation(mesh: Mesh, surface: RevolutionSurface, triangles: int = 50_000) -> float:
    """Return the largest distance from points of the mesh to the true surface.

    Fifteen points of each triangle are measured (corners, quarters of the edges, inner), of at most
    about ``triangles`` triangles evenly picked. The nearest point is sought within the meridian
    plane: exact for a full turn of one section, else an upper bound.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> mesh = sgb.tessellate(cylinder.surface, samples=(1, 32))
    >>> round(sgb.deviation(mesh, cylinder.surface), 4), round(10 * (1 - math.cos(math.pi / 32)), 4)
    (0.0482, 0.0482)
    """
    corners = mesh.positions[mesh.faces[:: max(1, len(mesh.triangles) // triangles)]]
    weights = np.array([(i, j, 4 - i - j) for i in range(5) for j in range(5 - i)]) / 4.0
    points = (weights @ corners).reshape(-1, 3)
    return float(distances(points, surface).max())


def distances(points: Floats, surface: RevolutionSurface) -> Floats:
    """Return the distance of each point, shape (P, 3), to the surface, within its meridian."""
    moved = (points - np.asarray(surface.placement.translation)) @ surface.placement.matrix
    height, cosine, sine = surface.axis.frame
    h = moved[:, height]
    rho = np.hypot(moved[:, cosine], moved[:, sine])
    theta = np.arctan2(moved[:, sine], moved[:, cosine]) - surface.start
    stretch: Floats | float = 1.0
    if surface.twisting is not None:
        # Slices are turned back; what lies d away and off its own height may lie farther again.
        theta = theta - surface.twisting.angle(h)
        stretch = np.hypot(1.0, rho * surface.twisting.rate(h)) if surface.laws else 1.0
    # A point belongs to the meridian it lies on or, where r < 0, to the opposite one.
    nearest = np.minimum(
        _meridian_distances(rho, theta, h, surface),
        _meridian_distances(rho, theta + pi, h, surface, -1.0),
    )
    return np.asarray(stretch * nearest)


def _meridian_distances(
    rho: Floats, theta: Floats, h: Floats, surface: RevolutionSurface, side: float = 1.0
) -> Floats:
    turned = np.mod(theta, 2.0 * pi)
    # Beyond the sweep the nearer of its two ends counts.
    past = turned > surface.sweep
    nearer_start = past & (2.0 * pi - turned < turned - surface.sweep)
    clamped = np.where(past, np.where(nearer_start, 0.0, surface.sweep), turned)
    r = side * rho * np.cos(turned - clamped)
    aside = rho * np.sin(turned - clamped)
    targets = np.stack([r, h], axis=-1)
    if surface.laws:
        return np.asarray(np.hypot(_to_sections(targets, clamped, surface), aside))
    # A turn repeats the same few distances; they are looked up once.
    grain = 1e-12 * surface.profile.size
    keys = np.round(targets / (grain or 1.0))
    _, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    found = _to_sections(targets[first], clamped[first], surface)[inverse.ravel()]
    return np.asarray(np.hypot(found, aside))


def _to_sections(targets: Floats, theta: Floats, surface: RevolutionSurface) -> Floats:
    """Return distances in the half-plane from (P, 2) points to the sections at (P,) angles."""
    result = np.empty(len(targets))
    for start in range(0, len(targets), CHUNK):
        part = slice(start, start + CHUNK)
        sections = surface.sections(theta[part]) if surface.laws else surface.section[None]
        result[part] = _nearest(targets[part], sections)
    return result


def _nearest(targets: Floats, sections: Sections) -> Floats:
    """Return distances from (P, 2) points to sections (P or 1, n): search, then refine."""
    coarse = sections.on(np.linspace(0.0, 1.0, COARSE + 1))
    # Chords, not samples, are compared: two segments share the sample at their joint.
    chord = np.diff(coarse, axis=-2)
    square = np.maximum((chord * chord).sum(axis=-1), np.finfo(float).tiny)
    step = targets[:, None, None, :] - coarse[..., :-1, :]
    along = np.clip((step * chord).sum(axis=-1) / square, 0.0, 1.0)
    step -= along[..., None] * chord
    best = np.argmin((step * step).sum(axis=-1).reshape(len(targets), -1), axis=1)
    rows = np.arange(len(targets))
    segment, k = np.divmod(best, COARSE)
    chosen = sections[rows if len(sections) > 1 else np.zeros_like(rows), segment]
    middle, reach = (k + along[rows, segment, k]) / COARSE, 1.0 / COARSE
    result = np.full(len(targets), np.inf)
    offsets = np.linspace(-1.0, 1.0, 9)
    # Each pass narrows the bracket to a quarter: fifteen reach 1e-11 of a segment.
    for _ in range(15):
        tries = np.clip(middle[:, None] + reach * offsets, 0.0, 1.0)
        step = chosen.on(tries) - targets[:, None, :]
        gaps = np.hypot(step[..., 0], step[..., 1])
        best = np.argmin(gaps, axis=1)
        middle = tries[rows, best]
        result = np.minimum(result, gaps[rows, best])
        reach /= 4.0
    return np.asarray(result)
