"""``measure`` under laws: joints are those of the curve as it is over the whole turn."""

from __future__ import annotations

import json

from app.__main__ import main
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.file import project_file
from sgb_core.document.model import Document
from sgb_core.surfaces.variation import Law

UPPER = Segment([(5, 13), (6, 12), (3, 10), (2, 8)], ShapeParameters(4, 3, 4, 1))
LOWER = Segment([(2, 8), (1, 6), (2, 3), (5, -1)], ShapeParameters(4, 3, 4, 1))
HALF = Law("omega", "raised-cosine", 0.0, 0.5)


def joint(tmp_path, capsys, *laws: Law) -> dict:
    path = tmp_path / "joint.sgb"
    project_file.save(Document(Profile.of([UPPER, LOWER], ["G1"]), variation=laws), path)
    assert main(["measure", str(path), "--json"]) == 0
    (found,) = json.loads(capsys.readouterr().out)["joints"]
    return found


def test_a_law_that_tames_a_stored_kink(tmp_path, capsys) -> None:
    assert joint(tmp_path, capsys)["measured"] == "G0"
    assert "at_deg" not in joint(tmp_path, capsys)
    tamed = joint(tmp_path, capsys, HALF)
    assert (tamed["measured"], tamed["at_deg"]) == ("C1", 0.0)


def test_a_speed_ratio_that_only_shows_on_the_way_round(tmp_path, capsys) -> None:
    # At θ = 0 both ends are equally fast; at 180°, where ω is ½, c is 3/4 and a (3 − 3/2)/4.
    follows = Law("lambda3", "raised-cosine", 4.0, 1.0, (0,))
    found = joint(tmp_path, capsys, HALF, follows)
    assert found["measured"] == "G1"
    assert abs(found["speed_ratio"] - 0.5) < 1e-9
