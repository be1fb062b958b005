"""Where the panels of a plate and their captions stand, in whole pixels of its resolution."""

from __future__ import annotations

from app.figures.plate import CurvePanel, Panel, Plate
from sgb_core.values import dataclass

INCH = 25.4
# Millimetres: around the plate, between panels, one line of a caption, a flat panel's numbers.
EDGE, GAP, LINE, NUMBERS = 1.0, 2.5, 3.7, 8.0
TITLE = 6.0
# Type in points, and its size on plates too narrow for it.
TYPE, SMALLEST = 8.0, 6.0


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle in pixels from the lower left corner of the plate."""

    left: int
    bottom: int
    width: int
    height: int


@dataclass(frozen=True, slots=True)
class Layout:
    """The plate's size in pixels, each panel's picture, and the size of type in points."""

    width: int
    height: int
    panels: tuple[Box, ...]
    type_size: float
    # From one panel's left edge to the next one's: what a caption may fill.
    pitch: float

    @property
    def aspect(self) -> float:
        """Width over height of one panel's picture."""
        return self.panels[0].width / self.panels[0].height


def caption_lines(panel: Panel) -> list[tuple[str, bool]]:
    """Return the lines below a panel, and of each whether it is a remark."""
    label = f"({panel.label})" if panel.label else ""
    first, *rest = panel.caption or ("",)
    lines = [("  ".join(filter(None, (label, first))), False), *((text, False) for text in rest)]
    return [line for line in [*lines, *((text, True) for text in panel.remark)] if line[0]]


def lay_out(plate: Plate, aspect: float) -> Layout:
    """Return the boxes of a plate whose panels want to be ``aspect`` times as wide as high."""
    pixel = INCH / plate.dpi
    flat = isinstance(plate.panels[0], CurvePanel)
    left, below = (NUMBERS + 3.0, NUMBERS) if flat else (0.0, 0.0)
    column = (plate.width_mm - 2 * EDGE - (plate.columns - 1) * GAP) / plate.columns
    width = max(column - left, 5.0)
    height = plate.panel_height_mm or min(width / aspect, 2.2 * width)
    lines = max(len(caption_lines(panel)) for panel in plate.panels)
    caption = LINE * lines + (1.0 if lines else 0.0)
    row = height + below + caption + GAP
    title = TITLE if plate.title else 0.0
    total = 2 * EDGE + plate.rows * row - GAP + title
    boxes = []
    for number in range(len(plate.panels)):
        line, place = divmod(number, plate.columns)
        # A last row that is not full stands in the middle.
        missing = min(0, len(plate.panels) - (line + 1) * plate.columns)
        x = EDGE + place * (column + GAP) + left - missing * (column + GAP) / 2.0
        y = total - EDGE - title - line * row - height
        boxes.append(
            Box(
                round(x / pixel),
                round(y / pixel),
                max(1, round(width / pixel)),
                max(1, round(height / pixel)),
            )
        )
    size = max(SMALLEST, min(TYPE, TYPE * column / 34.0)) * (1.5 if plate.width_mm > 200.0 else 1.0)
    return Layout(
        round(plate.width_mm / pixel),
        round(total / pixel),
        tuple(boxes),
        size,
        (column + GAP) / pixel,
    )
