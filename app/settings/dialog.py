"""All preferences in one place; each applies at once, and the window goes on working beside."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from app.settings.shortcut_editor import KeyEditor
from app.state import preferences
from app.state.preferences import TEXT_PERCENT, Preferences
from app.theme import theme
from app.widgets.form import Row, add_rows, offering
from app.widgets.labels import take_labels
from app.widgets.number_field import NumberField
from sgb_core.document.model import Unit

STYLES = {
    "studio": "SGB Studio: left drag orbits, Shift or middle drag pans",
    "blender": "Blender: middle drag orbits, Shift+middle drag pans",
    "rhino": "Rhino: right drag orbits, Shift+right drag pans",
    "fusion": "Fusion: Shift+middle drag orbits, middle drag pans",
}
UNITS = {Unit.MM: "Millimetres", Unit.CM: "Centimetres", Unit.IN: "Inches"}


class PreferencesDialog(QDialog):
    """Reads and writes :mod:`app.state.preferences`, the theme and the keys."""

    def __init__(
        self, set_theme: Callable[[theme.Choice], object], keys: KeyEditor, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle("Preferences")
        self.setModal(False)
        self.keys = keys
        self.tabs = QTabWidget(self)
        self.tabs.setAccessibleName("Preferences")
        self.tabs.addTab(self._build_general(Preferences()), "General")
        self.tabs.addTab(self._build_viewport(), "Viewport")
        self.tabs.addTab(keys, "Keys")
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.close)
        buttons.button(QDialogButtonBox.StandardButton.Close).setAutoDefault(False)
        layout = QVBoxLayout(self)
        layout.addWidget(self.tabs, 1)
        layout.addWidget(buttons)
        take_labels(self)
        self.resize(560, 480)
        self._show(preferences.current())
        self._connect(set_theme)
        preferences.notifier().changed.connect(self._show)
        theme.notifier().changed.connect(self._theme_changed)

    def _build_general(self, usual: Preferences) -> QWidget:
        self.theme = _choice(theme.CHOICES)
        self.text = _whole(TEXT_PERCENT, usual.text_percent, step=10.0)
        self.unit = _choice(UNITS)
        self.snap = NumberField(
            minimum=0.0, maximum=1e6, step=0.5, reset=usual.snap_step, words={0.0: "as the grid"}
        )
        self.gallery = QCheckBox("Open the gallery at every start")
        self.legs = QCheckBox("A joint keeps its handles in proportion")
        self.crossing = QCheckBox("Let points go through the axis")
        return _page(
            Row("Theme", self.theme, "Light, dark, or as the system has it"),
            Row("Text size, %", self.text, "Percent of the system's text size", "Text size"),
            Row(
                "Unit of new documents",
                self.unit,
                "The unit of new documents; open ones keep theirs",
                "Unit",
            ),
            Row(
                "Snap step",
                self.snap,
                "Dragged points snap to multiples of this; 0 is the grid that is seen",
            ),
            Row("", self.legs, "Else a joint carries them as they are; H switches in a drag"),
            Row("", self.crossing, "Else what is dragged stops at the axis"),
            Row("", self.gallery, "Else only at the very first one"),
        )

    def _build_viewport(self) -> QWidget:
        self.navigation = _choice(STYLES)
        self.animate = QCheckBox("Glide to standard views")
        self.invert = QCheckBox("Turn the wheel the other way")
        return _page(
            Row("Navigation", self.navigation, "Which buttons of the mouse turn and pan"),
            Row("", self.animate, "Move there smoothly instead of at once"),
            Row("", self.invert, "Wheel up zooms out"),
        )

    def _connect(self, set_theme: Callable[[theme.Choice], object]) -> None:
        change = preferences.change
        self.theme.activated.connect(lambda _index: set_theme(self.theme.currentData()))
        # What a combo box keeps of an enumeration is its plain value.
        self.unit.activated.connect(lambda _index: change(new_unit=Unit(self.unit.currentData())))
        self.navigation.activated.connect(
            lambda _index: change(navigation_style=self.navigation.currentData())
        )
        self.text.changed.connect(lambda value: change(text_percent=round(value)))
        self.snap.changed.connect(lambda value: change(snap_step=value))
        self.gallery.toggled.connect(lambda on: change(gallery_at_start=on))
        self.legs.toggled.connect(lambda on: change(scale_legs=on))
        self.crossing.toggled.connect(lambda on: change(cross_axis=on))
        self.animate.toggled.connect(lambda on: change(animate_views=on))
        self.invert.toggled.connect(lambda on: change(invert_wheel=on))

    def _show(self, wanted: Preferences) -> None:
        parts = (
            self.theme,
            self.unit,
            self.navigation,
            self.gallery,
            self.legs,
            self.crossing,
            self.animate,
            self.invert,
        )
        blockers = [QSignalBlocker(part) for part in parts]
        self.theme.setCurrentIndex(self.theme.findData(theme.choice()))
        self.unit.setCurrentIndex(self.unit.findData(wanted.new_unit))
        self.navigation.setCurrentIndex(self.navigation.findData(wanted.navigation_style))
        self.text.set_value(wanted.text_percent)
        self.gallery.setChecked(wanted.gallery_at_start)
        self.legs.setChecked(wanted.scale_legs)
        self.crossing.setChecked(wanted.cross_axis)
        self.animate.setChecked(wanted.animate_views)
        self.invert.setChecked(wanted.invert_wheel)
        self.snap.set_value(wanted.snap_step)
        del blockers

    def _theme_changed(self, _palette: theme.Palette) -> None:
        self._show(preferences.current())
        self.keys.refresh()


def _choice(choices: Mapping[Any, str]) -> QComboBox:
    combo = offering(QComboBox(), ((text, value) for value, text in choices.items()))
    combo.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
    combo.setMinimumContentsLength(24)
    for index, text in enumerate(choices.values()):
        combo.setItemData(index, text, Qt.ItemDataRole.ToolTipRole)
    return combo


def _whole(limits: tuple[int, int], usual: int, step: float) -> NumberField:
    low, high = limits
    return NumberField(minimum=low, maximum=high, step=step, whole=True, reset=usual)


def _page(*rows: Row) -> QWidget:
    page = QWidget()
    form = QFormLayout(page)
    form.setHorizontalSpacing(16)
    form.setVerticalSpacing(8)
    add_rows(form, rows)
    return page
