"""Guides by name, for the keyboard: through the selected point, and away with all."""

from __future__ import annotations

from functools import partial

from app.commands.command import Command
from app.state.presenter import Presenter
from sgb_core.document import edits
from sgb_core.document.guides import Guide, GuideAt
from sgb_core.document.model import Document

_MENU = "Edit/Guides"


def guide_commands(presenter: Presenter) -> list[Command]:
    """Return what adds and removes guides without a hand on the rulers."""

    def add(at: GuideAt) -> None:
        points = sorted(presenter.view.points)
        if not points:
            presenter.notify("Select a point first: the guide goes through it.", "warning")
            return

        def through(document: Document) -> Document:
            for segment, index in points:
                place = document.profile.segments[segment].points[index]
                document = edits.add_guide(document, Guide(at, float(place[at.coordinate])))
            return document

        presenter.do("Add a guide", through)

    return [
        Command(
            "guide_upright",
            _MENU,
            "Upright guide through the point",
            partial(add, GuideAt.RADIUS),
            tip="A line at the radius of each selected point, to which dragged points are drawn; "
            "with the mouse pull one from the left ruler",
        ),
        Command(
            "guide_level",
            _MENU,
            "Level guide through the point",
            partial(add, GuideAt.HEIGHT),
            tip="A line at the height of each selected point, to which dragged points are drawn; "
            "with the mouse pull one from the lower ruler",
        ),
        Command(
            "remove_guides",
            _MENU,
            "Remove all guides",
            lambda: presenter.do("Remove all guides", edits.remove_guides),
            tip="Take all guides away; one alone goes when it is dragged back to its ruler",
            enabled=lambda frame: bool(frame.document.guides),
        ),
    ]
