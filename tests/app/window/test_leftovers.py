"""What kills left half written is gone at the next start, wherever it lies."""

import os
from pathlib import Path

from PySide6.QtCore import QSettings

from app.files.files import RecentFiles
from app.state import stored, user_folders, written_folders
from app.window import program
from sgb_core.document.file import hidden

HALF = ".sgb-0123456789abcdef.tmp"


def half(folder: Path) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    left = folder / HALF
    left.write_bytes(b"half")
    return left


def test_a_start_cleans_every_place_that_is_written_to(qapp, tmp_path, monkeypatch):
    monkeypatch.setattr(hidden.tempfile, "tempdir", str(tmp_path / "temporary"))
    project = tmp_path / "projects" / "pot.sgb"
    lefts = [half(tmp_path / name) for name in ("temporary", "projects", "exports")]
    lefts += [
        half(place())
        for place in (
            user_folders.recovery,
            user_folders.thumbnails,
            user_folders.backups,
            user_folders.printers,
        )
    ]
    project.touch()
    RecentFiles().add(project)
    written_folders.note(tmp_path / "exports" / "pot.stl")
    program.clean_up()
    assert [left for left in lefts if left.exists()] == []


def test_settings_half_written_hold_no_start_up(qapp):
    QSettings().setValue("theme", "dark")
    QSettings().sync()
    place = Path(QSettings().fileName())
    kept = place.with_name(f"{place.name}.backup")
    kept.touch()
    os.utime(kept, (1e9, 1e9))
    lefts = [place.with_name(f"{place.name}.{end}") for end in ("lock", "aBcDeF")]
    for left in lefts:
        left.touch()
    stored.check_store()
    assert [left for left in lefts if left.exists()] == []
    assert stored.stored_theme() == "dark"
    kept.unlink()
