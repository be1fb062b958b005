from __future__ import annotations

import errno
import os
import stat
from pathlib import Path
from typing import BinaryIO

import pytest

from sgb_core.document.errors import FileError
from sgb_core.document.file.atomic import write_whole


def new(stream: BinaryIO) -> None:
    stream.write(b"new")


def test_a_file_is_written_and_replaced(tmp_path: Path) -> None:
    target = tmp_path / "a.stl"
    write_whole(target, new)
    assert target.read_bytes() == b"new"
    write_whole(str(target), lambda stream: stream.write(b"newer") and None)
    assert target.read_bytes() == b"newer"
    assert os.listdir(tmp_path) == ["a.stl"]


def test_a_new_file_has_the_usual_permissions_and_an_old_one_keeps_its_own(tmp_path: Path) -> None:
    usual, target = tmp_path / "usual", tmp_path / "a"
    usual.touch()
    write_whole(target, new)
    assert target.stat().st_mode == usual.stat().st_mode
    target.chmod(0o640)
    write_whole(target, new)
    assert stat.S_IMODE(target.stat().st_mode) == 0o640


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "real").write_bytes(b"old")
    (tmp_path / "link").symlink_to("real")
    write_whole(tmp_path / "link", new)
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real").read_bytes() == b"new"


@pytest.mark.parametrize("error", [OSError(errno.ENOSPC, "No space left on device"), KeyError()])
def test_a_failure_leaves_the_old_file_and_nothing_else(tmp_path: Path, error: Exception) -> None:
    target = tmp_path / "a"
    target.write_bytes(b"old")

    def fails(stream: BinaryIO) -> None:
        stream.write(b"half")
        raise error

    expected = FileError if isinstance(error, OSError) else type(error)
    with pytest.raises(expected):
        write_whole(target, fails)
    assert target.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["a"]


def test_an_interrupt_leaves_no_file(tmp_path: Path) -> None:
    def interrupted(stream: BinaryIO) -> None:
        stream.write(b"half")
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_whole(tmp_path / "a", interrupted)
    assert os.listdir(tmp_path) == []


def line(path: object) -> str:
    with pytest.raises(FileError) as caught:
        write_whole(path, new)  # type: ignore[arg-type]
    text = str(caught.value)
    assert text.isprintable()
    return text


def test_what_the_system_refuses_is_one_line_with_the_path(tmp_path: Path) -> None:
    assert line(tmp_path) == f"cannot write {tmp_path}: it is a folder"
    assert "there is no folder" in line(tmp_path / "none" / "a")
    (tmp_path / "file").touch()
    assert "cannot write" in line(tmp_path / "file" / "a")
    assert "File name too long" in line(tmp_path / ("x" * 300))
    assert "not a file name" in line("a\0b")
    assert "\\n" in line(tmp_path / "none\n" / "a")


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs /dev/full")
def test_a_full_device_is_one_line() -> None:
    assert "No space left on device" in line("/dev/full")


def test_a_write_protected_file_is_not_replaced(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # As root nothing is protected, so the system's answer is played here.
    (tmp_path / "a").write_bytes(b"old")
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    assert "write-protected" in line(tmp_path / "a")
    assert (tmp_path / "a").read_bytes() == b"old"


def test_the_longest_file_name_works(tmp_path: Path) -> None:
    target = tmp_path / ("x" * 255)
    write_whole(target, new)
    assert target.read_bytes() == b"new"


def test_no_private_file_is_readable_while_it_is_written(tmp_path: Path) -> None:
    target = tmp_path / "a"
    target.touch(mode=0o600)
    modes = []
    write_whole(target, lambda _: modes.extend(p.stat().st_mode & 0o77 for p in tmp_path.iterdir()))
    assert modes == [0, 0]
    assert target.stat().st_mode & 0o777 == 0o600
