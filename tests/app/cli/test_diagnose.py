"""What a report of a fault needs, with and without a display."""

import pytest

from app.cli import parser


def report(capsys):
    assert parser.main(["--diagnose"]) == 0
    lines = capsys.readouterr().out.splitlines()
    return dict(line.split(": ", 1) for line in lines)


def test_versions_and_folders_are_told_without_a_display(capsys, monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        monkeypatch.delenv(name, raising=False)
    told = report(capsys)
    assert {"Python", "System", "numpy", "vtk", "Settings", "Log", "Unsaved work"} <= set(told)
    assert told["Display"].startswith("none; there is no screen")
    assert "OpenGL" not in told


def test_screens_and_opengl_are_told_where_there_are_any(capsys, qapp):
    told = report(capsys)
    assert told["Display"] == qapp.platformName()
    assert any(name.startswith("Screen") for name in told)
    assert told["OpenGL"]


@pytest.mark.parametrize("kind", ["file", "folder"])
def test_what_is_in_a_folders_place_is_told(tmp_path, kind):
    from app.cli.diagnose import _state

    place = tmp_path / "place"
    assert _state(place) == "not made yet"
    place.touch() if kind == "file" else place.mkdir()
    assert _state(place).startswith("no folder" if kind == "file" else "writable")
