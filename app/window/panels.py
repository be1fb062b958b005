"""The table of the panels: what each is called, where it sits and what makes it; their docks."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING, TypeVar

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDockWidget, QMainWindow, QTabWidget, QWidget

from app.window.panel_slot import PanelSlot
from sgb_core.values import dataclass

if TYPE_CHECKING:
    from app.state.presenter import Presenter, View

Area = Qt.DockWidgetArea
LEFT, RIGHT = Area.LeftDockWidgetArea, Area.RightDockWidgetArea
P = TypeVar("P", bound=QWidget)


@dataclass(frozen=True, slots=True)
class PanelKind:
    """One panel: its key, its title, the side it docks to, and what makes it.

    It lies ``below`` the panel of that key, or is a tab beside that of ``tab_of``. ``scrolls``
    gives it a scroll area of its own; ``hidden`` ones are shown on demand. ``module`` is where it
    lies among the panels, by default in the one of its key.
    """

    key: str
    title: str
    area: Area
    make: Callable[[Presenter, QWidget], View]
    below: str = ""
    tab_of: str = ""
    scrolls: bool = False
    hidden: bool = False
    module: str = ""


# A panel is imported when it is made: most are never looked at in one sitting.


def _profile(presenter: Presenter, window: QWidget) -> View:
    from app.profile_editor.view import ProfileView

    return ProfileView(presenter, window)


def _points(presenter: Presenter, window: QWidget) -> View:
    from app.panels.points.table import PointTable

    return PointTable(presenter, window)


def _curvature(presenter: Presenter, window: QWidget) -> View:
    from app.panels.curvature_plot import CurvaturePlot

    return CurvaturePlot(presenter, window)


def _shape(presenter: Presenter, window: QWidget) -> View:
    from app.panels.shape.panel import ShapePanel

    return ShapePanel(presenter, window)


def _turn(presenter: Presenter, window: QWidget) -> View:
    from app.panels.turn.panel import TurnPanel

    return TurnPanel(presenter, window)


def _vary(presenter: Presenter, window: QWidget) -> View:
    from app.panels.laws.panel import VariationPanel

    return VariationPanel(presenter, window)


def _solid(presenter: Presenter, window: QWidget) -> View:
    from app.panels.solid.panel import SolidPanel

    return SolidPanel(presenter, window)


def _measures(presenter: Presenter, window: QWidget) -> View:
    from app.panels.measures.panel import MeasuresPanel

    return MeasuresPanel(presenter, window)


def _locks(presenter: Presenter, window: QWidget) -> View:
    from app.panels.locks.panel import LocksPanel

    return LocksPanel(presenter, window)


def _look(presenter: Presenter, window: QWidget) -> View:
    from app.panels.look.panel import LookPanel

    return LookPanel(presenter, window)


def _states(presenter: Presenter, window: QWidget) -> View:
    from app.panels.states import StatesPanel

    return StatesPanel(presenter, window)


def _joints(presenter: Presenter, window: QWidget) -> View:
    from app.panels.joints import JointsPanel

    return JointsPanel(presenter, window)


def _history(presenter: Presenter, window: QWidget) -> View:
    from app.panels.history import HistoryPanel

    return HistoryPanel(presenter, window)


# In the order of the menu; tabs in that of their group.
PANELS = (
    PanelKind("profile", "Profile", LEFT, _profile),
    PanelKind("points", "Points", LEFT, _points, below="profile"),
    PanelKind(
        "curvature",
        "Curvature",
        LEFT,
        _curvature,
        below="profile",
        hidden=True,
        module="curvature_plot",
    ),
    PanelKind("shape", "Shape", RIGHT, _shape),
    PanelKind("turn", "Turn", RIGHT, _turn, tab_of="shape", scrolls=True),
    PanelKind("vary", "Vary", RIGHT, _vary, tab_of="turn", scrolls=True, module="laws"),
    PanelKind("solid", "Solid", RIGHT, _solid, tab_of="vary", scrolls=True),
    PanelKind("measures", "Measures", RIGHT, _measures, tab_of="solid", scrolls=True),
    PanelKind("locks", "Locks", RIGHT, _locks, tab_of="measures", scrolls=True),
    PanelKind("look", "Look", RIGHT, _look, tab_of="locks", scrolls=True),
    PanelKind("joints", "Joints", LEFT, _joints, tab_of="points", scrolls=True),
    PanelKind("states", "States", LEFT, _states, tab_of="joints", scrolls=True),
    PanelKind("history", "History", LEFT, _history, tab_of="states", scrolls=True),
)


def make_docks(window: QMainWindow) -> dict[str, QDockWidget]:
    """Return the docks of a window by their keys, still empty, where PANELS says."""
    docks: dict[str, QDockWidget] = {}
    for kind in PANELS:
        docks[kind.key] = dock = QDockWidget(kind.title, window)
        dock.setObjectName(f"dock_{kind.key}")
        window.addDockWidget(kind.area, dock)
    for kind in PANELS:
        if kind.below:
            window.splitDockWidget(docks[kind.below], docks[kind.key], Qt.Orientation.Vertical)
        if kind.hidden:
            docks[kind.key].hide()
    # Upright at the window's edge seven tabs keep their whole names in the narrowest dock.
    window.setTabPosition(RIGHT, QTabWidget.TabPosition.East)
    for kind in PANELS:
        if kind.tab_of:
            window.tabifyDockWidget(docks[kind.tab_of], docks[kind.key])
    for kind in PANELS:
        if not kind.tab_of and not kind.hidden:
            docks[kind.key].raise_()
    return docks


class Panels:
    """The panels of one window in its ``docks``, by their keys.

    ``changed`` is called with whether it is seen now whenever one comes or goes.
    """

    def __init__(
        self,
        presenter: Presenter,
        window: QMainWindow,
        docks: Mapping[str, QDockWidget],
        changed: Callable[[bool], object],
    ) -> None:
        self._slots: dict[str, PanelSlot] = {}
        self.docks = docks
        for kind in PANELS:
            dock = docks[kind.key]
            make = partial(kind.make, presenter, window)
            self._slots[kind.key] = PanelSlot(presenter, dock, make, scrolls=kind.scrolls)
            dock.visibilityChanged.connect(changed)

    def __getitem__(self, key: str) -> QWidget:
        """Return a panel, made and up to date."""
        return self._slots[key].panel

    def __iter__(self) -> Iterator[PanelSlot]:
        """Walk through the places of the panels, in the order of PANELS."""
        return iter(self._slots.values())

    def of(self, key: str, kind: type[P]) -> P:
        """Return a panel as the class that it is of; raises TypeError for another."""
        panel = self[key]
        if not isinstance(panel, kind):
            raise TypeError(f"the panel {key} is a {type(panel).__name__}, no {kind.__name__}")
        return panel
