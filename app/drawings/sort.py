"""The sorts of drawings on paper."""

from __future__ import annotations

from enum import StrEnum


class Sort(StrEnum):
    """What can be drawn on paper."""

    SECTION = "section"
    VESSEL = "vessel"
    TEMPLATE = "template"
    CURVES = "curves"
    CURVATURE = "curvature"
