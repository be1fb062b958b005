"""A drawn plate as PNG, PDF or SVG: text stays text, and its fonts travel with it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from io import BytesIO

import matplotlib
from matplotlib.figure import Figure

from app.figures.svg import stand_alone
from sgb_core.fields.kinds import Choice
from sgb_core.findings.errors import FindingError
from sgb_core.findings.refusal import Unknown

SUFFIXES = (".png", ".pdf", ".svg")
FAMILY = "STIXGeneral"


@contextmanager
def plate_style() -> Iterator[None]:
    """Draw and write with the plates' fonts; needed around both."""
    with matplotlib.rc_context():
        # Whatever the user's own settings are, a plate looks the same.
        matplotlib.rcParams.update(
            {
                **matplotlib.rcParamsDefault,
                "backend": "agg",
                "font.family": FAMILY,
                "mathtext.fontset": "stix",
                # TrueType, which every journal takes; not outlines: words can be found and copied.
                "pdf.fonttype": 42,
                "svg.fonttype": "none",
                "svg.hashsalt": "sgb-studio",
                "image.composite_image": False,
                "path.simplify": False,
            }
        )
        yield


def figure_bytes(figure: Figure, suffix: str, title: str = "") -> bytes:
    """Return a figure as the file that ``suffix`` names; the same figure gives the same bytes.

    ``title`` is what the file says it is. Raises ValueError for a suffix that is not one of
    SUFFIXES.
    """
    if suffix not in SUFFIXES:
        raise FindingError(Unknown("format of plates", suffix, Choice(SUFFIXES)))
    known: dict[str, dict[str, str | None]] = {
        ".png": {"Software": "SGB Studio"},
        ".pdf": {"Creator": "SGB Studio", "CreationDate": None},
        ".svg": {"Creator": "SGB Studio", "Date": None},
    }
    metadata = known[suffix]
    if title:
        metadata["Title"] = title
    stream = BytesIO()
    with plate_style():
        figure.savefig(stream, format=suffix[1:], dpi=figure.dpi, metadata=metadata)
    if suffix != ".svg":
        return stream.getvalue()
    return stand_alone(stream.getvalue().decode("utf-8"), FAMILY).encode("utf-8")
