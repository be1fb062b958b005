"""What all curves with keys show: their keys, which is selected, which is told of."""

from __future__ import annotations

from math import hypot

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.theme import theme
from app.widgets.plot import Plot
from sgb_core.surfaces.variation import Law

Key = tuple[float, float]

# A press so near a key, in pixels, takes it.
REACH = 9.0


class KeySheet(QWidget):
    """Shows one curve of a law; a kind of curve says where its keys lie, and draws it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._law: Law | None = None
        self._selected: int | None = None
        self._over: int | None = None
        self._pointer: QPointF | None = None
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        theme.notifier().changed.connect(self._theme_changed)

    # What a kind of curve says.

    def place(self, x: float, y: float) -> QPointF:
        """Return where a pair of values lies, in pixels."""
        raise NotImplementedError

    def read(self, at: QPointF) -> Key:
        """Return the values at a place, not limited to the plot."""
        raise NotImplementedError

    def _keys_of(self, law: Law) -> tuple[Key, ...]:
        raise NotImplementedError

    def _key_words(self, index: int) -> str:
        """Return where a key lies, in words."""
        raise NotImplementedError

    def _places_of(self, key: Key) -> tuple[QPointF, ...]:
        """Return where a key is seen, in pixels; its own place first."""
        return (self.place(*key),)

    # What is shown.

    @property
    def selected(self) -> int | None:
        """The number of the selected key."""
        return self._selected

    @property
    def _keys(self) -> tuple[Key, ...]:
        return () if self._law is None else self._keys_of(self._law)

    @property
    def _marked(self) -> int | None:
        """The key that is told of: under the pointer, or selected by the keyboard."""
        if self._over is None and self._pointer is None and self.hasFocus():
            return self._selected
        return self._over

    def _show(self, law: Law | None) -> None:
        self._law = law
        count = len(self._keys)
        if self._selected is not None and self._selected >= count:
            self._selected = None
        if self._over is not None and self._over >= count:
            self._over = None
        self._describe()
        self.update()

    def _key_at(self, at: QPointF) -> int | None:
        best, least = None, REACH
        for index, key in enumerate(self._keys):
            steps = [place - at for place in self._places_of(key)]
            distance = min(hypot(step.x(), step.y()) for step in steps)
            if distance <= least:
                best, least = index, distance
        return best

    def _column(self, key: Key) -> float:
        return self._places_of(key)[0].x()

    def _select(self, index: int | None) -> None:
        self._selected = index
        self._describe()
        self.update()

    def _describe(self) -> None:
        index, words = self._selected, ""
        if index is not None and index < len(self._keys):
            words = f"Key {index + 1} of {len(self._keys)}: {self._key_words(index)}"
        self.setAccessibleDescription(words)

    def _theme_changed(self, _palette: object) -> None:
        self.update()

    def _paint_focus(self, painter: QPainter, plot: Plot) -> None:
        if self.hasFocus():
            painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
            painter.setPen(QPen(QColor(theme.current().accent), 1.0))
            painter.drawRect(plot.box.adjusted(-1, -1, 1, 1))
