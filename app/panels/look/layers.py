"""The drawing part of the look panel: layers of paint, each set by numbers."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLineEdit,
    QListWidget,
    QMenu,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from app.panels.look.form import Change, LookForm, show_choice, show_depths
from app.state.presenter import Frame, Presenter
from app.state.window_reader import WINDOW
from app.theme import icons
from app.widgets.gradient_bar import GradientBar
from app.widgets.menu_button import open_menu
from app.widgets.number_field import NumberField
from sgb_core.document import edits
from sgb_core.document.appearance.model import Along, Appearance, Layer, LayerKind
from sgb_core.document.edits import usual_layer
from sgb_core.fields.kinds import LONGEST_LINE
from sgb_core.fields.record import table_of
from sgb_core.lettering.fonts import TITLES as TITLES_OF_FONTS
from sgb_core.values import dataclass

TITLES = {
    LayerKind.BAND: "Band",
    LayerKind.RINGS: "Rings",
    LayerKind.STRIPES: "Stripes",
    LayerKind.GRADIENT: "Gradient",
    LayerKind.SEGMENTS: "Segment colours",
    LayerKind.TEXT: "Text",
}


@dataclass(frozen=True, slots=True)
class Steps:
    """Which numbers an animation passes, in what steps; ``scale`` of one of the layer's."""

    span: tuple[float, float]
    step: float = 1.0
    scale: float = 1.0


PERCENT = Steps((0.0, 100.0), scale=100.0)
DEPTHS = Steps((-2.0, 2.0), step=0.1)
WIDTHS = Steps((0.5, 6.0), step=0.5)


class DrawingPart(LookForm):
    """The layers, the lowest first, and the numbers of the chosen one."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(presenter, "Drawing", parent)
        self.layers = QListWidget(self)
        self.layers.setAccessibleName("Layers of paint")
        self.layers.setToolTip("Later layers lie over earlier ones")
        self.layers.setMaximumHeight(96)
        self.layers.currentRowChanged.connect(lambda _row: self._show_layer())
        self.form.addRow(self.layers)
        self.form.addRow(self._buttons())
        self.colour_button = self.colour("Colour", self._sets("color"))
        self.stops = GradientBar(self)
        self.stops.began.connect(lambda: self._gesture.begin("Gradient"))
        self.stops.changed.connect(self._gesture_stops)
        self.stops.ended.connect(self._gesture.commit)
        self.form.addRow("Colours", self.stops)
        self._build_words()
        self.start = self._layer_number("From", "start", "Where it begins")
        self.end = self._layer_number("To", "end", "Where it ends")
        self.by = self.combo(
            "Measured by",
            [("Height", Along.HEIGHT), ("Profile length", Along.LENGTH)],
            lambda v: self.do("Measured by", lambda look: self._with(look, by=v)),
            "Of what the positions are parts",
        )
        self.count = self._layer_number(
            "Number",
            "count",
            "How many rings or stripes, or how often the text stands around",
            Steps((1.0, 24.0)),
        )
        self.width_field = self._layer_number(
            "Width", "width", "Of the distance from one to the next"
        )
        self.twist = self._layer_number(
            "Twist",
            "twist",
            "Turns from one end to the other",
            Steps((-1.0, 1.0), step=0.05),
        )
        self.shift = self._layer_number(
            "Shift around", "shift", "How far the text is moved around, in parts of the turn"
        )
        self.relief = self._layer_number(
            "Relief",
            "relief",
            "Raises what is painted by so much, or sinks it where negative; 0 is paint alone",
            DEPTHS,
        )
        self.edge = self._layer_number(
            "Soft edge", "edge", "How wide the slope at the edge of the relief is", WIDTHS
        )
        self.segments = QLineEdit(self)
        self.segments.setAccessibleName("Segments")
        self.segments.setToolTip("Numbers of segments, counted from 1, such as 1, 3")
        self.segments.editingFinished.connect(self._take_segments)
        self.form.addRow("Segments", self.segments)

    def _build_words(self) -> None:
        self.words = QLineEdit(self)
        self.words.setAccessibleName("Text of the layer")
        self.words.setToolTip("The text, in one line; it stands on From, its capitals reach to To")
        self.words.setMaxLength(LONGEST_LINE)
        self.words.editingFinished.connect(self._take_words)
        self.form.addRow("Text", self.words)
        self.font_box = self.combo(
            "Font",
            [(title, font) for font, title in TITLES_OF_FONTS.items()],
            lambda font: self.do("Font", lambda look: self._with(look, font=font)),
            "In which letters the text is set",
        )

    def _layer_number(self, name: str, key: str, tip: str, numbers: Steps = PERCENT) -> NumberField:
        """Add a row for one number of the chosen layer; its table says what it may be."""

        def taken(value: float) -> dict[str, Any]:
            return {key: value / numbers.scale}

        def usual() -> float | None:
            layer = self._chosen(self.appearance)
            return None if layer is None else numbers.scale * getattr(usual_layer(layer.kind), key)

        return self.number(
            name,
            lambda look, value: self._with(look, **taken(value)),
            tip,
            reset=usual,
            span=numbers.span,
            allowed=table_of(Layer).row(key).kind,
            scale=numbers.scale,
            step=numbers.step,
            unit="%" if numbers is PERCENT else "",
            to_all=lambda look, value: replace(
                look, drawing=tuple(replace(each, **taken(value)) for each in look.drawing)
            ),
        )

    def _buttons(self) -> QWidget:
        row = QWidget(self)
        layout = QHBoxLayout(row)
        layout.setContentsMargins(0, 0, 0, 0)
        add = QToolButton(row)
        add.setText("Add")
        add.setToolTip("Paint another layer")
        add.setProperty("segment", "only")
        add.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        menu = QMenu(add)
        for kind, title in TITLES.items():
            menu.addAction(title).triggered.connect(lambda _=False, kind=kind: self.add(kind))
        open_menu(add, menu)
        self.up_button = QToolButton(row)
        self.remove_button = QToolButton(row)
        for button, icon, tip, action in (
            (self.up_button, "chevron-down", "Move this layer down the list, over the next",
             self.raise_layer),
            (self.remove_button, "segment-remove", "Remove this layer", self.remove),
        ):  # fmt: skip
            icons.bind(button, icon)
            button.setToolTip(tip)
            button.setAccessibleName(tip)
            button.clicked.connect(action)
        layout.addWidget(add, 1)
        layout.addWidget(self.up_button)
        layout.addWidget(self.remove_button)
        return row

    # Edits.

    def add(self, kind: LayerKind) -> None:
        """Paint another layer over those there are."""
        drawing = (*self.appearance.drawing, usual_layer(kind))
        self.do(f"Add {TITLES[kind].lower()}", lambda look: replace(look, drawing=drawing))
        self.refresh(self.presenter.frame)
        self.layers.setCurrentRow(self.layers.count() - 1)

    def remove(self) -> None:
        """Remove the chosen layer."""
        drawing, row = list(self.appearance.drawing), self.layers.currentRow()
        if 0 <= row < len(drawing):
            del drawing[row]
            self.do("Remove layer", lambda look: replace(look, drawing=tuple(drawing)))

    def raise_layer(self) -> None:
        """Lay the chosen layer over the next one."""
        drawing, row = list(self.appearance.drawing), self.layers.currentRow()
        if 0 <= row < len(drawing) - 1:
            drawing[row], drawing[row + 1] = drawing[row + 1], drawing[row]
            self.do("Raise layer", lambda look: replace(look, drawing=tuple(drawing)))
            self.refresh(self.presenter.frame)
            self.layers.setCurrentRow(row + 1)

    def _with(self, look: Appearance, **changes: Any) -> Appearance:
        drawing, row = list(look.drawing), self.layers.currentRow()
        if not 0 <= row < len(drawing):
            return look
        drawing[row] = replace(drawing[row], **changes)
        return replace(look, drawing=tuple(drawing))

    def _sets(self, key: str) -> Change:
        return lambda look, value: self._with(look, **{key: value})

    def _chosen(self, look: Appearance) -> Layer | None:
        drawing, row = look.drawing, self.layers.currentRow()
        return drawing[row] if 0 <= row < len(drawing) else None

    def _gesture_stops(self, stops: object) -> None:
        self._gesture.apply(
            lambda document: edits.replace_appearance(
                document, self._with(document.appearance, stops=stops)
            )
        )

    def _take_words(self) -> None:
        layer = self._chosen(self.appearance)
        if layer is None or not self.words.isModified():
            return
        self.words.setModified(False)
        words = self.words.text()
        if words != layer.text:
            self.do("Text", lambda look: self._with(look, text=words))
        self._show_layer()

    def _take_segments(self) -> None:
        if not self.segments.isModified():
            return
        self.segments.setModified(False)
        words = self.segments.text().replace(",", " ").split()
        if not all(word.isdecimal() and int(word) >= 1 for word in words):
            self.presenter.notify("Segments are numbers from 1, such as 1, 3", "warning")
            self._show_layer()
            return
        numbers = tuple(int(word) - 1 for word in words)
        self.do("Segments", lambda look: self._with(look, segments=numbers))

    # Showing.

    def refresh(self, frame: Frame) -> None:
        """Show the layers, and the numbers of the chosen one."""
        drawing = frame.document.appearance.drawing
        row = self.layers.currentRow()
        with QSignalBlocker(self.layers):
            texts = [f"{k + 1}  {TITLES[layer.kind]}" for k, layer in enumerate(drawing)]
            if texts != [self.layers.item(k).text() for k in range(self.layers.count())]:
                self.layers.clear()
                self.layers.addItems(texts)
                self.layers.setCurrentRow(min(max(row, 0), len(texts) - 1))
        self._show_layer()

    def _show_layer(self) -> None:
        drawing, row = self.appearance.drawing, self.layers.currentRow()
        layer = self._chosen(self.appearance)
        kind = None if layer is None else layer.kind
        between = kind not in (None, LayerKind.SEGMENTS)
        text = kind is LayerKind.TEXT
        repeated = kind in (LayerKind.RINGS, LayerKind.STRIPES)
        for part, shown in (
            (self.layers, bool(drawing)),
            (self.colour_button, kind not in (None, LayerKind.GRADIENT)),
            (self.stops, kind is LayerKind.GRADIENT),
            (self.start, between),
            (self.end, between),
            (self.by, between),
            (self.words, text),
            (self.font_box, text),
            (self.shift, text),
            (self.count, repeated or text),
            (self.width_field, repeated),
            (self.twist, kind is LayerKind.STRIPES),
            (self.relief, kind is not None),
            (self.edge, layer is not None and layer.relief != 0.0),
            (self.segments, kind is LayerKind.SEGMENTS),
        ):
            self.form.setRowVisible(part, shown)
        self.remove_button.setEnabled(layer is not None)
        self.up_button.setEnabled(layer is not None and row < len(drawing) - 1)
        if layer is None:
            return
        self.colour_button.set_colour(layer.color)
        self.stops.set_stops(layer.stops)
        self.start.set_value(100.0 * layer.start)
        self.end.set_value(100.0 * layer.end)
        show_choice(self.by, layer.by)
        self.count.set_value(layer.count)
        self.width_field.set_value(100.0 * layer.width)
        self.twist.set_value(layer.twist)
        show_depths(self.presenter.document, self.relief, layer.relief, self.edge, layer.edge)
        self.shift.set_value(100.0 * layer.shift)
        show_choice(self.font_box, layer.font)
        if not (self.words.hasFocus() and self.words.isModified()):
            self.words.setText(layer.text)
        if not self.segments.hasFocus():
            self.segments.setText(", ".join(str(WINDOW.number(k)) for k in layer.segments))
