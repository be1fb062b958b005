"""Pictures: outlines of dark things, and drawn lines followed by clicks."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageDraw

from sgb_core.findings.sources import NoSource, PictureSize, Sides, TinyPicture, TooMuch, Unreadable
from sgb_core.sources import Options, ScaleBar, Side, SourceError, Taken
from tests.sgb_core.sources.files import apart, taken

FINE = 4
HEIGHTS = np.linspace(0.0, 300.0, 301)
RADII = 70.0 + 40.0 * np.sin(HEIGHTS / 60.0)
SIDE = np.stack([RADII, HEIGHTS], axis=1)


def png(picture: Image.Image) -> bytes:
    """Return a picture as the bytes of a PNG file."""
    stream = BytesIO()
    picture.save(stream, "PNG")
    return stream.getvalue()


def drawing(*lines: tuple[np.ndarray, int], filled: bool = False, grey: int = 0) -> Image.Image:
    """Return lines (points in pixels, width) drawn smoothly on white."""
    picture = Image.new("L", (300 * FINE, 360 * FINE), 255)
    draw = ImageDraw.Draw(picture)
    for points, width in lines:
        path = [tuple(point) for point in ((points + 0.5) * FINE).tolist()]
        if filled:
            draw.polygon(path, fill=grey)
        else:
            draw.line(path, fill=grey, width=width * FINE, joint="curve")
    return picture.resize((300, 360), Image.Resampling.BOX)


def seen(axis: float = 150.0, bottom: float = 330.0, left: float = 1.0) -> np.ndarray:
    """Return the outline of the vase in pixels; the left side ``left`` times as far out."""
    right = np.stack([axis + RADII, bottom - HEIGHTS], axis=1)
    other = np.stack([axis - left * RADII, bottom - HEIGHTS], axis=1)
    return np.concatenate([right, other[::-1]])


def vase(folder: Path, options: Options, **how: float) -> Taken:
    """Return what is taken from the picture of a filled vase."""
    return taken(folder, "vase.png", png(drawing((seen(**how), 1), filled=True)), options)


def test_a_filled_outline_is_traced_to_a_pixel_upright_at_its_axis(tmp_path: Path) -> None:
    found = vase(tmp_path, Options(scale=0.5, side=Side.RIGHT))
    assert found.axis[0] == pytest.approx(150.0, abs=0.2)
    assert found.trace.tolerance == 0.5
    assert apart(found.trace.profile, 0.5 * SIDE[3:-3]) * found.trace.profile.size < 0.75
    assert len(found.trace.profile) <= 4


def test_the_height_can_give_the_scale(tmp_path: Path) -> None:
    found = vase(tmp_path, Options(height=30.0))
    low, high = found.trace.profile.bounds()
    assert high[1] - low[1] == pytest.approx(30.0, rel=2e-3)
    assert found.left_right == pytest.approx(0.0, abs=0.02)


def test_a_given_axis_tells_how_the_sides_differ(tmp_path: Path) -> None:
    found = vase(tmp_path, Options(scale=1.0, axis=150.0), left=1.1)
    assert found.left_right == pytest.approx(0.1 * np.sqrt((RADII**2).mean()), rel=0.05)
    mean = SIDE * [1.05, 1.0]
    assert apart(found.trace.profile, mean[3:-3]) * found.trace.profile.size < 1.5


def test_a_leaning_object_is_turned_upright(tmp_path: Path) -> None:
    picture = drawing((seen(), 1), filled=True).rotate(4.0, Image.Resampling.BICUBIC, fillcolor=255)
    found = taken(tmp_path, "vase.png", png(picture), Options(scale=1.0))
    assert found.left_right < 1.0  # type: ignore[operator]
    assert apart(found.trace.profile, SIDE[5:-5]) * found.trace.profile.size < 1.5


def test_what_the_picture_s_edge_cuts_is_left_out_and_said(tmp_path: Path) -> None:
    found = vase(tmp_path, Options(scale=1.0, axis=150.0, side=Side.RIGHT), bottom=370.0)
    assert Sides.CUT in found.notes
    kept = SIDE[20:-5] - [0.0, 11.0]
    assert apart(found.trace.profile, kept) * found.trace.profile.size < 2.0


def test_a_drawn_line_is_followed_between_clicks_past_what_is_around_it(tmp_path: Path) -> None:
    outer = np.stack([100.0 + RADII, 330.0 - HEIGHTS], axis=1)
    inner = outer - [12.0, 0.0]
    bands = [np.array([[100.0, y], [100.0 + RADII[330 - y] - 2.0, y]]) for y in (150, 160, 240)]
    frame = np.array([[100.0, 30.0], [211.0, 30.0], [211.0, 330.0], [100.0, 330.0], [100.0, 30.0]])
    picture = drawing((outer, 3), (inner, 3), *((band, 1) for band in bands))
    lighter = np.minimum(np.asarray(picture), np.asarray(drawing((frame, 1), grey=150)))
    clicks = tuple((x + 2.0, y) for x, y in outer[[4, 100, 200, 296]].tolist())
    options = Options(scale_bar=ScaleBar((0.0, 0.0), (0.0, 100.0), 10.0), axis=100.0, clicks=clicks)
    found = taken(tmp_path, "jar.png", png(Image.fromarray(lighter)), options)
    ends = HEIGHTS[4]
    wanted = (SIDE[4:297] - [0.0, ends]) * 0.1
    assert apart(found.trace.profile, wanted) * found.trace.profile.size < 0.1


@pytest.mark.parametrize("beside", [9.0, 25.0])
def test_a_click_beside_the_line_means_the_nearest_ink(tmp_path: Path, beside: float) -> None:
    outer = np.stack([100.0 + RADII, 330.0 - HEIGHTS], axis=1)
    clicks = [(float(x), float(y)) for x, y in outer[[4, 150, 296]]]
    clicks[1] = (clicks[1][0] + beside, clicks[1][1])
    options = Options(scale=1.0, axis=100.0, clicks=tuple(clicks))
    found = taken(tmp_path, "jar.png", png(drawing((outer, 3))), options)
    wanted = SIDE[4:297] - [0.0, HEIGHTS[4]]
    assert apart(found.trace.profile, wanted) * found.trace.profile.size < 1.0
    # Nothing goes out to the click and back.
    assert float(found.points[:, 0].max()) < RADII.max() + 2.0
    assert len(found.trace.profile) <= 4


def _jpeg(width: int, height: int) -> bytes:
    stream = BytesIO()
    Image.new("L", (64, 64), 255).save(stream, "JPEG")
    data = bytearray(stream.getvalue())
    # The frame's header holds the size; what follows is never reached.
    start = data.index(b"\xff\xc0")
    data[start + 5 : start + 9] = height.to_bytes(2, "big") + width.to_bytes(2, "big")
    return bytes(data)


@pytest.mark.parametrize(
    ("name", "data", "finding"),
    [
        ("plain.png", png(Image.new("L", (50, 50), 99)), NoSource.ONE_COLOUR),
        ("dot.png", png(Image.new("L", (1, 1), 0)), TinyPicture(1, 1)),
        (
            "wide.jpg",
            _jpeg(30_000, 3_000),
            PictureSize(30_000, 3_000, 20_000, 50_000_000),
        ),
        ("huge.jpg", _jpeg(30_000, 30_000), TooMuch("pixels", 50_000_000)),
        ("prose.png", b"It was the best of times", Unreadable("PNG or JPEG picture", "")),
        ("vector.jpg", b"<svg/>", Unreadable("PNG or JPEG picture", "")),
    ],
)
def test_what_shows_nothing_is_refused(
    tmp_path: Path, name: str, data: bytes, finding: object
) -> None:
    with pytest.raises(SourceError) as error:
        taken(tmp_path, name, data, Options(scale=1.0))
    assert error.value.finding == finding


def test_a_truncated_picture_is_refused(tmp_path: Path) -> None:
    data = png(drawing((seen(), 1), filled=True))
    with pytest.raises(SourceError) as error:
        taken(tmp_path, "vase.png", data[: len(data) // 2], Options(scale=1.0))
    assert isinstance(error.value.finding, Unreadable)


def test_a_picture_needs_a_scale_and_clicks_an_axis(tmp_path: Path) -> None:
    data = png(drawing((seen(), 1), filled=True))
    with pytest.raises(SourceError) as error:
        taken(tmp_path, "vase.png", data)
    assert error.value.finding is NoSource.NO_SCALE
    with pytest.raises(SourceError) as error:
        taken(tmp_path, "vase.png", data, Options(scale=1.0, clicks=((1.0, 1.0), (9.0, 9.0))))
    assert error.value.finding is NoSource.NO_AXIS
    with pytest.raises(SourceError, match="click is"):
        taken(tmp_path, "vase.png", data, Options(scale=1.0, axis=0.0, clicks=((1, 1), (999, 9))))
