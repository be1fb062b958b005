"""Paints the fine picture of a look aside, so that refining never holds up the hand."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from app.state.jobs import Job, Jobs, Report

if TYPE_CHECKING:
    from app.scene.scene import Scene
    from app.state.presenter import Frame


class FinePainter(Jobs):
    """One picture at a time; ``again`` is called on the GUI thread whenever one is done.

    After one that failed the coarse picture stays, until the next frame asks again.
    """

    def __init__(self, again: Callable[[], object], parent: QObject) -> None:
        super().__init__(parent)
        self._again = again

    def is_ready(self, scene: Scene, frame: Frame) -> bool:
        """Whether the fine picture can be shown at once; if not, it is being painted."""
        if self.running:
            return False
        work = scene.look.fine_work(frame.evaluation, frame.view, frame.body)
        if not work:
            return True

        def work_all(_report: Report) -> None:
            for each in work:
                each()

        self.start(Job("Paint", work_all, lambda _: self._again(), lambda _: None))
        return False
