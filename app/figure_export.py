"""Writes a project's plate in a process of its own: VTK would hold up the window's thread."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import app
from sgb_core.document import file_format
from sgb_core.document.model import Document

# How often the process is looked after, in seconds.
PATIENCE = 0.15


def write_plate_aside(document: Document, path: Path, report: Callable[[float], None]) -> None:
    """Write the plate that ``document`` holds to ``path``; for a job's thread.

    ``report`` may raise to stop it. Raises ValueError with the process' own line where it fails.
    """
    with tempfile.TemporaryDirectory() as folder:
        project = Path(folder) / "plate.sgb"
        file_format.save(document, project)
        command = [sys.executable, "-m", "app", "plate", str(project), str(path)]
        process = subprocess.Popen(
            command,
            env=_environment(),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        try:
            while True:
                try:
                    _, said = process.communicate(timeout=PATIENCE)
                    break
                except subprocess.TimeoutExpired:
                    report(0.5)
        finally:
            if process.poll() is None:
                process.kill()
                process.communicate()
    if process.returncode != 0:
        lines = said.strip().splitlines() or ["the process ended early"]
        raise ValueError(lines[-1].removeprefix("sgb-studio: "))


def plate_bytes_aside(document: Document, suffix: str, report: Callable[[float], None]) -> bytes:
    """Return the plate as the bytes of a file; as :func:`write_plate_aside` otherwise."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"plate{suffix}"
        write_plate_aside(document, path, report)
        return path.read_bytes()


def _environment() -> dict[str, str]:
    """Return an environment in which the process finds this very program."""
    home = str(Path(app.__file__).parent.parent)
    known = os.environ.get("PYTHONPATH")
    return {**os.environ, "PYTHONPATH": f"{home}{os.pathsep}{known}" if known else home}
