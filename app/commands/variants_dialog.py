"""A sheet of variants that all keep what is locked: seen as a ghost, taken by a click."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QListWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.state.edit_gesture import EditGesture
from app.state.jobs import Job, Jobs, Report
from app.state.presenter import Frame, Presenter
from app.state.window_reader import reason, sentence
from app.widgets.combo_box import QuietComboBox
from app.widgets.form import named, offering
from app.widgets.number_field import NumberField
from app.widgets.silhouette import outline_picture
from app.widgets.tile_list import PICTURE, Tile, TileList
from sgb_core.curves.segment import PARAMETERS, SYMBOLS
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.measure import profile_energy
from sgb_core.document.model import Document
from sgb_core.document.variants import (
    Free,
    Swept,
    Variant,
    free_variants,
    parameter_variants,
    shared,
)

LABEL = "Variants"
_ONE, _TWO = "one", "two"
_WAYS = (
    ("All that is free, by shape parameters", Free.SHAPE.value),
    ("All that is free, points too", Free.POINTS.value),
    ("One shape parameter", _ONE),
    ("Two shape parameters", _TWO),
)
_LEAST_SIZE = (560, 520)


class VariantsDialog(QDialog):
    """Stays open beside the window; each variant that is taken is one step of undo."""

    def __init__(self, presenter: Presenter, jobs: Jobs, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(LABEL)
        self._presenter = presenter
        self._jobs = jobs
        self._job: Job | None = None
        self._gesture = EditGesture(presenter)
        self._start = presenter.document
        self.variants: tuple[Variant, ...] = ()
        self.way = offering(QuietComboBox(), list(_WAYS))
        self.axes = [(NumberField(minimum=1, whole=True), QuietComboBox()) for _ in range(2)]
        self.told = QLabel()
        self.tiles = TileList("Variants", self)
        self._build()
        self.tiles.chosen.connect(self._take)
        self.tiles.itemEntered.connect(self._point_at)
        self.tiles.currentItemChanged.connect(lambda item, _: self._point_at(item))
        presenter.refreshed.connect(self._refreshed)
        self._look()

    def _build(self) -> None:
        named(self.way, "Over", "What the variants differ in; locks and joints' rules hold in all")
        segment = min(self._presenter.view.segment, len(self._start.profile) - 1)
        form = QFormLayout()
        form.addRow("Over", self.way)
        for number, (field, box) in enumerate(self.axes):
            field.set_range(1, len(self._start.profile))
            field.set_value(min(segment + number, len(self._start.profile) - 1) + 1)
            offering(box, [(SYMBOLS[name], name) for name in PARAMETERS])
            box.setCurrentIndex(1)
            named(box, "Shape parameter", "The one that the variants go through")
            named(field, "Segment", "Of which segment")
            row = QHBoxLayout()
            for part in (box, QLabel("of segment"), field):
                row.addWidget(part)
            row.addStretch(1)
            form.addRow("" if number else "Of", row)
            field.changed.connect(self._look)
            box.currentIndexChanged.connect(self._look)
        self.way.currentIndexChanged.connect(self._look)
        self.told.setWordWrap(True)
        self.told.setAccessibleName("What all variants keep")
        self.tiles.setToolTip(
            "Arrows or the pointer show a variant as a ghost; Enter or a click takes it"
        )
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addLayout(form)
        layout.addWidget(self.told)
        layout.addWidget(self.tiles, 1)
        layout.addWidget(buttons)
        self.resize(*_LEAST_SIZE)

    # Looking for variants.

    def _swept(self) -> list[Swept]:
        many = {_ONE: 1, _TWO: 2}.get(self.way.currentData(), 0)
        return [Swept(int(field.value) - 1, box.currentData()) for field, box in self.axes[:many]]

    def _look(self, *_: object) -> None:
        """Look for variants of the document as it is now, aside."""
        swept, way = self._swept(), self.way.currentData()
        for number, parts in enumerate(self.axes):
            for part in parts:
                part.setEnabled(number < len(swept))
        self._drop()
        start = self._start = self._presenter.document
        self._show(())
        self.told.setText("Looking…")

        def work(report: Report) -> tuple[Variant, ...]:
            if swept:
                return parameter_variants(start, swept, report=report)
            return free_variants(start, Free(way), report=report)

        self._job = self._jobs.start(Job(LABEL, work, partial(self._found, swept), self._refused))

    def _drop(self) -> None:
        job, self._job = self._job, None
        if job is not None:
            job.drop()

    def _found(self, swept: list[Swept], variants: tuple[Variant, ...]) -> None:
        self._job = None
        kept = sentence(shared(self._start))
        none = "" if variants else " No variant keeps that."
        self.told.setText(f"{kept}{none}")
        self._show(variants, swept)

    def _refused(self, error: Exception) -> None:
        self._job = None
        self.told.setText(reason(error))

    def _show(self, variants: tuple[Variant, ...], swept: list[Swept] | None = None) -> None:
        self.variants = variants
        own = profile_energy(self._start.profile, Energy.BENDING)
        unit, ratio = str(self._start.unit), self.devicePixelRatioF()
        tiles = []
        for number, each in enumerate(variants, 1):
            values = ", ".join(
                f"{SYMBOLS[axis.parameter]} {value:.3g}"
                for axis, value in zip(swept or (), each.values, strict=False)
            )
            change = "" if not own else f", {changed(100.0 * (each.energy / own - 1.0))}"
            words = f"∫κ² dl {each.energy:.4g} 1/{unit}{change}"
            picture = outline_picture(each.document.profile, PICTURE, ratio, self._start.profile)
            title = values or ("Fairest" if number == 1 else f"Variant {number}")
            tiles.append(Tile(title, words, picture, partial(self._taken, each)))
        self.tiles.show_tiles(tiles)

    # What the hand does.

    def _point_at(self, item: QListWidgetItem | None) -> None:
        row = -1 if item is None else self.tiles.row(item)
        ghost = self.variants[row].document if 0 <= row < len(self.variants) else None
        self._presenter.set_view(ghost=ghost)

    def _take(self, tile: Tile) -> None:
        tile.run()

    def _taken(self, variant: Variant) -> None:
        """Take a variant; the sheet stays, to try another."""
        if self._is_strange(self._presenter.document):
            return
        self._gesture.begin("Take a variant")
        self._gesture.apply(lambda _: variant.document, settled=True)
        self._gesture.commit()

    def _is_strange(self, document: Document) -> bool:
        """Whether a document is neither what the sheet began with nor one of its variants."""
        return document is not self._start and all(
            document is not each.document for each in self.variants
        )

    def _refreshed(self, frame: Frame) -> None:
        """Look anew where the document was changed elsewhere."""
        if not frame.dragging and self._is_strange(frame.document):
            for field, _ in self.axes:
                field.set_range(1, len(frame.document.profile))
            self._look()

    def done(self, result: int) -> None:
        """Close, and leave no ghost behind."""
        self._drop()
        self._presenter.refreshed.disconnect(self._refreshed)
        self._presenter.set_view(ghost=None)
        super().done(result)


def changed(percent: float) -> str:
    """Return a change in words, in tenths where it is small."""
    if abs(percent) < 0.05:
        return "as now"
    return f"{percent:+.{0 if abs(percent) >= 9.95 else 1}f} %".replace("-", "−")
