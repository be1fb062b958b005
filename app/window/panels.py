"""The table of the panels: what each is called, where it sits and what makes it; their docks."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TypeVar, cast

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget, QMainWindow, QTabWidget, QWidget

from app.panels.curvature_plot import CurvaturePlot
from app.panels.history import HistoryPanel
from app.panels.laws.panel import VariationPanel
from app.panels.look.panel import LookPanel
from app.panels.measures.panel import MeasuresPanel
from app.panels.points.table import PointTable
from app.panels.shape.panel import ShapePanel
from app.panels.solid import SolidPanel
from app.panels.states import StatesPanel
from app.panels.turn.panel import TurnPanel
from app.profile_editor.view import ProfileView
from app.state.presenter import Presenter, View
from app.widgets.scroll_area import PanelArea

Area = Qt.DockWidgetArea
LEFT, RIGHT = Area.LeftDockWidgetArea, Area.RightDockWidgetArea
P = TypeVar("P", bound=QWidget)


@dataclass(frozen=True, slots=True)
class PanelKind:
    """One panel: its key, its title, the side it docks to, and what makes it.

    It lies ``below`` the panel of that key, or is a tab beside that of ``tab_of``. ``scrolls``
    gives it a scroll area of its own; ``hidden`` ones are shown on demand.
    """

    key: str
    title: str
    area: Area
    make: Callable[[Presenter, QWidget], View]
    below: str = ""
    tab_of: str = ""
    scrolls: bool = False
    hidden: bool = False


# In the order of the menu; tabs in that of their group.
PANELS = (
    PanelKind("profile", "Profile", LEFT, ProfileView),
    PanelKind("points", "Points", LEFT, PointTable, below="profile"),
    PanelKind("curvature", "Curvature", LEFT, CurvaturePlot, below="profile", hidden=True),
    PanelKind("shape", "Shape", RIGHT, ShapePanel),
    PanelKind("turn", "Turn", RIGHT, TurnPanel, tab_of="shape", scrolls=True),
    PanelKind("vary", "Vary", RIGHT, VariationPanel, tab_of="turn", scrolls=True),
    PanelKind("solid", "Solid", RIGHT, SolidPanel, tab_of="vary", scrolls=True),
    PanelKind("measures", "Measures", RIGHT, MeasuresPanel, tab_of="solid", scrolls=True),
    PanelKind("look", "Look", RIGHT, LookPanel, tab_of="measures", scrolls=True),
    PanelKind("states", "States", LEFT, StatesPanel, tab_of="points"),
    PanelKind("history", "History", LEFT, HistoryPanel, tab_of="states"),
)


class Panels:
    """The panels of one window in their ``docks``, by their keys, and at first where PANELS says.

    ``changed`` is called with whether it is seen now whenever one comes or goes.
    """

    def __init__(
        self, presenter: Presenter, window: QMainWindow, changed: Callable[[bool], object]
    ) -> None:
        self._widgets = {kind.key: kind.make(presenter, window) for kind in PANELS}
        self.docks: dict[str, QDockWidget] = {}
        for kind in PANELS:
            widget = self[kind.key]
            dock = QDockWidget(kind.title, window)
            dock.setObjectName(f"dock_{kind.key}")
            dock.setWidget(PanelArea(widget) if kind.scrolls else widget)
            dock.visibilityChanged.connect(changed)
            window.addDockWidget(kind.area, dock)
            self.docks[kind.key] = dock
        self._arrange(window)

    def _arrange(self, window: QMainWindow) -> None:
        docks = self.docks
        for kind in PANELS:
            if kind.below:
                window.splitDockWidget(docks[kind.below], docks[kind.key], Qt.Orientation.Vertical)
            if kind.hidden:
                docks[kind.key].hide()
        # Upright at the window's edge six tabs keep their whole names in the narrowest dock.
        window.setTabPosition(RIGHT, QTabWidget.TabPosition.East)
        for kind in PANELS:
            if kind.tab_of:
                window.tabifyDockWidget(docks[kind.tab_of], docks[kind.key])
        for kind in PANELS:
            if not kind.tab_of and not kind.hidden:
                docks[kind.key].raise_()

    def __getitem__(self, key: str) -> QWidget:
        return cast(QWidget, self._widgets[key])

    def __iter__(self) -> Iterator[View]:
        """Walk through the panels themselves, in the order of PANELS."""
        return iter(self._widgets.values())

    def of(self, kind: type[P]) -> P:
        """Return the panel of a class; raises StopIteration where there is none."""
        return next(each for each in map(self.__getitem__, self._widgets) if isinstance(each, kind))
