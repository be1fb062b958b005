"""Small documents made by hand, for the tests of this package."""

from __future__ import annotations

import json
from collections.abc import Iterable

import numpy as np

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import NEUTRAL, Segment, ShapeParameters
from sgb_core.document.model import Document
from sgb_core.surfaces.variation import Law

# A vase of three segments: smooth joints at (6, 4) and (3, 8).
VASE = (
    [[4, 0], [5, 1], [6, 2], [6, 4]],
    [[6, 4], [6, 6], [3, 6], [3, 8]],
    [[3, 8], [3, 9], [4, 10], [5, 10]],
)
# The two halves of a ring, both running upwards, as the paper prints them.
HALVES = (
    [[5, 0], [8, 0], [8, 4], [5, 4]],
    [[5, 0], [2, 0], [2, 4], [5, 4]],
)


def document(
    points: Iterable[object] = VASE,
    rules: Iterable[str] = (),
    closed: bool = False,
    shape: ShapeParameters = NEUTRAL,
    laws: tuple[Law, ...] = (),
) -> Document:
    segments = [Segment(np.array(p, dtype=float), shape) for p in points]
    return Document(Profile.of(segments, rules, closed), variation=laws)


def tree(**changes: object) -> dict:
    """Return a valid file of one segment as plain values, with top-level keys changed."""
    return {
        "format": "sgb-document",
        "version": 1,
        "profile": {"segments": [{"points": [[1, 0], [2, 1], [2, 2], [1, 3]]}]},
        **changes,
    }


def data(tree: object) -> bytes:
    return json.dumps(tree).encode()
