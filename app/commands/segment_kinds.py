"""More of the Segment menu: segments of a familiar kind, mirrors, order, head to tail."""

from __future__ import annotations

from functools import partial

from app.commands.command import Command
from app.commands.segment import on_segment, with_deviation
from app.state.presenter import Frame, Presenter
from app.state.window_reader import WINDOW, sentence
from sgb_core.curves.head_to_tail import joined_head_to_tail
from sgb_core.document import edits
from sgb_core.document.edits.segments import Kind
from sgb_core.findings.profile import OpposedParts

_KINDS = (
    (Kind.LINE, "Straight line", "Add a straight line that goes on from the end; exact"),
    (Kind.ARC, "Arc", "Add a quarter of a circle that goes on from the end, as near as can be"),
    (Kind.CUBIC, "Cubic", "Add a cubic Bézier curve that goes on from the end; exact"),
)


def more_segment_commands(presenter: Presenter) -> list[Command]:
    """Return the commands that add, mirror, reorder and put head to tail."""
    added = [
        Command(
            f"add_{kind}",
            "Segment/Add",
            text,
            partial(append_kind, presenter, kind),
            tip=tip,
            enabled=_is_open,
        )
        for kind, text, tip in _KINDS
    ]
    return [
        *added,
        Command(
            "mirror_segment",
            "Segment",
            "Mirror segment",
            lambda: on_segment(presenter, "Mirror segment", edits.mirror_segment),
            tip="Exchange the two ends of the selected segment's shape; its ends stay",
        ),
        Command(
            "move_earlier",
            "Segment",
            "Move earlier in the chain",
            lambda: _reorder(presenter, -1),
            "Ctrl+Shift+PgUp",
            enabled=lambda frame: frame.view.segment > 0,
            tip="Let the selected segment change places with the one before it",
        ),
        Command(
            "move_later",
            "Segment",
            "Move later in the chain",
            lambda: _reorder(presenter, 1),
            "Ctrl+Shift+PgDown",
            enabled=lambda frame: frame.view.segment < len(frame.document.profile) - 1,
            tip="Let the selected segment change places with the one after it",
        ),
        Command(
            "mirror_image",
            "Segment",
            "Double by mirror image",
            lambda: presenter.do("Double by mirror image", edits.append_mirror_image),
            enabled=_is_open,
            tip="Add the mirror image of the whole profile beyond its end",
        ),
        Command(
            "head_to_tail",
            "Segment",
            "Put head to tail",
            lambda: presenter.do("Put head to tail", edits.head_to_tail),
            tip="Reverse parts of the chain so that they meet end to end",
        ),
    ]


def append_kind(presenter: Presenter, kind: Kind) -> None:
    """Add a segment of a kind after the end and select it; an arc says its deviation."""
    if with_deviation(presenter, f"Add {kind}", lambda d: edits.append_kind(d, kind), _arc_words):
        presenter.select(len(presenter.document.profile) - 1)


def offer_head_to_tail(presenter: Presenter) -> bool:
    """Offer to join parts that run in opposite directions; returns whether there are any."""
    if joined_head_to_tail(presenter.document.profile) is None:
        return False
    presenter.notify(
        sentence(OpposedParts()),
        "info",
        "Put head to tail",
        lambda: presenter.do("Put head to tail", edits.head_to_tail),
    )
    return True


def _arc_words(presenter: Presenter, deviation: float) -> str:
    return f"The arc strays from a circle by at most {deviation:.2g} {presenter.document.unit}."


def _is_open(frame: Frame) -> bool:
    return not frame.document.profile.closed


def _reorder(presenter: Presenter, step: int) -> None:
    segment = presenter.view.segment
    label = f"Move {WINDOW.segment(segment)}"
    if presenter.do(label, lambda d: edits.move_segment(d, segment, step)):
        presenter.select(segment + step)
