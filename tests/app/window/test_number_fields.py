"""Every number of the window has a label that resets it, steps, units and the same menu."""

from itertools import pairwise

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractSpinBox, QApplication, QLabel, QWidget

from app.commands.scale_dialog import ScaleDialog
from app.export.dialog import ExportDialog
from app.export.picture_dialog import PictureDialog
from app.figures.fit_dialog import FitDialog
from app.figures.studio_form import StudioForm
from app.film.dialog import FilmDialog
from app.panels.solid.cut_outs import COUNTS, LENGTHS
from app.panels.turn.placement import PlaceSection
from app.widgets.number_field import NumberField
from app.widgets.slider_row import SliderRow
from app.window.panels import PANELS
from sgb_core.bodies.solid import BodyKind
from sgb_core.document import edits
from sgb_core.document.appearance.model import Layer, LayerKind, Texture
from sgb_core.document.body_state import BodyState
from sgb_core.surfaces.variation import Law
from tests.app.waiting import let_turn
from tests.app.window_stage import WindowStage

# Parts of one line differ in the height of their middles by less than this.
LINE = 8
# Numbers of which the surface shows nothing.
STILL = {
    "Volume to hold",
    "Overhang angle in degrees",
    "Density",
    "Shrinkage in percent",
    # Holes are cut when the hand rests.
    *(f"{row.label}, number" for row in LENGTHS),
    *(row.label for row in COUNTS),
    "Darker than",
}


@pytest.fixture(scope="module")
def everything():
    """Return an edit that lets a document have every kind of number."""

    def edit(document):
        document = edits.set_solid(document, kind=BodyKind.VESSEL)
        document = edits.set_fill(document, 60.0)
        document = edits.add_law(document, Law("omega", "cosine", 0.0, 1.0, None, 7))
        layers = (Layer(LayerKind.STRIPES, count=9), Layer(LayerKind.STRIPES))
        return edits.set_appearance(document, drawing=layers, textures=(Texture("wood"),))

    return edit


@pytest.fixture
def stage(qtbot, everything):
    stage = WindowStage(qtbot, wait_for_scene=False)
    # The fields are looked at, not the body: measuring one with laws takes its time.
    stage.window.body_work._make = BodyState
    stage.window.files.new_from_preset("vase")
    stage.presenter.do("Everything", everything)
    stage.presenter.refresh_now()
    yield stage
    stage.close()


def double_click(widget):
    at = QPointF(widget.rect().center())
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    kind = QEvent.Type.MouseButtonDblClick
    there = QPointF(widget.mapToGlobal(at))
    QApplication.sendEvent(widget, QMouseEvent(kind, at, there, left, left, none))


def label_of(field):
    """Return the label that a person would take for that of a field."""
    holder = field.parentWidget()
    if isinstance(holder, SliderRow):
        return holder.label
    if isinstance(holder, PlaceSection):
        key = next(key for (key, _axis), each in holder.fields.items() if each is field)
        return next(label for label, name in holder.labels.items() if name == key)
    named = [each for each in field.window().findChildren(QLabel) if each.buddy() is field]
    assert named, field.accessibleName()
    return named[0]


def entries(field):
    return {action.text().split(" to ")[0]: action for action in field.menu(field).actions()}


def another(field):
    """Return a value that the field takes, other than its own and the one it resets to."""
    usual = field.reset_value
    for value in (usual + 1.0, usual - 1.0, 0.5 * usual, 0.5 * usual + 0.1):
        try:
            if field.kind.parsed(repr(value)) not in (field.value, usual):
                return value
        except ValueError:
            continue
    raise AssertionError(field.accessibleName())


def check(field, settle):
    """Reset a field by its label and by its menu, after changing it."""
    assert field.accessibleName()
    assert field.toolTip()
    offered = entries(field)
    assert {"Reset", "Copy value", "Paste value"} <= offered.keys()
    ways = [lambda: entries(field)["Reset"].trigger()]
    if field.accessibleName() != "Height of the fill line":
        # Its label is the box that switches the line.
        ways.insert(0, lambda: double_click(label_of(field)))
    for way in ways:
        usual = field.reset_value
        field.enter(another(field))
        settle()
        way()
        settle()
        assert field.value == pytest.approx(usual, rel=1e-9), field.accessibleName()


def test_every_number_of_the_panels(stage):
    window, seen = stage.window, set()

    def settle():
        stage.presenter.refresh_now()
        for kind in PANELS:
            # Panels that nobody sees are brought up to date when they are asked for.
            assert window.panels[kind.key] is not None

    for field in window.findChildren(NumberField):
        if field.isEnabled():
            check(field, settle)
            seen.add(field.accessibleName())
            assert ("Animate" in entries(field)) is (field.accessibleName() not in STILL)
    assert len(seen) > 40
    assert {"Height", "Wall, number", "Around", "Number of waves n", "Width", *STILL} <= seen


def stations(window, panel):
    """Return the middles of what F6 and then Tab come to in a panel."""
    part = strike(window, Qt.Key.Key_F6)
    while not panel.isAncestorOf(part):
        part = strike(window, Qt.Key.Key_F6)
    found = []
    while panel.isAncestorOf(part):
        at = part.mapTo(panel, part.rect().center())
        found.append((at.y(), at.x()))
        part = strike(window, Qt.Key.Key_Tab)
    return found


def strike(window, key):
    QTest.keyClick(window.windowHandle(), key)
    return QApplication.focusWidget()


def test_tab_walks_through_every_panel_as_it_is_read(stage, qtbot):
    window = stage.window
    for name in ("shape", "turn", "vary", "solid", "measures", "look"):
        window.panels.docks[name].raise_()
        panel = window.panels[name]
        qtbot.waitUntil(lambda panel=panel: not panel.visibleRegion().isEmpty())
        let_turn()
        walk = stations(window, panel)
        assert len(walk) > 6
        for (y, x), (below, beside) in pairwise(walk):
            # Down, or to the right on the same line.
            assert below > y + LINE or (abs(below - y) <= LINE and beside > x), (name, y, x)


def test_every_number_of_the_dialogs(stage, qtbot):
    window, document = stage.window, stage.document
    window.show_preferences()
    dialogs: list[QWidget] = [
        window._preferences,
        ExportDialog(document, (".stl",), window),
        FilmDialog(document, 0, window),
        PictureDialog((800, 600), window),
        FitDialog(stage.presenter, window.jobs, window),
        ScaleDialog(stage.presenter, window),
        StudioForm(window),
    ]
    export = dialogs[1]
    counts = []
    for dialog in dialogs:
        assert not dialog.findChildren(QAbstractSpinBox)
        fields = dialog.findChildren(NumberField)
        counts.append(len(fields))
        for field in fields:
            radios = {
                export.tolerance_field: export.by_tolerance,
                export.count: export.by_count,
                export.along: export.by_samples,
            }
            field.setEnabled(True)
            if field in radios:
                radios[field].setChecked(True)
                field.enter(another(field))
                double_click(radios[field])
                assert field.value == field.reset_value
            elif any(each.buddy() is field for each in dialog.findChildren(QLabel)):
                check(field, QApplication.processEvents)
    assert min(counts) >= 2
    for dialog in dialogs[:-1]:
        dialog.reject()


def test_a_number_is_applied_to_all_laws_layers_and_textures(stage):
    window = stage.window
    second = Law("omega", "cosine", 0.0, 0.5, None, 3)
    stage.presenter.do("Law", lambda d: edits.add_law(d, second))
    stage.presenter.refresh_now()
    form = window.panels["vary"].form
    entries(form.numbers["count"])["Apply"]
    form.numbers["count"].menu(form.numbers["count"]).actions()[-2].trigger()
    assert {law.count for law in stage.document.variation} == {7}
    drawing = window.panels["look"].findChildren(QWidget)
    count = next(each for each in drawing if each.accessibleName() == "Number")
    entries(count)["Apply"].trigger()
    assert {layer.count for layer in stage.document.appearance.drawing} == {9}


def test_animating_a_number_shows_its_values_and_leaves_nothing(stage, qtbot):
    window, before, shown = stage.window, stage.document, []
    stage.session.subscribe(lambda _old, new: shown.append(new))
    field, sway = window.panels["turn"].height_field, window.panels["turn"].sway
    entries(field)["Animate"].trigger()
    assert sway.running
    # On a slow machine the whole swing may pass while the window draws once.
    qtbot.waitUntil(lambda: any(document is not before for document in shown))
    sway.stop()
    assert stage.document is before


def test_ctrl_e_exports_from_a_number_field(stage, qtbot, monkeypatch):
    opened = []
    monkeypatch.setattr(ExportDialog, "exec", lambda dialog: opened.append(dialog) or 0)
    field = stage.window.panels["shape"].cards[0].rows["omega"].field
    field.setFocus()
    qtbot.waitUntil(field.hasFocus)
    QTest.keyClick(stage.window.windowHandle(), Qt.Key.Key_E, Qt.KeyboardModifier.ControlModifier)
    assert len(opened) == 1
    field.selectAll()
    QTest.keyClick(stage.window.windowHandle(), Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert QApplication.clipboard().text() == field.text()


def test_tab_leads_from_number_to_number_and_from_slider_to_slider(stage, qtbot):
    window = stage.window
    stage.presenter.do("Vessel", lambda document: edits.set_solid(document, kind="vessel"))
    window.panels.docks["solid"].raise_()
    stage.settle()
    rows = list(window.panels["solid"].rows.values())
    for part in ("field", "slider"):
        getattr(rows[0], part).setFocus(Qt.FocusReason.TabFocusReason)
        qtbot.waitUntil(getattr(rows[0], part).hasFocus)
        for row in rows[1:]:
            assert strike(window, Qt.Key.Key_Tab) is getattr(row, part)
        for row in rows[-2::-1]:
            assert strike(window, Qt.Key.Key_Backtab) is getattr(row, part)
    # The keyboard comes from a slider to its number.
    assert strike(window, Qt.Key.Key_Return) is rows[0].field
