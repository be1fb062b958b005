"""Runs one of the program's own commands in a process of its own: VTK would hold up the window."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from app.state.jobs import Report
from sgb_core.document.file import format
from sgb_core.document.model import Document


def run_aside(
    command: str, document: Document, path: Path, report: Report, arguments: Sequence[str] = ()
) -> None:
    """Run ``command FILE path --progress arguments`` on a document; for a job's thread.

    The percentages that it prints are passed on; what ``report`` raises ends it. Raises
    ValueError with the command's own line where it fails.
    """
    with tempfile.TemporaryDirectory(prefix="sgb-aside-") as folder:
        source = Path(folder) / "document.sgb"
        format.save(document, source)
        words = [command, str(source), str(path.resolve()), "--progress", *arguments]
        with subprocess.Popen(
            [sys.executable, "-m", "app", *words],
            # Where the program lies, installed or not.
            cwd=Path(__file__).resolve().parents[2],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        ) as child:
            assert child.stdout is not None
            assert child.stderr is not None
            try:
                for line in child.stdout:
                    if line.strip().isdecimal():
                        report(int(line) / 100.0)
                said = child.stderr.read().strip()
            except BaseException:
                child.terminate()
                raise
        if child.returncode != 0:
            last = said.rpartition("\n")[2].removeprefix("sgb-studio: ")
            raise ValueError(last or f"{command} ended early")
