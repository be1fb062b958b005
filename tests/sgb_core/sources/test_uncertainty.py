"""What a traced vessel holds, and why it may hold another volume: each reason by itself."""

from math import hypot, pi, sqrt
from pathlib import Path

import pytest
from PIL import Image, ImageDraw

from sgb_core.sources import Opened, Options, ScaleBar, Side
from sgb_core.sources.uncertainty import Holding, holding


def held(path: Path, options: Options) -> Holding:
    opened = Opened.of_file(path)
    reading = opened.reading(options)
    found = holding(opened.traced(reading, options), reading, options)
    assert found is not None
    return found


def beaker(folder: Path, left: int = 100) -> Path:
    """Draw a filled beaker, its axis at x = 199.5, 100 pixels wide to the right."""
    image = Image.new("L", (400, 400), 255)
    ImageDraw.Draw(image).rectangle((200 - left, 100, 299, 299), fill=0)
    image.save(folder / "beaker.png")
    return folder / "beaker.png"


def test_a_scale_set_to_half_a_pixel_counts_three_times(tmp_path: Path) -> None:
    bar = ScaleBar((100.0, 350.0), (300.0, 350.0), 100.0)
    found = held(beaker(tmp_path), Options(scale_bar=bar, axis=199.5))
    assert found.volume == pytest.approx(pi * 50.0**2 * 100.0, rel=0.02)
    assert found.scale == pytest.approx(found.volume * 3.0 * sqrt(2.0) * 0.5 / 200.0)
    assert found.sides == pytest.approx(0.0, abs=1e-6 * found.volume)
    given = held(beaker(tmp_path), Options(scale=0.5, axis=199.5))
    assert given.scale == 0.0
    rest = hypot(given.curve, given.sides)
    assert given.total == pytest.approx(rest, rel=1e-9, abs=0.0)


def test_sides_that_differ_leave_half_their_difference_open(tmp_path: Path) -> None:
    path = beaker(tmp_path, left=80)
    found = held(path, Options(scale=0.5, axis=199.5))
    each = [held(path, Options(scale=0.5, axis=199.5, side=side)).volume for side in Side][:2]
    assert found.sides == pytest.approx(abs(each[0] - each[1]) / 2.0, rel=0.01)
    assert found.total >= found.sides > 0.1 * found.volume


def test_points_leave_their_noise_open_and_rings_hold_nothing(tmp_path: Path) -> None:
    (tmp_path / "tube.csv").write_text("20,0\n20,30\n20,60\n", encoding="utf-8")
    tube = held(tmp_path / "tube.csv", Options())
    assert tube.volume == pytest.approx(pi * 400.0 * 60.0)
    assert tube.total < 1e-6 * tube.volume
    rows = "\n".join(f"{20 + (0.2 if k % 2 else -0.2)},{k}" for k in range(61))
    (tmp_path / "rough.csv").write_text(rows, encoding="utf-8")
    rough = held(tmp_path / "rough.csv", Options(tolerance=0.5))
    # The wall's area times the noise, and what the curve gives of its own.
    assert 1.0 < rough.curve / (2.0 * pi * 20.0 * 60.0 * 0.2) < 1.6
    circle = '<circle cx="50" cy="50" r="10"/><path id="axis" d="M0 0 V100"/>'
    text = f'<svg xmlns="http://www.w3.org/2000/svg" width="100mm" viewBox="0 0 100 100">{circle}'
    (tmp_path / "ring.svg").write_text(f"{text}</svg>", encoding="utf-8")
    opened = Opened.of_file(tmp_path / "ring.svg")
    reading = opened.reading(Options(axis=0.0))
    assert holding(opened.traced(reading, Options()), reading, Options()) is None
