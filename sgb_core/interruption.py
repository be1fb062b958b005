"""Long computations that can be stopped: whoever starts one says whether it is still wanted."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar


def _go_on() -> None:
    pass


# A thread of its own has a context of its own: no computation is stopped by another's.
_ask: ContextVar[Callable[[], None]] = ContextVar("ask", default=_go_on)


@contextmanager
def interruptible(ask: Callable[[], None]) -> Iterator[None]:
    """Let ``ask`` be called at every checkpoint inside; what it raises ends the computation."""
    token = _ask.set(ask)
    try:
        yield
    finally:
        _ask.reset(token)


def checkpoint() -> None:
    """Mark a place between two steps of a long computation, such as two angles of a body."""
    _ask.get()()
