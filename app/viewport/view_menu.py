"""What can be done with the view where nothing of the object is to be grabbed, as a menu."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Protocol

from PySide6.QtWidgets import QMenu, QWidget

from app.hand.coordinates import ScreenPoint
from app.scene.standard_views import STANDARD_VIEWS

# Those that a ring has room for.
_SHOWN = ("front", "right", "top", "iso")


class Viewed(Protocol):
    """What such a menu changes."""

    def fit(self) -> None:
        """See all of the object."""

    def set_view_direction(self, name: str) -> None:
        """See from a standard direction."""

    def toggle_projection(self) -> None:
        """Change between perspective and parallel."""

    def set_pivot(self, x: float, y: float) -> None:
        """Turn about what is seen at (x, y), in logical pixels from the top left."""


def build(parent: QWidget, viewport: Viewed, at: ScreenPoint) -> QMenu:
    """Return the menu of the view, opened at a place of it."""
    menu = QMenu(parent)

    def add(words: str, run: Callable[[], object]) -> None:
        menu.addAction(words).triggered.connect(lambda _checked=False: run())

    add("Fit the surface", viewport.fit)
    add("Turn about this place", partial(viewport.set_pivot, at.x, at.y))
    for name in _SHOWN:
        add(STANDARD_VIEWS[name].words, partial(viewport.set_view_direction, name))
    add("Change projection", viewport.toggle_projection)
    return menu
