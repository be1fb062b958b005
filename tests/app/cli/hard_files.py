"""Small project files of kinds that programs of this field fail on."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from tests.app.cli.files import project

PROFILE = [[20, 0], [55, 10], [50, 60], [25, 80]]
# Of these four, as both λ1 = λ3 = 4 and ω = 1, the end derivatives vanish.
STILL = {"lambda": [4, 3, 4], "omega": 1}


def _curve(points: Any, **shape: Any) -> dict[str, Any]:
    return {"points": points, **shape}


def _line(*corners: tuple[float, float]) -> list[dict[str, Any]]:
    """Return the straight segments between corners."""
    thirds = (0.0, 1 / 3, 2 / 3, 1.0)
    return [
        _curve([[r0 + (r1 - r0) * t, h0 + (h1 - h0) * t] for t in thirds])
        for (r0, h0), (r1, h1) in pairwise(corners)
    ]


def _law(parameter: str, first: float, last: float, kind: str = "paper", **more: Any) -> Any:
    law = {"segments": "all", "parameter": parameter, "law": kind, "from": first, "to": last}
    return [{**law, **more}]


def _vessel(**fields: Any) -> dict[str, Any]:
    return {"kind": "vessel", **fields}


def _turn(sweep: float, start: float = 0.0) -> dict[str, Any]:
    return {"start_deg": start, "sweep_deg": sweep}


FILLED = {"kind": "filled"}
TUBE = _line((20, 0), (20, 60))
CURVE = [_curve(PROFILE)]
# A chain with many kinks.
RIB = [
    _curve([[20 - k % 3, 5 * k], [24, 5 * k + 1], [24, 5 * k + 4], [20 - (k + 1) % 3, 5 * k + 5]])
    for k in range(12)
]

HARD: dict[str, dict[str, Any]] = {
    "wall that leaves no cavity": project(CURVE, solid=_vessel(wall=60, side="inside", base=9)),
    "wall larger than the shape": project(RIB, solid=_vessel(wall=1e9)),
    "wall of nothing": project(CURVE, solid=_vessel(wall=1e-9, base=0, rim="round")),
    "wall of nothing outside": project(
        CURVE, solid=_vessel(wall=1e-9, base=1e-9, side="outside", foot_ring=4, drain_hole=1e-12)
    ),
    "thick wall outside": project(
        [_curve([[37, 0], [24, 44], [43, 26], [62, 46]]), *_line((62, 46), (59, 52))],
        solid=_vessel(wall=74, side="outside", base=0, rim="round"),
    ),
    "flat plate": project(_line((40, 0), (10, 0)), solid=_vessel(side="outside")),
    "flat plate inside": project(_line((10, 0), (40, 0)), solid=_vessel(wall=2)),
    "flat filled plate": project(_line((10, 0), (40, 0)), solid=FILLED),
    "sliver under a law": project(
        CURVE, variation=_law("omega", 0, 1), revolution=_turn(1e-12), solid=_vessel()
    ),
    "sliver": project(CURVE, revolution=_turn(1e-6), solid=FILLED),
    "far away": project(
        CURVE, unit="cm", placement={"translation": [5e7, 4.5e8, 12e3]}, solid=_vessel()
    ),
    "turned far": project(CURVE, placement={"rotation_deg": [-122.5, 0, 1e15]}, solid=FILLED),
    "start angle beyond the range": project(CURVE, revolution=_turn(360, 1e300)),
    "start angle at the end of the range": project(CURVE, revolution=_turn(90, 1e9)),
    "law of a million waves": project(CURVE, variation=_law("omega", 0, 1, "cosine", n=10**6)),
    "law over kinks": project(
        [
            _curve([[5, 13], [6, 12], [3, 10], [2, 8]], **STILL),
            _curve([[2, 8], [1, 6], [2, 3], [5, -1]], **STILL),
        ],
        variation=_law("omega", 0, 0.5, "raised-cosine"),
        profile_joints=["G1"],
    ),
    "law to the axis": project(
        [
            _curve([[40, 0], [48, 14], [52, 25], [0, 30]], **{"lambda": [4, 0, 4], "omega": 0.3}),
            _curve([[0, 30], [15, 31], [50, 60], [28, 62]], **{"lambda": [0, 0, 0], "omega": 0.2}),
        ],
        variation=_law("omega", 0.47, 0.82, "raised-cosine"),
        solid=_vessel(wall=5, foot_ring=6),
    ),
    "half a turn of a lens": project(
        [_curve([[10, 0], [20, 20], [0, 20], [10, 0]], **{"lambda": [0, 3, 1], "omega": 0.05})],
        revolution=_turn(180, 30),
        solid=_vessel(wall=6, side="outside", base=0),
    ),
    "near cusp": project([_curve([[5, 0], [6.000001, 1], [5, 1], [6, 0]], omega=0)]),
    "point, then a line": project(_line((10, 0), (10, 0), (10, 30))),
    "point between lines": project(_line((10, 0), (20, 9), (20, 9), (20, 30)), solid=FILLED),
    "all points one": project(_line((5, 5), (5, 5))),
    "on the axis": project(_line((0, 0), (0, 30)), solid=FILLED),
    "punt": project(
        [_curve([[0, 12], [10, 12], [25, 8], [30, 0]]), *_line((30, 0), (30, 80))],
        solid=_vessel(wall=2, base=0.5),
    ),
    "ring turned in part": project(
        _line((10, 0), (20, 0), (20, 10), (10, 10), (10, 0)),
        profile_closed=True,
        revolution=_turn(270, 30),
        solid=FILLED,
    ),
    "spire": project([_curve([[30, 0], [20, 20], [10, 40], [0, 60]], **STILL)]),
    "touch of the axis": project([_curve([[21, 0], [-7, 30], [-7, 60], [21, 90]])], solid=FILLED),
    "beyond the axis": project([_curve([[21, 0], [-30, 30], [-30, 60], [21, 90]])], solid=FILLED),
    "loop": project([_curve([[10, 0], [60, 60], [0, 60], [50, 0]])], solid=_vessel()),
    "bar across an end": project(
        [
            _curve([[10, 0], [40, 20], [40, 60], [20, 60]]),
            _curve([[20, 60], [0, 60], [25, 10], [30, 30]]),
        ],
        solid=FILLED,
    ),
    "loose foot": project(
        [
            _curve([[31, 0], [43, 1], [56, 10], [35, 18]], **{"lambda": [0, 3, 1], "omega": 0.5}),
            _curve([[35, 18], [50, 47], [2, 39], [26, 54]], **{"lambda": [0, 0, 0], "omega": 0}),
        ],
        solid=_vessel(wall=3, base=1, rim="round", drain_hole=40, foot_ring=4),
    ),
    "nearly level rim": project(
        [
            _curve([[43, 1], [33, 14], [40, 42], [23, 63]]),
            _curve([[23, 63], [5, 84], [28, 81], [21.3, 81.5]]),
        ],
        revolution=_turn(250),
        solid=_vessel(wall=1.5, side="outside"),
    ),
    "rules that cannot hold": project(
        [_curve(each["points"], **STILL) for each in RIB], profile_joints=["C1"] * 11
    ),
    "ring whose rules an edit breaks together": project(
        [
            _curve([[20, 0], [25, 0], [30, 5], [30, 10]], **{"lambda": [4, 3, 4], "omega": 0}),
            _curve([[30, 10], [30, 15], [15, 0], [20, 0]], omega=0),
        ],
        profile_closed=True,
        profile_joints=["G1", "G1"],
    ),
    "gaps": project([*TUBE, *_line((30, 60), (30, 90))], profile_joints=["free"], solid=_vessel()),
    "a heap of equal segments": project(
        _line(*[(10, 0), (20, 20)] * 6), profile_joints=["free"] * 10
    ),
    "farthest coordinates": project(_line((1e9, -1e9), (1e9, 1e9)), solid=FILLED),
    "least coordinates": project(_line((1e-300, 0), (1e-300, 1e-300)), solid=_vessel()),
}
