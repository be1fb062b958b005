"""The ``fit`` command: which target is meant, and what is said of the result."""

from __future__ import annotations

import argparse

from sgb_core.design.fitting import Deviation, Freedom, deviation
from sgb_core.document.edits.fit import SUPERELLIPSE, arc_for, fit_profile
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoFit
from sgb_core.findings.errors import FindingError


def fitted_document(document: Document, options: argparse.Namespace) -> tuple[Document, str]:
    """Return the fitted document and the lines to print.

    Raises EditError for a target or a profile that cannot be fitted.
    """
    exponent = 2.0
    if options.exponent is not None and options.target != "superellipse":
        raise FindingError(NoFit.EXPONENT)
    if options.target == "superellipse":
        exponent = SUPERELLIPSE if options.exponent is None else options.exponent
    target = arc_for(
        document,
        a=options.a,
        b=options.b,
        centre=options.centre,
        exponent=exponent,
        circle=options.target == "circle",
    )
    before = deviation(document.profile, target)
    result, found = fit_profile(
        document,
        target,
        Freedom(options.freedom),
        keep_ends=options.keep_ends,
        slide_poles=options.slide_poles,
        squares=options.least_squares,
    )
    unit = document.unit.value
    where = "" if target.radius is None else f"radius = {target.radius:g}, "
    lines = [
        f"target: {options.target}, a = {target.a:g}, b = {target.b:g}, "
        f"{where}centre = {target.centre:g}, exponent = {target.exponent:g} ({unit})",
        f"as it was: largest deviation {told(before, unit)}",
        f"best, {options.freedom}: largest deviation {told(found.deviation, unit)}",
    ]
    if options.least_squares:
        lines.append(f"root mean square: {before.rms:.6g}, now {found.deviation.rms:.6g} {unit}")
    return result, "\n".join(lines)


def told(found: Deviation, unit: str) -> str:
    """Return a deviation in words: how much and where."""
    r, h = found.point
    return (
        f"{found.largest:.6g} {unit} in segment {found.segment} at s = {found.s:.4g} "
        f"(r = {r:.6g}, h = {h:.6g})"
    )
