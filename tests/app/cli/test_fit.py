"""The ``fit`` command: what it prints, writes and refuses."""

from __future__ import annotations

from pathlib import Path

import pytest

from app.__main__ import main
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.design.fitting import deviation
from sgb_core.design.target_curves import SuperellipseArc
from sgb_core.document.file import project_file
from sgb_core.document.model import Document

PAPER = ((0.0, 0.0), (1.2, 0.0), (1.2, 2.0), (0.0, 2.0))
CIRCLE = SuperellipseArc(1.0, 1.0, 1.0)


def published() -> Document:
    return Document(Profile.of([Segment(PAPER, ShapeParameters(0, 3, 0, 0.671))]))


def test_the_command_fits_and_tells(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source, out = tmp_path / "in.sgb", tmp_path / "out.sgb"
    project_file.save(published(), source)
    words = ["fit", str(source), str(out), "--target", "circle", "--freedom", "polygon"]
    assert main(words) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "0.03342 mm in segment 0" in lines[1]
    assert deviation(project_file.load(out).profile, CIRCLE).largest < 2e-4
    assert main(["fit", str(source), str(out), "--target", "ellipse", "--exponent", "3"]) == 1
    assert main(["fit", str(source), str(out), "--target", "square"]) == 2
    assert main(["fit", str(source), str(out), "--target", "circle", "--a", "-1"]) == 2
