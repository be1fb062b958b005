"""What the drawn surface means as an object, as commands: bare, filled, a vessel."""

from __future__ import annotations

from functools import partial

from app.commands.command import Command
from app.state.presenter import Frame, Presenter
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.document import edits
from sgb_core.fields.record import table_of

KIND = table_of(Solid).row("kind")


def body_commands(presenter: Presenter) -> list[Command]:
    """Return the choice of what the surface is the body of."""

    def choose(kind: BodyKind) -> None:
        label = f"{KIND.label}: {kind}"
        presenter.do(label, lambda document: edits.set_solid(document, kind=kind))

    def is_chosen(kind: BodyKind, frame: Frame) -> bool:
        return frame.document.solid.kind is kind

    return [
        Command(
            f"body_{kind}",
            "Edit/Body",
            KIND.titles[kind],
            partial(choose, kind),
            tip=KIND.tips[kind],
            state=partial(is_chosen, kind),
        )
        for kind in BodyKind
    ]
