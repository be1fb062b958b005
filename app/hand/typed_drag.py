"""What can be typed during a drag, and where what is in the hand then goes."""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, cos, degrees, hypot, radians, sin

from app.hand.coordinates import DesignPoint
from app.hand.drag import Gesture, State
from app.hand.handle_number import handle_number
from app.hand.scale_frame import LEAST, SIDES
from app.hand.typed import Typed, TypedField
from app.widgets.number_kind import NumberKind
from sgb_core.curves.segment import LAMBDAS, PARAMETER_RANGES, SYMBOLS
from sgb_core.document import edits
from sgb_core.document.model import Document

_LEG, _ANGLE, _POLAR = "leg", "∠", "polar"
_STEP_R, _STEP_H = "Δr", "Δh"
_TIMES_R, _TIMES_H = "× r", "× h"
_ONE_NUMBER = (State.FILLING, State.MEASURING, State.SHAPING)


def typed_fields(gesture: Gesture, document: Document) -> tuple[TypedField, ...]:
    """Return the numbers that can be typed during a drag; none for what has no number."""
    unit, handle = str(document.unit), gesture.handle
    length = NumberKind(unit=unit)
    if handle is None:
        return ()
    if gesture.state is State.MOVING and len(gesture.points) > 1:
        return TypedField(_STEP_R, length), TypedField(_STEP_H, length)
    if gesture.state is State.MOVING:
        fields = (TypedField("r", length), TypedField("h", length))
        if handle.index in (0, 3):
            return fields
        leg = NumberKind(minimum=0.0, unit=unit)
        return (
            *fields,
            TypedField(_LEG, leg, _POLAR),
            TypedField(_ANGLE, NumberKind(unit="deg"), _POLAR),
        )
    if gesture.state is State.SLIDING:
        name = LAMBDAS[handle.index]
        return (TypedField(SYMBOLS[name], NumberKind(*PARAMETER_RANGES[name])),)
    if gesture.state in _ONE_NUMBER:
        number = handle_number(document, handle)
        return () if number is None else (TypedField(number.name, number.kind),)
    if gesture.state is State.SCALING:
        wide, tall = SIDES[handle.index]
        factor = NumberKind(minimum=LEAST)
        names = [name for name, used in ((_TIMES_R, wide), (_TIMES_H, tall)) if used]
        return tuple(TypedField(name, factor) for name in names)
    return ()


def typed_place(gesture: Gesture, start: DesignPoint, cursor: DesignPoint) -> DesignPoint:
    """Return where what is moved goes: where the hand is, but for what is typed."""
    values = {} if gesture.typed is None else gesture.typed.values
    if not values or gesture.profile is None or gesture.handle is None:
        return cursor
    if values.keys() & {_STEP_R, _STEP_H}:
        return DesignPoint(
            start.r + values[_STEP_R] if _STEP_R in values else cursor.r,
            start.h + values[_STEP_H] if _STEP_H in values else cursor.h,
        )
    if not values.keys() & {_LEG, _ANGLE}:
        return DesignPoint(values.get("r", cursor.r), values.get("h", cursor.h))
    segment, index = gesture.handle.segment, gesture.handle.index
    base = DesignPoint.of(gesture.profile.segments[segment].points[0 if index == 1 else 3])
    dr, dh = cursor.r - base.r, cursor.h - base.h
    length = values.get(_LEG, hypot(dr, dh))
    angle = values.get(_ANGLE, degrees(atan2(dh, dr)))
    turned = radians(angle)
    # Quarter turns exactly: the sine of π is not 0.
    along = (cos(turned), sin(turned))
    if angle % 90.0 == 0.0:
        along = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[round(angle / 90.0) % 4]
    return DesignPoint(base.r + length * along[0], base.h + length * along[1])


def typed_factors(gesture: Gesture, factors: tuple[float, float]) -> tuple[float, float]:
    """Return by what a frame is scaled: as the hand says, but for what is typed."""
    values = {} if gesture.typed is None else gesture.typed.values
    return values.get(_TIMES_R, factors[0]), values.get(_TIMES_H, factors[1])


def typing(gesture: Gesture, document: Document) -> Typed | None:
    """Return the numbers of a drag that changes a document, None where it has none."""
    if gesture.typed is not None:
        return gesture.typed
    fields = typed_fields(gesture, document)
    return Typed.of(fields) if fields and gesture.edits else None


def typed_edit(gesture: Gesture, document: Document) -> Callable[[Document], Document] | None:
    """Return the edit by the number of a drag that has but one, None while it is not typed.

    ``document`` is that of the gesture's start.
    """
    value = None if gesture.typed is None else next(iter(gesture.typed.values.values()), None)
    if value is None or gesture.handle is None:
        return None
    segment, index = gesture.handle.segment, gesture.handle.index
    if gesture.state in _ONE_NUMBER:
        number = handle_number(document, gesture.handle)
        return None if number is None else lambda d: number.edit(d, value)
    if gesture.state is State.SLIDING:
        return lambda d: edits.set_shape_parameter(d, segment, LAMBDAS[index], value)
    return None
