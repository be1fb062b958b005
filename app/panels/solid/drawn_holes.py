"""What is cut out where holes are drawn: a text in a font, or the dark parts of a picture."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QFileDialog, QFormLayout, QLabel, QLineEdit, QWidget

from app.state.number_edits import NumberEdits
from app.state.picture_choice import PICTURE_FILES, TEXTURES, picture_bytes
from app.state.presenter import Edit, Presenter
from app.widgets.combo_box import QuietComboBox
from app.widgets.number_field import NumberField
from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.fields.kinds import LONGEST_LINE
from sgb_core.fields.record import Row, table_of

_TABLE = table_of(CutOut)
TEXT, FONT, PICTURE, THRESHOLD = (
    _TABLE.row(name) for name in ("text", "font", "picture", "threshold")
)
_OWN = "own picture"
_PERCENT = 100.0


class DrawnRows(QWidget):
    """Text and font of a pattern, or its picture and how dark it is cut."""

    def __init__(
        self,
        presenter: Presenter,
        numbers: NumberEdits,
        change: Callable[..., Edit],
        cut_picture: Callable[[bytes], Edit],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._change = change
        self._cut_picture = cut_picture
        self._shown: CutOut | None = None
        self.form = QFormLayout(self)
        self.form.setContentsMargins(0, 0, 0, 0)
        self.text = QLineEdit(self)
        self.text.setAccessibleName(TEXT.label)
        self.text.setMaxLength(LONGEST_LINE)
        self.text.editingFinished.connect(self._take_text)
        self._add(TEXT, self.text)
        self.font_box = QuietComboBox(self)
        for value, title in FONT.titles.items():
            self.font_box.addItem(title, str(value))
        self.font_box.setAccessibleName(FONT.label)
        self.font_box.activated.connect(
            lambda at: presenter.do(FONT.label, change(font=self.font_box.itemData(at)))
        )
        self._add(FONT, self.font_box)
        self.picture = QuietComboBox(self)
        for title, name in (*TEXTURES, ("Picture from a file…", _OWN)):
            self.picture.addItem(title, name)
        self.picture.setAccessibleName(PICTURE.label)
        self.picture.activated.connect(lambda at: self._choose(str(self.picture.itemData(at))))
        self._add(PICTURE, self.picture)
        self.threshold = NumberField(
            minimum=0.0,
            maximum=_PERCENT,
            step=5.0,
            reset=_PERCENT * CutOut().threshold,
            parent=self,
        )
        self.threshold.set_suffix("%")
        self.threshold.setAccessibleName(THRESHOLD.label)
        numbers.connect(
            self.threshold, THRESHOLD.label, lambda value: change(threshold=value / _PERCENT)
        )
        self.threshold.take_label(self._add(THRESHOLD, self.threshold))

    def _add(self, row: Row, field: QWidget) -> QLabel:
        label = QLabel(row.label, self)
        label.setToolTip(row.tip)
        label.setBuddy(field)
        field.setToolTip(row.tip)
        self.form.addRow(label, field)
        return label

    def _take_text(self) -> None:
        if not self.text.isModified() or self._shown is None:
            return
        self.text.setModified(False)
        words = self.text.text()
        if words != self._shown.text and not self._presenter.do(
            TEXT.label, self._change(text=words)
        ):
            self.text.setText(self._shown.text)

    def _choose(self, name: str) -> None:
        if name == _OWN:
            path, _ = QFileDialog.getOpenFileName(self, "Picture to cut", "", PICTURE_FILES)
            if path:
                self.take_picture(Path(path))
        else:
            self._presenter.do(PICTURE.label, self._change(picture=name))
        if self._shown is not None:
            self.show_pattern(self._shown)

    def take_picture(self, path: Path) -> None:
        """Cut the dark parts of the picture in a file; it is kept inside the project."""
        data = picture_bytes(self._presenter, path)
        if data is None:
            return
        self._presenter.do(f"Picture {path.name}", self._cut_picture(data))

    def show_pattern(self, shown: CutOut) -> None:
        """Show what a pattern cuts, where it is drawn."""
        self._shown = shown
        self.setVisible(shown.shape.is_drawn)
        text = shown.shape is HoleShape.TEXT
        for part, there in (
            (self.text, text),
            (self.font_box, text),
            (self.picture, not text),
            (self.threshold, not text),
        ):
            self.form.setRowVisible(part, there)
        if not self.text.hasFocus() or not self.text.isModified():
            self.text.setText(shown.text)
        with QSignalBlocker(self.font_box), QSignalBlocker(self.picture):
            self.font_box.setCurrentIndex(self.font_box.findData(str(shown.font)))
            own = len(shown.picture) == 64
            self.picture.setCurrentIndex(self.picture.findData(_OWN if own else shown.picture))
        self.threshold.set_value(_PERCENT * shown.threshold)
