"""The joints as a list, the worst first: what each truly is, and a click goes there."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QVBoxLayout, QWidget

from app.commands.joint_words import details
from app.state.presenter import Frame, Presenter
from app.widgets.empty_hint import EmptyHint
from sgb_core.curves.continuity import JointReport

EMPTY = "Segments meet at joints, listed here the worst first. Ctrl+Return appends a segment."


class JointsPanel(QWidget):
    """Gaps before kinks, kinks before jumps of curvature, each the largest first."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._shown: tuple[JointReport, ...] | None = None
        self.empty = EmptyHint("joint", EMPTY, self)
        self.list = QListWidget(self)
        self.list.setAccessibleName("Joints, the worst first")
        self.list.setToolTip("The worst joint first; click one to select it")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 6, 8, 8)
        layout.addWidget(self.empty, 1)
        layout.addWidget(self.list)
        layout.addStretch(0)
        # Keys walk as clicks do.
        self.list.currentItemChanged.connect(lambda item, _old: self._go(item))
        self.list.itemClicked.connect(self._go)

    def refresh(self, frame: Frame) -> None:
        """List the joints as they are; they keep their places while the hand moves."""
        reports = frame.evaluation.joints
        if frame.dragging or reports is self._shown:
            return
        self._shown = reports
        profile = frame.document.profile
        with QSignalBlocker(self.list):
            chosen = self.list.currentItem()
            kept = None if chosen is None else chosen.data(Qt.ItemDataRole.UserRole)
            self.list.clear()
            for report in sorted(reports, key=badness, reverse=True):
                before, after = profile.neighbours(report.joint)
                item = QListWidgetItem(_row(report, before, after))
                item.setData(Qt.ItemDataRole.UserRole, report.joint)
                item.setToolTip(details(report, before, after))
                self.list.addItem(item)
                if report.joint == kept:
                    self.list.setCurrentItem(item)
        self.list.setVisible(bool(reports))
        self.empty.setVisible(not reports)

    def _go(self, item: QListWidgetItem | None) -> None:
        if item is None:
            return
        joint = int(item.data(Qt.ItemDataRole.UserRole))
        profile = self._presenter.document.profile
        if joint in profile.joints:
            self._presenter.select(profile.neighbours(joint)[0], 3)


def badness(report: JointReport) -> tuple[float, float, float]:
    """Return by what joints are ordered: gap, then kink, then jump of curvature, in size."""
    return report.gap, report.kink_deg or 0.0, abs(report.curvature_jump or 0.0)


def _row(report: JointReport, before: int, after: int) -> str:
    words = f"{before + 1}–{after + 1}   {report.measured}"
    if report.measured == "gap":
        return f"{words}, {report.gap:.3g} apart"
    if report.kink_deg is not None and report.measured == "G0":
        return f"{words}, kink {report.kink_deg:.3g}°"
    if report.curvature_jump is not None and report.measured != "G2":
        return f"{words}, curvature jump {abs(report.curvature_jump):.2g}"
    return words
