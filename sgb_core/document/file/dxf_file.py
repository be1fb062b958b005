"""DXF as bytes: the same drawing gives the same file, without dates and random identifiers."""

from __future__ import annotations

from collections.abc import Callable
from io import StringIO
from typing import Any


def dxf_bytes(make: Callable[[], Any]) -> bytes:
    """Return the file of the ezdxf drawing that ``make`` returns."""
    # Imported late: it takes as long to load as everything else together.
    import ezdxf

    before = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        drawing = make()
        text = StringIO()
        drawing.write(text)
        encoded: bytes = text.getvalue().encode(drawing.output_encoding, "dxfreplace")
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = before
    return encoded
