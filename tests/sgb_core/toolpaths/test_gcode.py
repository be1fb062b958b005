"""The files, read by a reader of their own."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely

import resources
from sgb_core.document.errors import FileError
from sgb_core.document.file import project_file
from sgb_core.toolpaths.gcode import gcode_lines, write_gcode
from sgb_core.toolpaths.plan_path import toolpath
from sgb_core.toolpaths.settings import Wanted
from tests.sgb_core.toolpaths.printing import AUGER, CLAY, PLASTIC, chain, read, roomy

VASE = project_file.load(resources.path("presets/vase.sgb"))
CUP = chain((25.0, 0.0), (30.0, 40.0))


def test_the_file_holds_the_path_and_what_it_pushes() -> None:
    path = toolpath(VASE, CLAY, Wanted(floor_layers=2))
    found = read(list(gcode_lines(path, "Vase")))
    prints = [kind in ("SKIRT", "FLOOR", "WALL") for kind in found.kinds]
    places = np.array(found.places)[prints]
    moves = path.parts > 0
    assert places == pytest.approx(path.on_bed[moves], abs=6e-5)
    assert sum(found.pushed) == pytest.approx(path.extruded_volume, rel=1e-6)
    assert found.seconds == pytest.approx(path.time, rel=0.01)
    kinds = [
        kind
        for kind, before in zip(found.kinds, ["", *found.kinds], strict=False)
        if kind != before
    ]
    assert kinds == ["TRAVEL", "SKIRT", "TRAVEL", "FLOOR", "WALL"]
    assert sorted(set(found.layers)) == [-1, *range(path.layer_count)]


def test_filament_is_counted_in_its_length() -> None:
    path = toolpath(CUP, PLASTIC, Wanted())
    found = read(list(gcode_lines(path, "Cup")))
    pushed = sum(
        push for push, kind in zip(found.pushed, found.kinds, strict=True) if kind != "TRAVEL"
    )
    assert pushed * np.pi * 1.75**2 / 4.0 == pytest.approx(path.extruded_volume, rel=1e-6)
    whole = replace(PLASTIC, feed=replace(PLASTIC.feed, absolute=True))
    other = read(list(gcode_lines(toolpath(CUP, whole, Wanted()), "Cup")))
    assert sum(other.pushed) == pytest.approx(pushed, rel=1e-6)


def test_an_auger_has_no_e_and_moves_as_fast_as_its_flow() -> None:
    path = toolpath(CUP, AUGER, Wanted())
    lines = list(gcode_lines(path, "Cup"))
    assert not any(" E" in line for line in lines if line.startswith("G1"))
    area = path.volumes[1:] / path.lengths[1:]
    steady = (path.speeds[1:] > 4.0 + 1e-9) & (path.speeds[1:] < 60.0 - 1e-9)
    assert steady.any()
    assert (area * path.speeds[1:])[steady] == pytest.approx(300.0)


@pytest.mark.parametrize("clockwise", [False, True])
def test_arcs_stay_within_the_chord_of_the_exact_surface(clockwise) -> None:
    wanted = Wanted(floor_layers=1, arcs=True, clockwise=clockwise, skirt=1)
    path = toolpath(VASE, CLAY, wanted)
    lines = list(gcode_lines(path, "Vase"))
    code = "G2" if clockwise else "G3"
    arcs = sum(line.startswith(code + " ") for line in lines)
    assert arcs > 500
    assert len(lines) < len(path.points) / 4
    found = read(lines)
    assert sum(found.pushed) == pytest.approx(path.extruded_volume, rel=1e-6)
    wall = np.array(
        [place for place, kind in zip(found.places, found.kinds, strict=True) if kind == "WALL"]
    )
    curve = shapely.LineString(
        np.concatenate([s.point(np.linspace(0.0, 1.0, 1001)) for s in VASE.profile])
    )
    wall = wall[::83]
    low = min(segment.quartic[:, 1].min() for segment in VASE.profile)
    r = np.hypot(wall[:, 0] - 140.0, wall[:, 1] - 132.5)
    inside = (wall[:, 2] > 2.5) & (wall[:, 2] < 287.5)
    away = shapely.distance(shapely.points(np.column_stack([r, wall[:, 2] + low])[inside]), curve)
    assert np.abs(away - 2.5).max() < 0.02


def test_the_head_has_the_picture_and_one_line_a_comment() -> None:
    path = toolpath(CUP, roomy(PLASTIC), Wanted(layer=1.0))
    picture = resources.path("presets/vase.png").read_bytes()
    lines = list(gcode_lines(path, "Cup\nG28 ; not a move", picture))
    assert lines[0] == "; Cup G28 ; not a move: a continuous path by SGB Studio"
    begin = next(line for line in lines if "thumbnail begin" in line)
    assert begin.split()[3].count("x") == 1
    assert all(len(line) <= 80 for line in lines if line.startswith("; ") and "thumb" not in line)


def test_a_cancelled_or_impossible_file_leaves_the_old_one(tmp_path) -> None:
    path = toolpath(CUP, roomy(PLASTIC), Wanted(layer=1.0))
    target = tmp_path / "cup.gcode"
    target.write_text("old")

    def stop(_: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_gcode(path, target, "Cup", report=stop)
    assert target.read_text() == "old"
    with pytest.raises(FileError):
        write_gcode(path, tmp_path / "nowhere" / "cup.gcode", "Cup")
    parts: list[float] = []
    write_gcode(path, target, "Cup", report=parts.append)
    assert parts[-1] == 1.0
    assert target.read_text().splitlines() == list(gcode_lines(path, "Cup"))
