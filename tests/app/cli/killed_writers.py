"""Writes a file of each kind and looks at every state that a kill could leave.

``python -m tests.app.cli.killed_writers FOLDER KIND...`` prints for each kind how many states
there were, and how many things were left in them to be cleaned away.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import redirect_stdout
from io import StringIO
from mmap import mmap
from pathlib import Path

import numpy as np
from PySide6.QtCore import QSettings

import resources
from app.__main__ import main
from app.film.film import Film, write_film
from app.state import stored
from sgb_core.document import edits
from sgb_core.document.file import hidden, project_file, recovery, versions
from sgb_core.document.file import journal as journals
from tests.kill_points import Left, at_every_call

Work = Callable[[Path], object]
JOURNAL, STEPS = "journal", 12


def _command(name: str, *words: str, preset: str = "vase") -> Work:
    """Return what has the command line write a file; IN and the folder are put into the words."""

    def work(folder: Path) -> None:
        source = folder.parent / f"{preset}.sgb"
        if not source.exists():
            assert main(["new", preset, str(source)]) == 0
        given = [
            str(source)
            if word == "IN"
            else word.replace("OUT", f"{folder}/out").replace("HERE", f"{folder}")
            for word in words
        ]
        with redirect_stdout(StringIO()):
            assert main([name, *given]) == 0

    return work


def _film(suffix: str) -> Work:
    def images() -> Iterator[np.ndarray]:
        for number in range(3):
            yield np.full((32, 48, 4), 60 * number, dtype=np.uint8)

    return lambda folder: write_film(
        folder / f"out{suffix}", images(), Film(frames=3), lambda _part: None
    )


FINENESS = ("--samples", "6", "8")
WORKS: dict[str, Work] = {
    **{
        suffix: _command("export", "IN", f"OUT{suffix}", *FINENESS)
        for suffix in (".stl", ".ply", ".glb", ".3mf")
    },
    ".obj": _command("export", "IN", "OUT.obj", *FINENESS, preset="earthen-house"),
    ".step": _command("export", "IN", "OUT.step"),
    **{suffix: _command("export", "IN", f"OUT{suffix}") for suffix in (".svg", ".dxf", ".csv")},
    **{
        f"drawing {suffix}": _command("drawing", "IN", f"OUT{suffix}", "--date", "2026-03-31")
        for suffix in (".svg", ".dxf", ".pdf")
    },
    ".gcode": _command("toolpath", "IN", "OUT.gcode", "--printer", "generic-clay", "--anyway"),
    "points .csv": _command("sample", "IN", "--out", "OUT.csv"),
    ".sgb": _command("edit", "IN", "OUT.sgb", "set", "0", "lambda2", "6"),
    "variants": _command("variants", "IN", "--out", "HERE", "--over", "0.lambda2", "--count", "3"),
    **{f"film {suffix}": _film(suffix) for suffix in (".gif", ".mp4", ".png")},
}


def _backup(folder: Path) -> None:
    versions.keep_backup(resources.path("presets/vase.sgb"), folder)


def _settings(folder: Path) -> None:
    store = QSettings(str(folder / "out.conf"), QSettings.Format.IniFormat)
    store.setValue("recent_files", [f"/a/long/way/{number}.sgb" for number in range(10)])
    store.sync()


WORKS["backup"] = _backup
WORKS["settings"] = _settings
OLD = b"[General]\nold=1\n"


def _cleaned(kind: str, folder: Path) -> int:
    """Clean up as the program does when it starts; return how many things went."""
    before = len(list(folder.iterdir()))
    if kind == "settings":
        for held in folder.glob("*.lock"):
            # The program that holds it is gone, some time ago; here it is only stopped.
            os.utime(held, (1e9, 1e9))
        stored.clean_store(folder / "out.conf")
    else:
        hidden.clean(folder)
    return before - len(list(folder.iterdir()))


def written(kind: str, folder: Path) -> Left:
    """Write once undisturbed, then over old files, stopped at each system call."""
    whole, target, work = folder / "whole", folder / "target", WORKS[kind]
    for place in (whole, target):
        place.mkdir(parents=True)
    if kind == "settings":
        (whole / "out.conf").write_bytes(OLD)
    work(whole)
    new = {each.name: each.read_bytes() for each in whole.iterdir()}
    for name in new:
        (target / name).write_bytes(OLD)

    def see(after: Path) -> int:
        cleaned = _cleaned(kind, after)
        found = {each.name: each.read_bytes() for each in after.iterdir()}
        assert found.keys() == new.keys(), f"{kind}: {sorted(found)} where {sorted(new)} were"
        for name, data in found.items():
            assert data in (OLD, new[name]), f"{kind}: {name} is neither the old nor the new one"
        return cleaned

    left = Left(target, see)
    at_every_call(lambda: work(target), left.look)
    assert {each.name: each.read_bytes() for each in target.iterdir()} == new
    return left


def journal(folder: Path) -> Left:
    """Write a journal step by step, begun anew in between, and then another that takes it over."""
    target, locks, done = folder / "target", folder / "locks", mmap(-1, 1)
    target.mkdir(parents=True)
    journals.LARGE, journals.GROWN = 2000, 1
    start = project_file.loads(resources.load_preset("vase"))

    def work() -> None:
        document = start
        first = journals.Journal(target, locks)
        for step in range(1, STEPS + 1):
            document = edits.rename(edits.set_leg_fraction(document, 1, 1, step / 99), f"{step}")
            first.write(document)
            done[0] = step
        first.close()
        (item,) = recovery.recoverable(target, locks)
        second = journals.Journal(target, locks)
        assert second.adopt(item)
        second.close()

    def see(after: Path) -> int:
        cleaned = hidden.clean(after)
        found = recovery.recoverable(after, folder / "other locks")
        steps = max((int(item.document.name) for item in found), default=0)
        assert done[0] <= steps <= done[0] + 1
        assert sorted(after.iterdir()) == sorted(item.entry for item in found)
        return cleaned

    left = Left(target, see)
    at_every_call(work, left.look)
    assert done[0] == STEPS
    return left


def run(kinds: Sequence[str], folder: Path) -> None:
    """Look at what kills leave of several kinds, and print their counts as an object."""
    found = {}
    for kind in kinds:
        place = folder / kind
        left = journal(place) if kind == JOURNAL else written(kind, place)
        found[kind] = [left.states, left.half]
    print(json.dumps(found))


if __name__ == "__main__":
    run(sys.argv[2:], Path(sys.argv[1]))
