"""Runs one of the program's own commands in a process of its own: VTK would hold up the window."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from app.state.jobs import Report
from sgb_core.document.file import project_file
from sgb_core.document.file.hidden import new_folder
from sgb_core.document.model import Document
from sgb_core.findings.errors import FindingError


def run_aside(
    command: str, document: Document, path: Path, report: Report, arguments: Sequence[str] = ()
) -> None:
    """Run ``command FILE path --progress arguments`` on a document; for a job's thread.

    The percentages that it prints are passed on; what ``report`` raises ends it. Raises
    ValueError with what the command says in the window's words where it fails.
    """
    with new_folder() as folder:
        source = folder / "document.sgb"
        project_file.save(document, source)
        failure = f"{command} ended early"
        words = [command, str(source), str(path.resolve()), "--progress", *arguments]
        with subprocess.Popen(
            [sys.executable, "-m", "app.cli.aside", *words],
            # Where the program lies, installed or not.
            cwd=Path(__file__).resolve().parents[2],
            stdout=subprocess.PIPE,
            text=True,
        ) as child:
            assert child.stdout is not None
            try:
                for line in child.stdout:
                    told = _told(line)
                    if isinstance(told, str):
                        failure = told
                    elif isinstance(told, int):
                        report(told / 100.0)
            except BaseException:
                child.terminate()
                raise
        if child.returncode != 0:
            raise FindingError(failure)


def _told(line: str) -> object:
    """Return what a line of the command's output holds, None for what a library has printed."""
    try:
        return json.loads(line)
    except ValueError:
        return None
