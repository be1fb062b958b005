"""What cannot be exported is doubted beforehand, and nothing else is: the exporter is the judge."""

import pytest

import sgb_core as sgb
from sgb_core import exchange
from sgb_core.document.export_doubts import export_doubts
from sgb_core.findings.bodies import NoBodyFor
from sgb_core.findings.errors import FindingError
from sgb_core.findings.exports import SinglePrecision


def cup(kind="vessel"):
    plain = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (30, 60))]))
    return sgb.edits.set_solid(plain, kind=kind)


def refused(document, path):
    try:
        exchange.write(document, path)
    except FindingError as error:
        return type(error.finding)
    return None


@pytest.mark.parametrize("away", [0.0, 1e3, 1e5, 4e5, 8e6, 1e9])
@pytest.mark.parametrize("kind", ["surface", "vessel"])
def test_what_lies_too_far_away_for_stl(tmp_path, away, kind):
    document = sgb.edits.set_placement(cup(kind), translation=(0.0, away, 0.0))
    doubts = export_doubts(document)
    assert [type(each) for each in doubts] == ([SinglePrecision] if away > 4e6 else [])
    assert bool(doubts) is (refused(document, tmp_path / "cup.stl") is SinglePrecision)
    assert refused(document, tmp_path / "cup.obj") is None


@pytest.mark.parametrize("sweep", [360.0, 1.0, 1e-3, 1e-6, 1e-12])
def test_a_turn_too_narrow_for_a_body(tmp_path, sweep):
    document = sgb.edits.set_revolution(cup(), sweep_deg=sweep)
    doubts = export_doubts(document)
    assert list(doubts) == ([NoBodyFor.TOO_NARROW] if sweep < 1e-5 else [])
    assert bool(doubts) is (refused(document, tmp_path / "cup.glb") is NoBodyFor)
