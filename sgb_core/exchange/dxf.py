"""DXF of the generatrix: exact splines of degree 4, for lathes and CAD programs."""

from __future__ import annotations

from typing import Any, BinaryIO

from sgb_core.document.file.dxf_file import dxf_bytes
from sgb_core.document.model import Document, Unit
from sgb_core.exchange.format import Format

# The DXF codes of $INSUNITS.
_UNITS = {Unit.IN: 1, Unit.MM: 4, Unit.CM: 5}


def write_dxf(document: Document, stream: BinaryIO) -> None:
    """Write each segment, at the start angle, as one Bézier SPLINE; x = r, y = h, in the unit.

    On a layer GENERATRIX; the rotation axis is a LINE on a layer AXIS.
    """
    stream.write(dxf_bytes(lambda: _drawing(document)))


def _drawing(document: Document) -> Any:
    import ezdxf

    surface = document.surface
    profile = surface.profile_at(surface.start)
    drawing = ezdxf.new("R2000", setup=["linetypes"])
    drawing.header["$INSUNITS"] = _UNITS[document.unit]
    drawing.header["$MEASUREMENT"] = 0 if document.unit is Unit.IN else 1
    drawing.layers.add("GENERATRIX")
    drawing.layers.add("AXIS", linetype="CENTER")
    space = drawing.modelspace()
    low, high = profile.bounds()
    space.add_line((0.0, float(low[1])), (0.0, float(high[1])), dxfattribs={"layer": "AXIS"})
    for segment in profile.segments:
        spline = space.add_spline(degree=4, dxfattribs={"layer": "GENERATRIX"})
        spline.control_points = [(float(r), float(h), 0.0) for r, h in segment.quartic]
        spline.knots = [0.0] * 5 + [1.0] * 5
    return drawing


FORMAT = Format(
    ".dxf",
    "Generatrix as DXF",
    lambda request, stream: write_dxf(request.document, stream),
    lambda _document: "The generatrix as curves",
    meshed=False,
    tolerance=None,
    any_axis=False,
)
