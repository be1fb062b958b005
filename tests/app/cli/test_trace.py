"""The ``trace`` command: what it writes, prints and refuses."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from app.__main__ import main
from sgb_core.document.file import project_file
from sgb_core.document.model import Unit

HEIGHTS = np.linspace(0.0, 100.0, 101)
RADII = 30.0 + 15.0 * np.sin(HEIGHTS / 30.0)
TABLE = "r;h\n" + "\n".join(
    f"{r:.9f};{h:.9f}".replace(".", ",") for r, h in zip(RADII, HEIGHTS, strict=True)
)
DRAWING = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="10cm" viewBox="0 0 100 100">'
    '<path d="M10 90 C40 80 50 40 20 20"/></svg>'
)
# What contract.md fixes.
KEYS = {
    "segments",
    "points",
    "tolerance",
    "largest_deviation",
    "rms_deviation",
    "exact",
    "axis",
    "left_right",
    "joints",
    "warnings",
}


@pytest.fixture
def table(tmp_path: Path) -> Path:
    path = tmp_path / "jar.csv"
    path.write_text(TABLE)
    return path


def test_points_become_a_project_that_says_where_it_came_from(
    table: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "jar.sgb"
    assert main(["trace", str(table), str(out), "--tolerance", "0.2", "--unit", "cm"]) == 0
    lines = capsys.readouterr().out.splitlines()
    document = project_file.load(out)
    assert document.unit is Unit.CM
    assert document.name == "jar"
    count = len(document.profile)
    assert f"{count} {'segment' if count == 1 else 'segments'} from 101 points" in lines[0]
    assert len(document.reference.points) == 101
    np.testing.assert_allclose(document.profile.segments[0].points[0], [30.0, 0.0])
    np.testing.assert_allclose(document.profile.segments[-1].points[3], [RADII[-1], 100.0])


def test_json_has_the_contract_s_keys_in_full_precision(
    table: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["trace", str(table), str(tmp_path / "jar.sgb"), "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert set(said) >= KEYS
    assert said["points"] == 101
    assert said["exact"] is False
    assert said["left_right"] is None
    assert said["axis"] == 0.0
    assert 0.0 < said["rms_deviation"] < said["largest_deviation"] <= said["tolerance"]
    assert len(said["joints"]) == said["segments"] - 1


def test_a_drawing_is_exact_in_the_unit_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = tmp_path / "jar.svg", tmp_path / "jar.sgb"
    source.write_text(DRAWING)
    assert main(["trace", str(source), str(out), "--unit", "in", "--axis", "5", "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert said["exact"] is True
    assert said["axis"] == 5.0
    assert said["largest_deviation"] < 1e-9
    (segment,) = project_file.load(out).profile.segments
    np.testing.assert_allclose(segment.points[0], np.array([5.0, -90.0]) / 25.4)


def test_many_sources_go_into_a_folder_and_a_bad_one_keeps_none_back(
    table: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    drawing, prose, folder = tmp_path / "jar.svg", tmp_path / "note.txt", tmp_path / "out"
    drawing.write_text(DRAWING)
    prose.write_text("Dear Sir")
    sources = [str(drawing), str(prose), str(table)]
    assert main(["trace", *sources, str(folder)]) == 1
    assert "note.txt\n  error: the text has no two columns" in capsys.readouterr().out
    assert sorted(path.name for path in folder.iterdir()) == ["jar.csv.sgb", "jar.svg.sgb"]
    assert main(["trace", *sources, str(folder), "--json"]) == 1
    said = json.loads(capsys.readouterr().out)
    assert [("error" in each) for each in said] == [False, True, False]
    assert set(said[0]) >= KEYS


@pytest.mark.parametrize(
    ("words", "status", "line"),
    [
        (["jar.csv", "out.sgb", "--axis", "left"], 2, "'left' is not allowed"),
        (["jar.csv", "out.sgb", "--tolerance", "-1"], 2, "'-1' is not allowed"),
        (["jar.csv", "out.sgb", "--height", "3", "--scale", "4"], 2, "not allowed with"),
        (["jar.csv", "out.sgb", "--scale-bar", "1,2,3"], 2, "'1,2,3' is not allowed"),
        (["jar.csv", "out.sgb", "--clicks", "1,2"], 2, "'1,2' is not allowed"),
        (["jar.csv", "out.sgb", "--axis", "z"], 1, "axis is 'z'"),
        (["jar.csv", "out.sgb", "--tolerance", "1e6"], 1, "within the tolerance"),
        (["jar.doc", "out.sgb"], 1, "suffix is '.doc'"),
        (["no.csv", "out.sgb"], 1, "No such file"),
        (["jar.csv"], 2, "OUT.sgb"),
    ],
)
def test_what_cannot_be_is_told_in_a_line_and_nothing_is_written(
    table: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    words: list[str],
    status: int,
    line: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["trace", *words]) == status
    told = capsys.readouterr().err
    assert line in told
    assert "Traceback" not in told
    assert list(tmp_path.iterdir()) == [table]
