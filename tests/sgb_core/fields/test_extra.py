from __future__ import annotations

import pickle

import pytest
from hypothesis import given

from sgb_core.bodies.solid import Solid
from sgb_core.document.file import json_text
from sgb_core.fields.extra import NO_EXTRA, Extra
from sgb_core.findings.refusal import RefusalError
from tests.sgb_core.document.strategies import extras


@given(extras)
def test_unknown_keys_are_kept_as_they_are(values: dict[str, object]) -> None:
    kept = Solid(extra=values).extra
    assert isinstance(kept, Extra)
    assert dict(kept) == values
    assert pickle.loads(pickle.dumps(kept)) == kept
    assert Solid(extra=kept).extra is kept
    json_text.parse(json_text.dump(kept))


@pytest.mark.parametrize(
    ("values", "line"),
    [
        ({"wall": 3}, 'solid.extra is "wall"; allowed is a key that the program does not know'),
        ({"note": {"deep": [0, float("nan")]}}, "solid.note.deep[1] is NaN; allowed is a plain"),
        ({"note": Solid()}, "solid.note is "),
        ({"note": {1: 2}}, "solid.note is 1; allowed is a text as key"),
        ({"\ud800": 1}, "half a character"),
        ({"note": ["\ud800"]}, "solid.note[0] holds half a character"),
        (3, "solid.extra is 3; allowed is a mapping"),
    ],
)
def test_what_no_file_can_hold_is_refused(values: object, line: str) -> None:
    with pytest.raises(RefusalError) as caught:
        Solid(extra=values)  # type: ignore[arg-type]
    assert line in str(caught.value)


def test_nothing_unknown_is_one_value() -> None:
    assert Solid().extra is NO_EXTRA
    assert dict(NO_EXTRA) == {}
    with pytest.raises(KeyError):
        NO_EXTRA["anything"]
