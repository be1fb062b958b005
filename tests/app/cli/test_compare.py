"""The ``compare`` command: what it writes, prints and refuses."""

from __future__ import annotations

import json

import pytest

from app.cli.parser import main
from sgb_core.document.file import project_file
from tests.sgb_core.drawings.pdf_reading import read_pdf
from tests.sgb_core.drawings.shapes import BENT


@pytest.fixture
def bent(tmp_path):
    path = tmp_path / "bent.sgb"
    project_file.save(BENT, path)
    return path


def test_a_plate_is_drawn_and_measured(bent, tmp_path, capsys) -> None:
    out = tmp_path / "curves.pdf"
    assert main(["compare", str(bent), str(out), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert [each["kind"] for each in found["curves"]] == [
        "sg-bezier",
        "cubic",
        "quartic",
        "rational-cubic",
    ]
    assert len(found["curves"][3]["weights"]) == 2
    assert read_pdf(out.read_bytes()).about["Title"] == "Bent"
    assert main(["compare", str(bent), str(tmp_path / "curves.svg")]) == 0
    assert len(capsys.readouterr().out.splitlines()) == 4


def test_another_suffix_is_refused(bent, tmp_path, capsys) -> None:
    assert main(["compare", str(bent), str(tmp_path / "curves.png")]) == 1
    assert "allowed are .svg .pdf .dxf" in capsys.readouterr().err
