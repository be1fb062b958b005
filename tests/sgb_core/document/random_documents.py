"""Random project files of all kinds, the degenerate ones too, each made from its number alone."""

from __future__ import annotations

from typing import Any

import numpy as np

from sgb_core.surfaces.laws.law import RADIUS
from sgb_core.surfaces.laws.shapes import SHAPES

TOPS = {"lambda1": 4.0, "lambda2": 6.0, "lambda3": 4.0, "omega": 1.0}
RULES = ("free", "G0", "G1", "C1", "G2")
# Sizes and lengths that nobody would choose, and those that everybody does.
SIZES = (1.0, 50.0, 50.0, 50.0, 1e-6, 1e-3, 1e3, 1e7)
SWEEPS = (360.0, 360.0, 360.0, 180.0, 270.0, 90.0, 1e-12, 1e-6, 359.999999)
STARTS = (0.0, 0.0, 30.0, -90.0, 1e9, -1e9, 123456.789, 1e-9)


def random_project(number: int) -> dict[str, Any]:
    """Return the plain object of a project file; the same number gives the same file."""
    rng = np.random.default_rng(number)
    points, closed = _points(rng)
    size = float(rng.choice(SIZES))
    points = points * size / 50.0
    count = len(points)
    tree: dict[str, Any] = {
        "format": "sgb-document",
        "version": 1,
        "profile": {
            "closed": closed,
            "segments": [{"points": each.tolist(), **_shape(rng)} for each in points],
            "joints": [
                str(rng.choice(RULES if rng.random() < 0.3 else ("G0",)))
                for _ in range(count if closed else count - 1)
            ],
        },
        "revolution": {
            "axis": str(rng.choice(["x", "y", "z"])),
            "start_deg": float(rng.choice(STARTS)),
            "sweep_deg": float(rng.choice(SWEEPS) if rng.random() < 0.8 else rng.uniform(1, 360)),
        },
    }
    if rng.random() < 0.4:
        tree["variation"] = [_law(rng, count) for _ in range(rng.integers(1, 4))]
    if rng.random() < 0.75:
        tree["solid"] = _solid(rng, size)
    if rng.random() < 0.2:
        tree["placement"] = {
            "rotation_deg": rng.uniform(-180, 180, 3).tolist(),
            "translation": (rng.uniform(-9, 9, 3) * size).tolist(),
        }
    return tree


def _points(rng: np.random.Generator) -> tuple[np.ndarray, bool]:
    """Return control points (n, 4, 2) some 50 across, and whether they close."""
    count = int(rng.integers(1, 6))
    kind = rng.choice(["pot", "pot", "wild", "grid", "lines", "flat", "axis", "ring", "beyond"])
    steps = 3 * count + 1
    heights = np.cumsum(rng.uniform(0.0, 60.0 / steps, steps))
    chain = np.stack([rng.uniform(5, 40, steps), heights], axis=1)
    if kind == "wild":
        chain = rng.uniform(0, 50, (steps, 2))
    elif kind == "grid":
        chain = rng.integers(0, 4, (steps, 2)) * 12.5
    elif kind == "lines":
        chain = _thirds(chain[::3])
    elif kind == "flat":
        chain[:, 1] = rng.choice([0.0, 0.0, 1e-9, 1e-3]) * rng.uniform(0, 50, steps)
    elif kind == "axis":
        chain[rng.random(steps) < 0.3, 0] = 0.0
    elif kind == "beyond":
        chain[:, 0] -= rng.uniform(0, 30)
    closed = kind == "ring"
    if closed:
        turn = np.linspace(0, 2 * np.pi, steps) * rng.choice([-1.0, 1.0])
        reach = rng.uniform(4, 16, steps)
        chain = np.stack([20 + reach * np.cos(turn), 20 + reach * np.sin(turn)], axis=1)
        chain[-1] = chain[0]
    elif rng.random() < 0.4:
        chain[0, 0] = 0.0
    if not closed and rng.random() < 0.25:
        chain[-1, 0] = 0.0
    if rng.random() < 0.3:
        # Legs of no length, segments that are points.
        for k in rng.integers(0, steps - 1, int(rng.integers(1, 4))):
            chain[k] = chain[k + 1]
        if closed:
            chain[-1] = chain[0]
    if rng.random() < 0.2:
        chain = chain[::-1]
    return np.stack([chain[3 * k : 3 * k + 4] for k in range(count)]), closed


def _thirds(corners: np.ndarray) -> np.ndarray:
    """Return the control points of straight segments between corners."""
    parts = [corners[:-1] + np.diff(corners, axis=0) * (k / 3) for k in range(3)]
    return np.concatenate([np.stack(parts, axis=1).reshape(-1, 2), corners[-1:]])


def _shape(rng: np.random.Generator) -> dict[str, Any]:
    def value(top: float) -> float:
        return float(rng.choice([0.0, top]) if rng.random() < 0.3 else rng.uniform(0, top))

    one, two, three, omega = map(value, TOPS.values())
    return {"lambda": [one, two, three], "omega": omega}


def _law(rng: np.random.Generator, count: int) -> dict[str, Any]:
    name, kind = str(rng.choice(list(TOPS))), str(rng.choice(list(SHAPES)))
    low, high = (
        float(rng.choice([0.0, TOPS[name]]) if rng.random() < 0.3 else rng.uniform(0, TOPS[name]))
        for _ in range(2)
    )
    if rng.random() < 0.25:
        name, low, high = RADIUS, *rng.uniform(0.7, 1.4, 2).tolist()
    law: dict[str, Any] = {"parameter": name, "law": kind, "from": low, "to": high}
    law["segments"] = "all" if rng.random() < 0.5 else [int(rng.integers(count))]
    uses = SHAPES[kind].uses
    if "count" in uses:
        law["n"] = max(SHAPES[kind].least_count, int(rng.choice([1, 2, 3, 5, 8, 40])))
    if "flank" in uses:
        law["flank"] = float(rng.uniform(0.01, 1.0) * 180.0 / law["n"])
    for share in ("sharp", "round"):
        if share in uses:
            law[share] = float(rng.choice([0.0, 1.0, rng.random()]))
    if "keyframes" in uses:
        keys = int(rng.integers(1, 6))
        law["keyframes"] = np.stack([rng.uniform(0, 360, keys), rng.random(keys)], axis=1).tolist()
    return law


def _solid(rng: np.random.Generator, size: float) -> dict[str, Any]:
    wall = size * float(np.exp(rng.uniform(np.log(0.002), np.log(0.4))))
    if rng.random() < 0.05:
        wall = float(rng.choice([1e-9, 1e9]))

    def length(often: float) -> float:
        share = float(rng.choice([0.5, 1.0, 2.0, 20.0]))
        return min(share * wall, 1e9) if rng.random() < often else 0.0

    return {
        "kind": str(rng.choice(["filled", "vessel", "vessel"])),
        "wall": wall,
        "side": str(rng.choice(["inside", "outside"])),
        "base": length(0.7),
        "rim": str(rng.choice(["flat", "round"])),
        "drain_hole": length(0.2),
        "foot_ring": length(0.2),
    }
