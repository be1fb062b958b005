"""Paints the fine picture of a look aside, so that refining never holds up the hand."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer

from app.state.jobs import Job, Jobs, Report

if TYPE_CHECKING:
    from app.scene.scene import Scene
    from app.state.presenter import Frame
    from sgb_core.document.body_state import BodyState


# A fine body is waited for so long, in milliseconds: a picture of the coarse one would hold it up.
BODY_COMES = 600


class FinePainter(Jobs):
    """One picture at a time; ``again`` is called on the GUI thread whenever one is done.

    After one that failed the coarse picture stays, until the next frame asks again.
    """

    def __init__(self, again: Callable[[], object], parent: QObject) -> None:
        super().__init__(parent)
        self._again = again
        self._awaited: BodyState | None = None
        self._patience = QTimer(self, singleShot=True, interval=BODY_COMES)
        self._patience.timeout.connect(again)

    def is_ready(self, scene: Scene, frame: Frame) -> bool:
        """Whether the fine picture can be shown at once; if not, it or its body is on its way."""
        if self.running or self._awaits_body(frame):
            return False
        work = scene.look.fine_work(frame.evaluation, frame.view, frame.body)
        if not work:
            return True

        def work_all(_report: Report) -> None:
            for each in work:
                each()

        self.start(Job("Paint", work_all, lambda _: self._again(), lambda _: None))
        return False

    def _awaits_body(self, frame: Frame) -> bool:
        body = frame.body
        if body is None or body.fine or body.mesh is None:
            self._patience.stop()
            return False
        if body is not self._awaited:
            self._awaited = body
            self._patience.start()
        return self._patience.isActive()


def completes(before: Frame | None, frame: Frame) -> bool:
    """Whether all that a frame adds to the one before is the fine body at rest."""
    return (
        before is not None
        and frame.body is not None
        and frame.body.fine
        and frame.body is not before.body
        and not frame.dragging
        and before.evaluation is frame.evaluation
        and before.generation == frame.generation
        and before.view == frame.view
        and before.compared is frame.compared
    )
