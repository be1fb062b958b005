"""Progress of a file being written, its cancelling, and how large it will be."""

from __future__ import annotations

from pathlib import Path

import pytest

from sgb_core import exchange
from sgb_core.document.errors import FileError
from sgb_core.document.model import Document
from tests.sgb_core.document import samples

SUFFIXES = exchange.suffixes()
FINE = {"samples": (64, 256)}


@pytest.fixture
def document() -> Document:
    return samples.document()


class Stop(Exception):  # noqa: N818 - stands for a cancelled job
    """What a cancelled job raises."""


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_progress_runs_from_nothing_to_all(suffix: str, document: Document, tmp_path: Path) -> None:
    seen: list[float] = []
    size = exchange.file_size(document, suffix, **FINE)
    exchange.write(
        document, tmp_path / f"a{suffix}", report=seen.append, expected_bytes=size, **FINE
    )
    assert seen[0] == 0.0
    assert seen[-1] == 1.0
    assert seen == sorted(seen)
    assert len(seen) > 2


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_the_size_told_is_that_of_the_file(suffix: str, document: Document, tmp_path: Path) -> None:
    path = tmp_path / f"a{suffix}"
    exchange.write(document, path, samples=(9, 20))
    assert exchange.file_size(document, suffix, samples=(9, 20)) == path.stat().st_size


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_reporting_changes_no_byte(suffix: str, document: Document, tmp_path: Path) -> None:
    quiet, told = tmp_path / f"a{suffix}", tmp_path / f"b{suffix}"
    exchange.write(document, quiet, samples=(9, 20))
    exchange.write(document, told, samples=(9, 20), report=lambda _: None)
    assert quiet.read_bytes() == told.read_bytes()


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("reports", [1, 2])
def test_a_cancelled_export_leaves_no_file_and_keeps_the_old_one(
    suffix: str, reports: int, document: Document, tmp_path: Path
) -> None:
    left = iter(range(reports))

    def report(_part: float) -> None:
        if next(left, None) is None:
            raise Stop

    old = tmp_path / f"old{suffix}"
    old.write_bytes(b"precious")
    for path in (old, tmp_path / f"new{suffix}"):
        left = iter(range(reports))
        with pytest.raises(Stop):
            exchange.write(document, path, report=report, **FINE)
    assert [p.name for p in tmp_path.iterdir()] == [old.name]
    assert old.read_bytes() == b"precious"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is always full")
def test_a_full_disk_is_one_line(document: Document, tmp_path: Path) -> None:
    link = tmp_path / "full.stl"
    link.symlink_to("/dev/full")
    with pytest.raises(FileError, match=r"^cannot write .*full\.stl: No space left on device$"):
        exchange.write(document, link, report=lambda _: None, **FINE)


def test_progress_never_reaches_the_end_by_itself(document: Document, tmp_path: Path) -> None:
    seen: list[float] = []
    exchange.write(document, tmp_path / "a.obj", report=seen.append, expected_bytes=10, **FINE)
    assert seen == sorted(seen)
    assert seen[-2] < 1.0
