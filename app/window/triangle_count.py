"""How many triangles there are now: what an export of the surface writes, or the body's mesh."""

from __future__ import annotations

from PySide6.QtCore import QObject, QTimer, Signal

from app.state.body_work import same_body
from app.state.jobs import Job, Jobs, Report
from app.state.presenter import Frame
from sgb_core.bodies.solid import BodyKind
from sgb_core.document.model import Document

# The hand has stopped when nothing has changed for this long.
REST_MILLISECONDS = 200


class TriangleCount(QObject):
    """Makes the surface's mesh aside with the tolerance that exports begin with.

    A body with laws would take too long for that: of bodies the mesh that is shown is counted.
    """

    # The count, 0 where there is nothing to write.
    counted = Signal(int)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        # Of its own: what runs here shows no progress and delays no export.
        self._jobs = Jobs(self)
        self._frame: Frame | None = None
        self._done_for: Document | None = None
        self._timer = QTimer(self, singleShot=True, interval=REST_MILLISECONDS)
        self._timer.timeout.connect(self._start)

    def refresh(self, frame: Frame) -> None:
        """Count what ``frame`` holds once nothing newer comes for a moment."""
        self._frame = frame
        if frame.document.solid.kind is not BodyKind.SURFACE:
            self._timer.stop()
            self._done_for = None
            mesh = None if frame.body is None else frame.body.mesh
            self.counted.emit(0 if mesh is None else len(mesh.triangles))
        elif not same_body(self._done_for, frame.document):
            self._timer.start()

    def _start(self) -> None:
        frame = self._frame
        if frame is None or frame.dragging:
            # The frame that ends the drag comes here again.
            return
        if self._jobs.running:
            self._timer.start()
            return
        document = self._done_for = frame.document

        def work(_report: Report) -> int:
            from sgb_core.exchange.body import exported_mesh

            return len(exported_mesh(document).triangles)

        def done(count: int) -> None:
            if self._done_for is document:
                self.counted.emit(count)

        self._jobs.start(Job("", work, done, lambda _error: done(0)))
