"""Makes a film aside: VTK draws in a process of its own, with progress, to be cancelled."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from PySide6.QtWidgets import QDialog

from app.exporting import Exporting
from app.film import check_target
from app.film_dialog import FilmDialog
from app.jobs import Report
from app.presenter import Presenter
from sgb_core.document import file_format
from sgb_core.document.model import Document


def make_film(exporting: Exporting, presenter: Presenter, parent: object) -> None:
    """Ask for a film and where to write it, then make it aside."""
    document = presenter.document
    dialog = FilmDialog(document, presenter.view.segment, parent)  # type: ignore[arg-type]
    if dialog.exec() != QDialog.DialogCode.Accepted:
        return
    path = exporting.ask_path("Film", dialog.suffix)
    if path is None:
        return
    try:
        check_target(path)
    except ValueError as error:
        presenter.notify(str(error), "warning")
        return
    arguments = dialog.arguments
    exporting.write(path, lambda report: draw_film(document, path, arguments, report))


def draw_film(document: Document, path: Path, arguments: Sequence[str], report: Report) -> None:
    """Run the command ``animate`` and pass its progress on; what ``report`` raises ends it.

    Raises ValueError with what the command says where it fails.
    """
    with tempfile.TemporaryDirectory(prefix="sgb-film-") as folder:
        source = Path(folder) / "film.sgb"
        file_format.save(document, source)
        command = [sys.executable, "-m", "app", "animate", str(source), str(path.resolve())]
        with subprocess.Popen(
            [*command, "--progress", *arguments],
            # Where the program lies, installed or not.
            cwd=Path(__file__).resolve().parent.parent,
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
            raise ValueError(said.rpartition("\n")[2] or "the film was not finished")
