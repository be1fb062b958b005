"""What can be done in the viewport with the thing under the pointer, as a menu."""

from __future__ import annotations

from functools import partial

from PySide6.QtWidgets import QMenu, QWidget

from app.commands import context_menu
from app.hand.turn import TurnEnd
from app.state.presenter import Presenter
from app.viewport.handles import Grip, SideGrip
from app.viewport.rim_handle import RimGrip
from app.viewport.texture_handle import TextureGrip
from sgb_core.document import edits
from sgb_core.surfaces.revolution import Axis

TURNS = {360.0: "Full turn", 270.0: "Three quarters", 180.0: "Half a turn", 90.0: "A quarter"}

TWISTS = {0.0: "No twist", 0.125: "An eighth of a turn", 0.25: "A quarter", 0.5: "Half a turn"}


def build(parent: QWidget, presenter: Presenter, grip: Grip) -> QMenu:
    """Return the menu of a grip; of what the profile has it is that of the editor."""
    if not isinstance(grip, TurnEnd | SideGrip):
        return context_menu.build(parent, presenter, grip)
    menu = QMenu(parent)
    if isinstance(grip, TurnEnd):
        for degrees, words in TURNS.items():
            action = menu.addAction(words)
            action.triggered.connect(partial(_set_sweep, presenter, degrees))
    elif isinstance(grip, TextureGrip):
        context_menu.add_texture(menu, presenter, grip.number)
    elif isinstance(grip, RimGrip):
        for turns, words in TWISTS.items():
            action = menu.addAction(words)
            action.triggered.connect(partial(_set_twist, presenter, turns))
    else:
        for axis in Axis:
            action = menu.addAction(f"Axis {axis}")
            action.triggered.connect(partial(_set_axis, presenter, axis))
    return menu


def _set_sweep(presenter: Presenter, degrees: float, _checked: bool = False) -> None:
    presenter.do("Sweep", lambda d: edits.set_revolution(d, sweep_deg=degrees))


def _set_axis(presenter: Presenter, axis: Axis, _checked: bool = False) -> None:
    presenter.do("Axis", lambda d: edits.set_revolution(d, axis=axis))


def _set_twist(presenter: Presenter, turns: float, _checked: bool = False) -> None:
    presenter.do("Twist", lambda d: edits.set_twist(d, turns=turns))
