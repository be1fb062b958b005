"""Says in the notice bar, once a gesture, which locks have stopped the hand."""

from __future__ import annotations

from app.state.presenter import Frame, Presenter
from app.state.window_reader import sentence


class LockFindings:
    """Watches frames for locks in the way."""

    def __init__(self, presenter: Presenter) -> None:
        self._presenter = presenter
        self._told: tuple[int, ...] = ()

    def refresh(self, frame: Frame) -> None:
        """Speak up where the hand is stopped by other locks than were named last."""
        stopped = frame.in_the_way
        numbers = () if stopped is None else stopped.numbers
        if stopped is not None and not set(numbers) <= set(self._told):
            # It leaves with its cause: the next thing that is done, or an undo.
            self._presenter.notify(
                sentence(stopped), "warning", holds=lambda now: now.in_the_way is not None
            )
        self._told = numbers
