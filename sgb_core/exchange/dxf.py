"""DXF of the generatrix: exact splines of degree 4, for lathes and CAD programs."""

from __future__ import annotations

from io import StringIO
from typing import BinaryIO

from sgb_core.document.model import Document, Unit
from sgb_core.exchange.format import Format

# The DXF codes of $INSUNITS.
_UNITS = {Unit.IN: 1, Unit.MM: 4, Unit.CM: 5}


def write_dxf(document: Document, stream: BinaryIO) -> None:
    """Write each segment, at the start angle, as one Bézier SPLINE; x = r, y = h, in the unit.

    On a layer GENERATRIX; the rotation axis is a LINE on a layer AXIS.
    """
    # Imported late: it takes as long to load as everything else together.
    import ezdxf

    before = ezdxf.options.write_fixed_meta_data_for_testing
    # The same document gives the same file: no dates, no random identifiers.
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        stream.write(_drawing(document))
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = before


def _drawing(document: Document) -> bytes:
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
    text = StringIO()
    drawing.write(text)
    encoded: bytes = text.getvalue().encode(drawing.output_encoding, "dxfreplace")
    return encoded


FORMAT = Format(
    ".dxf",
    "Generatrix as DXF",
    lambda request, stream: write_dxf(request.document, stream),
    lambda _document: "The generatrix as curves",
    meshed=False,
    tolerance=None,
    any_axis=False,
)
