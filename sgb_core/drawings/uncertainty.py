"""How far what a traced vessel holds is known, from what its project keeps of the tracing."""

from __future__ import annotations

from math import sqrt

from sgb_core.document.model import Document
from sgb_core.surfaces import measures

# How truly each end of a picture's scale is set, in pixels.
_SET = 0.5


def volume_uncertainty(document: Document, volume: float) -> float | None:
    """Return the uncertainty of a volume (unit³) of a traced profile; None for any other.

    The root of the sum of three squares. The curve: the surface's area times the root mean square
    deviation of the source's points. The sides: the area times half their rms difference, which
    bounds half the difference of what they hold. The scale of a picture: both ends of the height
    are set to half a pixel, which changes the volume by three times their part of it.
    """
    reference = document.reference
    if reference is None or reference.rms_deviation is None:
        return None
    area = measures.area(document.surface)
    curve = area * reference.rms_deviation
    sides = 0.0 if reference.left_right is None else 0.5 * area * reference.left_right
    scale, height = 0.0, measures.height(document.surface)
    if reference.picture is not None and height > 0.0:
        scale = 3.0 * sqrt(2.0) * _SET * reference.scale / height * volume
    return sqrt(curve**2 + sides**2 + scale**2)
