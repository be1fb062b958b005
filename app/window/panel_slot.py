"""The place of one panel in its dock: made when it is first seen, at work only while it is seen."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, cast

from PySide6.QtCore import QEvent, QObject, QTimer
from PySide6.QtWidgets import QDockWidget, QWidget

from app.widgets.scroll_area import PanelArea

if TYPE_CHECKING:
    from app.state.presenter import Frame, Presenter, View


class PanelSlot(QObject):
    """Passes frames on to a panel that can be seen; the others get the newest when they can.

    A panel behind another tab, or one that is hidden, costs nothing: it is not even made before
    it is first seen or asked for. ``make`` makes it; ``scrolls`` gives it a scroll area.
    """

    def __init__(
        self,
        presenter: Presenter,
        dock: QDockWidget,
        make: Callable[[], View],
        *,
        scrolls: bool = False,
    ) -> None:
        super().__init__(dock)
        self._presenter = presenter
        self._dock = dock
        self._make = make
        self._scrolls = scrolls
        self._made: QWidget | None = None
        self._stale = True
        self._later = QTimer(self, singleShot=True, interval=0)
        self._later.timeout.connect(self._catch_up)
        dock.visibilityChanged.connect(self._come_or_gone)

    @property
    def made(self) -> bool:
        """Whether the panel has been made."""
        return self._made is not None

    @property
    def panel(self) -> QWidget:
        """The panel, which shows what there is now."""
        self._catch_up()
        return self._widget()

    def refresh(self, frame: Frame) -> None:
        """Show ``frame`` where the panel is to be seen, else remember that there is another."""
        made = self._made
        if made is not None and made.isVisible() and not made.visibleRegion().isEmpty():
            self._stale = False
            cast("View", made).refresh(frame)
        else:
            self._stale = True

    def look(self) -> None:
        """Make the panel where its dock, empty so far, is seen already."""
        if self._dock.isVisible() and not self._dock.visibleRegion().isEmpty():
            self._catch_up()

    def _widget(self) -> QWidget:
        if self._made is None:
            self._made = made = cast(QWidget, self._make())
            self._dock.setWidget(PanelArea(made) if self._scrolls else made)
            made.installEventFilter(self)
        return self._made

    def _come_or_gone(self, seen: bool) -> None:
        if seen:
            self._catch_up()

    def _catch_up(self) -> None:
        widget = self._widget()
        if self._stale:
            self._stale = False
            cast("View", widget).refresh(self._presenter.frame)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        # What uncovers a panel need not be its dock: a gallery laid over it leaves, too.
        if self._stale and event.type() in (QEvent.Type.Show, QEvent.Type.Paint):
            self._later.start()
        return super().eventFilter(watched, event)
