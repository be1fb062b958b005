"""Edits of the laws over the angle: one law at a time, and the keys of a keyframe curve.

The functions that take a law return a law; :func:`replace_law` puts it into the document, which
is where everything is checked.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sgb_core.document.edits.checks import finite, within
from sgb_core.document.edits.whole import set_variation
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.fields.kinds import SHARE
from sgb_core.fields.record import table_of
from sgb_core.findings.edits import NoEdit, NoSuch, NoSuchKey, TooManyWaves
from sgb_core.surfaces.laws.keyframes import KEYFRAMES
from sgb_core.surfaces.laws.law import (
    CLOSEST_STRENGTHS,
    LAW_RANGES,
    MAX_KEYFRAMES,
    RADIUS,
    STRENGTHS,
    Law,
    LawParameter,
)
from sgb_core.surfaces.laws.shape import LawShape

Key = tuple[float, float]

# A key moved onto another stops so many degrees short of it.
SHORT_OF = 0.01
# A key moved beside another along the height stays so far from it, a part of the height.
KEPT_APART = 1e-3


def add_law(document: Document, law: Law) -> Document:
    """Add a law after the others; where two name the same parameter the later one counts."""
    return set_variation(document, (*document.variation, law))


def replace_law(document: Document, index: int, law: Law) -> Document:
    """Put another law in the place of one."""
    laws = list(document.variation)
    laws[law_number(document, index)] = law
    return set_variation(document, laws)


def remove_law(document: Document, index: int) -> Document:
    """Remove a law; its parameter has the segments' own values again."""
    laws = list(document.variation)
    del laws[law_number(document, index)]
    return set_variation(document, laws)


def move_law(document: Document, index: int, place: int) -> Document:
    """Move a law to another place in the order, in which later ones count more."""
    laws = list(document.variation)
    law = laws.pop(law_number(document, index))
    laws.insert(law_number(document, place), law)
    return set_variation(document, laws)


def law_number(document: Document, index: int) -> int:
    """Return the number of a law. Raises EditError where there is no such law."""
    count = len(document.variation)
    if not 0 <= index < count:
        raise EditError(NoSuch("law", index, count))
    return index


def with_key(law: Law, degrees: float, value: float) -> Law:
    """Return a keyframe law with a key at an angle: a new one, or the one there changed."""
    turn, height = _turn(degrees), _height(value)
    others = [key for key in law.keyframes if _turn(key[0]) != turn]
    return replace(law, keyframes=tuple(sorted([*others, (turn, height)])))


def without_key(law: Law, index: int) -> Law:
    """Return a keyframe law without one of its keys. Raises EditError on the only one."""
    _key_number(law, index)
    if len(law.keyframes) == 1:
        raise EditError(NoEdit.ONLY_KEY)
    return replace(law, keyframes=law.keyframes[:index] + law.keyframes[index + 1 :])


def with_key_moved(law: Law, index: int, degrees: float, value: float) -> Law:
    """Return a keyframe law with one key elsewhere; the keys keep their numbers.

    Angles are taken around the turn and f is held within [0, 1]. At another key's angle it
    stops a little short of it, on the side it came from.
    """
    _key_number(law, index)
    turn, height = _turn(degrees), min(max(finite(value, "f"), 0.0), 1.0)
    taken = {_turn(key[0]) for k, key in enumerate(law.keyframes) if k != index}
    ahead = np.mod(turn - law.keyframes[index][0] + 180.0, 360.0) - 180.0
    while turn in taken:
        turn = _turn(turn - (SHORT_OF if ahead >= 0.0 else -SHORT_OF))
    keys = list(law.keyframes)
    keys[index] = (turn, height)
    return replace(law, keyframes=tuple(keys))


def as_keyframes(law: Law) -> Law:
    """Return the law as a keyframe curve through points of the same curve, to be shaped by hand.

    Its extremes are kept, between the keys it is near. Raises EditError where it has more waves
    than keys are allowed.
    """
    shape = law.shape
    if shape is KEYFRAMES:
        return law
    waves = law.waves or 1
    a_wave = min(shape.keys_a_wave, MAX_KEYFRAMES // waves // 2 * 2)
    if a_wave < 2:
        raise EditError(TooManyWaves(waves, MAX_KEYFRAMES))
    count = a_wave * waves
    turns = 360.0 * np.arange(count) / count
    heights = np.clip(law.fraction(np.deg2rad(turns)), 0.0, 1.0)
    keys = tuple(zip(turns.tolist(), np.round(heights, 12).tolist(), strict=True))
    return replace(law, kind=KEYFRAMES.name, keyframes=keys)


def with_parameter(law: Law, parameter: LawParameter) -> Law:
    """Return the law for another parameter: the same parts of its range, or usual factors."""
    if parameter == law.parameter:
        return law
    if RADIUS in (parameter, law.parameter):
        allowed = LAW_RANGES[parameter]
        start, end = (allowed.low, allowed.high) if parameter != RADIUS else law.shape.natural
    else:
        part = LAW_RANGES[parameter].high / LAW_RANGES[law.parameter].high
        start, end = part * law.start, part * law.end
    along = law.along if parameter == RADIUS else ()
    return replace(law, parameter=parameter, start=start, end=end, along=along)


def with_shape(law: Law, shape: LawShape) -> Law:
    """Return the law with another shape of its curve, and what that needs.

    Keyframes run through points of the curve as it was. Raises EditError as
    :func:`as_keyframes` does.
    """
    if shape is KEYFRAMES:
        return as_keyframes(law)
    first = {name: value for name, value in shape.first.items() if not _is_set(law, name)}
    if law.count < shape.least_count:
        first["count"] = shape.first["count"]
    if law.parameter == RADIUS and (law.start, law.end) == law.shape.natural:
        first["start"], first["end"] = shape.natural
    return replace(law, kind=shape.name, keyframes=(), **first)


def with_strength(law: Law, u: float, k: float) -> Law:
    """Return a law of the radius whose strength at a share u of the height is k.

    A new key, or the one there changed; without any the strength is 1 all along.
    """
    place = within(finite(u, "u"), "u", SHARE)
    strength = within(finite(k, "k"), "k", STRENGTHS)
    others = [key for key in law.along if abs(key[0] - place) >= CLOSEST_STRENGTHS]
    return replace(law, along=tuple(sorted([*others, (place, strength)])))


def without_strength(law: Law, index: int) -> Law:
    """Return a law without one of its keys along the height; without the last it has 1 all along.

    Raises EditError where there is no such key.
    """
    _strength_number(law, index)
    return replace(law, along=law.along[:index] + law.along[index + 1 :])


def with_strength_moved(law: Law, index: int, u: float, k: float) -> Law:
    """Return a law with one key along the height elsewhere; the keys keep their numbers.

    It stays between its neighbours, u within [0, 1] and k within what is allowed.
    """
    _strength_number(law, index)
    keys = list(law.along)
    low = keys[index - 1][0] + KEPT_APART if index > 0 else 0.0
    high = keys[index + 1][0] - KEPT_APART if index + 1 < len(keys) else 1.0
    place = min(max(finite(u, "u"), low), max(high, low))
    keys[index] = (place, min(max(finite(k, "k"), STRENGTHS.low), STRENGTHS.high))
    return replace(law, along=tuple(keys))


def _strength_number(law: Law, index: int) -> None:
    if not 0 <= index < len(law.along):
        raise EditError(NoSuchKey(index, len(law.along)))


def _is_set(law: Law, name: str) -> bool:
    return bool(getattr(law, name) != table_of(Law).row(name).default)


def _turn(degrees: float) -> float:
    turn = finite(degrees, "the angle") % 360.0
    # The remainder of a tiny negative angle is 360 itself.
    return 0.0 if turn == 360.0 else turn


def _height(value: float) -> float:
    return within(finite(value, "f"), "f", SHARE)


def _key_number(law: Law, index: int) -> None:
    if not 0 <= index < len(law.keyframes):
        raise EditError(NoSuchKey(index, len(law.keyframes)))
