"""The directions in which a profile can still go while all locks and joints' rules hold."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.design.demands.chain import Chain
from sgb_core.design.locks.columns import Columns

# Places on each segment by which it is told how far a curve goes.
_PLACES = 9
# Equations whose slopes are smaller than this part of the largest are met by others already;
# directions that move the curve less than this part of what the first moves it are not shown.
_RANK, _SEEN = 1e-9, 1e-3


def displacements(chain: Chain, columns: Columns) -> Floats:
    """Return how far along its normal each unknown moves the curve, (places, m), in sizes.

    At equal steps of s on each segment: with Q the quartic points, δL = Σ Bᵢ⁴ ∂Qᵢ/∂y, and what
    goes along the tangent is no change of shape. Where the tangent vanishes the place is left out.
    """
    s = np.linspace(0.0, 1.0, _PLACES)
    rows = basis.bernstein(4, s)
    quartics, moves = chain.quartics, chain.slopes()
    count, numbers = len(chain), moves.shape[2]
    tangents = 4.0 * basis.bernstein(3, s) @ np.diff(quartics, axis=1)
    lengths = np.hypot(tangents[..., 0], tangents[..., 1])
    safe = np.where(lengths > _RANK, lengths, 1.0)
    normals = np.stack([-tangents[..., 1], tangents[..., 0]], axis=-1) / safe[..., None]
    normals[lengths <= _RANK] = 0.0
    shifts = np.einsum("sq,nqkj->nskj", rows, moves.reshape(count, 5, 2, numbers))
    across = np.einsum("nsk,nskj->nsj", normals, shifts)
    whole = np.zeros((count, _PLACES, count, numbers))
    whole[range(count), :, range(count)] = across
    return columns.gathered(whole.reshape(count * _PLACES, count * numbers))


def free_directions(slope: Floats, moved: Floats, cost: Floats, most: int) -> tuple[Floats, Floats]:
    """Return directions of the unknowns that no equation sees, and how far each moves the curve.

    ``slope`` (k, m) are the equations', ``moved`` (places, m) the curve's displacements by the
    unknowns, ``cost`` (m,) what a unit of each unknown costs. The null space of the equations,
    told in costs, is turned so that the first of its directions (d, m), each of cost 1, moves the
    curve farthest (root of the mean square, in sizes), the second farthest of what is left, and
    so on: the right singular vectors of the displacements on it.
    """
    scaled = slope / cost
    sizes = np.sqrt((scaled**2).sum(axis=1))
    scaled = scaled[sizes > _RANK] / sizes[sizes > _RANK][:, None]
    null = np.eye(len(cost))
    if len(scaled):
        _, parts, rows = np.linalg.svd(scaled)
        null = rows[int((parts > _RANK * parts[0]).sum()) :].T
    if null.shape[1] == 0:
        return np.zeros((0, len(cost))), np.zeros(0)
    _, reach, turned = np.linalg.svd((moved / cost) @ null, full_matrices=False)
    reach = reach / np.sqrt(len(moved))
    seen = np.flatnonzero(reach > _SEEN * max(float(reach[0]), 1e-300))[:most]
    return (turned[seen] @ null.T) / cost, reach[seen]
