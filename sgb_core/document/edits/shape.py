"""Edits of the shape parameters λ1, λ2, λ3 and ω."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sgb_core.curves import basis
from sgb_core.curves.constraints import set_shapes
from sgb_core.curves.segment import (
    LAMBDAS,
    NEUTRAL,
    PARAMETER_RANGES,
    READY,
    ParameterName,
    ShapeParameters,
    parameter_range,
)
from sgb_core.document.edits.checks import (
    finite,
    keeping_ring,
    segment_number,
    with_profile,
    within,
)
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.fields.kinds import SHARE, Choice
from sgb_core.findings.edits import NotOfSegment
from sgb_core.findings.refusal import Unknown


def set_shape_parameter(
    document: Document, segment: int | None, parameter: ParameterName, value: float
) -> Document:
    """Set λ1, λ2, λ3 or ω of one segment, of all where ``segment`` is None.

    The joints keep their rules: at a C1 joint a leg scales, at a G2 joint the neighbour's
    parameters follow. Raises EditError out of range; nothing is clamped.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.edits.set_shape_parameter(cylinder, 0, "omega", 0.8).profile[0].shape.omega
    0.8
    >>> sgb.edits.set_shape_parameter(cylinder, 0, "omega", 1.2)
    Traceback (most recent call last):
        ...
    sgb_core.document.errors.EditError: omega is 1.2; allowed is 0 to 1
    """
    if parameter not in PARAMETER_RANGES:
        raise EditError(Unknown("shape parameter", parameter, Choice(PARAMETER_RANGES)))
    number = within(finite(value, parameter), parameter, parameter_range(parameter))
    return _reshape(document, segment, {parameter: number})


def slide_shape_parameter(
    document: Document, segment: int | None, parameter: ParameterName, value: float
) -> Document:
    """Set λ1, λ2, λ3 or ω as a hand on its slider means it: a λ shows at once.

    As :func:`set_shape_parameter`, but where a λ has no effect since ω is 0 that becomes 1 and the
    segment's other λ neutral: the curve starts from the cubic that it is, and only this λ shows.
    Where a law governs ω that stays the law's. Raises EditError out of range.

    >>> wall = sgb.Segment([(20, 0), (55, 10), (50, 60), (25, 80)], sgb.ShapeParameters(2, 5, 3, 0))
    >>> pot = sgb.Document(sgb.Profile.of([wall]))
    >>> sgb.edits.slide_shape_parameter(pot, 0, "lambda2", 4.5).profile[0].shape
    ShapeParameters(lambda1=1.0, lambda2=4.5, lambda3=1.0, omega=1.0)
    """
    numbers = range(len(document.profile)) if segment is None else [segment]
    woken = {k: READY for k in numbers if wakes(document, k, parameter)}
    return set_shape_parameter(_with_shapes(document, woken), segment, parameter, value)


def wakes(document: Document, segment: int, parameter: ParameterName) -> bool:
    """Whether :func:`slide_shape_parameter` of this parameter sets ω of a segment to 1."""
    still = document.profile.segments[segment_number(document, segment)].shape.omega == 0.0
    return still and parameter in LAMBDAS and not omega_law(document, segment)


def omega_law(document: Document, segment: int) -> bool:
    """Whether a law over the angle governs ω of a segment."""
    return any(law.parameter == "omega" and law.applies_to(segment) for law in document.variation)


def reset_shape(
    document: Document, segment: int | None, parameter: ParameterName | None
) -> Document:
    """Set one shape parameter, or all where it is None, to neutral: λ = (1, 3, 1), ω = 0.

    Of one segment, or of all where ``segment`` is None; the joints keep their rules.
    """
    if parameter is not None:
        neutral = getattr(NEUTRAL, parameter, None)
        return set_shape_parameter(document, segment, parameter, neutral)  # type: ignore[arg-type]
    return _reshape(document, segment, {name: getattr(NEUTRAL, name) for name in PARAMETER_RANGES})


def set_leg_fraction(document: Document, segment: int, which: int, fraction: float) -> Document:
    """Place Q1, Q2 or Q3 (``which`` 0, 1, 2) at a fraction of its leg, as when dragging it.

    Only the λ of that leg changes where it can reach the fraction with the present ω. Where it
    cannot, as at ω = 0, all four parameters are rewritten at ω = 1, which reaches every
    fraction, so that the other two Q stay where they are. Raises EditError outside [0, 1].
    """
    segment_number(document, segment)
    if which not in (0, 1, 2):
        raise EditError(NotOfSegment("legs", which))
    what = "the leg fraction"
    target = within(finite(fraction, what), what, SHARE)
    shape = document.profile.segments[segment].shape
    if shape.leg_fractions[which] == target:
        return document
    return _with_shapes(document, {segment: shape_with_fraction(shape, which, target)})


def shape_with_fraction(shape: ShapeParameters, which: int, fraction: float) -> ShapeParameters:
    """Return the parameters with one leg fraction changed and the other two the same."""
    name = LAMBDAS[which]
    low, high = PARAMETER_RANGES[name]
    if shape.omega > 0.0:
        value = basis.lambda_at(which, fraction, shape.omega)
        if low <= value <= high:
            return _replaced(shape, {name: value})
    fractions = [min(max(f, 0.0), 1.0) for f in shape.leg_fractions]
    fractions[which] = fraction
    return ShapeParameters.from_leg_fractions(*fractions)


def _reshape(
    document: Document, segment: int | None, values: Mapping[ParameterName, float]
) -> Document:
    segments = document.profile.segments
    numbers = range(len(segments)) if segment is None else [segment_number(document, segment)]
    return _with_shapes(document, {k: _replaced(segments[k].shape, values) for k in numbers})


def _replaced(shape: ShapeParameters, values: Mapping[ParameterName, float]) -> ShapeParameters:
    return replace(shape, **dict(values))


def _with_shapes(document: Document, shapes: Mapping[int, ShapeParameters]) -> Document:
    segments = document.profile.segments
    changed = {k: shape for k, shape in shapes.items() if shape != segments[k].shape}
    if not changed:
        return document
    return with_profile(
        document, keeping_ring(document.profile, lambda p: set_shapes(p, changed).profile)
    )
