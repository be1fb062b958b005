"""What a profile can come from, one module a kind, and the way from there to a project."""

from sgb_core.sources.errors import SourceError
from sgb_core.sources.intake import Opened, Taken, take
from sgb_core.sources.options import Options, ScaleBar, Side
from sgb_core.sources.registry import SOURCES, Source, source_for

__all__ = [
    "SOURCES",
    "Opened",
    "Options",
    "ScaleBar",
    "Side",
    "Source",
    "SourceError",
    "Taken",
    "source_for",
    "take",
]
