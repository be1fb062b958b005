"""What every test needs: no trace left on the machine, no box that waits for a click."""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

# Set before anything imports Qt or matplotlib, so that child processes inherit it too.
_HOME = tempfile.TemporaryDirectory(prefix="sgb-studio-tests-")
for _name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME"):
    os.environ[_name] = str(Path(_HOME.name) / _name.lower())
os.environ["MPLBACKEND"] = "Agg"

# Examples take as long as the machine is busy; only wrong answers fail.
settings.register_profile(
    "studio", deadline=None, suppress_health_check=[HealthCheck.too_slow], print_blob=True
)
settings.register_profile("ci", parent=settings.get_profile("studio"), derandomize=True)
settings.load_profile("ci" if os.environ.get("CI") else "studio")


@pytest.fixture(autouse=True)
def _no_stray_boxes(request: pytest.FixtureRequest) -> Iterator[None]:
    """Turn a modal box that no test asked for into a failure instead of an endless wait."""
    if "PySide6.QtWidgets" not in sys.modules:
        yield
        return
    from PySide6.QtWidgets import QDialog, QFileDialog, QMessageBox

    def refuse(*args: object, **_: object) -> None:
        words = [a for a in args if isinstance(a, str)]
        raise AssertionError(f"a modal box opened that the test did not expect: {words}")

    patch = pytest.MonkeyPatch()
    patch.setattr(QDialog, "exec", refuse)
    for name in ("exec", "information", "question", "warning", "critical"):
        patch.setattr(QMessageBox, name, refuse)
    for name in ("getOpenFileName", "getSaveFileName", "getExistingDirectory"):
        patch.setattr(QFileDialog, name, refuse)
    yield
    patch.undo()


@pytest.fixture(autouse=True)
def _nothing_remembered() -> None:
    """Let no test find the layout, hints or preferences that another one left behind."""
    if "PySide6.QtCore" in sys.modules:
        sys.modules["PySide6.QtCore"].QSettings().clear()
    if "app.state.preferences" in sys.modules:
        sys.modules["app.state.preferences"].reload()


@pytest.fixture(autouse=True)
def _no_scroll_remembered(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let no panel that one test scrolled keep the wheel from the controls of the next."""
    if "app.widgets.step_burst" in sys.modules:
        guard = sys.modules["app.widgets.step_burst"].ScrollGuard
        monkeypatch.setattr(guard, "_last", guard._last)
