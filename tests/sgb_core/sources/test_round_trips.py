"""Our own profiles, exported or drawn as pictures, come back with the segments they had.

SGB_ROUND_TRIPS=40 for a long run.
"""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageDraw

import resources
from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.design.tracing.result import distances
from sgb_core.document.file.project_file import loads
from sgb_core.document.model import Document
from sgb_core.exchange import write
from sgb_core.sources import Options, Taken, take

PRESETS = ("amphora", "bowl", "ceramic-pot", "plant-pot", "tower", "vase")
COUNT = int(os.environ.get("SGB_ROUND_TRIPS", "2"))
NUMBERS = range(max(COUNT - len(PRESETS), 2))
NAMES = PRESETS if len(PRESETS) < COUNT else ("vase",)
# Of the size: what is exact, what is asked of a table or a mesh, and what the mesh itself is off.
EXACT, ASKED = 1e-9, 1e-3
ALLOWED = {".svg": EXACT, ".dxf": EXACT, ".csv": 1.1 * ASKED}
AXES = {".stl": "z", ".obj": "z", ".ply": "z", ".3mf": "z", ".glb": "y"}
# A picture's height in pixels, samples to a pixel, and how far its outline is from the drawn one.
PIXELS, FINE, DRAWN = 1000, 4, 0.25


def random_profile(number: int) -> Profile:
    """Return a smooth open vessel of one to five segments, every third of plain cubics."""
    rng = np.random.default_rng(number)
    count = int(rng.integers(1, 6))
    heights = np.append(0.0, np.cumsum(rng.uniform(20.0, 50.0, count)))
    nodes = np.stack([rng.uniform(15.0, 60.0, count + 1), heights], axis=1)
    slopes = np.stack([rng.uniform(-0.8, 0.8, count + 1), np.ones(count + 1)], axis=1)
    slopes /= np.hypot(*slopes.T)[:, None]
    segments = []
    for k in range(count):
        legs = float(np.hypot(*(nodes[k + 1] - nodes[k]))) * rng.uniform(0.25, 0.4, 2)
        shape = rng.uniform(0.3, 3.7, 3), rng.uniform(0.3, 1.0)
        inner = [nodes[k] + legs[0] * slopes[k], nodes[k + 1] - legs[1] * slopes[k + 1]]
        points = np.array([nodes[k], *inner, nodes[k + 1]])
        plain = number % 3 == 0
        segments.append(
            Segment(points) if plain else Segment(points, ShapeParameters(*shape[0], shape[1]))
        )
    return Profile.of(segments)


def profiles() -> list[tuple[str, Profile]]:
    """Return the profiles that go round, named."""
    own = [(name, loads(resources.load_preset(name)).profile) for name in NAMES]
    return own + [(f"random-{number}", random_profile(number)) for number in NUMBERS]


def draw(profile: Profile, path: Path) -> float:
    """Draw the filled outline as a picture, and return how large a pixel is."""
    line = profile.sample(400).reshape(-1, 2)
    high = float(line[:, 1].max())
    scale = (high - float(line[:, 1].min())) / PIXELS
    width, height = int(2.0 * line[:, 0].max() / scale) + 80, PIXELS + 80
    rows = 40.0 + (high - line[:, 1]) / scale
    sides = [width / 2.0 + sign * line[:, 0] / scale for sign in (1.0, -1.0)]
    ring = np.concatenate([np.stack([sides[0], rows], 1), np.stack([sides[1], rows], 1)[::-1]])
    picture = Image.new("L", (width * FINE, height * FINE), 255)
    ImageDraw.Draw(picture).polygon([(x * FINE, y * FINE) for x, y in ring.tolist()], fill=0)
    picture.resize((width, height), Image.Resampling.BOX).save(path)
    return scale


def _places(profile: Profile) -> Floats:
    return profile.sample(200).reshape(-1, 2)


@pytest.mark.parametrize(("name", "profile"), profiles(), ids=lambda value: str(value)[:12])
@pytest.mark.parametrize("suffix", [".svg", ".dxf", ".csv", *AXES])
def test_an_exported_profile_comes_back(
    suffix: str, name: str, profile: Profile, tmp_path: Path
) -> None:
    path = tmp_path / f"{name}{suffix}"
    write(Document(profile, name), path)
    found = take(path, Options(axis=AXES.get(suffix), tolerance=ASKED * profile.size)).trace
    # A mesh has its own tolerance besides, as large as the one asked for.
    allowed = ALLOWED.get(suffix, 2.0 * ASKED) * profile.size
    assert distances(found.profile, _places(profile)).max() <= allowed
    assert distances(profile, _places(found.profile)).max() <= allowed
    most = len(profile) + (ALLOWED.get(suffix) != EXACT)
    assert len(found.profile) <= most
    if ALLOWED.get(suffix) == EXACT:
        assert len(found.profile) == len(profile)


def _read(profile: Profile, path: Path) -> tuple[Taken, float]:
    scale = draw(profile, path)
    return take(path, Options(scale=scale)), scale


@pytest.mark.parametrize(("name", "profile"), profiles(), ids=lambda value: str(value)[:12])
def test_a_drawn_profile_comes_back_to_a_pixel(name: str, profile: Profile, tmp_path: Path) -> None:
    taken, scale = _read(profile, tmp_path / f"{name}.png")
    found = taken.trace
    assert len(found.profile) <= len(profile) + 1
    assert found.largest_deviation <= scale
    places = _places(profile)
    # Pictures stand on their lowest point.
    places -= np.array([0.0, places[:, 1].min()])
    drawn = Profile.of(
        [
            Segment(segment.points - [0.0, _places(profile)[:, 1].min()], segment.shape)
            for segment in profile.segments
        ]
    )
    assert distances(drawn, _places(found.profile)).max() <= (1.0 + DRAWN) * scale
    if name.startswith("random"):
        # Of the presets, what closes foot and mouth is no profile to a picture.
        assert distances(found.profile, places).max() <= (1.0 + DRAWN) * scale
