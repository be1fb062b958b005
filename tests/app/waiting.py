"""What window tests wait for: conditions, never a time that a slow machine may exceed."""

from PySide6.QtTest import QTest

# How long, in milliseconds, a test waits before it says that what it waits for does not come.
PATIENCE = 60_000


def let_turn(turns=5):
    """Let the event loop turn: what is posted in one turn may post again in the next."""
    for _ in range(turns):
        QTest.qWait(1)


def is_drawn(viewport):
    """Whether a viewport shows its frame, from where it is to be seen, as finely as it will."""
    moves = viewport._glide.active or viewport._refine_timer.isActive()
    fine = viewport._refined or viewport.frame is None or viewport.frame.dragging
    return fine and not moves and not viewport._painter.running
