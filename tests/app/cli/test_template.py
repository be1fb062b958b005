"""The ``template`` command: what it writes, prints and refuses."""

from __future__ import annotations

import pytest

from app.cli.parser import main
from sgb_core.document.file import project_file
from tests.sgb_core.drawings.pdf_reading import read_pdf
from tests.sgb_core.drawings.shapes import CUP, preset


@pytest.fixture
def cup(tmp_path):
    path = tmp_path / "cup.sgb"
    project_file.save(CUP, path)
    return path


def test_a_template_is_written_and_told(cup, tmp_path, capsys) -> None:
    out = tmp_path / "cup.pdf"
    assert main(["template", str(cup), str(out), "--wall", "inside", "--as", "fired"]) == 0
    said = capsys.readouterr().out
    assert "inside of the wall, fired size, 1:1 on A4 portrait, 1 page\n" in said
    assert read_pdf(out.read_bytes()).about["Title"] == CUP.name


def test_what_is_larger_than_the_paper_takes_pages(tmp_path, capsys) -> None:
    vase = tmp_path / "vase.sgb"
    project_file.save(preset("vase"), vase)
    assert main(["template", str(vase), str(tmp_path / "v.pdf"), "--paper", "Letter"]) == 0
    assert "2 pages" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "status"),
    [(["OUT.svg"], 1), (["OUT.pdf", "--paper", "A1"], 2), (["OUT.pdf", "--wall", "both"], 2)],
)
def test_what_cannot_be_is_said_in_a_line(words, status, cup, tmp_path, capsys) -> None:
    out, *more = words
    assert main(["template", str(cup), str(tmp_path / out), *more]) == status
    assert capsys.readouterr().err.count("\n") == 1
    assert not (tmp_path / out).exists()


def test_the_project_is_not_written_over(cup) -> None:
    assert main(["template", str(cup), str(cup)]) == 1
    assert project_file.load(cup) == CUP
