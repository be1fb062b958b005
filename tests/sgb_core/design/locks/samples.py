"""Profiles that locks are tried on."""

from __future__ import annotations

import numpy as np

import sgb_core as sgb


def wavy(count: int, waves: float = 1.3, rule: str = "G1") -> sgb.Profile:
    """Return a smooth pot of some segments with a neck and a belly, 150 high."""
    at = np.arange(count + 1)
    places = np.stack([40.0 + 15.0 * np.sin(waves * at), np.linspace(0.0, 150.0, count + 1)], 1)
    rise = 150.0 / count
    legs = np.stack([15.0 * waves * np.cos(waves * at), np.full(count + 1, rise)], 1) / 3.0
    segments = [
        sgb.Segment([places[k], places[k] + legs[k], places[k + 1] - legs[k + 1], places[k + 1]])
        for k in range(count)
    ]
    return sgb.Profile.of(segments, [rule] * (count - 1))


def pot(count: int = 4) -> sgb.Document:
    """Return a vessel with a wall of 3 and a floor of 4."""
    document = sgb.Document(wavy(count), name="Pot")
    return sgb.edits.set_solid(document, kind="vessel", wall=3, base=4)


def locked(document: sgb.Document, *kinds: str) -> sgb.Document:
    """Return the document with dimensions of these kinds locked at what they measure."""
    for kind in kinds:
        document = sgb.edits.add_dimension(document, sgb.Dimension(kind))
        document = sgb.edits.set_lock(document, len(document.dimensions) - 1, True)
    return document
