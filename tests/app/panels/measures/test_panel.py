"""The measures panel: right values, live, and only while somebody looks."""

import pytest
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QTabWidget, QWidget

from app.panels.measures import lines as measure_lines
from app.panels.measures import panel as measures_panel
from app.panels.measures.lines import digits
from app.panels.measures.panel import MeasuresPanel
from app.state.presenter import Presenter
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.model import Document, Unit
from sgb_core.document.session import Session
from sgb_core.surfaces.variation import Law
from tests.app.waiting import let_turn, show

# A cylinder of radius 10 and height 30: V = 3000π, A = 600π.
CYLINDER = Document(Profile.of([Segment([(10.0, 0.0), (10.0, 10.0), (10.0, 20.0), (10.0, 30.0)])]))


@pytest.fixture
def presenter(qtbot):
    return Presenter(Session(CYLINDER))


@pytest.fixture
def panel(qtbot, presenter):
    panel = MeasuresPanel(presenter)
    presenter.add_view(panel)
    show(qtbot, panel)
    return panel


def shown(panel):
    return {name: label.text() for name, label in panel.values.items()}


def test_a_cylinder(qtbot, panel):
    qtbot.waitUntil(lambda: panel.values["Volume"].text() != "–")
    assert shown(panel) == {
        "Volume": "9424.8 mm³",
        "as liquid": "9.4248 ml",
        "Area": "1885.0 mm²",
        "Height": "30.000 mm",
        "Diameter": "20.000 mm",
        "Profile length": "30.000 mm",
        "Certain": "off the axis, monotone, convex",
    }


def test_units(qtbot, panel, presenter):
    presenter.do("unit", lambda document: edits.set_unit(document, Unit.IN, False))
    qtbot.waitUntil(lambda: "in³" in panel.values["Volume"].text())
    litres = 3000 * 3.14159265 * 25.4**3 / 1e6
    assert panel.values["as liquid"].text() == f"{litres:.2f} l"


def test_follows_the_hand(qtbot, panel, presenter):
    presenter.begin("Height")
    presenter.apply(lambda document: edits.set_height(document, 60.0))
    qtbot.waitUntil(lambda: panel.values["Height"].text() == "60.000 mm")
    assert panel.values["Volume"].text() == "18850 mm³"
    presenter.cancel()
    qtbot.waitUntil(lambda: panel.values["Height"].text() == "30.000 mm")


def test_waits_with_laws_until_the_hand_stops(qtbot, panel, presenter):
    law = Law("omega", "cosine", 0.0, 1.0, count=2)
    presenter.do("Law", lambda document: edits.set_variation(document, (law,)))
    qtbot.waitUntil(lambda: panel.values["Volume"].text() != "–")
    before = shown(panel)
    presenter.begin("Height")
    presenter.apply(lambda document: edits.set_height(document, 60.0))
    qtbot.wait(3 * measures_panel.PAUSE_MILLISECONDS)
    assert shown(panel) == before
    presenter.commit()
    qtbot.waitUntil(lambda: panel.values["Height"].text() == "60.000 mm")


def test_measures_nothing_while_it_cannot_be_seen(qtbot, presenter, monkeypatch):
    asked = []
    monkeypatch.setattr(measure_lines.measures, "area", lambda surface: asked.append(surface) or 1)
    tabs = QTabWidget()
    panel = MeasuresPanel(presenter)
    presenter.add_view(panel)
    tabs.addTab(QWidget(), "first")
    tabs.addTab(panel, "measures")
    show(qtbot, tabs)
    qtbot.wait(3 * measures_panel.PAUSE_MILLISECONDS)
    assert asked == []
    tabs.setCurrentIndex(1)
    qtbot.waitUntil(lambda: len(asked) == 1)


def test_all_can_be_copied(qtbot, panel):
    let_turn()
    panel.copy_button.click()
    lines = QGuiApplication.clipboard().text().splitlines()
    assert lines[0] == "Volume: 9424.8 mm³"
    assert len(lines) == 7


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (412631.24, "412631"), (1234.567, "1234.6"), (0.5, "0.5000"), (2e-7, "2e-07")],
)
def test_five_digits(value, text):
    assert digits(value) == text
