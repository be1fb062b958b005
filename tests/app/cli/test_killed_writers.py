"""Killed at any point of a write, what was there is the old file or the new one, whole."""

from __future__ import annotations

import importlib.util
import json
import os
import platform
import subprocess
import sys
from pathlib import Path

import pytest

from tests.app.cli.killed_writers import JOURNAL, WORKS

ROOT = Path(__file__).resolve().parents[3]
NEEDS = {"film .mp4": "imageio_ffmpeg", ".step": "OCP"}
KINDS = [
    kind for kind in (*WORKS, JOURNAL) if kind not in NEEDS or importlib.util.find_spec(NEEDS[kind])
]
pytestmark = pytest.mark.skipif(platform.system() != "Linux", reason="needs Linux's ptrace")


@pytest.fixture(scope="module")
def counts(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[int]]:
    """Return for each kind how many states a kill can leave, and what was left in them."""
    folder = tmp_path_factory.mktemp("killed")
    # A process of one thread alone can be stopped as a whole.
    lone = dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"), "1")
    done = subprocess.run(
        [sys.executable, "-m", "tests.app.cli.killed_writers", str(folder), *KINDS],
        cwd=ROOT,
        env={**os.environ, **lone},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    found: dict[str, list[int]] = json.loads(done.stdout)
    return found


@pytest.mark.parametrize("kind", KINDS)
def test_whatever_a_kill_leaves_is_old_or_new_and_clean(
    kind: str, counts: dict[str, list[int]]
) -> None:
    states, half = counts[kind]
    # The old, something half written, and the new.
    assert states >= 3
    assert half >= 1
