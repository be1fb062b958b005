"""The measures panel: right values, live, and only while somebody looks."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QTabWidget, QWidget

from app.panels.measures import lines as measure_lines
from app.panels.measures import panel as measures_panel
from app.panels.measures.lines import digits
from app.panels.measures.panel import MeasuresPanel
from app.state.presenter import Presenter
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.body_state import body_state
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
    return {
        name: label.text()
        for name, label in panel.values.items()
        if not label.parentWidget().isHidden()
    }


def test_a_cylinder(qtbot, panel):
    qtbot.waitUntil(lambda: panel.values["Volume"].text() != "–")
    assert shown(panel) == {
        "Encloses": "9.4248 ml",
        "Height": "30.000 mm",
        "Diameter": "20.000 mm",
        "Volume": "9424.8 mm³",
        "Area": "1885.0 mm²",
        "Profile length": "30.000 mm",
        "Certain": "off the axis, monotone, convex",
    }


def test_units(qtbot, panel, presenter):
    presenter.do("unit", lambda document: edits.set_unit(document, Unit.IN, False))
    qtbot.waitUntil(lambda: "in³" in panel.values["Volume"].text())
    ounces = 3000 * 3.14159265 * 25.4**3 / 1000 / 29.5735295625
    assert panel.values["Encloses"].text() == f"{ounces:.1f} fl oz"
    for liquid, text in (("in³", "9424.8 in³"), ("l", "154.44 l"), ("", f"{ounces:.1f} fl oz")):
        panel.liquid_unit.setCurrentIndex(panel.liquid_unit.findData(liquid))
        panel.liquid_unit.activated.emit(panel.liquid_unit.currentIndex())
        assert panel.values["Encloses"].text() == text


def test_follows_the_hand(qtbot, panel, presenter):
    presenter.begin("Height")
    presenter.apply(lambda document: edits.set_height(document, 60.0))
    qtbot.waitUntil(lambda: panel.values["Height"].text() == "60.000 mm")
    assert panel.values["Volume"].text() == "18.850 cm³"
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
    assert lines[0] == "Encloses: 9.4248 ml"
    assert len(lines) == 7


def test_the_first_line_lies_below_the_rim_and_stays_there(qtbot, panel, presenter):
    assert panel.make_vessel.isVisible()
    assert not panel.holding.fill.isVisible()
    panel.make_vessel.click()
    presenter.refresh_now()
    holding = panel.holding
    assert not panel.make_vessel.isVisible()
    holding.fill_on.click()
    presenter.refresh_now()
    assert presenter.document.manufacture.fill.below_rim == 5.0
    assert (holding.fill.value, holding.fill.suffix) == (5.0, "mm")
    assert holding.fill_from.currentText() == "Below the rim"
    holding.fill.setFocus()
    holding.fill.selectAll()
    QTest.keyClicks(holding.fill, "10")
    QTest.keyClick(holding.fill, Qt.Key.Key_Return)
    presenter.do("Height", lambda document: edits.set_height(document, 60.0))
    presenter.refresh_now()
    assert presenter.document.fill_height == 50.0
    assert holding.fill.value == 10.0
    # Counted from elsewhere it stays where it is.
    holding.fill_from.setCurrentIndex(1)
    holding.fill_from.activated.emit(1)
    presenter.refresh_now()
    assert presenter.document.manufacture.fill.height == 50.0
    assert holding.fill.value == 50.0
    holding.fill_on.click()
    assert presenter.document.fill_height is None


def test_enter_makes_it_hold_the_volume_that_stands_there(panel, presenter):
    target = panel.holding.target
    target.setFocus()
    QTest.keyClick(target, Qt.Key.Key_Return)
    assert presenter.session.undo_label == "Hold 350 ml"
    assert presenter.frame.evaluation.volume == pytest.approx(350_000.0, rel=1e-9)
    target.selectAll()
    QTest.keyClicks(target, "200")
    QTest.keyClick(target, Qt.Key.Key_Enter)
    assert presenter.frame.evaluation.volume == pytest.approx(200_000.0, rel=1e-9)


def test_units_are_shown_in_the_fields(panel, presenter):
    assert (panel.clay.density.suffix, panel.clay.percent.suffix) == ("g/cm³", "%")
    assert panel.holding.target.suffix == "ml"
    presenter.do("unit", lambda document: edits.set_unit(document, Unit.IN, False))
    presenter.refresh_now()
    assert panel.holding.target.suffix == "fl oz"
    assert panel.holding.fill.suffix == "in"


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (412631.24, "412631"), (1234.567, "1234.6"), (0.5, "0.5000"), (2e-7, "2e-07")],
)
def test_five_digits(value, text):
    assert digits(value) == text


def test_a_body_has_the_size_with_which_it_leaves(qtbot, panel, presenter):
    presenter.do(
        "Vessel",
        lambda document: edits.set_solid(document, kind="vessel", wall=2, side="outside", base=4),
    )
    document = presenter.document
    presenter.set_body(body_state(document, document.surface, fine=True))
    presenter.refresh_now()
    qtbot.waitUntil(lambda: panel.body_values["Height"].text() == "34.000 mm")
    assert panel.body_values["Diameter"].text() == "24.000 mm"
    assert shown(panel)["Drawn line"] == "⌀ 20.000 mm × 30.000 mm"
    assert "Diameter" not in shown(panel)
    panel.copy_button.click()
    copied = QGuiApplication.clipboard().text().splitlines()
    assert [each for each in copied if each.startswith(("Height", "Diameter"))] == [
        "Height: 34.000 mm",
        "Diameter: 24.000 mm",
    ]
