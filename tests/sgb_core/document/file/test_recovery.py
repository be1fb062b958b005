from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from sgb_core.document.errors import FileError
from sgb_core.document.file.recovery import Journal, recoverable
from tests.sgb_core.document import samples

DOCUMENT = samples.document()


def as_if_crashed(journal: Journal) -> Path:
    """Rename a journal's entry so that it belongs to a program that has ended."""
    gone = subprocess.Popen([sys.executable, "-c", ""])
    gone.wait()
    entry = journal.entry.with_name(f"{gone.pid}-{journal.entry.name}")
    return journal.entry.rename(entry)


def test_what_a_crash_left_is_found_with_its_place(tmp_path: Path) -> None:
    folder = tmp_path / "journal"
    assert recoverable(folder) == []
    journal = Journal(folder)
    assert journal.write(DOCUMENT, tmp_path / "vase.sgb")
    assert not journal.write(DOCUMENT)
    entry = as_if_crashed(journal)
    (found,) = recoverable(folder)
    assert found.document == DOCUMENT
    assert found.target == tmp_path / "vase.sgb"
    assert found.entry == entry


def test_the_newest_comes_first_and_broken_ones_are_left_out(tmp_path: Path) -> None:
    for age in (20, 10):
        journal = Journal(tmp_path)
        journal.write(samples.document(samples.VASE[: 1 + (age > 10)]))
        entry = as_if_crashed(journal)
        os.utime(entry, (1000 - age, 1000 - age))
    (tmp_path / "0-broken.recovery").write_bytes(b"{")
    (tmp_path / "x.recovery").write_bytes(b'{"target": 3, "document": {}}')
    found = recoverable(tmp_path)
    assert [len(item.document.profile) for item in found] == [1, 2]
    assert [item.target for item in found] == [None, None]


def test_work_of_running_programs_is_not_offered(tmp_path: Path) -> None:
    journal = Journal(tmp_path)
    journal.write(DOCUMENT)
    assert recoverable(tmp_path) == []
    assert journal.entry.exists()
    journal.clear()
    assert not journal.entry.exists()
    journal.clear()
    assert journal.write(DOCUMENT)


def test_a_folder_that_cannot_be_made_is_one_line(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(FileError, match="cannot make"):
        Journal(tmp_path / "file").write(DOCUMENT)
