"""The slump line: beside the heights and along the curve, what the printer chosen can build."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QRectF, Qt

from app.hand.canvas import Canvas
from app.state import printers
from app.state.window_reader import reason
from sgb_core.arrays import Floats, Ints
from sgb_core.document.model import Document
from sgb_core.toolpaths.errors import ToolpathError
from sgb_core.toolpaths.printer import Printer
from sgb_core.toolpaths.slump import Build, Slump, slump

SLUMP_WIDTH = 7.0
_COLOURS = {Build.HOLDS: "good", Build.LEANS: "warning", Build.FAILS: "error"}


class SlumpLine:
    """Worked out once for a document and the printer chosen; one for each editor."""

    def __init__(self) -> None:
        self._chosen: tuple[Printer, float] | None = None
        self._document: Document | None = None
        self._found: Slump | ToolpathError | None = None

    def forget(self) -> None:
        """Look anew which printer is chosen."""
        self._chosen = self._document = None

    def of(self, document: Document) -> Slump | ToolpathError:
        """Return how a document is built, or why no path can be."""
        if self._found is None or document is not self._document:
            self._chosen = self._chosen or printers.chosen(printers.known())
            self._document = document
            try:
                self._found = slump(document, *self._chosen)
            except ToolpathError as error:
                self._found = error
        return self._found

    def tip(self, document: Document, height: float) -> str:
        """Return what is said of the wall at a height."""
        found = self.of(document)
        if isinstance(found, ToolpathError):
            return reason(found)
        lean, worst = _at(found, np.array([height]))
        if worst[0] < 0:
            return ""
        where = f"{_named(found)}: at {height:.4g} {document.unit} "
        if worst[0] == Build.FLOOR:
            return f"{where}it is floor, filled by spirals"
        if not np.isfinite(lean[0]):
            return f"{where}a turn has nothing to rest on, or the printer does not reach"
        held = found.printer.largest_lean
        said = f"{where}a turn lies {lean[0]:.2g} of a bead beside the one below"
        return said if worst[0] == Build.HOLDS else f"{said}; up to {held:g} holds"

    def draw(self, canvas: Canvas, document: Document) -> None:
        """Draw the strip beside the heights, and what leans along the curve."""
        found = self.of(document)
        if isinstance(found, ToolpathError):
            _caption(canvas, reason(found), "warning")
            return
        for places, build in zip(found.places, found.build, strict=True):
            _draw_along(canvas, canvas.transform.map(places), build)
        _draw_strip(canvas, found)
        wall = found.lean[found.build > Build.FLOOR]
        most = float(wall.max(initial=0.0))
        worst = Build(int(found.build.max()))
        lean = f"leans up to {most:.2g} of a bead" if np.isfinite(most) else "cannot all be built"
        colour = _COLOURS.get(worst, "good")
        _caption(canvas, f"{_named(found)}: {lean}", "text" if colour == "good" else colour)


def _named(found: Slump) -> str:
    return f"{found.printer.title}, layer {found.layer:.3g} mm"


def _at(found: Slump, heights: Floats) -> tuple[Floats, Ints]:
    """Return the largest lean, and the worst :class:`Build` or −1 for none, at heights (m,)."""
    h = found.places[..., 1]
    low = np.minimum(h[:, :-1], h[:, 1:]).ravel()
    high = np.maximum(h[:, :-1], h[:, 1:]).ravel()
    build = np.maximum(found.build[:, :-1], found.build[:, 1:]).ravel()
    lean = np.maximum(found.lean[:, :-1], found.lean[:, 1:]).ravel()
    inside = (heights[:, None] >= low) & (heights[:, None] <= high)
    worst = np.where(inside, build, -1).max(axis=1)
    wall = inside & (build > Build.FLOOR)
    return np.where(wall, lean, 0.0).max(axis=1), worst


def _draw_along(canvas: Canvas, places: Floats, build: Ints) -> None:
    """Underlay what leans or fails of one segment, in one line for each run."""
    worst = np.maximum(build[:-1], build[1:])
    edges = np.flatnonzero(np.diff(worst)) + 1
    for first, after in zip(np.r_[0, edges], np.r_[edges, len(worst)], strict=True):
        kind = Build(int(worst[first]))
        if kind >= Build.LEANS:
            pen = canvas.pen(_COLOURS[kind], 11.0, 84)
            canvas.polyline(places[first : after + 1], pen)


def _draw_strip(canvas: Canvas, found: Slump) -> None:
    """Draw one colour for each stretch of heights, against the ruler."""
    area, transform = canvas.area, canvas.transform
    ends = transform.map(found.places).reshape(-1, 2)[:, 1]
    top, bottom = max(area.top, float(ends.min())), min(area.bottom, float(ends.max()))
    if bottom <= top:
        return
    rows = np.arange(int(top), int(bottom) + 1, dtype=np.float64) + 0.5
    _, worst = _at(found, (transform.y0 - rows) / transform.scale)
    edges = np.flatnonzero(np.diff(worst)) + 1
    canvas.painter.setPen(Qt.PenStyle.NoPen)
    for first, after in zip(np.r_[0, edges], np.r_[edges, len(worst)], strict=True):
        if worst[first] > Build.FLOOR:
            colour = canvas.color(_COLOURS[Build(int(worst[first]))])
            box = QRectF(area.left + 1.0, rows[first] - 0.5, SLUMP_WIDTH, float(after - first))
            canvas.painter.fillRect(box, colour)
    canvas.painter.setBrush(Qt.BrushStyle.NoBrush)


def _caption(canvas: Canvas, words: str, colour: str) -> None:
    """Say at the lower edge which printer this is for and what comes out."""
    area = canvas.area
    width, height = canvas.size_of(words)
    left = area.left + SLUMP_WIDTH + 6.0
    box = QRectF(left, area.bottom - height - 6.0, min(width, area.right - left - 4.0), height)
    canvas.text(box, words, canvas.color(colour))
    canvas.occupy(box)
