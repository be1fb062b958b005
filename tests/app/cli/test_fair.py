"""The ``fair`` command: what it writes and prints, and how it refuses."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from app.cli import parser
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.document import edits
from sgb_core.document.dimensions import dimension_value
from sgb_core.document.file import project_file


def run(capsys: pytest.CaptureFixture[str], *argv: str) -> tuple[int, str, str]:
    status = parser.main(argv)
    captured = capsys.readouterr()
    return status, captured.out, captured.err


def test_the_tower_becomes_fair(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source, out = str(tmp_path / "tower.sgb"), str(tmp_path / "fair.sgb")
    assert run(capsys, "new", "tower", source)[0] == 0
    status, text, _ = run(capsys, "fair", source, out, "--json")
    assert status == 0
    found = json.loads(text)
    assert found["energy"] == "bending"
    assert found["before"] == pytest.approx(7.546, rel=1e-3)
    assert found["after"] == pytest.approx(2.198, rel=1e-3)
    assert found["kept"] == ["joint 0 G1", "joint 1 G1"]
    assert found["status"] == "fairer"
    before, after = project_file.load(source).profile, project_file.load(out).profile
    assert np.array_equal(before.control_points, after.control_points)
    for segment, name, old, new in found["moved"]:
        assert getattr(before.segments[segment].shape, name) == old
        assert getattr(after.segments[segment].shape, name) == new
    status, text, _ = run(capsys, "fair", source, out, "--segments", "1", "--energy", "variation")
    assert status == 0
    assert "segment 1: lambda2" in text
    assert "segment 0" not in text


def test_what_cannot_be_is_one_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source, out = tmp_path / "wave.sgb", tmp_path / "fair.sgb"
    points = [
        [[1, 0], [2, 0], [3, 0.5], [4, 2]],
        [[4, 2], [5, 3.5], [6, 3.5], [7, 2]],
        [[7, 2], [8, 0.5], [9, 0], [10, 0]],
    ]
    segments = [{"points": each} for each in points]
    profile = {"segments": segments, "joints": ["G2", "G2"]}
    tree = {"format": "sgb-document", "version": 1, "profile": profile}
    source.write_text(json.dumps(tree), encoding="utf-8")
    status, text, error = run(capsys, "fair", str(source), str(out))
    assert (status, text) == (1, "")
    assert error.count("\n") == 1
    assert "joint" in error
    assert "G2" in error
    assert not out.exists()
    assert run(capsys, "fair", str(source), str(out), "--segments", "7")[0] == 1
    assert run(capsys, "fair", str(source), str(out), "--keep", "colour")[0] == 2


def test_what_a_vessel_holds_is_kept(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source, out = tmp_path / "vase.sgb", tmp_path / "fair.sgb"
    assert run(capsys, "new", "vase", str(source))[0] == 0
    vase = edits.set_solid(project_file.load(source), kind="vessel", wall=3.0)
    project_file.save(vase, source)
    assert run(capsys, "fair", str(source), str(out), "--keep", "capacity")[0] == 0
    fair = project_file.load(out)
    capacity = Dimension(DimensionKind.CAPACITY)
    wanted, found = (dimension_value(each, capacity) for each in (vase, fair))
    assert found == pytest.approx(wanted, rel=1e-8)
    assert fair.profile != vase.profile
    assert fair.dimensions == ()
    bare = tmp_path / "bare.sgb"
    assert run(capsys, "new", "tower", str(bare))[0] == 0
    status, _, error = run(capsys, "fair", str(bare), str(out), "--keep", "capacity")
    assert (status, error.count("\n")) == (1, 1)
