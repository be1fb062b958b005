"""The small buttons at the viewport's edge: fit, views, projection, what is shown."""

from __future__ import annotations

from itertools import pairwise
from typing import Protocol

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QFrame, QHBoxLayout, QMenu, QToolButton, QWidget

from app.scene.standard_views import STANDARD_VIEWS
from app.state.overlays import Overlay
from app.state.view_state import ViewState
from app.theme import icons
from app.widgets.menu_button import open_menu


class Owner(Protocol):
    """The viewport as its buttons know it."""

    def fit(self) -> None:
        """See all of the object."""

    def set_view_direction(self, name: str) -> None:
        """See from a standard direction."""

    def toggle_projection(self) -> None:
        """Change between perspective and parallel."""

    def toggle_overlay(self, overlay: Overlay) -> None:
        """Show or hide an overlay."""


class ViewportButtons(QFrame):
    """A bar that floats over the viewport's corner. Opaque, so that it costs no drawing below."""

    def __init__(self, owner: Owner, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("viewport-buttons")
        self.setAutoFillBackground(True)
        self.setAccessibleName("Viewport")
        row = QHBoxLayout(self)
        row.setContentsMargins(2, 2, 2, 2)
        row.setSpacing(0)
        fit = self._button("fit", "Fit the surface into the view (F)", "Fit")
        fit.clicked.connect(owner.fit)
        views = self._button("view-iso", "Standard views (1, 3, 7; Ctrl: from behind)", "Views")
        menu = QMenu(views)
        for name, each in STANDARD_VIEWS.items():
            action = menu.addAction(each.words)
            icons.bind(action, each.icon)
            action.triggered.connect(lambda _=False, name=name: owner.set_view_direction(name))
        open_menu(views, menu)
        self.projection = self._button("perspective", "", "Parallel projection")
        self.projection.setCheckable(True)
        self.projection.clicked.connect(owner.toggle_projection)
        show = self._button("show", "What is shown", "Show")
        menu = QMenu(show)
        menu.setToolTipsVisible(True)
        group = QActionGroup(menu)
        group.setExclusionPolicy(QActionGroup.ExclusionPolicy.None_)
        self.overlays: dict[Overlay, QAction] = {}
        self._shown: ViewState | None = None
        for overlay in Overlay:
            if not overlay.in_viewport:
                continue
            action = menu.addAction(overlay.words)
            action.setCheckable(True)
            action.setToolTip(overlay.tip or overlay.words)
            group.addAction(action)
            action.triggered.connect(lambda _=False, key=overlay: owner.toggle_overlay(key))
            self.overlays[overlay] = action
        open_menu(show, menu)
        for button in (fit, views, self.projection, show):
            row.addWidget(button)

    def _button(self, icon: str, tip: str, name: str) -> QToolButton:
        button = QToolButton(self)
        icons.bind(button, icon)
        button.setToolTip(tip)
        button.setAccessibleName(name)
        button.setAutoRaise(True)
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        return button

    def come_after(self, part: QWidget) -> None:
        """Let Tab lead from ``part``, which was made much later, to the buttons.

        Left at the end of the chain it would close a round of Tab that leaves others out; and
        where a round begins anew, Qt passes by buttons that take no focus from a click.
        """
        buttons = self.findChildren(QToolButton)
        QWidget.setTabOrder(buttons[-1], part)
        for before, button in pairwise((part, *buttons)):
            QWidget.setTabOrder(before, button)

    def show_state(self, view: ViewState) -> None:
        """Let the buttons say what is so."""
        # An icon that is set anew, even the same one, lays out the whole window.
        known = self._shown
        if known is not None and (known.projection, known.show) == (view.projection, view.show):
            # A button that was just pressed has changed by itself.
            self.projection.setChecked(view.projection == "parallel")
            return
        self._shown = view
        parallel = view.projection == "parallel"
        self.projection.setChecked(parallel)
        icons.bind(self.projection, "parallel" if parallel else "perspective")
        other = "perspective" if parallel else "parallel projection"
        self.projection.setToolTip(f"Change to {other} (P)")
        for overlay, action in self.overlays.items():
            action.setChecked(view.shows(overlay))
