"""All commands on files of kinds that programs fail on: done, or one line, and nothing else."""

from __future__ import annotations

import json
import warnings

import pytest

from app.cli.edit_verbs import VERBS
from app.cli.parser import COMMANDS, main
from sgb_core import exchange
from tests.app.cli.hard_files import HARD

# What follows the file; OUT is the folder to write to.
EDITS = [
    "split 0 0.4",
    "reverse 0",
    "set 0 lambda1 2.5",
    "set 0 omega 1",
    "rule 0 G1",
    "rule 0 G2",
    "close",
    "open",
    "scale 3",
    "fill 5",
    "set-twist 0.25 --ease smooth",
    "dimension height 30",
    "lock height",
    "unlock height",
    "set-cut-outs circle,rows=2",
    "add-layer text,text=A,relief=0.5,edge=1",
    "remove-layer 0",
    "set-relief layer-0 depth=0.5,edge=1",
]
DRAWN = [suffix for suffix, found in exchange.FORMATS.items() if not found.meshed]
EVERYWHERE = [
    "check",
    "measure --json",
    "sample --per-segment 2",
    "sample --per-segment 2 --out OUT/a.csv",
    "sample --curvature --out OUT/k.pdf",
    "sample --curvature --per-segment 3",
    *(f"edit OUT/edited.sgb {edit}" for edit in EDITS),
    "solve OUT/solved.sgb height=30 --by all",
    "toolpath OUT/a.gcode --chord 1",
    "drawing OUT/a.pdf",
    "drawing OUT/b.svg --style vessel",
    "compare OUT/e.svg --json",
    "template OUT/c.pdf",
    "template OUT/d.pdf --wall inside",
    *(f"export OUT/a{suffix} --samples 3 8" for suffix in (".stl", ".glb")),
    *(f"export OUT/a{suffix}" for suffix in DRAWN),
]
# What takes long, or works on what the others have made; a few files stand for all.
ON_A_FEW = [
    "measure",
    "edit OUT/edited.sgb merge 0",
    "fit OUT/fitted.sgb --target circle --freedom omega",
    "fair OUT/faired.sgb",
    "solve OUT/solved.sgb volume=500",
    "variants --out OUT/variants --count 3",
    "plate OUT/a.pdf",
    *(f"export OUT/a{suffix} --samples 3 8" for suffix in (".ply", ".obj", ".3mf")),
    "render OUT/a.png --size 48x32",
    "animate OUT/a.gif --frames 2 --size 32x32",
    "animate OUT/b.gif --vary all omega 0 1 --frames 2 --size 32x32",
]
A_FEW = ["wall that leaves no cavity", "on the axis"]


def test_every_command_and_verb_is_tried() -> None:
    tried = {line.split()[0] for line in [*EVERYWHERE, *ON_A_FEW]}
    # What takes no project file.
    assert tried == set(COMMANDS) - {"presets", "new", "figures", "trace", "printers"}
    assert {edit.split()[0] for edit in EDITS} | {"merge"} == set(VERBS)


def _said(argv: list[str], capfd: pytest.CaptureFixture[str]) -> tuple[int, str, str]:
    """Run a command in which every warning of a library counts as one printed."""
    with warnings.catch_warnings():
        warnings.simplefilter("always")
        status = main(argv)
    return status, *capfd.readouterr()


@pytest.mark.parametrize("name", HARD)
def test_each_command_is_done_or_says_one_line(name, tmp_path, capfd) -> None:
    path = tmp_path / "hard.sgb"
    path.write_text(json.dumps(HARD[name]), encoding="utf-8")
    for line in [*EVERYWHERE, *(ON_A_FEW if name in A_FEW else [])]:
        command, *rest = line.split()
        out = tmp_path / command
        out.mkdir(exist_ok=True)
        argv = [command, str(path), *(word.replace("OUT", str(out)) for word in rest)]
        status, said, err = _said(argv, capfd)
        what = f"{line}: {status} {err}"
        assert status in (0, 1), what
        assert err == "" or (err.startswith("sgb-studio: ") and err.endswith("\n")), what
        assert err.count("\n") == (1 if err else 0), what
        assert not any(word in err for word in ("Warning", "array", "NoneType", "Error")), what
        assert "NaN" not in said, what
        assert "Infinity" not in said, what
        if status == 1:
            assert err, what
            assert said == "", what
            # Nothing is half-written.
            assert not any(out.glob(".*")), what
        elif command != "edit":
            # An edit names there what of the rules it could not keep.
            assert err == "", what
