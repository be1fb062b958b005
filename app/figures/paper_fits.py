"""Fits for the figures that approximate circles and ellipses, each made once."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.design.fitting import Deviation, Fit, Freedom, deviation, fit
from sgb_core.design.target_curves import SuperellipseArc
from sgb_core.document.model import Document


def target(entry: dict[str, float]) -> SuperellipseArc:
    """Return the arc that a figure's data name."""
    return SuperellipseArc(float(entry["b"]), float(entry["a"]), float(entry["centre"]))


def fitted_document(document: Document, arc: SuperellipseArc) -> Document:
    """Return the document fitted with a free polygon that keeps it smooth at the poles."""
    return replace(document, profile=_fit(_key(document), arc, Freedom.POLYGON, True).profile)


def facts(document: Document, arc: SuperellipseArc) -> dict[str, Any]:
    """Return what a panel's JSON says of a document and its target.

    Deviations are lengths along the target's normal; "relative" is of the larger half axis.
    """
    key = _key(document)
    found = deviation(document.profile, arc)
    best = {
        "omega": _described(_fit(key, arc, Freedom.OMEGA, False), arc),
        "shape": _described(_fit(key, arc, Freedom.SHAPE, False), arc),
        "polygon": _described(_fit(key, arc, Freedom.POLYGON, False), arc),
        "polygon_smooth_poles": _described(_fit(key, arc, Freedom.POLYGON, True), arc),
    }
    return {
        "target": {"b": arc.b, "a": arc.a, "centre": arc.centre},
        **_deviation(found, arc),
        "best": best,
    }


def percent(value: float) -> str:
    """Return a part as a percentage of two digits."""
    return f"{100.0 * value:.2g} %"


def _deviation(found: Deviation, arc: SuperellipseArc) -> dict[str, Any]:
    return {
        "deviation": found.largest,
        "relative": found.largest / arc.size,
        "where": {"segment": found.segment, "s": found.s, "point": list(found.point)},
    }


def _described(found: Fit, arc: SuperellipseArc) -> dict[str, Any]:
    shape = found.profile.segments[0].shape
    return {
        "points": found.profile.control_points.tolist(),
        "lambda": [[shape.lambda1, shape.lambda2, shape.lambda3]],
        "omega": [shape.omega],
        **_deviation(found.deviation, arc),
    }


def _key(document: Document) -> tuple[Any, ...]:
    """Return the one segment of a figure as values that compare."""
    (segment,) = document.profile.segments
    return (tuple(map(tuple, segment.points.tolist())), segment.shape)


@cache
def _fit(key: tuple[Any, ...], arc: SuperellipseArc, freedom: Freedom, smooth: bool) -> Fit:
    points, shape = key
    return fit(Profile.of([Segment(points, shape)]), arc, freedom, keep_ends=smooth)
