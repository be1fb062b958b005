"""The ``variants`` command: what it writes, prints and refuses."""

from __future__ import annotations

import json

import pytest

from app.cli.parser import main
from sgb_core.document.dimensions import missed_locks
from sgb_core.document.file import project_file
from tests.sgb_core.design.locks.samples import locked, pot


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "pot.sgb"
    project_file.save(locked(pot(3), "capacity", "rim_diameter"), path)
    return path


def test_variants_are_project_files_that_keep_the_locks(file, tmp_path, capsys) -> None:
    out = tmp_path / "found"
    assert main(["variants", str(file), "--out", str(out), "--count", "4", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert [lock.split()[0] for lock in found["locks"]] == ["Capacity", "Rim"]
    names = [each["file"] for each in found["variants"]]
    assert sorted(path.name for path in out.iterdir()) == names
    assert len(names) == 4
    for name in names:
        assert missed_locks(project_file.load(out / name)) == ()


def test_parameters_are_gone_through(file, tmp_path, capsys) -> None:
    out = tmp_path / "found"
    argv = ["variants", str(file), "--out", str(out), "--count", "3", "--over", "1.lambda2"]
    assert main(argv) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("all keep Capacity ")
    assert len(lines) == 1 + len(list(out.iterdir()))


@pytest.mark.parametrize(
    ("more", "status", "said"),
    [
        (["--over", "9.omega"], 1, "9"),
        (["--over", "1.sigma"], 2, "SEGMENT.PARAMETER"),
        (["--over", "1.omega", "--free", "points"], 2, "not allowed with"),
        (["--count", "1"], 2, "1"),
    ],
)
def test_what_is_wrong_is_one_line(more, status, said, file, tmp_path, capsys) -> None:
    try:
        found = main(["variants", str(file), "--out", str(tmp_path / "x"), *more])
    except SystemExit as ended:
        found = ended.code
    assert found == status
    assert said in capsys.readouterr().err
    assert not (tmp_path / "x").exists()
