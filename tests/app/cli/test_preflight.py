import ctypes
import sys

import pytest

from app.cli import preflight
from sgb_core.findings.words import say


@pytest.fixture
def machine(monkeypatch):
    """A Linux machine whose missing libraries can be chosen; with a screen and a driver."""
    missing: set[str] = set()

    def load(name: str) -> object:
        if name in missing or name.startswith("libEGL_"):
            raise OSError(f"{name}: cannot open shared object file")
        return object()

    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(ctypes, "CDLL", load)
    for name in ("WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "LIBGL_DRIVERS_PATH"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("DISPLAY", ":0")
    return missing


def test_nothing_is_missing(machine):
    assert preflight.window_finding() is None


def test_missing_libraries_are_named_by_their_packages(machine):
    machine.update({"libEGL.so.1", "libxcb-cursor.so.0", "libdbus-1.so.3"})
    words = say(preflight.window_finding())
    assert words.endswith("sudo apt install libegl1 libdbus-1-3 libxcb-cursor0")
    assert "\n" not in words


@pytest.mark.parametrize("library", preflight.WINDOW_LIBRARIES)
def test_each_library_counts(machine, library):
    machine.add(library)
    package = preflight.WINDOW_LIBRARIES[library]
    assert say(preflight.window_finding()).endswith(f"sudo apt install {package}")


def test_no_screen(machine, monkeypatch):
    monkeypatch.delenv("DISPLAY")
    assert "DISPLAY" in say(preflight.window_finding())
    monkeypatch.setenv("WAYLAND_DISPLAY", "wayland-0")
    assert preflight.window_finding() is None


def test_a_platform_without_a_screen_needs_none(machine, monkeypatch):
    monkeypatch.delenv("DISPLAY")
    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen:enable_fonts")
    assert preflight.window_finding() is None


@pytest.mark.parametrize("platform", ["darwin", "win32"])
def test_other_systems_bring_everything(machine, monkeypatch, platform):
    machine.update(preflight.WINDOW_LIBRARIES)
    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.delenv("DISPLAY")
    assert preflight.window_finding() is None
    assert preflight.drawing_finding() is None


def test_drawing_without_a_screen_needs_egl_and_a_driver(machine, monkeypatch):
    monkeypatch.delenv("DISPLAY")
    monkeypatch.setattr(preflight, "has_driver", lambda: False)
    machine.add("libEGL.so.1")
    words = say(preflight.drawing_finding())
    assert words.endswith("sudo apt install libegl1 libgl1-mesa-dri")
    machine.clear()
    assert say(preflight.drawing_finding()).endswith("sudo apt install libgl1-mesa-dri")
    monkeypatch.setattr(preflight, "has_driver", lambda: True)
    assert preflight.drawing_finding() is None


def test_drawing_through_an_x_server_needs_no_egl(machine, monkeypatch):
    machine.add("libEGL.so.1")
    monkeypatch.setattr(preflight, "has_driver", lambda: True)
    assert preflight.drawing_finding() is None


def test_drivers_are_looked_for_on_the_disk(machine, monkeypatch):
    assert not preflight.has_driver(lambda pattern: False)
    assert preflight.has_driver(lambda pattern: pattern.endswith("dri/*_dri.so"))
    assert preflight.has_driver(lambda pattern: "gallium" in pattern)
    monkeypatch.setenv("LIBGL_DRIVERS_PATH", "/opt/mesa")
    assert preflight.has_driver(lambda pattern: pattern == "/opt/mesa/*_dri.so")


def test_a_driver_of_another_kind(machine, monkeypatch):
    monkeypatch.setattr(ctypes, "CDLL", lambda name: object())
    assert preflight.has_driver(lambda pattern: False)
