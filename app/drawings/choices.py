"""The fields of the drawing dialog: what kind of page, on which paper, how."""

from __future__ import annotations

from datetime import date

from PySide6.QtWidgets import QComboBox, QFormLayout, QWidget

from app.drawings.sort import Sort
from app.widgets.form import Row, add_rows, offering
from app.widgets.number_field import NumberField
from sgb_core.bodies.solid import WallSide
from sgb_core.document.manufacture import Stage
from sgb_core.drawings.scales import PLATES, WORKSHOP, Paper, Scale
from sgb_core.drawings.template import PAPERS, TemplateWanted
from sgb_core.drawings.wanted import MOST_NUMBER, Fill, Side, Style, Wanted
from sgb_core.values import dataclass

_TITLES = {
    Sort.SECTION: "Dimensioned section",
    Sort.VESSEL: "Vessel plate",
    Sort.TEMPLATE: "Template at true size",
    Sort.CURVES: "Comparison of curves",
    Sort.CURVATURE: "Curvature along the profile",
}
# Of one size whatever the paper.
_FIGURES = (Sort.CURVES, Sort.CURVATURE)
_SCALES = tuple(dict.fromkeys((*WORKSHOP, *PLATES)))


@dataclass(frozen=True, slots=True)
class Chosen:
    """What the fields ask for: how a ``template`` is made, or what else is ``wanted``."""

    sort: Sort
    template: TemplateWanted = TemplateWanted()
    wanted: Wanted = Wanted()


class Choices(QWidget):
    """One form; what a sort of drawing does not know is hidden."""

    def __init__(self) -> None:
        super().__init__()
        self.sort = offering(QComboBox(), [(title, sort) for sort, title in _TITLES.items()])
        self.paper = QComboBox()
        self.scale = offering(
            QComboBox(),
            [
                ("Largest to fit", None),
                *((str(each), each) for each in sorted(_SCALES, key=lambda s: -s.factor)),
            ],
        )
        self.side = offering(QComboBox(), [("Right", Side.RIGHT), ("Left", Side.LEFT)])
        self.fill = offering(
            QComboBox(), [("Usual", None), ("Hatched", Fill.HATCHED), ("Filled", Fill.FILLED)]
        )
        self.first = NumberField(minimum=0, maximum=MOST_NUMBER, whole=True, reset=1)
        self.first.set_value(1)
        self.stage = offering(QComboBox(), [("Wet, as thrown", Stage.WET), ("Fired", Stage.FIRED)])
        self.wall = offering(
            QComboBox(), [("Outside", WallSide.OUTSIDE), ("Inside", WallSide.INSIDE)]
        )
        self._form = QFormLayout(self)
        self._form.setContentsMargins(0, 0, 0, 0)
        add_rows(
            self._form,
            (
                Row(
                    "Drawing",
                    self.sort,
                    "For the workshop, a plate, a template, or figures of the curve",
                ),
                Row("Paper", self.paper, "The sheet; the smallest that fits where none is chosen"),
                Row("Scale", self.scale, "How large the object is shown"),
                Row("Section stands", self.side, "Two conventions: swap section and outside"),
                Row("Wall", self.fill, "Hatched is usual in a section, filled in a plate"),
                Row("First number", self.first, "The number under the first vessel"),
                Row("Size", self.stage, "The size before or after shrinking"),
                Row("Side of the wall", self.wall, "Where the board lies against the clay"),
            ),
        )
        self.sort.currentIndexChanged.connect(self._adapt)
        self._adapt()

    def _adapt(self) -> None:
        """Show what the sort of drawing knows, and its papers."""
        sort = self.chosen_sort
        template = sort is Sort.TEMPLATE
        drawn = sort in (Sort.SECTION, Sort.VESSEL)
        rows = {
            self.paper: sort not in _FIGURES,
            self.scale: drawn,
            self.side: drawn,
            self.fill: drawn,
            self.first: sort is Sort.VESSEL,
            self.stage: template,
            self.wall: template,
        }
        for field, shown in rows.items():
            self._form.setRowVisible(field, shown)
        kept = self.paper.currentData()
        self.paper.blockSignals(True)
        self.paper.clear()
        if template:
            offering(self.paper, [(str(paper), paper) for paper in PAPERS])
        else:
            fitting = "A4" if sort is Sort.VESSEL else "Smallest to fit"
            offering(self.paper, [(fitting, None), *((str(paper), paper) for paper in Paper)])
        self.paper.setCurrentIndex(max(0, self.paper.findData(kept)))
        self.paper.blockSignals(False)

    @property
    def chosen_sort(self) -> Sort:
        """Which drawing is chosen."""
        return Sort(self.sort.currentData())

    @property
    def chosen(self) -> Chosen:
        """What the fields ask for."""
        today = date.today().isoformat()
        paper, sort = self.paper.currentData(), self.chosen_sort
        if sort is Sort.TEMPLATE:
            template = TemplateWanted(
                Paper(paper), Stage(self.stage.currentData()), WallSide(self.wall.currentData())
            )
            return Chosen(sort, template)
        if sort in _FIGURES:
            return Chosen(sort)
        scale, fill = self.scale.currentData(), self.fill.currentData()
        assert scale is None or isinstance(scale, Scale)
        wanted = Wanted(
            style=Style(str(sort)),
            paper=None if paper is None else Paper(paper),
            scale=scale,
            side=Side(self.side.currentData()),
            fill=None if fill is None else Fill(fill),
            day=today if sort is Sort.SECTION else "",
            first=round(self.first.value),
        )
        return Chosen(sort, wanted=wanted)

    @property
    def suffixes(self) -> tuple[str, ...]:
        """The formats that can hold the drawing."""
        return (".pdf",) if self.chosen_sort is Sort.TEMPLATE else (".pdf", ".svg", ".dxf", ".png")
