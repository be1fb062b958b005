"""What the menus offer for looking into a body."""

from __future__ import annotations

from functools import partial
from typing import Protocol

from app.commands.command import Command
from app.state.cut import Cut
from app.state.presenter import Frame, Presenter


class Viewport(Protocol):
    """The 3-D view as these commands know it."""

    def set_view_direction(self, name: str) -> None:
        """See from one of the standard views."""


def cut_commands(presenter: Presenter, viewport: Viewport) -> list[Command]:
    """Return the commands that choose what is left away."""

    def choose(cut: Cut) -> None:
        presenter.set_view(cut=cut)
        if cut is Cut.SECTION:
            # The section lies in the plane that is seen from the front.
            viewport.set_view_direction("front")

    return [
        Command(
            f"cut_{cut}",
            "View/Cut away",
            cut.words,
            partial(choose, cut),
            cut.keys,
            tip=cut.tip,
            state=partial(_is, cut),
        )
        for cut in Cut
    ]


def _is(cut: Cut, frame: Frame) -> bool:
    return frame.view.cut is cut
