"""The mirror image of a chain of segments as a map of the numbers that describe it."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi, tau

import numpy as np

from sgb_core.arrays import Floats

# A number of the vector: what it is, of which segment, joint or end, and which coordinate.
Name = tuple[str, int, int]

# What becomes what when a chain is mirrored in height and run through backwards.
_IMAGE = {"before": "after", "after": "before", "P1": "P2", "P2": "P1"}


def symmetric_vectors(
    names: Sequence[Name],
    near: Floats,
    count: int,
    closed: bool,
    smooth: Sequence[bool],
    twice_middle: float,
) -> tuple[Floats, Floats] | None:
    """Return base (N,) and spread (N, M) of the vectors that are their own mirror image.

    The mirror lies at half of ``twice_middle``. A ring has as many mirrorings as segments; the one
    nearest to the vector ``near`` counts. None where the joints' rules are not symmetric.
    """
    best: tuple[float, Floats, Floats, Floats] | None = None
    for turn in range(count) if closed else (count - 1,):
        joints = [(turn - joint - 1) % count for joint in range(len(smooth))]
        if any(smooth[joint] != smooth[image] for joint, image in enumerate(joints)):
            continue
        image, sign, shift = _mirrored(names, near, count, turn, twice_middle)
        off = float(np.abs(near - (sign * near[image] + shift)).max())
        if best is None or off < best[0] - 1e-9:
            best = off, image, sign, shift
    return None if best is None else _fixed_vectors(*best[1:])


def _mirrored(
    names: Sequence[Name], near: Floats, count: int, turn: int, twice_middle: float
) -> tuple[Floats, Floats, Floats]:
    """Return what a mirrored vector is: sign · vector[image] + shift."""
    place = {name: k for k, name in enumerate(names)}
    image, sign, shift = np.zeros(len(names), dtype=int), np.ones(len(names)), np.zeros(len(names))
    for k, (what, number, part) in enumerate(names):
        if what == "fraction":
            partner: Name = (what, (turn - number) % count, 2 - part)
            sign[k], shift[k] = (-1.0, 1.0) if part == 1 else (1.0, 0.0)
        elif what in ("pole", "outer", "free"):
            partner = (what, 1 - number, part)
        else:
            partner = (_IMAGE.get(what, what), (turn - number - 1) % count, part)
        image[k] = place[partner]
        if what == "pole" or (part == 1 and what in ("joint", "P1", "P2", "free")):
            sign[k], shift[k] = -1.0, twice_middle
        elif what == "angle":
            turns = round((near[k] + near[image[k]] - pi) / tau)
            sign[k], shift[k] = -1.0, pi + tau * turns
    return image, sign, shift


def _fixed_vectors(image: Floats, sign: Floats, shift: Floats) -> tuple[Floats, Floats]:
    """Return base and spread of the vectors that a mirroring leaves as they are."""
    count = len(image)
    base, columns = np.zeros(count), []
    for k, other in enumerate(image.tolist()):
        if other < k:
            continue
        if other == k and sign[k] < 0.0:
            base[k] = shift[k] / 2.0
            continue
        column = np.zeros(count)
        column[k] = 1.0
        if other != k:
            column[other], base[other] = sign[other], shift[other]
        columns.append(column)
    return base, np.stack(columns, axis=1)
