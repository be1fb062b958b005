"""The curve of a law's strength along the height: how far flutes reach, where a spout sets in."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QSize
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from app.panels.laws.height_picture import Scale, paint_heights, strengths_of
from app.panels.laws.key_curve import HELP, SNAP, KeyCurve
from app.panels.laws.key_sheet import Key
from app.theme.fonts import small_font
from sgb_core.document import edits
from sgb_core.surfaces.variation import Law

ROUND_SHARE, ROUND_STRENGTH = 0.05, 0.25


class HeightCurve(KeyCurve):
    """Shows k(u) of one law of the radius and lets its keys be moved."""

    NUDGE = (0.01, 0.01)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName("Strength along the height")
        self.setToolTip(
            "How strong the law is along the height, from the foot on the left to the rim on the\n"
            f"right; without keys it is as strong at every height.\n{HELP}"
        )

    def show_law(self, law: Law) -> None:
        """Show a law of the radius."""
        if law != self._law:
            self._show(law)

    @property
    def scale(self) -> Scale:
        """Where shares of the height and strengths lie in this widget."""
        return Scale.of(float(self.width()), float(self.height()), self._keys)

    def place(self, x: float, y: float) -> QPointF:
        """Return where a share of the height and a strength lie, in pixels."""
        return self.scale.place(x, y)

    def read(self, at: QPointF) -> Key:
        """Return the share of the height and the strength at a place, not limited to the plot."""
        return self.scale.read(at)

    def sizeHint(self) -> QSize:
        return QSize(220, 92)

    def minimumSizeHint(self) -> QSize:
        return QSize(160, 80)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        font, scale = small_font(self.font()), self.scale
        paint_heights(painter, scale, self._keys, self._selected, self._marked, font)
        self._paint_focus(painter, scale.plot)
        painter.end()

    def _keys_of(self, law: Law) -> tuple[Key, ...]:
        return law.along

    def _step_name(self, verb: str) -> str:
        return f"{verb} key along the height"

    def _key_words(self, index: int) -> str:
        u, k = self._keys[index]
        return f"{u:.0%} of the height, {k:.0%} strong"

    def _snapped(self, at: Key, levels: list[float]) -> Key:
        (u, k), box = at, self.scale.plot
        near = ROUND_SHARE * round(u / ROUND_SHARE)
        u = near if abs(near - u) * box.width <= SNAP else u
        marks = [ROUND_STRENGTH * round(k / ROUND_STRENGTH), *levels]
        mark = min(marks, key=lambda each: abs(each - k))
        reach = self.scale.high - self.scale.low
        return round(u, 4), mark if abs(mark - k) / reach * box.height <= SNAP else round(k, 3)

    def _within(self, k: float) -> float:
        return min(max(k, self.scale.low), self.scale.high)

    def _moved(self, law: Law, index: int, to: Key) -> Law:
        return edits.with_strength_moved(law, index, to[0], self._within(to[1]))

    def _without(self, law: Law, index: int) -> Law:
        return edits.without_strength(law, index)

    def _with(self, law: Law, key: Key) -> Law:
        u, k = min(max(key[0], 0.0), 1.0), self._within(key[1])
        # The first key alone would change the strength at every height.
        whole = law if law.along else edits.with_strength(law, 1.0 if u < 0.5 else 0.0, 1.0)
        return edits.with_strength(whole, u, k)

    def _between(self, law: Law, selected: int | None) -> Key:
        shares = [u for u, _ in law.along]
        here = shares[selected] if selected is not None else 0.0
        after = next((u for u in shares if u > here), 1.0)
        u = (here + after) / 2.0 if shares else 0.5
        return u, float(strengths_of(law.along, [u])[0])
