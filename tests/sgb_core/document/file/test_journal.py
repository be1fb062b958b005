"""A journal that is killed while it is written, or while the disk takes its time."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from sgb_core.document import edits
from sgb_core.document.appearance.pictures import encode_png
from sgb_core.document.file import journal as journals
from sgb_core.document.file.recovery import aside, recoverable
from tests.sgb_core.document import samples
from tests.sgb_core.document.file.test_recovery import Place

DOCUMENT = samples.document()
PICTURE = encode_png(np.random.default_rng(1).integers(0, 256, (64, 64, 4), np.uint8))


@pytest.fixture
def place(tmp_path: Path) -> Place:
    return Place(tmp_path)


def test_a_kill_before_the_first_step_is_whole_leaves_nothing(place: Place) -> None:
    journal = place.journal()
    journal.write(edits.add_picture(DOCUMENT, PICTURE))
    journal.close()
    whole = journal.entry.read_bytes()
    last = whole.rindex(b"\n", 0, -1) + 1
    for cut in (
        *range(12),
        last - 9,
        last,
        last + 1,
        last + 8,
        last + 9,
        last + 50,
        len(whole) - 1,
    ):
        journal.entry.write_bytes(whole[:cut])
        assert place.found() == []
        assert not journal.entry.exists()
        assert aside(place.folder) == []


def test_a_step_is_there_before_the_disk_has_it(
    place: Place, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The disk takes its time; a kill meanwhile loses nothing.
    monkeypatch.setattr(journals, "LARGE", 2000)
    journal, steps, seen = place.journal(), 0, []

    def slow(_descriptor: int) -> None:
        (found,) = recoverable(place.folder, place.locks.with_name("others"))
        seen.append(found.steps)
        assert found.steps == steps

    for name in ("fsync", "fdatasync"):
        monkeypatch.setattr(os, name, slow, raising=False)
    for number in range(1, 60):
        steps = number
        journal.write(edits.rename(DOCUMENT, "n" * number))
    assert len(seen) > steps
    journal.close()
