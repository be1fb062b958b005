"""Scaling several points together by numbers, seen while they are typed."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QVBoxLayout,
    QWidget,
)

from app.commands.command import Command
from app.hand.hit_test import PointId, canonical, distinct_points
from app.state.edit_gesture import EditGesture
from app.state.presenter import Presenter
from app.widgets.labels import take_labels
from app.widgets.number_field import NumberField
from sgb_core.document import edits

# About what the points are scaled.
_ABOUT = ("the middle of the points", "the axis and the lowest point", "the axis and the top point")


def selection_commands(presenter: Presenter, window: QWidget) -> list[Command]:
    """Return the commands of the Edit menu that change the selected points together."""
    return [
        Command(
            "scale_selection",
            "Edit",
            "Scale points…",
            lambda: ScaleDialog(presenter, window).show(),
            "Ctrl+T",
            tip="Scale the selected points, or all, by numbers",
        ),
        Command(
            "mirror_selection_height",
            "Edit",
            "Mirror points upside down",
            lambda: mirror(presenter, (1.0, -1.0)),
            "Ctrl+Shift+H",
            tip="Mirror the selected points, or all, in the level through their middle",
        ),
        Command(
            "mirror_selection_radius",
            "Edit",
            "Mirror points inside out",
            lambda: mirror(presenter, (-1.0, 1.0)),
            "Ctrl+Shift+J",
            tip="Mirror the selected points, or all, in the upright line through their middle",
        ),
    ]


def meant_points(presenter: Presenter) -> list[PointId]:
    """Return the selected points, or all where none are selected."""
    profile = presenter.document.profile
    return canonical(profile, presenter.view.points) or distinct_points(profile)


def mirror(presenter: Presenter, factors: tuple[float, float]) -> None:
    """Mirror the selected points about the middle of their box."""
    points = meant_points(presenter)
    presenter.do(f"Mirror {len(points)} points", lambda d: edits.scale_points(d, points, factors))


class ScaleDialog(QDialog):
    """Two factors, one for the radii and one for the heights; Cancel takes everything back."""

    def __init__(self, presenter: Presenter, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._presenter = presenter
        self._points = meant_points(presenter)
        self.setWindowTitle(f"Scale {len(self._points)} points")
        self._gesture = EditGesture(presenter)
        self._heights = presenter.document.profile.control_points[..., 1]
        self.radius_factor = self._factor("Factor of the radii")
        self.height_factor = self._factor("Factor of the heights")
        self.together = QCheckBox("Keep the proportions", self)
        self.together.setChecked(True)
        self.about = QComboBox(self)
        self.about.addItems([text.capitalize() for text in _ABOUT])
        self.about.setAccessibleName("Scale about")
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel, self
        )
        form = QFormLayout()
        form.addRow("Radius ×", self.radius_factor)
        form.addRow("Height ×", self.height_factor)
        form.addRow("", self.together)
        form.addRow("About", self.about)
        layout = QVBoxLayout(self)
        layout.addLayout(form)
        layout.addWidget(buttons)
        take_labels(self)
        self.radius_factor.changed.connect(lambda value: self._changed(self.height_factor, value))
        self.height_factor.changed.connect(lambda value: self._changed(self.radius_factor, value))
        self.together.toggled.connect(
            lambda on: self._changed(self.height_factor, self.radius_factor.value) if on else None
        )
        self.about.currentIndexChanged.connect(lambda _index: self._apply())
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        self._gesture.begin(f"Scale {len(self._points)} points")

    def _factor(self, name: str) -> NumberField:
        field = NumberField(minimum=0.0, above_minimum=True, step=0.05, decimals=4, reset=1.0)
        field.setParent(self)
        field.setAccessibleName(name)
        field.set_help(f"{name} of the points; below 1 they come together")
        return field

    def _changed(self, other: NumberField, value: float) -> None:
        if self.together.isChecked():
            other.set_value(value)
        self._apply()

    def _apply(self) -> None:
        factors = (self.radius_factor.value, self.height_factor.value)
        chosen = [self._heights[key] for key in self._points]
        about = (None, (0.0, min(chosen)), (0.0, max(chosen)))[self.about.currentIndex()]
        self._gesture.apply(lambda d: edits.scale_points(d, self._points, factors, about))

    def accept(self) -> None:
        """Keep what has been done."""
        self._gesture.commit()
        super().accept()

    def reject(self) -> None:
        """Take everything back."""
        self._gesture.cancel()
        super().reject()
