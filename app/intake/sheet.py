"""The sheet over a source: choose, see the chain change, and take it into the document."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.intake.backdrop import backdrop_of
from app.intake.form import SourceForm
from app.intake.grabs import Grabs
from app.intake.view import SourceView
from app.intake.words import told_holding, told_trace
from app.intake.work import Intake, Traced
from app.state.presenter import Presenter
from app.state.window_reader import sentence, why
from app.widgets.combo_box import QuietComboBox
from app.widgets.form import named, offering
from app.widgets.scroll_area import PanelArea
from sgb_core.document import edits
from sgb_core.findings.errors import FindingError
from sgb_core.sources import Opened, SourceError

REPLACE, ADD, GHOST, BEHIND = "replace", "add", "ghost", "behind"
_WAYS = (
    ("in place of the profile", REPLACE),
    ("after its end", ADD),
    ("over it, as a ghost", GHOST),
)
_BEHIND = ("behind it: the picture alone", BEHIND)
_FORM_WIDTH, _ROOM = 320, 40


class ImportSheet(QDialog):
    """Stays beside the window; Apply is one undo entry."""

    def __init__(
        self, presenter: Presenter, parent: QWidget, fit: Callable[[], object] = lambda: None
    ) -> None:
        """Open beside ``parent``; ``fit`` shows the whole of a profile that has been replaced."""
        super().__init__(parent)
        self._presenter, self._fit = presenter, fit
        self.setWindowTitle("Import")
        self.setSizeGripEnabled(True)
        self.intake = Intake(self)
        self.view = SourceView(self)
        self.form = SourceForm()
        self._build()
        self._connect()
        room = parent.size() - QSize(_ROOM, _ROOM)
        self.resize(QSize(1080, 720).boundedTo(room))

    def _build(self) -> None:
        self.name = QLabel("…")
        self.name.setWordWrap(True)
        self.outcome = QLabel("")
        self.problem = QLabel("")
        for label, words in ((self.outcome, "What was traced"), (self.problem, "Problem")):
            label.setWordWrap(True)
            label.setAccessibleName(words)
            label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.problem.setProperty("role", "error")
        self.vessel = QCheckBox("")
        self.vessel.setToolTip("Give the profile the wall that the source shows")
        self.vessel.hide()
        self.into = named(
            offering(QuietComboBox(), _WAYS), "Take it", "Where the profile goes; one step of undo"
        )
        self.progress = QProgressBar()
        self.progress.setRange(0, 0)
        self.progress.setTextVisible(False)
        self.progress.setAccessibleName("Under way")
        self.stop = named(QPushButton("Stop"), "Stop", "Stop reading or tracing")
        self.stop.setAutoDefault(False)
        going = QHBoxLayout()
        going.addWidget(self.progress, 1)
        going.addWidget(self.stop)
        self._going = QWidget()
        going.setContentsMargins(0, 0, 0, 0)
        self._going.setLayout(going)
        policy = self._going.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self._going.setSizePolicy(policy)
        inside = QWidget()
        column = QVBoxLayout(inside)
        column.setContentsMargins(0, 0, 6, 0)
        for part in (self.name, self.form, self.outcome, self.problem, self.vessel):
            column.addWidget(part)
        column.addStretch(1)
        area = PanelArea(inside)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        self.apply_button = buttons.addButton("Apply", QDialogButtonBox.ButtonRole.ApplyRole)
        self.apply_button.setToolTip("Take the profile; one step of undo")
        buttons.button(QDialogButtonBox.StandardButton.Close).setAutoDefault(False)
        self.apply_button.setDefault(True)
        self.apply_button.clicked.connect(self.apply)
        buttons.rejected.connect(self.reject)
        side = QVBoxLayout()
        side.addWidget(area, 1)
        side.addWidget(self._going)
        side.addWidget(self.into)
        side.addWidget(buttons)
        holder = QWidget()
        holder.setFixedWidth(_FORM_WIDTH)
        side.setContentsMargins(0, 0, 0, 0)
        holder.setLayout(side)
        layout = QHBoxLayout(self)
        layout.addWidget(self.view, 1)
        layout.addWidget(holder)

    def _connect(self) -> None:
        self.stop.clicked.connect(self.intake.cancel)
        self.intake.opened.connect(self._opened)
        self.intake.changed.connect(self._show)
        self.form.changed.connect(self._want)
        self.view.axis_moved.connect(self.form.set_axis)
        self.view.clicks_moved.connect(self.form.set_clicks)
        self.view.scale_moved.connect(self.form.set_bar)
        self.view.path_chosen.connect(self.form.set_path)
        self.into.currentIndexChanged.connect(self._show)

    # What comes in.

    def open_path(self, path: Path) -> None:
        """Read a file aside and show what it holds."""
        self._read(path.name, lambda: Opened.of_file(path))

    def open_data(self, data: bytes, name: str) -> None:
        """Read what was pasted or dropped, as the contents of a file of this name."""
        self._read(name, lambda: Opened.of_data(data, name))

    def _read(self, name: str, read: Callable[[], Opened]) -> None:
        self.name.setText(f"<b>{_escaped(name)}</b>")

        def safely() -> Opened:
            try:
                return read()
            except OSError as error:
                raise FindingError(error.strerror or str(error)) from None

        self.intake.open(safely)

    def _opened(self) -> None:
        source = self.intake.source
        assert source is not None
        document = self._presenter.document
        self.name.setText(f"<b>{_escaped(source.name)}</b> · {source.source.title}")
        ways = (*_WAYS, _BEHIND) if source.data is not None else _WAYS
        self.into.clear()
        offering(self.into, ways)
        self.view.show_source(backdrop_of(source))
        self.form.show_source(source, document.unit, document.height)

    def _want(self) -> None:
        self._show_grabs()
        if self.form.follows_line and len(self.form.clicks) < 2:
            self.intake.cancel()
            self.intake.refuse("Click along the line that is wanted: two places at least.")
            return
        try:
            options = self.form.options(self._presenter.document.unit)
        except SourceError as error:
            self.intake.refuse(why(error))
            return
        self.intake.want(options)

    def _show_grabs(self) -> None:
        form = self.form
        picture = self.intake.source is not None and self.intake.source.data is not None
        self.view.path = form.path.currentData() or 0
        self.view.grabs = Grabs(
            axis=not form.is_mesh,
            lean=picture,
            scale=form.bar if form.scales_by_points else None,
            clicks=form.clicks if form.follows_line else None,
        )
        self.view.update()

    def _show(self) -> None:
        intake, traced = self.intake, self.intake.traced
        self._going.setVisible(intake.busy)
        self.problem.setText(intake.problem)
        self.problem.setVisible(bool(intake.problem))
        if traced is not None and traced is not self.view.traced:
            self.view.show_traced(traced)
            self.form.show_traced(traced)
            self._tell(traced)
        fresh = traced is not None and not intake.problem
        self.apply_button.setEnabled(fresh)

    def _tell(self, traced: Traced) -> None:
        taken = traced.taken
        notes = [sentence(note) for note in taken.notes]
        holds = [] if traced.holding is None else [told_holding(traced.holding, taken)]
        self.outcome.setText("\n".join([*told_trace(taken), *holds, *notes]))
        wall = taken.wall
        self.vessel.setVisible(wall is not None)
        if wall is not None:
            self.vessel.setText(f"A vessel with a wall of {wall.median:.3g} {wall.unit}")

    # What goes into the document.

    def apply(self) -> None:
        """Take the profile as it is chosen."""
        traced = self.intake.traced
        if traced is None or self.intake.problem:
            return
        way, taken = self.into.currentData(), traced.taken
        profile, source = taken.trace.profile, taken.reference()
        wall = taken.wall.median if taken.wall is not None and self.vessel.isChecked() else None
        name = os.path.splitext(taken.name)[0]
        present = self._presenter
        if way == GHOST:
            ghost = edits.take_profile(present.document, profile)
            present.set_view(ghost=ghost)
            present.notify(
                f"{taken.name} lies over the profile.",
                "info",
                "Hide it",
                lambda: present.set_view(ghost=None),
            )
            return
        label = f"Import {taken.name}"
        if way == ADD:
            done = present.do(label, lambda d: edits.add_profile(d, profile, source))
        elif way == BEHIND:
            done = present.do(label, lambda d: edits.set_reference(d, source))
        else:
            done = present.do(
                label, lambda d: edits.take_profile(d, profile, source, wall=wall, name=name)
            )
        if done:
            if way == REPLACE:
                present.refresh_now()
                self._fit()
            present.notify(
                f"Took {taken.name}: {told_trace(taken)[0]}.", "info", "Undo", present.undo
            )

    def done(self, result: int) -> None:
        """Close, and stop what nobody waits for any more."""
        self.intake.cancel()
        super().done(result)


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;")
