"""The path from the exact surface beside PrusaSlicer's vase mode on our own mesh of the same vase.

``pytest tests/benchmarks/test_slicers.py -s`` prints a table where ``prusa-slicer`` is installed.
Both files are read as a machine reads them; what is compared is where the nozzle goes and what it
pushes.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest
import shapely

import resources
from sgb_core import exchange
from sgb_core.arrays import Floats
from sgb_core.bodies.solid import BodyKind
from sgb_core.document import edits
from sgb_core.document.file import project_file
from sgb_core.document.model import Document
from sgb_core.toolpaths.gcode import gcode_lines
from sgb_core.toolpaths.plan_path import toolpath
from sgb_core.toolpaths.printer import Bed
from sgb_core.toolpaths.settings import Wanted
from sgb_core.values import dataclass
from tests.sgb_core.toolpaths.printing import BIG, read

SLICER = shutil.which("prusa-slicer")
LAYER, BEAD, FILAMENT = 0.3, 0.5, 1.75
PRESETS = ("vase", "bottle", "ceramic-pot")
PRINTER = replace(BIG, bed=Bed(400.0, 400.0, 500.0))
# The middle of the bed is the axis.
MIDDLE = np.array([200.0, 200.0, 0.0])
# What of a preset is printed, so that it stands on a bed.
SIZE = 0.5
SAMPLES = np.linspace(0.0, 1.0, 2001)


@dataclass(frozen=True, slots=True, eq=False)
class Wall:
    """The extruding moves of a wall: their ends (k, 3), and what each pushes in mm³ (k,)."""

    starts: Floats
    ends: Floats
    pushed: Floats

    @property
    def lengths(self) -> Floats:
        """How long each move is."""
        return np.asarray(np.linalg.norm(self.ends - self.starts, axis=1))


def shape(name: str) -> Document:
    """Return a preset's outer shape, standing on z = 0."""
    document = project_file.loads(resources.load_preset(name))
    document = edits.for_export(document, factor=SIZE)
    return edits.set_solid(document, kind=BodyKind.SURFACE)


def ours(document: Document) -> Wall:
    """Return the wall of our own file."""
    path = toolpath(document, PRINTER, Wanted(layer=LAYER, bead=BEAD, floor_layers=0, anyway=True))
    found = read(list(gcode_lines(path, document.name)))
    places, kinds = np.array(found.places), np.array(found.kinds)
    wall = np.flatnonzero((kinds == "WALL")[1:] & (kinds == "WALL")[:-1]) + 1
    places -= MIDDLE
    return Wall(places[wall - 1], places[wall], np.array(found.pushed)[wall] * FILAMENT**2 * pi / 4)


def theirs(document: Document, folder: Path) -> Wall:
    """Return the wall of PrusaSlicer's file, from a mesh a hundred times as fine as a layer."""
    solid = edits.set_solid(document, kind=BodyKind.FILLED)
    exchange.write(solid, folder / "mesh.stl", tolerance=LAYER / 100.0)
    width = [f"--{kind}extrusion-width={BEAD}" for kind in ("", "perimeter-", "first-layer-")]
    assert SLICER is not None
    subprocess.run(
        [
            SLICER,
            "--export-gcode",
            "--spiral-vase",
            *("--top-solid-layers=0", "--bottom-solid-layers=0", "--fill-density=0"),
            *("--perimeters=1", f"--layer-height={LAYER}", f"--first-layer-height={LAYER}"),
            *width,
            f"--external-perimeter-extrusion-width={BEAD}",
            *("--bed-shape=0x0,400x0,400x400,0x400", "--center=200,200", "--max-print-height=500"),
            *("--skirts=0", "--brim-width=0", f"--filament-diameter={FILAMENT}"),
            *("--use-relative-e-distances", "--elefant-foot-compensation=0"),
            *("--gcode-resolution=0.0125", "--resolution=0"),
            f"--output={folder / 'theirs.gcode'}",
            str(folder / "mesh.stl"),
        ],
        check=True,
        capture_output=True,
    )
    return followed((folder / "theirs.gcode").read_text().splitlines())


def followed(lines: list[str]) -> Wall:
    """Follow a slicer's moves: what pushes is wall."""
    place, moves, inside = np.zeros(3), [], False
    for text in lines:
        inside = text.startswith(";TYPE:External") if text.startswith(";TYPE:") else inside
        code, *words = text.split(";")[0].split() or [""]
        if code not in ("G0", "G1"):
            continue
        values = {w[0]: float(w[1:]) for w in words if re.fullmatch(r"[A-Z]-?[\d.]+", w)}
        goal = np.array([values.get(axis, old) for axis, old in zip("XYZ", place, strict=True)])
        if inside and values.get("E", 0.0) > 0.0 and bool((goal[:2] != place[:2]).any()):
            moves.append((place, goal, values["E"] * FILAMENT**2 * pi / 4))
        place = goal
    starts, ends, pushed = zip(*moves, strict=True)
    return Wall(np.array(starts) - MIDDLE, np.array(ends) - MIDDLE, np.array(pushed))


def drawn(document: Document) -> Floats:
    """Return points (k, 2) along the profile, which stands on z = 0."""
    line = np.concatenate([segment.point(SAMPLES) for segment in document.profile])
    return np.asarray(line - (0.0, line[:, 1].min()))


def off(document: Document, wall: Wall) -> Floats:
    """Return how far the ends of moves are from half a bead inside the true surface, in mm."""
    line = drawn(document)
    pieces = shapely.linestrings(np.stack([line[:-1], line[1:]], axis=1))
    spots = shapely.points(np.hypot(*wall.ends[:, :2].T), wall.ends[:, 2])
    _, found = shapely.STRtree(pieces).query_nearest(spots, return_distance=True, all_matches=False)
    return np.asarray(np.abs(found - BEAD / 2.0))


def held(document: Document) -> float:
    """Return what a wall as thick as a bead holds, by Pappus: its middle half a bead inside."""
    step = np.diff(drawn(document), axis=0)
    lengths = np.hypot(*step.T)
    r = (drawn(document)[:-1, 0] + drawn(document)[1:, 0]) / 2.0
    inward = np.abs(step[:, 1]) / np.where(lengths > 0.0, lengths, 1.0)
    return float((2.0 * pi * (r - inward * BEAD / 2.0) * lengths).sum() * BEAD)


def first_turns(wall: Wall) -> float:
    """Return by what part more is pushed in the first two turns than there is room for.

    The room of a move is as wide as a bead and reaches to the turn before it, along the surface; of
    the first turn to the foot.
    """
    angle = np.unwrap(np.arctan2(wall.ends[:, 1], wall.ends[:, 0]))
    angle = np.abs(angle - angle[0])
    spots = (wall.starts + wall.ends) / 2.0
    height, r = spots[:, 2], np.hypot(*spots[:, :2].T)
    below = np.interp(angle - 2.0 * pi, angle, height, left=0.0)
    beside = np.interp(angle - 2.0 * pi, angle, r, left=r[0])
    first = angle <= 4.0 * pi
    room = BEAD * (wall.lengths * np.hypot(height - below, r - beside))[first].sum()
    return float(wall.pushed[first].sum() / room - 1.0)


@pytest.mark.skipif(SLICER is None, reason="prusa-slicer is not installed")
@pytest.mark.parametrize("name", PRESETS)
def test_the_path_beside_vase_mode(name: str, tmp_path: Path) -> None:
    document = shape(name)
    rows = {}
    for who, wall in (("ours", ours(document)), ("vase mode", theirs(document, tmp_path))):
        away = off(document, wall)
        rises = wall.ends[:, 2] - wall.starts[:, 2]
        breaks = np.linalg.norm(wall.starts[1:] - wall.ends[:-1], axis=1)
        rows[who] = {
            "moves": len(wall.pushed),
            "length m": float(wall.lengths.sum()) / 1000.0,
            "of the wall's volume": float(wall.pushed.sum()) / held(document),
            # Beside a floor or a sharp corner another part of the profile is nearer: one in 100.
            "99 % off by mm": float(np.quantile(away, 0.99)),
            "half off by mm": float(np.quantile(away, 0.5)),
            "first two turns": first_turns(wall),
            "steepest": float((rises / np.maximum(wall.lengths, 1e-9)).max()),
            "breaks": int((breaks > 1e-3).sum()),
        }
    print()
    for who, row in rows.items():
        cells = "  ".join(f"{key} {value:.4g}" for key, value in row.items())
        print(f"{name:>12} {who:>10}  {cells}")
    assert rows["ours"]["99 % off by mm"] < 2e-3
    assert rows["ours"]["breaks"] == 0
