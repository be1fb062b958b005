"""The line at the foot of the window: joint, triangles, volume, size, certificate."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSize
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QLabel, QProgressBar, QPushButton, QStatusBar, QWidget

from app.panels.measures.lines import Units, stored_units
from app.state.body_work import same_body
from app.state.jobs import Jobs
from app.state.presenter import Frame, Presenter
from app.state.window_reader import WINDOW
from app.widgets.quantity import grouped
from app.widgets.steady_label import SteadyLabel
from app.window.triangle_count import TriangleCount
from sgb_core.bodies.solid import BodyKind
from sgb_core.curves.continuity import JointReport
from sgb_core.document.evaluation import Evaluation

if TYPE_CHECKING:
    from sgb_core.document.body_measures import BodyMeasures


class StatusBar(QStatusBar):
    """Reads frames and running jobs; never changes the document."""

    def __init__(self, presenter: Presenter, jobs: Jobs, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._jobs = jobs
        self._frame: Frame | None = None
        self._volume_shown: tuple[Evaluation, BodyMeasures | None, Units] | None = None
        self._units: Units | None = None
        self._joint = self._label("Joint", "What the joint after the selected segment truly is")
        self._triangles = self._label(
            "Triangles",
            "Of a bare surface what an export writes at the tolerance that it begins with, a "
            "thousandth of the size; of a body those of the mesh that is shown",
        )
        self._count = TriangleCount(self)
        self._count.counted.connect(self._tell_triangles)
        self._size = self._label(
            "Size", "Height and largest diameter of the body as it leaves, else of the bare surface"
        )
        self._volume = self._label("Volume", "")
        self._verdict = self._label("Verdict", "Whether the profile can cross the axis or itself")
        self._progress = QProgressBar(self)
        self._progress.setRange(0, 100)
        self._cancel = QPushButton("Cancel", self)
        self._cancel.setToolTip("Stop what is being written; the old file stays")
        self._cancel.clicked.connect(jobs.cancel_all)
        for widget in (
            self._joint,
            self._triangles,
            self._volume,
            self._size,
            self._verdict,
        ):
            self.addWidget(widget)
        for passing in (self._progress, self._cancel):
            self.addPermanentWidget(passing)
            passing.hide()
        # What stays longest where there is not room for all.
        self._by_weight = (
            self._verdict,
            self._volume,
            self._joint,
            self._size,
            self._triangles,
        )
        jobs.changed.connect(self._show_jobs)

    def minimumSizeHint(self) -> QSize:
        """Nothing said here makes the window wider."""
        return QSize(0, super().minimumSizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._make_room()

    def _make_room(self) -> None:
        """Hide what does not fit."""
        layout = self.layout()
        assert layout is not None
        gap = layout.spacing()
        free = self.width() - self.height()
        if self._jobs.running:
            free -= self._progress.width() + self._cancel.sizeHint().width() + 2 * gap
        for label in self._by_weight:
            free -= label.maximumWidth() + gap
            label.setVisible(free >= 0)

    def refresh(self, frame: Frame) -> None:
        """Show ``frame``; what is dear, as a volume with laws, waits until the hand stops."""
        before, self._frame = self._frame, frame
        self._count.refresh(frame)
        evaluation = frame.evaluation
        same = before is not None and before.evaluation is evaluation
        if not same or before is None or before.view.segment != frame.view.segment:
            self._joint.setText(joint_text(evaluation, frame.view.segment))
        rests = not frame.dragging and (not same or (before is not None and before.dragging))
        if not (frame.dragging and evaluation.document.variation):
            self._show_body(frame)
        if rests:
            self._verdict.setText(verdict_text(evaluation))
            self._verdict.setToolTip(certificate_text(evaluation))
        self._make_room()

    def _show_body(self, frame: Frame) -> None:
        # A hand that drags does not choose units: the settings are read when it rests.
        if self._units is None or not frame.dragging:
            self._units = stored_units()
        if _awaits_body(frame):
            self._volume_shown = None
            self._volume.setText(_UNDER_WAY[frame.document.solid.kind])
            self._size.setText(_SIZE_UNDER_WAY)
            return
        shown, last = (frame.evaluation, _measured(frame), self._units), self._volume_shown
        # The first two by identity: what is in them is dear to compare.
        same = last is not None and last[0] is shown[0] and last[1] is shown[1]
        if last is None or not same or last[2] != shown[2]:
            self._volume_shown = shown
            self._volume.setText(volume_text(*shown))
            self._volume.setToolTip(_VOLUME_TIPS[frame.document.solid.kind])
            bodiless = shown[1] is None and _may_have_body(frame)
            self._size.setText(_SIZE_UNDER_WAY if bodiless else size_text(*shown[:2]))

    def _tell_triangles(self, count: int) -> None:
        self._triangles.setText(f"{grouped(count)} triangles" if count else "")
        self._make_room()

    def _label(self, name: str, tip: str) -> QLabel:
        label = SteadyLabel(self)
        label.setAccessibleName(name)
        label.setToolTip(tip)
        label.setContentsMargins(8, 0, 8, 0)
        return label

    def _show_jobs(self) -> None:
        running = self._jobs.running
        self._progress.setVisible(bool(running))
        self._cancel.setVisible(bool(running))
        if running:
            job = running[0]
            self._progress.setValue(0)
            self._progress.setFormat(f"{job.label} %p %")
            widest = self.fontMetrics().horizontalAdvance(f"{job.label} 100 %")
            self._progress.setFixedWidth(widest + 20)
            self._progress.setToolTip(job.label)
            job.progressed.connect(self._show_progress)
        self._make_room()

    def _show_progress(self, fraction: float) -> None:
        self._progress.setValue(round(100 * fraction))


def joint_text(evaluation: Evaluation, segment: int) -> str:
    """Say what the joint after ``segment`` truly is, or where there is none what the curve is."""
    joints = evaluation.joints
    if not joints:
        return "One segment"
    index = min(segment, len(joints) - 1)
    return f"Joint {WINDOW.number(index)}: {describe_joint(joints[index])}"


def describe_joint(joint: JointReport) -> str:
    """Say in a few words what was measured at a joint."""
    words: str = joint.measured
    if joint.measured == "gap":
        return f"gap of {joint.gap:.4g}"
    if joint.measured == "G0" and joint.kink_deg is not None:
        words += f", kink {joint.kink_deg:.3g}°"
    elif joint.measured == "G1" and joint.speed_ratio is not None:
        words += f", speed ratio {joint.speed_ratio:.3g}"
    if joint.degenerate:
        words += ", degenerate end"
    if not joint.holds:
        words += f" (rule {joint.rule} not met)"
    return words


def size_text(evaluation: Evaluation, body: BodyMeasures | None) -> str:
    """Say the height and the largest diameter of the body, of a bare surface its own."""
    unit = evaluation.document.unit
    height, diameter = evaluation.size if body is None else (body.height, body.diameter)
    return f"Height {height:.4g} {unit} · ⌀ {diameter:.4g} {unit}"


def volume_text(evaluation: Evaluation, body: BodyMeasures | None, units: Units) -> str:
    """Say what a vessel holds, what a solid body is made of, or what a bare surface encloses.

    Of a vessel never the volume of its outside; "" until its body has been made.
    """
    document = evaluation.document
    kind = document.solid.kind
    if kind is BodyKind.SURFACE:
        return f"Encloses {units.short_liquids(document, evaluation.volume)}"
    if body is None:
        return ""
    if kind is BodyKind.FILLED:
        return f"Solid, {units.short_liquids(document, body.vessel.material_volume)}"
    if body.vessel.capacity is None:
        return "Closed, no rim"
    said = [f"{units.short_liquids(document, body.vessel.capacity)} to the brim"]
    if body.filled is not None:
        said.insert(0, f"{units.short_liquids(document, body.filled)} to the line")
    return f"Holds {' · '.join(said)}"


def _awaits_body(frame: Frame) -> bool:
    """Whether the body of what rests here is being made: no number of another is shown then."""
    state, document = frame.body, frame.document
    return (
        document.solid.kind is not BodyKind.SURFACE
        and state is not None
        and not frame.dragging
        and not same_body(state.document, document)
    )


def _may_have_body(frame: Frame) -> bool:
    """Whether a body is asked for that nothing is known against."""
    state = frame.body
    asked = frame.document.solid.kind is not BodyKind.SURFACE
    return asked and (state is None or state.error is None)


def _measured(frame: Frame) -> BodyMeasures | None:
    """Return the measures of a body of the document's kind, the newest there are.

    A bare surface with a relief has a mesh, and no more to say.
    """
    state, document = frame.body, frame.document
    if state is None or document.solid.kind is BodyKind.SURFACE:
        return None
    of_this = state.document.solid.kind is document.solid.kind
    return state.measures if of_this and state.document.unit is document.unit else None


_SIZE_UNDER_WAY = "Height … · ⌀ …"
_UNDER_WAY = {
    BodyKind.SURFACE: "",
    BodyKind.FILLED: "Solid, …",
    BodyKind.VESSEL: "Holds …",
}
_VOLUME_TIPS = {
    BodyKind.SURFACE: "Volume enclosed when the profile is closed to the axis, without any wall",
    BodyKind.FILLED: "Volume of the solid body",
    BodyKind.VESSEL: "What the vessel holds, to its fill line and to the brim",
}


def verdict_text(evaluation: Evaluation) -> str:
    """Say whether the profile crosses the axis or itself, or can never do so."""
    if evaluation.axis_crossings:
        return "⚠ Crosses the axis"
    if evaluation.self_intersections:
        touches = all(crossing.touches for crossing in evaluation.self_intersections)
        return "⚠ Touches itself" if touches else "⚠ Crosses itself"
    if evaluation.certificates.never_crosses_axis:
        return "Never crosses the axis"
    return "Clear of the axis"


def certificate_text(evaluation: Evaluation) -> str:
    """Say what no slider can break, read off the control polygon alone."""
    found = evaluation.certificates
    lines = [
        "Certain at every setting of λ and ω that moves no control point:",
        _certified(found.never_crosses_axis, "it never crosses the axis"),
        _certified(found.height_monotone, "it only rises, or only falls"),
        _certified(found.convex, "it is convex, closed by its chord"),
    ]
    lines.append("Read off the control polygon: sufficient, not necessary.")
    return "\n".join([*lines, "What is not certain may still be so."])


def _certified(holds: bool, words: str) -> str:
    return f"✓ {words}" if holds else f"– not certain: {words}"
