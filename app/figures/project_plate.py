"""A project's own plate: its settings made into panels with labels and captions."""

from __future__ import annotations

from math import ceil, radians, sqrt
from string import ascii_lowercase

from app.figures.plate import TINT, Plate, SurfacePanel
from app.scene.camera import Pose
from app.state.window_reader import WINDOW
from sgb_core.curves.segment import SYMBOLS
from sgb_core.document.edits.plate import PlatePanel, plate_panels
from sgb_core.document.model import Document
from sgb_core.document.plates import PlateSettings, Projection, Variation
from sgb_core.findings.errors import FindingError
from sgb_core.findings.plates import NoPlate

_LETTERS = {"λ": r"\lambda", "ω": r"\omega"}


def plate_of(document: Document) -> Plate:
    """Return the plate that a document holds.

    Raises ValueError where it holds none, EditError for one that it cannot draw.
    """
    if document.plate is None:
        raise FindingError(NoPlate.NONE)
    return make_plate(document, document.plate)


def make_plate(document: Document, settings: PlateSettings) -> Plate:
    """Return the plate that settings make of a document; raises EditError as plates do."""
    found = plate_panels(document, settings)
    tint = document.appearance.color or TINT
    panels = tuple(
        SurfacePanel(
            panel.document,
            _label(number) if settings.labels else "",
            _caption(panel) if settings.captions else (),
            show=frozenset(str(part) for part in settings.show),
            tint=tint,
        )
        for number, panel in enumerate(found)
    )
    camera = settings.camera
    pose = Pose(
        document.revolution.axis,
        radians(camera.azimuth_deg),
        radians(camera.elevation_deg),
        1.0,
        (0.0, 0.0, 0.0),
        (0.0, 0.0, 0.0),
        parallel=camera.projection is Projection.PARALLEL,
    )
    return Plate(
        panels,
        min(settings.columns or _columns(settings, len(panels)), len(panels)),
        pose,
        settings.width_mm,
        settings.dpi,
        settings.panel_height_mm,
        settings.common_scale,
        settings.title.replace("$", r"\$"),
    )


def _columns(settings: PlateSettings, count: int) -> int:
    # Two variations make a table: the second along the rows.
    if len(settings.vary) == 2 and not settings.states:
        return len(settings.vary[1].values)
    return count if count <= 4 else min(4, ceil(sqrt(count)))


def _label(number: int) -> str:
    rest, letter = divmod(number, len(ascii_lowercase))
    return (ascii_lowercase[rest - 1] if rest else "") + ascii_lowercase[letter]


def _caption(panel: PlatePanel) -> tuple[str, ...]:
    if panel.state:
        return (panel.state.replace("$", r"\$"),)
    if not panel.values:
        return ()
    return ("$" + r",\ ".join(_equation(*pair) for pair in panel.values) + "$",)


def _equation(variation: Variation, value: float) -> str:
    letter, index = SYMBOLS[variation.parameter][0], SYMBOLS[variation.parameter][1:]
    of_segment = "" if variation.segment is None else str(WINDOW.number(variation.segment))
    places = ",".join(filter(None, (index, of_segment)))
    below = f"_{{{places}}}" if of_segment else f"_{places}" if places else ""
    return f"{_LETTERS[letter]}{below}={value:.4g}"
