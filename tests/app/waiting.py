"""What window tests wait for: conditions, never a time that a slow machine may exceed."""

from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

# How long, in milliseconds, a test waits before it says that what it waits for does not come.
PATIENCE = 120_000


class PatientBot(QtBot):
    """Waits as long as a slow machine may need, unless told otherwise."""

    def waitUntil(self, callback, *, timeout=PATIENCE):  # noqa: N802
        super().waitUntil(callback, timeout=timeout)

    def waitExposed(self, widget, *, timeout=PATIENCE):  # noqa: N802
        return super().waitExposed(widget, timeout=timeout)

    def waitSignal(self, signal, *, timeout=PATIENCE, **options):  # noqa: N802
        return super().waitSignal(signal, timeout=timeout, **options)


def let_turn(turns=5):
    """Let the event loop turn: what is posted in one turn may post again in the next."""
    for _ in range(turns):
        QTest.qWait(1)


def activate(qtbot, window):
    """Give a window the keyboard; what one that closes just now takes with it is taken back."""

    def is_active():
        window.activateWindow()
        return window.isActiveWindow()

    qtbot.waitUntil(is_active)


def show(qtbot, widget, *size):
    """Show a widget as a window that has the keyboard and closes with the test."""
    qtbot.addWidget(widget)
    if size:
        widget.resize(*size)
    with qtbot.waitExposed(widget):
        widget.show()
    activate(qtbot, widget)
    let_turn()


def is_drawn(viewport):
    """Whether a viewport shows its frame, from where it is to be seen, as finely as it will."""
    moves = viewport._glide.active or viewport._refine_timer.isActive()
    fine = viewport._refined or viewport.frame is None or viewport.frame.dragging
    return fine and not moves and not viewport._painter.running
