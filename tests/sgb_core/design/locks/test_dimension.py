from __future__ import annotations

import pytest

import sgb_core as sgb
from sgb_core.design.locks.dimension import KINDS, Dimension, DimensionKind, misplaced


def test_every_kind_is_described() -> None:
    assert set(KINDS) == set(DimensionKind)


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"kind": "girth"}, 'dimension.kind is "girth"'),
        ({"kind": "height", "locked": True}, "a number where locked"),
        ({"kind": "height", "value": 3.0}, "none where it is not locked"),
        ({"kind": "height", "locked": True, "value": -3.0}, "a positive number"),
        ({"kind": "height", "locked": True, "value": float("nan")}, "a finite number"),
        ({"kind": "distance", "points": [(0, 1)]}, "a list of 2 different pairs"),
        ({"kind": "distance", "points": [(0, 1), (0, 1)]}, "a list of 2 different pairs"),
        ({"kind": "point", "points": [(0, 4)]}, "0 to 3"),
        ({"kind": "diameter_at"}, "dimension.height"),
        ({"kind": "height", "joint": 0}, "none for height"),
        ({"kind": "joint", "joint": 0, "rule": "G0"}, '"G1", "C1", "G2"'),
        ({"kind": "radius", "segment": 0, "s": 1.5}, "dimension.s"),
    ],
)
def test_what_is_not_allowed_is_refused(fields: dict[str, object], words: str) -> None:
    with pytest.raises(ValueError) as caught:
        Dimension(**fields)  # type: ignore[arg-type]
    assert words in str(caught.value)


def test_a_dimension_names_what_a_profile_has() -> None:
    assert misplaced(Dimension("point", points=((2, 0),)), 2, 1) == (("points", 0, 0), 2, 1)
    assert misplaced(Dimension("radius", segment=2, s=0.5), 2, 1) == (("segment",), 2, 1)
    assert misplaced(Dimension("joint", joint=1, rule=sgb.JointRule.G1), 2, 1) is not None
    assert misplaced(Dimension("point", points=((1, 3),)), 2, 1) is None


def test_an_angle_and_a_height_may_be_negative() -> None:
    assert Dimension("neck_height", locked=True, value=-3.0).value == -3.0
    assert Dimension("angle", locked=True, points=((0, 0), (0, 1)), value=-30.0).value == -30.0
