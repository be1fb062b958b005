"""The Segment menu: what can be done to the selected segment and to the chain."""

from __future__ import annotations

from collections.abc import Callable

from app.commands.command import Command
from app.state.presenter import Presenter
from app.state.window_reader import WINDOW, reason, told
from sgb_core.document import edits
from sgb_core.document.model import Document
from sgb_core.findings.edits import Deviation

# A curve that moves by less than this part of its size is seen not to have moved.
UNSEEN = 1e-9


def segment_commands(presenter: Presenter) -> list[Command]:
    """Return the commands of the Segment menu, in its order."""
    return [*_dividing(presenter), *_changing(presenter), *_selecting(presenter)]


def _dividing(presenter: Presenter) -> list[Command]:
    return [
        Command(
            "append_segment",
            "Segment",
            "Append segment",
            lambda: _append(presenter),
            "Ctrl+Return",
            "segment-append",
            tip="Add a segment that goes on smoothly from the end of the profile",
        ),
        Command(
            "insert_segment",
            "Segment",
            "Insert before selected",
            lambda: on_segment(presenter, "Insert before segment", edits.insert_segment),
            "Ctrl+I",
            "segment-insert",
            tip="Insert a segment before the selected one",
        ),
        Command(
            "split_segment",
            "Segment",
            "Split in the middle",
            lambda: split(presenter, presenter.view.segment, 0.5),
            "Ctrl+K",
            "segment-split",
            tip="Insert a joint without changing the shape: exactly, by de Casteljau’s algorithm.\n"
            "Where no exact split exists, as under a law, the deviation is measured first.",
        ),
        Command(
            "merge_segment",
            "Segment",
            "Merge with next",
            lambda: merge(presenter),
            "Ctrl+M",
            enabled=lambda frame: len(frame.evaluation.joints) > 0,
            tip="Replace the selected segment and the next by the one that fits them best",
        ),
    ]


def _changing(presenter: Presenter) -> list[Command]:
    return [
        Command(
            "reverse_segment",
            "Segment",
            "Reverse segment",
            lambda: on_segment(presenter, "Reverse segment", edits.reverse_segment),
            icon="segment-reverse",
            tip="Run the selected segment from its end to its start",
        ),
        Command(
            "remove_segment",
            "Segment",
            "Remove segment",
            lambda: on_segment(presenter, "Remove segment", edits.remove_segment),
            "Ctrl+Backspace",
            "segment-remove",
            enabled=lambda frame: len(frame.document.profile.segments) > 1,
            tip="Remove the selected segment and join its neighbours",
        ),
        Command(
            "close_profile",
            "Segment",
            "Closed profile (ring)",
            lambda: _toggle_closed(presenter),
            separator=True,
            state=lambda frame: frame.document.profile.closed,
            tip="Join the end of the profile to its start",
        ),
    ]


def _selecting(presenter: Presenter) -> list[Command]:
    return [
        Command(
            "next_segment",
            "Segment",
            "Select next segment",
            lambda: _step(presenter, 1),
            "Ctrl+PgDown",
            separator=True,
        ),
        Command(
            "previous_segment",
            "Segment",
            "Select previous segment",
            lambda: _step(presenter, -1),
            "Ctrl+PgUp",
        ),
    ]


def on_segment(presenter: Presenter, label: str, edit: Callable[[Document, int], Document]) -> bool:
    """Apply an edit to the selected segment; returns whether it was allowed."""
    segment = presenter.view.segment
    return presenter.do(f"{label} {WINDOW.number(segment)}", lambda d: edit(d, segment))


def _append(presenter: Presenter) -> None:
    if presenter.do("Append segment", edits.append_segment):
        presenter.select(len(presenter.document.profile.segments) - 1)


def _step(presenter: Presenter, step: int) -> None:
    count = len(presenter.document.profile.segments)
    presenter.select((presenter.view.segment + step) % count)


def split(presenter: Presenter, segment: int, s: float) -> None:
    """Split a segment; where that moves the curve, as under laws, it is offered first."""
    _offer(
        presenter,
        f"Split {WINDOW.segment(segment)}",
        lambda document: edits.split_segment(document, segment, s),
        f"Splitting {WINDOW.segment(segment)}",
        "Split",
    )


def merge(presenter: Presenter) -> None:
    """Merge the selected segment with the next; where that moves the curve, it is offered first."""
    merge_at(presenter, presenter.view.segment)


def merge_at(presenter: Presenter, segment: int) -> None:
    """Merge a segment with the next, as :func:`merge` does with the selected one."""
    following = (segment + 1) % len(presenter.document.profile)
    _offer(
        presenter,
        f"Merge {WINDOW.segment(segment)} with the next",
        lambda document: edits.merge_segments(document, segment),
        f"Merging segments {WINDOW.number(segment)} and {WINDOW.number(following)}",
        "Merge",
    )


def _offer(
    presenter: Presenter,
    label: str,
    edit: Callable[[Document], tuple[Document, float]],
    doing: str,
    button: str,
) -> None:
    """Do an edit that leaves the curve where it is; one that moves it is offered first.

    The offer tells the deviation, shows the new curve dashed in the editor and has a button that
    accepts it.
    """

    def accept() -> None:
        presenter.do(label, lambda document: edit(document)[0])

    document = presenter.document
    try:
        edited, deviation = edit(document)
    except edits.EditError as error:
        presenter.notify(reason(error), "warning")
        return
    if deviation <= UNSEEN * document.profile.size:
        accept()
        return
    # Over the whole turn; the editor draws one section of it.
    seen = "" if document.variation else ", as the dashed line shows"
    presenter.notify(
        f"{doing} moves the curve by up to {deviation:.3g} {document.unit}{seen}.",
        "info",
        button,
        accept,
    )
    presenter.set_view(preview=edited.profile)


def with_deviation(
    presenter: Presenter,
    label: str,
    edit: Callable[[Document], tuple[Document, float]],
    words: Callable[[Presenter, float], str] | None = None,
) -> bool:
    """Do an edit that says how far it moved the curve, and tell; returns whether it was done."""
    deviations: list[float] = []

    def keep_deviation(document: Document) -> Document:
        result, deviation = edit(document)
        deviations.append(deviation)
        return result

    if not presenter.do(label, keep_deviation):
        return False
    deviation, document = deviations[-1], presenter.document
    if deviation > UNSEEN * document.profile.size:
        said = f"The curve moved; {told(Deviation(deviation, document.unit.value))}."
        text = said if words is None else words(presenter, deviation)
        presenter.notify(text, "info", "Undo", presenter.undo)
    return True


def _toggle_closed(presenter: Presenter) -> None:
    if presenter.document.profile.closed:
        presenter.do("Open profile", edits.open_profile)
    else:
        presenter.do("Close profile", edits.close_profile)
