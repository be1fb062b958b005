"""What large files take, under limits of the operating system."""

import json
import resource
import subprocess
import sys
from math import pi, sin

import numpy as np
import pytest
from PIL import Image

import sgb_core as sgb
from sgb_core.document.appearance.model import Texture
from sgb_core.document.appearance.picture_file import Picture

GIGABYTE = 1 << 30


def chain(segments, wiggle):
    """Return the plain segments of a tall profile that waves once in about five of them."""

    def point(k):
        t = k / (3 * segments)
        return [60 + 20 * sin(3 * pi * t) + wiggle * sin(1.3 * t * segments), 200 * t]

    return [{"points": [point(3 * k + i) for i in range(4)]} for k in range(segments)]


def run(arguments, folder, limit=GIGABYTE, limited=resource.RLIMIT_AS):
    """Run a command under a limit and return the result, and its largest memory in bytes."""
    script = (
        "import re, resource, sys\n"
        f"resource.setrlimit({limited}, ({limit}, {limit}))\n"
        "from app.__main__ import main\n"
        "status = main(sys.argv[1:])\n"
        # Not ru_maxrss, which remembers the memory of the process that it was forked from.
        "peak = re.search(r'VmHWM:\\s+(\\d+)', open('/proc/self/status').read())\n"
        "print(int(peak[1]) * 1024, file=sys.stderr)\n"
        "sys.exit(status)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script, *map(str, arguments)],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    lines = done.stderr.splitlines()
    return done, int(lines.pop()), lines


# The moved curve of a wall crosses itself some hundred thousand times.
@pytest.mark.parametrize(("segments", "wiggle", "wall"), [(400, 0.3, 30), (600, 3.0, 2)])
def test_vessels_of_many_segments_stay_small(tmp_path, segments, wiggle, wall):
    file = tmp_path / "many.sgb"
    plain = {
        "format": "sgb-document",
        "version": 1,
        "profile": {"segments": chain(segments, wiggle)},
        "solid": {"kind": "vessel", "wall": wall, "base": 3},
    }
    file.write_text(json.dumps(plain))
    done, memory, errors = run(["measure", file, "--json"], tmp_path)
    assert (done.returncode, errors) == (0, [])
    assert memory < 200e6
    assert json.loads(done.stdout)["material_volume"] > 0.0


def test_eight_large_pictures_are_exported_in_little_memory(tmp_path):
    pictures = []
    for number in range(8):
        grain = np.random.default_rng(number).integers(0, 255, (50, 50, 3), dtype=np.uint8)
        path = tmp_path / "picture.jpg"
        Image.fromarray(grain).resize((4000, 4000)).save(path, quality=50)
        pictures.append(Picture(path.read_bytes()))
    cup = sgb.Document(sgb.Profile.of([sgb.Segment([(20, 0), (55, 10), (50, 60), (25, 80)])]))
    textures = tuple(Texture(each.name, repeat=(1.0, 0.0)) for each in pictures)
    sgb.save(
        sgb.edits.set_appearance(cup, textures=textures, pictures=tuple(pictures)),
        tmp_path / "eight.sgb",
    )
    done, memory, errors = run(["export", "eight.sgb", "eight.glb"], tmp_path)
    assert (done.returncode, errors) == (0, [])
    assert memory < 400e6


def test_a_full_disk_is_said_and_leaves_the_old_file_whole(tmp_path):
    sgb.save(sgb.Document(sgb.Profile.of([sgb.line((20, 0), (25, 60))])), tmp_path / "cup.sgb")
    (tmp_path / "cup.stl").write_bytes(b"old")
    done, _, errors = run(["export", "cup.sgb", "cup.stl"], tmp_path, 4096, resource.RLIMIT_FSIZE)
    assert done.returncode == 1
    assert len(errors) == 1
    assert "cup.stl" in errors[0]
    assert (tmp_path / "cup.stl").read_bytes() == b"old"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["cup.sgb", "cup.stl"]
