"""``presets``, ``new``, ``export``, ``edit`` and ``render``: what they write."""

import json
import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import trimesh

import resources
from app.__main__ import main
from sgb_core.document import edits
from sgb_core.document.file import project_file
from sgb_core.exchange.body import exported_mesh
from sgb_core.findings.system import MissingPackages
from tests.app.cli.files import SPINDLE, write_project


@pytest.fixture
def spindle(tmp_path):
    return write_project(tmp_path / "spindle.sgb", profile_joints=["G1"])


def loaded(path):
    return project_file.load(path)


def test_presets_are_listed_a_line_each(capsys):
    assert main(["presets"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == [p.name for p in resources.presets()]
    assert all(len(line.split()) > 3 for line in lines)


@pytest.mark.parametrize("name", [preset.name for preset in resources.presets()])
def test_each_preset_becomes_a_project_that_checks_and_measures(tmp_path, capsys, name):
    path = str(tmp_path / f"{name}.sgb")
    assert main(["new", name, path]) == 0
    assert main(["check", path]) == 0
    assert "warning" not in capsys.readouterr().out
    assert main(["measure", path, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["volume"] > 0


@pytest.mark.parametrize("suffix", ["stl", "obj", "ply", "glb", "3mf", "csv"])
def test_export_writes_what_the_suffix_says(tmp_path, capsys, spindle, suffix):
    out = tmp_path / f"out.{suffix}"
    assert main(["export", spindle, str(out), "--samples", "8", "12"]) == 0
    assert capsys.readouterr() == ("", "")
    if suffix in {"stl", "ply", "obj", "glb"}:
        read = trimesh.load(out, force="mesh")
        read.merge_vertices(merge_tex=True, merge_norm=True)
        assert read.is_watertight
        scale = 1e-9 if suffix == "glb" else 1.0
        mesh = exported_mesh(loaded(spindle), samples=(8, 12))
        assert read.volume == pytest.approx(mesh.volume * scale, rel=1e-5)


def test_export_keeps_to_the_tolerance(tmp_path, spindle):
    counts = []
    for tolerance in ("1", "0.01"):
        out = tmp_path / "out.stl"
        assert main(["export", spindle, str(out), "--tolerance", tolerance]) == 0
        counts.append(int.from_bytes(out.read_bytes()[80:84], "little"))
    assert counts[1] > 10 * counts[0]


def test_edit_set(tmp_path, capsys, spindle):
    out = str(tmp_path / "out.sgb")
    assert main(["edit", spindle, out, "set", "1", "lambda2", "2.5"]) == 0
    assert capsys.readouterr() == ("", "")
    expected = edits.set_shape_parameter(loaded(spindle), 1, "lambda2", 2.5)
    assert loaded(out) == expected
    assert loaded(out).profile.segments[1].shape.lambda2 == 2.5


def test_edit_reverse_twice_is_the_same_file(tmp_path, spindle):
    alone = write_project(tmp_path / "alone.sgb", SPINDLE[:1])
    out = str(tmp_path / "out.sgb")
    assert main(["edit", alone, out, "reverse", "0"]) == 0
    segment = loaded(out).profile.segments[0]
    assert segment.points.tolist() == SPINDLE[0]["points"][::-1]
    assert (segment.shape.lambda1, segment.shape.lambda2, segment.shape.lambda3) == (2, 2, 0.5)
    assert main(["edit", out, out, "reverse", "0"]) == 0
    assert loaded(out).profile == loaded(alone).profile


def test_edit_scale(tmp_path, spindle):
    out = str(tmp_path / "out.sgb")
    assert main(["edit", spindle, out, "scale", "2.5"]) == 0
    before, after = loaded(spindle).profile, loaded(out).profile
    assert np.allclose(after.control_points, 2.5 * before.control_points, rtol=1e-15)


def test_edit_split_is_exact_and_silent(tmp_path, capsys, spindle):
    out = str(tmp_path / "out.sgb")
    assert main(["edit", spindle, out, "split", "0", "0.25"]) == 0
    assert capsys.readouterr() == ("", "")
    before, after = loaded(spindle).profile, loaded(out).profile
    s = np.linspace(0, 1, 11)
    assert np.allclose(after.point(0, s), before.point(0, 0.25 * s), atol=1e-10)
    assert np.allclose(after.point(1, s), before.point(0, 0.25 + 0.75 * s), atol=1e-10)


def test_edit_merge_prints_the_deviation(tmp_path, capsys, spindle):
    out = str(tmp_path / "out.sgb")
    assert main(["edit", spindle, out, "merge", "0"]) == 0
    text = capsys.readouterr().out
    assert text.startswith("largest deviation: ")
    assert text.endswith(" mm\n")
    assert float(text.split()[2]) > 0
    assert len(loaded(out).profile) == 1


def test_edit_rule_close_and_open(tmp_path, spindle):
    out = str(tmp_path / "out.sgb")
    assert main(["edit", spindle, out, "rule", "0", "C1"]) == 0
    assert loaded(out).profile.rules == ("C1",)
    assert main(["edit", spindle, out, "close"]) == 0
    assert loaded(out).profile.closed
    assert main(["edit", out, out, "open"]) == 0
    assert not loaded(out).profile.closed


def test_an_edit_says_once_which_rule_it_could_not_keep(tmp_path, capsys, spindle):
    out = str(tmp_path / "out.sgb")
    assert main(["edit", spindle, out, "rule", "0", "C1"]) == 0
    said = "C1 at joint 0 moved P1 of segment 1 from (20, 50) to (19.25, 53)\n"
    assert capsys.readouterr() == (said, "")
    assert main(["edit", out, out, "set", "1", "lambda1", "4"]) == 0
    text = capsys.readouterr()
    assert text.out == ""
    assert text.err.startswith("sgb-studio: joint 0 is G")
    assert "not C1: suspended, as an end derivative vanishes there" in text.err
    assert text.err.count("\n") == 1
    assert main(["edit", out, out, "scale", "2"]) == 0
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize(("strength", "allowed"), [(0.02, True), (1.0, False)])
def test_a_split_under_a_law_is_refused_above_a_hundredth_of_the_size(
    tmp_path, capsys, strength, allowed
):
    bent = {"points": [[10, 0], [60, 20], [0, 40], [30, 60]], "lambda": [0, 6, 0], "omega": 0}
    law = {"segments": "all", "parameter": "omega", "law": "cosine", "n": 1, "to": strength}
    path = write_project(tmp_path / "a.sgb", [bent], variation=[{**law, "from": 0}])
    out = tmp_path / "out.sgb"
    document = loaded(path)
    _, deviation = edits.split_segment(document, 0, 0.5)
    assert (deviation <= 0.01 * document.profile.size) == allowed
    assert main(["edit", path, str(out), "split", "0", "0.5"]) == (0 if allowed else 1)
    said = capsys.readouterr()
    assert out.exists() == allowed
    assert f"{deviation:.6g} mm" in (said.out if allowed else said.err)
    assert (said.out + said.err).count("\n") == 1


def test_a_rule_says_what_it_moved_and_a_refused_one_moves_nothing(tmp_path, capsys):
    out = str(tmp_path / "out.sgb")
    sharp = {"points": [[0, 3], [0, 1], [1.5, 0], [3, 0]], "lambda": [1, 3, 1], "omega": 1}
    bent = {"points": [[3, 0], [5, 0], [7, 1.5], [7, 3]], "lambda": [1, 3, 1], "omega": 0.05}
    path = write_project(tmp_path / "a.sgb", [sharp, bent])
    assert main(["edit", path, out, "rule", "0", "G2"]) == 0
    said = capsys.readouterr()
    assert said.err == ""
    assert said.out.startswith("G2 at joint 0 moved lambda3 of segment 0 from 1 to 0.")
    held = write_project(tmp_path / "b.sgb", [{**sharp, "holds": ["end"]}, bent])
    assert main(["edit", held, out, "rule", "0", "G2"]) == 0
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith("sgb-studio: joint 0 is G1 now, not G2: no λ1, λ2 or λ3 in range")
    before, after = loaded(held).profile, loaded(out).profile
    assert (after.segments, after.rules) == (before.segments, ("G2",))


def test_an_edit_keeps_what_it_does_not_know(tmp_path):
    path = write_project(tmp_path / "a.sgb", later={"a": [1, None]})
    assert main(["edit", path, path, "scale", "2"]) == 0
    assert json.loads(Path(path).read_text())["later"] == {"a": [1, None]}


def rendered(tmp_path, spindle, *options, **environment):
    """Render in a process of its own: OpenGL's state is nobody else's business."""
    import os

    out = tmp_path / "out.png"
    done = subprocess.run(
        [sys.executable, "-m", "app", "render", spindle, str(out), *options],
        cwd=Path(__file__).resolve().parents[3],
        env={k: v for k, v in os.environ.items() if k not in environment},
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stderr == ""
    data = out.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    return data, struct.unpack(">II", data[16:24])


def test_render_draws_without_a_screen(tmp_path, spindle):
    data, size = rendered(tmp_path, spindle, "--size", "320x200", DISPLAY=None)
    assert size == (320, 200)
    other, _ = rendered(tmp_path, spindle, "--size", "320x200", "--view", "top")
    bare, _ = rendered(tmp_path, spindle, "--size", "320x200", "--show", "polygon,axes")
    assert len({data, other, bare}) == 3


def test_render_can_leave_the_background_out(tmp_path, spindle):
    from io import BytesIO

    from PIL import Image

    data, _ = rendered(tmp_path, spindle, "--size", "160x120", "--transparent")
    alpha = np.asarray(Image.open(BytesIO(data)).convert("RGBA"))[..., 3]
    assert alpha[0, 0] == 0
    assert alpha[60, 80] == 255


def test_render_says_what_the_system_lacks(tmp_path, capsys, spindle, monkeypatch):
    from app.cli import preflight

    missing = MissingPackages("drawing", ("libegl1",))
    monkeypatch.setattr(preflight, "drawing_finding", lambda: missing)
    assert main(["render", spindle, str(tmp_path / "out.png")]) == 1
    said = capsys.readouterr().err
    assert said.startswith("sgb-studio: drawing needs system libraries")
    assert said.endswith("sudo apt install libegl1\n")
    assert said.count("\n") == 1
    assert not (tmp_path / "out.png").exists()
