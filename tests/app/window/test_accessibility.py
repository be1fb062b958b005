"""Every control of the window: named for screen readers, explained, reached by keyboard."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QDialogButtonBox,
    QDockWidget,
    QHeaderView,
    QKeySequenceEdit,
    QLineEdit,
    QScrollBar,
    QTabBar,
    QToolBar,
    QWidget,
)

from tests.app.window_stage import WindowStage

CONTROLS = (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QKeySequenceEdit,
    QLineEdit,
)
# What Qt itself puts into its own widgets, and names.
INNER = (QHeaderView, QScrollBar)


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot)
    yield made
    made.close()


def controls(top):
    for widget in top.findChildren(QWidget):
        if not isinstance(widget, CONTROLS) or isinstance(widget, INNER) or inner(widget):
            continue
        yield widget


def inner(widget):
    """Whether Qt made a widget as a part of another, which carries the name."""
    parent = widget.parentWidget()
    own = (QDockWidget, QTabBar, QToolBar, QDialogButtonBox)
    if isinstance(widget, QAbstractButton) and widget.objectName().startswith("qt_"):
        return True
    if isinstance(parent, own) and not isinstance(parent, QToolBar):
        return True
    if isinstance(parent, (QAbstractSpinBox, QComboBox, QLineEdit, QKeySequenceEdit)):
        return True
    return (
        parent is not None
        and parent.parentWidget() is not None
        and isinstance(parent.parentWidget(), QComboBox)
    )


def describe(widget):
    chain = [widget]
    while chain[-1].parentWidget() is not None:
        chain.append(chain[-1].parentWidget())
    return " < ".join(type(each).__name__ for each in chain[:4]) + f" {widget.objectName()}"


def name_of(widget):
    words = widget.text() if isinstance(widget, QAbstractButton) else ""
    return widget.accessibleName() or words


def everything(stage):
    stage.window.show_preferences()
    stage.window.welcome.show_gallery()
    stage.window.welcome.show_hints()
    stage.window.welcome.start_tour()
    stage.settle()
    return stage.window


def test_every_control_has_a_name(stage):
    nameless = [describe(w) for w in controls(everything(stage)) if not name_of(w).strip()]
    assert nameless == []


def test_every_control_is_explained(stage):
    mute = [
        f"{name_of(w)}: {describe(w)}"
        for w in controls(everything(stage))
        if not (w.toolTip() or w.parentWidget().toolTip())
    ]
    assert mute == []


def test_every_control_is_reached_by_keyboard(stage):
    """Buttons of the toolbar and of the docks' titles stand in the menus too."""
    menus = (QToolBar,)
    out = [
        f"{name_of(w)}: {describe(w)}"
        for w in controls(stage.window)
        if not w.focusPolicy() & Qt.FocusPolicy.TabFocus
        and w.isEnabled()
        and not isinstance(w.parentWidget(), menus)
        and not getattr(w, "shortcut", lambda: None)()
    ]
    assert out == []


def test_tab_walks_through_the_shape_panel_and_on(stage):
    first = stage.slider(0, "lambda1")
    first.setFocus()
    walked = []
    for _ in range(120):
        widget = stage.window.focusWidget()
        walked.append(widget)
        QTest.keyClick(widget, Qt.Key.Key_Tab)
        if stage.window.focusWidget() in walked[:1]:
            break
    names = [name_of(w) for w in walked]
    order = [names.index(f"{symbol} of segment 1") for symbol in ("λ1", "λ2", "λ3", "ω")]
    assert order == sorted(order)
    assert len(set(walked)) > 10


def test_a_focused_control_looks_different(stage):
    for name in ("append_segment", "split_segment"):
        button = stage.window.panels["shape"].buttons[name]
        before = button.grab().toImage()
        button.setFocus(Qt.FocusReason.TabFocusReason)
        stage.settle()
        assert button.hasFocus()
        assert button.grab().toImage() != before
