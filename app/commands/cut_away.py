"""What the menus offer for looking into a body."""

from __future__ import annotations

from functools import partial
from typing import Protocol

from app.commands.command import Command
from app.state.presenter import Frame, Presenter
from app.state.view_state import Cut

CUTS: tuple[tuple[Cut, str, str, str], ...] = (
    ("none", "Whole", "Ctrl+F5", "Show the whole object"),
    ("quarter", "Without a quarter", "Ctrl+F6", "Leave a quarter away to see the wall"),
    ("half", "Without the front half", "Ctrl+F7", "Leave the front half away to see the wall"),
    ("section", "Section only", "Ctrl+F8", "Show nothing but the cross-section, flat"),
)


class Viewport(Protocol):
    """The 3-D view as these commands know it."""

    def set_view_direction(self, name: str) -> None:
        """See from one of the standard views."""


def cut_commands(presenter: Presenter, viewport: Viewport) -> list[Command]:
    """Return the commands that choose what is left away."""

    def choose(cut: Cut) -> None:
        presenter.set_view(cut=cut)
        if cut == "section":
            # The section lies in the plane that is seen from the front.
            viewport.set_view_direction("front")

    return [
        Command(
            f"cut_{cut}",
            "View/Cut away",
            text,
            partial(choose, cut),
            keys,
            tip=tip,
            state=partial(_is, cut),
        )
        for cut, text, keys, tip in CUTS
    ]


def _is(cut: Cut, frame: Frame) -> bool:
    return frame.view.cut == cut
