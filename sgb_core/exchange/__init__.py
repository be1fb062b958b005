"""Writing the formats of other programs: one module a format, which declares it as ``FORMAT``.

Knows the document and what can be made of it; nothing in the core knows it.
"""

from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.format import Format, Request
from sgb_core.exchange.registry import FORMATS, file_size, format_for, suffixes, write

__all__ = [
    "FORMATS",
    "ExportError",
    "Format",
    "Request",
    "file_size",
    "format_for",
    "suffixes",
    "write",
]
