"""The slump line in the profile editor: what is seen and said while a wall is sculpted."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF
from PySide6.QtGui import QHelpEvent, QImage
from PySide6.QtWidgets import QApplication, QToolTip

from app.profile_editor.slump_line import SLUMP_WIDTH
from app.state import preferences
from app.state.overlays import Overlay
from app.theme import theme
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.model import Document
from tests.app.profile_editor.bench import Bench

# Steep, then leaning by 1.5 · 4/3 / 5 = 0.4 of a bead of the generic clay printer.
JAR = Document(Profile.of([line((30.0, 0.0), (30.0, 60.0)), line((30.0, 60.0), (70.0, 90.0))]))


@pytest.fixture
def bench(qtbot):
    preferences.change(printer="generic-clay", print_layer=1.5)
    found = Bench(qtbot, JAR)
    found.presenter.toggle_overlay(Overlay.SLUMP)
    found.settle()
    yield found
    preferences.change(printer="", print_layer=0.0)


def strip(bench: Bench, height: float) -> str:
    """Return the meaning of the colour beside a height."""
    image = bench.view.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
    x = bench.view.area.left + SLUMP_WIDTH / 2.0
    y = bench.view.transform.map(np.array((0.0, height)))[1]
    ratio = image.devicePixelRatio()
    found = image.pixelColor(QPoint(round(x * ratio), round(y * ratio))).name()
    palette = theme.current()
    named = {palette.good: "holds", palette.warning: "leans", palette.error: "fails"}
    return named.get(found, "nothing")


def tip(bench: Bench, height: float) -> str:
    y = bench.view.transform.map(np.array((0.0, height)))[1]
    at = QPointF(bench.view.area.left + 2.0, y).toPoint()
    QApplication.sendEvent(
        bench.view, QHelpEvent(QHelpEvent.Type.ToolTip, at, bench.view.mapToGlobal(at))
    )
    return QToolTip.text()


def test_what_a_printer_can_build_is_seen_beside_the_heights(bench) -> None:
    assert (strip(bench, 30.0), strip(bench, 75.0)) == ("holds", "holds")
    bench.presenter.do("lean", lambda d: edits.move_point(d, 1, 3, (85.0, 90.0)))
    bench.settle()
    assert (strip(bench, 30.0), strip(bench, 75.0)) == ("holds", "leans")
    bench.presenter.do("lean", _level)
    bench.settle()
    assert (strip(bench, 30.0), strip(bench, 64.0)) == ("holds", "fails")
    assert strip(bench, 95.0) == "nothing"
    bench.presenter.toggle_overlay(Overlay.SLUMP)
    bench.settle()
    assert strip(bench, 30.0) == "nothing"


def test_it_follows_a_drag_and_the_printer_chosen(bench) -> None:
    bench.drag(bench.place(1, 3), bench.screen((90.0, 90.0)))
    assert strip(bench, 85.0) == "leans"
    preferences.change(print_layer=0.5)
    QApplication.processEvents()
    assert strip(bench, 85.0) == "holds"


def test_a_hover_says_by_how_much_a_turn_leans(bench) -> None:
    assert "0 of a bead" in tip(bench, 30.0)
    words = tip(bench, 75.0)
    assert "0.4 of a bead" in words
    assert "layer 1.5 mm" in words


def _level(document: Document) -> Document:
    return replace(
        document, profile=Profile.of([JAR.profile.segments[0], line((30.0, 60.0), (90.0, 66.0))])
    )


def _half(document: Document) -> Document:
    return replace(document, revolution=replace(document.revolution, sweep_deg=180.0))


def test_what_has_no_wall_is_said(qtbot, bench) -> None:
    bench.presenter.do("half", _half)
    bench.settle()
    assert "part of a turn" in tip(bench, 30.0)
    assert strip(bench, 30.0) == "nothing"
