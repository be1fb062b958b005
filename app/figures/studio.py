"""The figure studio: a plate of the document's own panels, with a live preview."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from math import degrees
from pathlib import Path
from typing import Any

from PySide6.QtCore import QSize, Qt, QTimer
from PySide6.QtGui import QGuiApplication, QImage, QPixmap, QResizeEvent, QShowEvent
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from app.figures.studio_form import StudioForm
from app.scene.camera import Pose
from app.state import written_folders
from app.state.child_command import run_aside
from app.state.jobs import Job, Jobs
from app.state.presenter import Frame, Presenter
from app.state.window_reader import reason, why
from app.widgets.scroll_area import PanelArea
from sgb_core.document import edits
from sgb_core.document.errors import EditError
from sgb_core.document.file.hidden import new_folder
from sgb_core.document.model import Document
from sgb_core.document.plates import PlateCamera, PlateSettings, Projection

# How long the hand rests before the preview is drawn, in milliseconds.
REST = 200
KEPT_RASTERS = 96
SUFFIXES = (".pdf", ".svg", ".png")


class FigureStudio(QDialog):
    """Settings to the left, the plate to the right; stays open beside the window."""

    def __init__(
        self,
        presenter: Presenter,
        jobs: Jobs,
        pose: Callable[[], Pose | None],
        ask_path: Callable[[str, str], Path | None],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle("Figure studio")
        self._presenter = presenter
        self._jobs = jobs
        self._pose = pose
        self._ask_path = ask_path
        self._document: Document | None = None
        self._rasters: dict[tuple[Any, ...], Any] = {}
        self._preview_job: Job | None = None
        self.form = StudioForm()
        self.preview = QLabel("Drawing…")
        self.preview.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.preview.setAccessibleName("Preview of the plate")
        self.preview.setMinimumSize(420, 320)
        self.preview.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        self.preview.setStyleSheet("background: #ffffff; color: #566068")
        self._row = QHBoxLayout()
        self._said = QLabel()
        self._said.setProperty("role", "muted")
        self._said.setAccessibleName("What was done last")
        self._buttons: list[QPushButton] = []
        self.keep = self._button(
            "Keep in project", "Save these settings with the project", self.store
        )
        self.copy = self._button("Copy", "Put the plate on the clipboard", self.copy_picture)
        for suffix in SUFFIXES:
            name = suffix[1:].upper()
            self._button(f"{name}…", f"Write the plate as {name}", partial(self.export, suffix))
        right = QVBoxLayout()
        right.addWidget(self.preview, 1)
        right.addLayout(self._row)
        right.addWidget(self._said)
        layout = QHBoxLayout(self)
        # As wide as it needs to be; the picture takes the rest.
        left = PanelArea(self.form)
        left.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Expanding)
        layout.addWidget(left)
        layout.addLayout(right, 1)
        room = QSize(1080, 720) if parent is None else parent.window().size()
        # Inside the window, so that a small screen shows the buttons too.
        self.resize(min(1080, room.width() - 16), min(720, room.height() - 48))
        self._rest = QTimer(self, singleShot=True, interval=REST)
        self._rest.timeout.connect(self._draw)
        # Owned timers end with the studio; what they draw next is kept beside them.
        self._waiting: tuple[Any, Any, list[Any], list[Any]] | None = None
        self._step = QTimer(self, singleShot=True, interval=0)
        self._step.timeout.connect(self._draw_next)
        self.form.changed.connect(self._rest.start)
        self.form.camera_wanted.connect(self._take_camera)
        presenter.refreshed.connect(self._refreshed)

    def _button(self, text: str, tip: str, run: Callable[[], object]) -> QPushButton:
        button = QPushButton(text)
        button.setToolTip(tip)
        button.setAutoDefault(False)
        button.clicked.connect(lambda _checked=False: run())
        self._row.addWidget(button)
        self._buttons.append(button)
        return button

    # The plate and the project.

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        document = self._presenter.document
        self._document = document
        self.form.show_document(document)
        if document.plate is not None:
            self.form.show_settings(document.plate)
        else:
            self.form.show_settings(PlateSettings())
            self._take_camera()

    def _refreshed(self, frame: Frame) -> None:
        if not self.isVisible() or frame.dragging or frame.document is self._document:
            return
        self._document = frame.document
        self.form.show_document(frame.document)
        self._rest.start()

    def _take_camera(self) -> None:
        pose = self._pose()
        if pose is not None:
            self.form.set_camera(
                PlateCamera(
                    round(degrees(pose.azimuth), 3),
                    round(degrees(pose.elevation), 3),
                    Projection.PARALLEL if pose.parallel else Projection.PERSPECTIVE,
                )
            )

    def store(self) -> bool:
        """Keep the plate in the project; returns whether it could be."""
        settings = self._settings()
        if settings is None:
            return False
        done = self._presenter.do(
            "Figure plate", lambda document: edits.set_plate(document, settings)
        )
        if done:
            self._said.setText("Kept in the project")
        return done

    def _with_plate(self) -> Document | None:
        """Return the document with the plate as it is set, None where it cannot be drawn."""
        settings = self._settings()
        return None if settings is None else edits.set_plate(self._presenter.document, settings)

    def _settings(self) -> PlateSettings | None:
        try:
            settings = self.form.settings()
            edits.set_plate(self._presenter.document, settings)
        except ValueError as error:
            self._tell(reason(error))
            return None
        self._tell("")
        return settings

    @property
    def said(self) -> str:
        """What was done last, in words."""
        return self._said.text()

    def _tell(self, problem: str) -> None:
        self.form.problem.setText(problem)
        for button in self._buttons:
            button.setEnabled(not problem)

    # Taking it away.

    def export(self, suffix: str) -> None:
        """Ask where to, and write the plate aside; the project stays as it is."""
        document = self._with_plate()
        path = None if document is None else self._ask_path("Write plate", suffix)
        if document is None or path is None:
            return

        def done(_: object) -> None:
            self._said.setText(f"Wrote {path.name}")
            self._presenter.notify(f"Wrote {path.name}.")

        self._said.setText("")
        written_folders.note(path)
        self._start(
            f"Writing {path.name}",
            lambda report: run_aside("plate", document, path, report, ["--progress"]),
            done,
        )

    def copy_picture(self) -> None:
        """Put the plate's picture on the clipboard; the project stays as it is."""
        document = self._with_plate()
        if document is None:
            return

        def work(report: Callable[[float], None]) -> bytes:
            with new_folder() as folder:
                path = folder / "plate.png"
                run_aside("plate", document, path, report, ["--progress"])
                return path.read_bytes()

        def done(png: bytes) -> None:
            QGuiApplication.clipboard().setImage(QImage.fromData(png))
            self._said.setText("Copied to the clipboard")
            self._presenter.notify("Copied the plate to the clipboard.")

        self._start("Drawing the plate", work, done)

    def _start(self, label: str, work: Callable[[Any], Any], done: Callable[[Any], object]) -> Job:
        def failed(error: Exception) -> None:
            self._presenter.notify(f"Could not write the plate: {why(error)}", "error")

        return self._jobs.start(Job(label, work, done, failed))

    # The preview: bodies as a job, rasters one in each event turn, then lines and text as a job.

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._rest.start()

    def _draw(self) -> None:
        if not self.isVisible():
            return
        settings = self._settings()
        if settings is None:
            return
        from app.figures.project_plate import make_plate

        try:
            plate = make_plate(self._presenter.document, settings)
        except EditError as error:
            self._tell(reason(error))
            return

        def work(report: Callable[[float], None]) -> Any:
            # Imported late: matplotlib takes a while, and only the studio needs it in the window.
            from app.figures.drawing import with_bodies

            return with_bodies(plate, fine=False, progress=report)

        self._preview(work, self._lay_out)

    def _preview(self, work: Callable[[Any], Any], done: Callable[[Any], object]) -> None:
        """Run one step of the preview aside; only the newest one's result counts."""
        # Jobs wait for each other: a preview that nobody will see must not hold up a file.
        if self._preview_job is not None:
            self._preview_job.cancel()

        def current(result: Any) -> None:
            if job is self._preview_job:
                done(result)

        job = self._preview_job = self._start("Drawing the preview", work, current)

    def _lay_out(self, plate: Any) -> None:
        from app.figures.drawing import panel_poses, plate_layout

        layout = plate_layout(plate)
        fill = min(
            self.preview.width() / layout.width,
            self.preview.height() / layout.height,
            900.0 / layout.width,
        )
        plate = replace(plate, dpi=max(20, int(plate.dpi * fill)))
        layout = plate_layout(plate)
        self._waiting = (plate, layout, panel_poses(plate, layout), [])
        self._step.start()

    def _draw_next(self) -> None:
        if self._waiting is None or not self.isVisible():
            return
        plate, layout, poses, rasters = self._waiting
        if len(rasters) == len(plate.panels):
            self._waiting = None
            self._compose(plate, layout, rasters)
            return
        from app.figures.drawing import panel_raster

        panel, box = plate.panels[len(rasters)], layout.panels[len(rasters)]
        pose, document = poses[len(rasters)], panel.document
        looks = document.solid, document.manufacture, document.appearance
        key = (document.surface, *looks, pose, box.width, box.height)
        if key not in self._rasters:
            while len(self._rasters) >= KEPT_RASTERS:
                del self._rasters[next(iter(self._rasters))]
            self._rasters[key] = panel_raster(panel, pose, box)
        rasters.append(self._rasters[key])
        self._step.start()

    def _compose(self, plate: Any, layout: Any, rasters: list[Any]) -> None:
        def work(report: Callable[[float], None]) -> bytes:
            report(0.0)
            from app.figures.drawing import compose
            from app.figures.files import figure_bytes, plate_style

            with plate_style():
                figure = compose(plate, layout, rasters)
            report(0.5)
            return figure_bytes(figure, ".png")

        def show(png: bytes) -> None:
            self.preview.setPixmap(QPixmap.fromImage(QImage.fromData(png)))

        self._preview(work, show)
