"""Reading and writing the formats of other programs, one module a format."""

from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.registry import (
    FORMATS,
    Fineness,
    Format,
    file_size,
    format_for,
    suffixes,
    write,
)

__all__ = [
    "FORMATS",
    "ExportError",
    "Fineness",
    "Format",
    "file_size",
    "format_for",
    "suffixes",
    "write",
]
