"""Runs one of the program's own commands in a process of its own.

VTK would hold up the window, and the CAD kernel all threads.
"""

from __future__ import annotations

import json
import subprocess
import sys
import threading
from collections.abc import Sequence
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import IO

from app.state.jobs import Report
from sgb_core.document.file import project_file
from sgb_core.document.file.hidden import new_folder
from sgb_core.document.model import Document
from sgb_core.findings.errors import FindingError
from sgb_core.interruption import checkpoint

# Seconds between two questions whether the work is still wanted.
_PATIENCE = 0.1


def run_aside(
    command: str, document: Document, path: Path, report: Report, arguments: Sequence[str] = ()
) -> None:
    """Run ``command FILE path arguments`` on a document; for a job's thread.

    The percentages that it prints, if told to, are passed on; what ``report`` or a checkpoint
    raises ends it. Raises ValueError with what the command says in the window's words where it
    fails.
    """
    with new_folder() as folder:
        source = folder / "document.sgb"
        project_file.save(document, source)
        failure = f"{command} ended early"
        words = [command, str(source), str(path.resolve()), *arguments]
        with subprocess.Popen(
            [sys.executable, "-m", "app.cli.aside", *words],
            # Where the program lies, installed or not.
            cwd=Path(__file__).resolve().parents[2],
            stdout=subprocess.PIPE,
            text=True,
        ) as child:
            assert child.stdout is not None
            coming: SimpleQueue[str] = SimpleQueue()
            listener = threading.Thread(target=_listen, args=(child.stdout, coming))
            listener.start()
            try:
                while line := _next(coming):
                    told = _told(line)
                    if isinstance(told, str):
                        failure = told
                    elif isinstance(told, int):
                        report(told / 100.0)
            except BaseException:
                child.terminate()
                raise
            finally:
                listener.join()
        if child.returncode != 0:
            raise FindingError(failure)


def _listen(stream: IO[str], coming: SimpleQueue[str]) -> None:
    """Hand on the lines of a stream as they come, and an empty one at its end."""
    for line in stream:
        coming.put(line)
    coming.put("")


def _next(coming: SimpleQueue[str]) -> str:
    """Return the next line, with checkpoints while there is none."""
    while True:
        try:
            return coming.get(timeout=_PATIENCE)
        except Empty:
            checkpoint()


def _told(line: str) -> object:
    """Return what a line of the command's output holds, None for what a library has printed."""
    try:
        return json.loads(line)
    except ValueError:
        return None
