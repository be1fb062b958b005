"""Points that mirror themselves give a chain that does."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.tracing.chain import (
    END,
    END_ANGLE,
    END_PULL,
    END_PUSH,
    SHARE,
    START,
    START_ANGLE,
    START_PULL,
    START_PUSH,
    Chain,
    Layout,
)

# Of the tolerance: what rounding leaves of a symmetry.
_ROUNDING = 1e-3
_MIRROR = np.array([1.0, -1.0])


def is_symmetric(points: Floats, tolerance: float) -> bool:
    """Whether points, shape (N, 2), about h = 0 are their own mirror image, run backwards."""
    mirrored = points[::-1] * _MIRROR
    return bool(np.abs(points - mirrored).max() <= _ROUNDING * tolerance)


def mirrored(chain: Chain) -> Chain:
    """Return the mirror image about h = 0 of a chain, run backwards."""
    frames = chain.frames[::-1]
    image = np.empty_like(frames)
    image[:, START], image[:, END] = frames[:, END] * _MIRROR, frames[:, START] * _MIRROR
    # Backwards and mirrored: (cos φ, sin φ) becomes (−cos φ, sin φ).
    image[:, START_ANGLE] = np.pi - frames[:, END_ANGLE]
    image[:, END_ANGLE] = np.pi - frames[:, START_ANGLE]
    image[:, START_PULL], image[:, END_PULL] = frames[:, END_PULL], frames[:, START_PULL]
    image[:, START_PUSH], image[:, END_PUSH] = frames[:, END_PUSH], frames[:, START_PUSH]
    image[:, SHARE] = 1.0 - frames[:, SHARE]
    return Chain(_mirrored_layout(chain.layout), image)


def symmetrized(chain: Chain) -> Chain | None:
    """Return the mean of a chain and its mirror image, or None where they have other corners."""
    image = mirrored(chain)
    if image.layout != chain.layout:
        return None
    other = image.frames.copy()
    for column in (START_ANGLE, END_ANGLE):
        turns = np.round((other[:, column] - chain.frames[:, column]) / (2.0 * np.pi))
        other[:, column] -= 2.0 * np.pi * turns
    return Chain(chain.layout, 0.5 * (chain.frames + other))


def _mirrored_layout(layout: Layout) -> Layout:
    last = layout.count - 1
    corners = frozenset((layout.count - node) % layout.nodes for node in layout.corners)
    straight = frozenset(last - segment for segment in layout.straight)
    return replace(layout, corners=corners, straight=straight, level=layout.level[::-1])
