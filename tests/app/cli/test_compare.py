"""The ``compare`` command: what it writes, prints and refuses."""

from __future__ import annotations

import json

import pytest

from app.cli.parser import main
from app.cli.version import version
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
        "sg-bezier-fairest",
        "sg-bezier-freed",
        "best-cubic",
        "best-quartic",
    ]
    assert len(found["curves"][3]["weights"]) == 2
    assert read_pdf(out.read_bytes()).about["Title"] == "Bent"
    assert main(["compare", str(bent), str(tmp_path / "curves.svg")]) == 0
    assert len(capsys.readouterr().out.splitlines()) == 8


@pytest.mark.parametrize("suffix", [".svg", ".pdf", ".dxf", ".png"])
def test_a_plate_is_made_again_from_the_file_beside_it(qapp, bent, tmp_path, suffix) -> None:
    out, again = tmp_path / f"curves{suffix}", tmp_path / f"again{suffix}"
    fine = ["--dpi", "96"] if suffix == ".png" else []
    assert main(["compare", str(bent), str(out), *fine]) == 0
    record = json.loads((tmp_path / f"curves{suffix}.json").read_text(encoding="utf-8"))
    made_by = record["made_by"]
    assert (made_by["program"], made_by["version"]) == ("SGB Studio", version())
    assert made_by["look"]["width_mm"] == 175.0
    assert made_by["command"] == ["compare", *fine]
    bent.unlink()
    verb, *more = made_by["command"]
    assert main([verb, f"{out}.json", str(again), *more]) == 0
    assert again.read_bytes() == out.read_bytes()


def test_another_suffix_is_refused(bent, tmp_path, capsys) -> None:
    assert main(["compare", str(bent), str(tmp_path / "curves.gif")]) == 1
    assert "allowed are .svg .pdf .dxf .png" in capsys.readouterr().err
    other = tmp_path / "other.json"
    other.write_text("{}")
    assert main(["compare", str(other), str(tmp_path / "curves.pdf")]) == 1
    assert "it is not the file of a plate" in capsys.readouterr().err
    assert not (tmp_path / "curves.pdf").exists()
