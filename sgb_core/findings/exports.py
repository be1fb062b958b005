"""Why a document cannot be exported in the asked way."""

from __future__ import annotations

from sgb_core.findings.plain import Plain, PlainOfField


class NoExport(Plain):
    """Why there is nothing to write."""

    NO_AREA = "the surface has no area: there is nothing to export"
    POINT = "the profile is a single point: there is nothing to export"


class NoStep(PlainOfField):
    """Why STEP, which holds exact surfaces, cannot hold a body."""

    VESSEL = (
        ("solid", "kind"),
        "STEP holds exact surfaces only, no vessel; choose surface or filled",
    )
    LAWS = ("variation",), "STEP holds surfaces of one section only, without laws"
    CROSSES_AXIS = ("profile",), "it crosses the axis; STEP needs one side of it"
    CROSSES_ITSELF = ("profile",), "it crosses itself; STEP needs a simple one"
    GAPS = ("profile",), "its segments do not meet; STEP needs one chain"


class KernelFailure(Plain):
    """What the CAD kernel lacks or could not do."""

    MISSING = "STEP needs an optional package: pip install 'sgb-studio[cad]'"
    EDGE = "the CAD kernel could not build an edge of the profile"
    FILE = "the CAD kernel could not write the STEP file"
