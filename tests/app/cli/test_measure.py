"""``measure``, ``check`` and ``sample``, against integrals of the paper's own basis (13)."""

import json

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from app.__main__ import main
from app.cli import measures_table
from sgb_core.document.evaluation import evaluate
from sgb_core.document.file import project_file
from sgb_core.document.measures import measures
from tests.app.cli.files import SPINDLE, project, write_project

KEYS = {
    "name",
    "unit",
    "volume",
    "area",
    "centroid",
    "bounds",
    "generatrix_length",
    "bending_energy",
    "surface_bending_energy",
    "segments",
    "joints",
    "dimensions",
    "warnings",
}
JOINT_KEYS = {"rule", "measured", "kink_deg", "speed_ratio", "curvature_jump"}


def printed(capsys, *words: str) -> str:
    assert main(words) == 0
    out, err = capsys.readouterr()
    assert err == ""
    return out


def refuse(word: str) -> None:
    raise AssertionError(f"{word} is no JSON")


def measured(capsys, path: str) -> dict:
    return json.loads(printed(capsys, "measure", path, "--json"), parse_constant=refuse)


def curve(segment: dict):
    """Return s -> (r, h) and its derivative by the basis (13), written out here anew."""
    l1, l2, l3 = segment.get("lambda", [1, 3, 1])
    w = segment.get("omega", 0)
    one, s = np.polynomial.Polynomial([1]), np.polynomial.Polynomial([0, 1])
    t = one - s
    basis = [
        (1 + (l1 - 1) * w * s) * t**3,
        (3 + w * (1 - l1) + w * (l1 + l2 - 4) * s) * s * t**2,
        (3 + (3 - l2) * w - w * (l3 - l2 + 2) * s) * s**2 * t,
        (1 + (l3 - 1) * w * t) * s**3,
    ]
    r, h = (
        sum(b * float(p[k]) for b, p in zip(basis, segment["points"], strict=True)) for k in (0, 1)
    )
    return r, h


def integral(f) -> float:
    return quad(f, 0, 1, epsabs=0, epsrel=1e-12, limit=200)[0]


def test_the_numbers_are_those_of_independent_integrals(tmp_path, capsys):
    path = write_project(tmp_path / "a.sgb", name="Gefäß", unit="cm")
    found = measured(capsys, path)
    assert set(found) == KEYS
    assert (found["name"], found["unit"]) == ("Gefäß", "cm")
    volume = moment = area = length = 0.0
    for index, segment in enumerate(SPINDLE):
        r, h = curve(segment)
        dr, dh = r.deriv(), h.deriv()
        volume += np.pi * (r * r * dh).integ()(1)
        moment += np.pi * (r * r * h * dh).integ()(1)
        area += 2 * np.pi * integral(lambda s, r=r, dr=dr, dh=dh: r(s) * np.hypot(dr(s), dh(s)))
        own = integral(lambda s, dr=dr, dh=dh: np.hypot(dr(s), dh(s)))
        length += own
        assert found["segments"][index]["length"] == pytest.approx(own, rel=1e-10)
    assert found["volume"] == pytest.approx(volume, rel=1e-12)
    assert found["area"] == pytest.approx(area, rel=1e-9)
    assert found["generatrix_length"] == pytest.approx(length, rel=1e-10)
    assert found["centroid"] == pytest.approx([0, 0, moment / volume], abs=1e-9)
    assert found["bounds"][0][2] == 0
    assert found["bounds"][1][2] == 60
    fractions = [segment["leg_fractions"] for segment in found["segments"]]
    assert fractions[0] == pytest.approx([(3 + 0.7 * 0.5) / 4, (3 + 0.7) / 6, (3 - 0.7) / 4])


def test_joints_say_rule_and_truth(tmp_path, capsys):
    found = measured(capsys, write_project(tmp_path / "a.sgb", profile_joints=["G1"]))
    (joint,) = found["joints"]
    assert set(joint) == JOINT_KEYS
    assert joint["rule"] == "G1"
    assert joint["measured"] == "G1"
    assert joint["kink_deg"] == pytest.approx(0, abs=1e-6)
    # |L'| at the ends is 4c and 4a times the legs; both legs have the same direction.
    expected = (3 - 1.0) / 4 * np.hypot(5, 20) / ((3 - 0.7) / 4 * np.hypot(5, 20))
    assert joint["speed_ratio"] == pytest.approx(expected)


def test_what_does_not_exist_is_null(tmp_path, capsys):
    segments = [
        {"points": [[5, 0], [4, 5], [4, 8], [5, 10]], "lambda": [4, 3, 4], "omega": 1},
        {"points": [[6, 10], [5, 12], [5, 14], [6, 20]], "lambda": [4, 3, 4], "omega": 1},
    ]
    path = write_project(tmp_path / "a.sgb", segments, profile_joints=["free"])
    found = measured(capsys, path)
    assert found["bending_energy"] is None
    assert found["joints"][0]["measured"] == "gap"
    assert found["joints"][0]["kink_deg"] is None
    assert found["joints"][0]["speed_ratio"] is None
    assert found["warnings"]
    flat = [{"points": [[1, 3], [2, 3], [3, 3], [4, 3]]}]
    assert measured(capsys, write_project(tmp_path / "b.sgb", flat))["centroid"] is None


def test_a_profile_across_the_axis_has_a_warning_and_the_formula_s_volume(tmp_path, capsys):
    segment = {"points": [[5, 0], [-4, 5], [-4, 8], [5, 10]]}
    found = measured(capsys, write_project(tmp_path / "a.sgb", [segment]))
    r, h = curve(segment)
    assert found["volume"] == pytest.approx(abs(np.pi * (r * r * h.deriv()).integ()(1)), rel=1e-12)
    assert any("axis" in warning for warning in found["warnings"])


def test_a_partial_sweep_is_its_share(tmp_path, capsys):
    whole = measured(capsys, write_project(tmp_path / "a.sgb"))
    part = measured(capsys, write_project(tmp_path / "b.sgb", revolution={"sweep_deg": 100}))
    assert part["volume"] == pytest.approx(whole["volume"] * 100 / 360, rel=1e-12)
    assert part["area"] == pytest.approx(whole["area"] * 100 / 360, rel=1e-12)
    assert part["generatrix_length"] == whole["generatrix_length"]


def test_with_a_law_lengths_are_of_the_section_at_the_start(tmp_path, capsys):
    law = {"segments": [0], "parameter": "omega", "law": "raised-cosine", "from": 0.7, "to": 0}
    plain = measured(capsys, write_project(tmp_path / "a.sgb"))
    turn = {"start_deg": 77}
    varied = measured(capsys, write_project(tmp_path / "b.sgb", variation=[law], revolution=turn))
    assert varied["generatrix_length"] == pytest.approx(plain["generatrix_length"], rel=1e-13)
    assert varied["volume"] != plain["volume"]
    plain_csv = printed(capsys, "sample", str(tmp_path / "a.sgb"))
    assert printed(capsys, "sample", str(tmp_path / "b.sgb")) == plain_csv


CORNERS = st.sampled_from([0.0, 1.0, 3.0, 4.0])
COORDINATES = st.one_of(st.sampled_from([0.0, 1.0]), st.floats(-1, 5))


@st.composite
def odd_projects(draw):
    """Draw chains with coincident points, vanishing ends, gaps, crossings and laws."""
    point = st.lists(COORDINATES, min_size=2, max_size=2)
    segments = draw(
        st.lists(
            st.fixed_dictionaries(
                {
                    "points": st.lists(point, min_size=4, max_size=4),
                    "lambda": st.lists(CORNERS, min_size=3, max_size=3),
                    "omega": st.sampled_from([0, 0.5, 1]),
                }
            ),
            min_size=1,
            max_size=3,
        )
    )
    law = {"segments": "all", "parameter": "omega", "law": "paper", "from": 0, "to": 1}
    return project(
        segments,
        profile_joints=["free"] * (len(segments) - 1),
        variation=draw(st.sampled_from([[], [law]])),
        revolution={"sweep_deg": draw(st.sampled_from([360, 90, 1e-3]))},
    )


@given(odd_projects())
@example(
    project([{"points": [[0, 0], [0, 2e-108], [1, 0], [0, 0]], "lambda": [0, 0, 0], "omega": 0}])
)
@settings(max_examples=60)
def test_no_document_gives_nan_or_infinity(document):
    evaluation = evaluate(project_file.loads(json.dumps(document).encode()))
    found = measures(evaluation)
    json.dumps(found, allow_nan=False)
    for text in (measures_table.table(found), measures_table.contents(evaluation)):
        assert "nan" not in text
        assert "inf" not in text.replace("infinite", "")


def test_the_table_has_every_number_and_unit(tmp_path, capsys):
    path = write_project(tmp_path / "a.sgb", name="Pot", unit="in")
    found = measured(capsys, path)
    text = printed(capsys, "measure", path)
    for piece in (f"{found['volume']:.8g} in³", f"{found['area']:.8g} in²", "Pot", "κ jump (1/in)"):
        assert piece in text
    first = [line for line in text.splitlines() if line.startswith(("volume", "generatrix"))]
    columns = {len(line) - len(line.split("   ")[-1].lstrip()) for line in first}
    assert len(columns) == 1, "values line up"
    assert "nan" not in text


def test_the_table_shows_warnings_and_an_infinite_energy(tmp_path, capsys):
    tower = [{"points": [[5, 0], [4, 5], [4, 8], [5, 10]], "lambda": [4, 3, 4], "omega": 1}]
    two = [*tower, {"points": [[5, 10], [6, 12], [6, 14], [6, 20]]}]
    text = printed(capsys, "measure", write_project(tmp_path / "a.sgb", two, profile_joints=["G2"]))
    assert "infinite" in text
    assert "warning: " in text


def test_check_says_what_the_file_holds(tmp_path, capsys):
    law = {"segments": [0], "parameter": "omega", "law": "paper", "from": 0, "to": 0.7}
    path = write_project(
        tmp_path / "a.sgb",
        name="Pot",
        unit="in",
        profile_joints=["C1"],
        revolution={"axis": "x", "sweep_deg": 270, "start_deg": 15},
        variation=[law],
        placement={"rotation_deg": [90, 0, 0], "translation": [1, 2, 3]},
        solid={"kind": "filled"},
    )
    text = printed(capsys, "check", path)
    for piece in (
        "Pot",
        "in",
        "2 segments, open",
        "270° from 15°",
        "filled",
        "rule C1, measured G1",
        "omega of segment 0: paper, from 0 to 0.7",
        "turned (90°, 0°, 0°), moved (1, 2, 3) in",
        "warning: ",
    ):
        assert piece in text, piece


def test_sample_is_csv_in_full_precision(tmp_path, capsys):
    path = write_project(tmp_path / "a.sgb")
    lines = printed(capsys, "sample", path).splitlines()
    assert lines[0] == "segment,s,r,h"
    assert len(lines) == 1 + 2 * 65
    rows = np.array([line.split(",") for line in lines[1:]], dtype=float)
    for index, segment in enumerate(SPINDLE):
        own = rows[rows[:, 0] == index]
        assert own[0, 1] == 0
        assert own[-1, 1] == 1
        expected = np.stack([p(own[:, 1]) for p in curve(segment)], axis=1)
        assert np.abs(own[:, 2:] - expected).max() < 1e-12 * 60


def test_sample_writes_the_same_to_a_file(tmp_path, capsys):
    path = write_project(tmp_path / "a.sgb")
    out = tmp_path / "out.csv"
    assert printed(capsys, "sample", path, "--per-segment", "7", "--out", str(out)) == ""
    assert out.read_text() == printed(capsys, "sample", path, "--per-segment", "7")
    assert len(out.read_text().splitlines()) == 1 + 2 * 7
