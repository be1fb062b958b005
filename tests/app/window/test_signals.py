"""What ends a program from outside reaches the event loop, and the handlers come back."""

import signal

import pytest
from PySide6.QtCore import QObject

from app.window.signals import ENDING, Signals, follow_session


@pytest.mark.parametrize("number", ENDING)
def test_a_signal_arrives_in_the_event_loop(qtbot, number):
    arrived, parent, before = [], QObject(), signal.getsignal(number)
    signals = Signals(parent, arrived.append)
    signal.raise_signal(number)
    assert arrived == []
    qtbot.waitUntil(lambda: arrived == [number])
    signals.close()
    assert signal.getsignal(number) is before


class Manager:
    """A session manager of a desktop that lets one ask, or not."""

    def __init__(self, asks):
        self.asks, self.cancelled, self.released = asks, False, False

    def allowsInteraction(self):  # noqa: N802
        return self.asks

    def cancel(self):
        self.cancelled = True

    def release(self):
        self.released = True


class Window:
    def __init__(self, answer):
        self.answer, self.flushed = answer, False

    def flush(self):
        self.flushed = True
        return True

    def may_end(self):
        return self.answer


class App:
    """Stands for the application; keeps what is connected to its signal."""

    def __init__(self):
        self.commitDataRequest = self

    def connect(self, slot, _kind):
        self.commit = slot


@pytest.mark.parametrize(
    ("asks", "answer", "cancelled"),
    [(True, False, True), (True, True, False), (False, False, False)],
)
def test_the_end_of_session_keeps_the_work_and_asks_where_it_may(asks, answer, cancelled):
    app, windows, manager = App(), [Window(True), Window(answer)], Manager(asks)
    follow_session(app, lambda: windows)
    app.commit(manager)
    assert all(window.flushed for window in windows)
    assert manager.cancelled is cancelled
    assert manager.released is asks
