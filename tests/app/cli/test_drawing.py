"""The ``drawing`` command: what it writes, prints and refuses."""

from __future__ import annotations

import subprocess
import sys
from datetime import date

import numpy as np
import pytest
from PIL import Image

from app.cli.parser import main
from sgb_core.document.file import project_file
from tests.sgb_core.drawings.pdf_reading import read_pdf
from tests.sgb_core.drawings.shapes import BENT, CUP


@pytest.fixture
def cup(tmp_path):
    path = tmp_path / "cup.sgb"
    project_file.save(CUP, path)
    return path


@pytest.mark.parametrize("suffix", [".svg", ".pdf", ".dxf"])
def test_a_section_is_written(suffix: str, cup, tmp_path, capsys) -> None:
    out = tmp_path / f"cup{suffix}"
    assert main(["drawing", str(cup), str(out), "--date", "2026-03-31"]) == 0
    said = capsys.readouterr().out
    assert "2:1 on A4 portrait" in said
    assert "curves within 0.001 mm" in said
    assert out.stat().st_size > 1000


def test_today_is_the_date_where_none_is_given(cup, tmp_path) -> None:
    out = tmp_path / "cup.pdf"
    before = date.today().isoformat()
    assert main(["drawing", str(cup), str(out)]) == 0
    words = [text for text, *_ in read_pdf(out.read_bytes()).pages[0].words]
    assert {before, date.today().isoformat()} & set(words)


def test_paper_scale_and_side_are_chosen(cup, tmp_path, capsys) -> None:
    out = tmp_path / "cup.pdf"
    words = ["--paper", "A3", "--scale", "1:1", "--section", "left", "--fill", "filled"]
    assert main(["drawing", str(cup), str(out), *words]) == 0
    assert "1:1 on A3 landscape" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "status", "said"),
    [
        (["--scale", "50:1", "--paper", "A4"], 1, "at 50:1 the drawing needs"),
        (["--scale", "two"], 2, "allowed are scales such as 1:2"),
        (["--paper", "A9"], 2, "invalid choice"),
        (["--date", "today"], 1, "the date is 'today'"),
    ],
)
def test_what_cannot_be_is_said_in_a_line(words, status, said, cup, tmp_path, capsys) -> None:
    out = tmp_path / "cup.pdf"
    assert main(["drawing", str(cup), str(out), *words]) == status
    error = capsys.readouterr().err
    assert said in error
    assert error.count("\n") == 1
    assert not out.exists()


def test_another_suffix_is_refused(cup, tmp_path, capsys) -> None:
    assert main(["drawing", str(cup), str(tmp_path / "cup.gif")]) == 1
    assert "allowed are .svg .pdf .dxf .png" in capsys.readouterr().err


def test_the_project_is_not_written_over(cup) -> None:
    before = cup.read_bytes()
    assert main(["drawing", str(cup), str(cup)]) == 1
    assert cup.read_bytes() == before


def test_several_files_are_several_pages(cup, tmp_path) -> None:
    other = tmp_path / "bent.sgb"
    project_file.save(BENT, other)
    out = tmp_path / "both.pdf"
    assert main(["drawing", str(cup), str(other), str(out)]) == 0
    assert len(read_pdf(out.read_bytes()).pages) == 2
    assert main(["drawing", str(cup), str(other), str(tmp_path / "both.svg")]) == 1


def test_neither_qt_nor_vtk_nor_matplotlib_is_loaded(cup, tmp_path) -> None:
    code = (
        "import sys; from app.cli.parser import main; "
        f"main(['drawing', {str(cup)!r}, {str(tmp_path / 'a.pdf')!r}]); "
        "print(sorted({'PySide6', 'vtkmodules', 'vtk', 'matplotlib'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stdout.splitlines()[-1] == "[]", done.stderr


def test_several_files_are_vessels_of_one_plate(cup, tmp_path, capsys) -> None:
    other = tmp_path / "bent.sgb"
    project_file.save(BENT, other)
    out = tmp_path / "plate.pdf"
    words = ["--style", "vessel", "--first", "4"]
    assert main(["drawing", str(cup), str(other), str(out), *words]) == 0
    assert "Vessel plate, 1:1 on A4 portrait" in capsys.readouterr().out
    (page,) = read_pdf(out.read_bytes()).pages
    assert {"4", "5"} <= {text for text, *_ in page.words}


def test_a_drawing_is_a_picture_of_true_size(qapp, cup, tmp_path, capsys) -> None:
    """Pillow reads what Qt wrote: pixels to the inch, the name, and lines as wide as on paper."""
    out = tmp_path / "cup.png"
    assert main(["drawing", str(cup), str(out), "--paper", "A4", "--dpi", "254"]) == 0
    with Image.open(out) as picture:
        grey = np.asarray(picture.convert("L"))
        assert picture.info["Title"] == project_file.load(cup).name
        assert picture.info["dpi"] == pytest.approx((254.0, 254.0), abs=0.1)
    assert grey.shape == (2970, 2100)
    # Nothing but paper outside the margins, and something within them.
    assert grey[:90].min() == grey[:, :90].min() == 255
    assert (grey < 100).sum() > 10_000
    capsys.readouterr()
    assert main(["drawing", str(cup), str(out), "--paper", "A1", "--dpi", "1200"]) == 1
    assert "at most" in capsys.readouterr().err
    for wrong in ("40", "1300", "x"):
        assert main(["drawing", str(cup), str(out), "--dpi", wrong]) == 2
