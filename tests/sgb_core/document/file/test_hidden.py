"""What a killed program left half written goes, and nothing else does."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import BinaryIO

import pytest

from sgb_core.document.file import hidden
from sgb_core.document.file.atomic import write_whole
from sgb_core.document.file.hidden import clean, new_file, new_folder

LEFT = ".sgb-0123456789abcdef.tmp"


def test_what_a_kill_left_is_removed_and_what_is_being_written_stays(tmp_path: Path) -> None:
    (tmp_path / LEFT).write_bytes(b"half")
    others = {tmp_path / name for name in ("mine.tmp", ".sgb-mine.tmp", "a.sgb")}
    for other in others:
        other.touch()

    def writer(stream: BinaryIO) -> None:
        assert not (tmp_path / LEFT).exists()
        assert clean(tmp_path) == 0
        stream.write(b"whole")

    write_whole(tmp_path / "b", writer)
    assert set(tmp_path.iterdir()) == {*others, tmp_path / "b"}
    assert clean(tmp_path / "nowhere") == 0


def test_a_folder_that_a_kill_left_goes_with_all_in_it(tmp_path: Path) -> None:
    (tmp_path / LEFT / "inner").mkdir(parents=True)
    (tmp_path / LEFT / "inner" / "half.png").write_bytes(b"half")
    with new_folder(tmp_path) as folder:
        (folder / "a").touch()
        assert clean(tmp_path) == 1
        assert (folder / "a").exists()
        assert folder.stat().st_mode & 0o77 == 0
    assert list(tmp_path.iterdir()) == []


def test_where_the_system_keeps_what_is_temporary_is_cleaned_too(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    (tmp_path / LEFT).mkdir()
    with new_folder() as folder:
        assert folder.parent == tmp_path
        assert clean() == 1


def test_links_and_pipes_stay_and_hold_nobody_up(tmp_path: Path) -> None:
    victim = tmp_path / "victim"
    victim.mkdir()
    (tmp_path / LEFT).symlink_to(victim)
    assert clean(tmp_path) == 0
    assert victim.is_dir()
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / ".sgb-aaaaaaaaaaaaaaaa.tmp")
        clean(tmp_path)


def test_a_new_file_that_another_program_took_for_left_over_is_made_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    hold, taken = hidden._hold, []

    def late(descriptor: int) -> bool:
        if not taken:
            taken.append(clean_by_another(tmp_path))
        return hold(descriptor)

    def clean_by_another(folder: Path) -> Path:
        (path,) = folder.iterdir()
        path.unlink()
        return path

    monkeypatch.setattr(hidden, "_hold", late)
    path, descriptor = new_file(tmp_path, 0o600)
    assert path.exists()
    assert path not in taken
    os.close(descriptor)


def test_where_files_cannot_be_held_they_are_written_all_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(descriptor: int) -> bool:
        raise OSError(37, "No locks available")

    monkeypatch.setattr(hidden, "_hold", refuse)
    (tmp_path / LEFT).touch()
    write_whole(tmp_path / "a", lambda stream: stream.write(b"whole"))
    assert (tmp_path / "a").read_bytes() == b"whole"
    # Whose it is nobody knows.
    assert (tmp_path / LEFT).exists()
