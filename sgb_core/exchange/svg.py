"""SVG of the generatrix at true size, for lathe templates and drawings."""

from __future__ import annotations

from html import escape
from typing import BinaryIO

import numpy as np

from sgb_core.curves.profile import GAP, Profile
from sgb_core.document.model import Document
from sgb_core.exchange.format import Format
from sgb_core.surfaces.cubics import cubic_pieces

# Of the larger side: the free border, the width of lines, and the default tolerance.
_BORDER = 0.05
_STROKE = 0.003
_TOLERANCE = 1e-6


def write_svg(document: Document, stream: BinaryIO, tolerance: float | None = None) -> None:
    """Write the generatrix, at the start angle, and its axis; one user unit is one length unit.

    r runs to the right and h upwards. The path stays within ``tolerance`` of the curve (default
    1e-6 of the size) and is exact for every segment that is a cubic. Beside it stand the quartic
    Bézier points of all segments, (r, h) in the unit, from which the profile can be had again.
    """
    surface = document.surface
    profile = surface.profile_at(surface.start)
    low, high = profile.bounds()
    left, right = min(float(low[0]), 0.0), max(float(high[0]), 0.0)
    bottom, top = float(low[1]), float(high[1])
    side = max(right - left, top - bottom) or 1.0
    border = _BORDER * side
    box = (left - border, -top - border, right - left + 2 * border, top - bottom + 2 * border)
    unit = document.unit.value
    within = tolerance if tolerance is not None else _TOLERANCE * (profile.size or 1.0)
    stroke = f'fill="none" stroke-width="{_number(_STROKE * side)}"'
    dashes = f"{_number(0.03 * side)} {_number(0.01 * side)}"
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_number(box[2])}{unit}" '
        f'height="{_number(box[3])}{unit}" viewBox="{" ".join(map(_number, box))}">',
        f"  <title>{escape(document.name, quote=False)}</title>",
        f'  <path id="axis" {stroke} stroke="#808080" stroke-dasharray="{dashes}" '
        f'd="M 0 {_number(-top - border / 2)} V {_number(-bottom + border / 2)}"/>',
        f'  <path id="generatrix" {stroke} stroke="#000000" d="{_path(profile, within)}" '
        f'data-sgb-quartics="{_quartics(profile)}"/>',
        "</svg>",
    ]
    stream.write(("\n".join(lines) + "\n").encode())


def _path(profile: Profile, tolerance: float) -> str:
    """Return path data: one run of cubics for each stretch without a gap."""
    words: list[str] = []
    end: np.ndarray | None = None
    reach = GAP * profile.size
    for segment in profile.segments:
        for piece in cubic_pieces(segment.quartic, tolerance):
            flipped = piece * (1.0, -1.0)
            if end is None or np.abs(flipped[0] - end).max() > reach:
                words.append(f"M {_point(flipped[0])}")
            words.append("C " + " ".join(map(_point, flipped[1:])))
            end = flipped[3]
    return " ".join([*words, "Z"] if profile.closed else words)


def _quartics(profile: Profile) -> str:
    """Return the quartic points in full precision: blanks in a segment, semicolons between."""
    return "; ".join(
        " ".join(f"{float(r)!r},{float(h)!r}" for r, h in quartic) for quartic in profile.quartics
    )


def _point(point: np.ndarray) -> str:
    return f"{_number(float(point[0]))} {_number(float(point[1]))}"


def _number(value: float) -> str:
    """Return a decimal number without an exponent, which some readers do not know."""
    text = f"{value:.9f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


FORMAT = Format(
    ".svg",
    "Generatrix as SVG",
    lambda request, stream: write_svg(request.document, stream, request.fineness.tolerance),
    lambda _document: "The generatrix as curves",
    meshed=False,
    tolerance=None,
    any_axis=False,
)
