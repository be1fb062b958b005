"""What a report of a fault needs: versions, OpenGL, screens, folders."""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from app.cli import preflight
from sgb_core.findings.words import say

PACKAGES = ("sgb-studio", "PySide6-Essentials", "vtk", "pyvista", "numpy", "scipy", "shapely")


def lines() -> Iterator[str]:
    """Yield the report, a line each: a name, a colon, what there is."""
    yield f"Python: {platform.python_version()} ({sys.executable})"
    yield f"System: {platform.platform()}"
    for name in PACKAGES:
        yield f"{name}: {_version(name)}"
    missing = preflight.window_finding()
    if missing is None:
        yield from _screens()
    else:
        yield f"Display: none; {say(missing)}"
    yield from _folders()


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "not installed"


def _screens() -> Iterator[str]:
    from PySide6.QtGui import QGuiApplication

    from app.state.graphics import opengl_names

    app = QGuiApplication.instance() or QGuiApplication([])
    assert isinstance(app, QGuiApplication)
    yield f"Display: {app.platformName()}"
    for screen in app.screens():
        size = screen.size()
        yield (
            f"Screen {screen.name()}: {size.width()} x {size.height()}, "
            f"{screen.devicePixelRatio():g} pixels to a point"
        )
    names = opengl_names()
    yield f"OpenGL: {'none' if names is None else ', '.join(names)}"


def _folders() -> Iterator[str]:
    from PySide6.QtCore import QCoreApplication, QSettings

    from app.state import user_folders

    QCoreApplication.setApplicationName(user_folders.PROGRAM)
    QCoreApplication.setOrganizationName(user_folders.PROGRAM)
    yield f"Settings: {QSettings().fileName()}"
    for name, folder in (
        ("Unsaved work", user_folders.recovery()),
        ("Backups", user_folders.backups()),
        ("Pictures of files", user_folders.thumbnails()),
        ("Locks", user_folders.locks()),
        ("Log", user_folders.log()),
    ):
        yield f"{name}: {folder} ({_state(folder)})"


def _state(folder: Path) -> str:
    if not os.path.lexists(folder):
        return "not made yet"
    if not folder.is_dir() or folder.is_symlink():
        return "no folder: something else is in its place"
    return "writable" if os.access(folder, os.W_OK) else "not writable"
