"""Copy, cut, paste and duplicate: runs of segments, and the places of selected points."""

from __future__ import annotations

import json
from collections.abc import Callable

from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication, QKeySequence

from app.commands.command import Command, Shortcut
from app.hand.hit_test import canonical
from app.state.presenter import Presenter
from app.state.window_reader import WINDOW, why
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.document import edits
from sgb_core.document.edits import clip
from sgb_core.document.errors import FileError

SEGMENTS = "application/x-sgb-segments"
POINTS = "application/x-sgb-points"
Key = QKeySequence.StandardKey


def clipboard_commands(presenter: Presenter, sources: Callable[[QMimeData], bool]) -> list[Command]:
    """Return the commands of the Edit menu that use the clipboard.

    ``sources`` takes pasted pictures and tables of points; it returns whether it did.
    """

    def command(
        name: str, text: str, run: Callable[[Presenter], object], keys: Shortcut, tip: str
    ) -> Command:
        return Command(
            name, "Edit", text, lambda: run(presenter), keys, tip=tip, separator=name == "cut"
        )

    return [
        command("cut", "Cut segment", cut, Key.Cut, "Copy the selected segment and remove it"),
        command(
            "copy",
            "Copy segment or points",
            copy,
            Key.Copy,
            "Copy the selected points, or else the selected segment",
        ),
        command(
            "paste",
            "Paste",
            lambda presenter: paste(presenter, sources),
            Key.Paste,
            "Add copied segments after the selected one, place the selected points, or trace a "
            "copied picture or table of points",
        ),
        command(
            "duplicate", "Duplicate segment", duplicate, "Ctrl+D", "Add the selected segment again"
        ),
    ]


def _run(presenter: Presenter) -> tuple[int, int]:
    """Return the first and last segment that are meant: all of them, or the selected one."""
    view, profile = presenter.view, presenter.document.profile
    if view.all_segments:
        return 0, len(profile) - 1
    return view.segment, view.segment


def copy(presenter: Presenter) -> None:
    """Put the selected points, or else the selected segment, on the clipboard."""
    points = canonical(presenter.document.profile, presenter.view.points)
    if points:
        places = [presenter.document.profile.control_points[key].tolist() for key in points]
        mime = QMimeData()
        mime.setData(POINTS, json.dumps(places).encode())
        mime.setText("\n".join(f"{r!r}\t{h!r}" for r, h in places))
        QGuiApplication.clipboard().setMimeData(mime)
        presenter.notify(f"Copied {_count(len(points), 'point')}.")
        return
    first, last = _run(presenter)
    _put(clip.dumps_run(clip.run_of(presenter.document, first, last), presenter.document.unit))
    presenter.notify(f"Copied {_count(last - first + 1, 'segment')}.")


def cut(presenter: Presenter) -> None:
    """Copy the selected segment and remove it."""
    first, last = _run(presenter)
    text = clip.dumps_run(clip.run_of(presenter.document, first, last), presenter.document.unit)
    label = f"Cut {WINDOW.segment(first)}"
    if presenter.do(label, lambda d: clip.remove_run(d, first, last)):
        _put(text)


def paste(presenter: Presenter, sources: Callable[[QMimeData], bool]) -> None:
    """Add copied segments after the selected one, or give selected points copied places.

    What holds neither is offered to ``sources``.
    """
    mime = QGuiApplication.clipboard().mimeData()
    if mime.hasFormat(POINTS):
        _paste_points(presenter, bytes(mime.data(POINTS).data()))
        return
    data = bytes(mime.data(SEGMENTS).data()).decode("utf-8", "replace")
    try:
        run = clip.loads_run(data or mime.text(), presenter.document.unit)
    except FileError as error:
        if sources(mime):
            return
        presenter.notify(f"Nothing to paste: {why(error)}.", "warning")
        return
    _add(presenter, presenter.view.segment, run, f"Paste {_count(len(run), 'segment')}")


def duplicate(presenter: Presenter) -> None:
    """Add the selected segment again after itself."""
    first, last = _run(presenter)
    run = clip.run_of(presenter.document, first, last)
    _add(presenter, last, run, f"Duplicate {WINDOW.segment(first)}")


def _add(presenter: Presenter, after: int, run: Profile, label: str) -> None:
    if not presenter.do(label, lambda d: clip.paste_run(d, after, run)):
        return
    joint = after + len(run)
    presenter.select(after + 1)
    rules = presenter.document.profile.rules
    if joint < len(rules) and rules[joint] is JointRule.FREE:
        numbers = f"{WINDOW.number(joint)} and {WINDOW.number(joint + 1)}"
        presenter.notify(
            f"Segments {numbers} do not meet: their radii differ.",
            "warning",
            "Join them",
            lambda: presenter.do(
                f"Join segments {numbers}",
                lambda d: edits.set_rule(d, joint, JointRule.G0),
            ),
        )


def _paste_points(presenter: Presenter, data: bytes) -> None:
    places = [(float(r), float(h)) for r, h in json.loads(data)]
    chosen = canonical(presenter.document.profile, presenter.view.points)
    if len(chosen) != len(places):
        presenter.notify(
            f"The clipboard holds {_count(len(places), 'point')}: select as many to move there.",
            "warning",
        )
        return
    moved = dict(zip(chosen, places, strict=True))
    presenter.do(f"Paste {_count(len(places), 'point')}", lambda d: edits.place_points(d, moved))


def _put(text: str) -> None:
    mime = QMimeData()
    mime.setData(SEGMENTS, text.encode())
    mime.setText(text)
    QGuiApplication.clipboard().setMimeData(mime)


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"
