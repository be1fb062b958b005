"""Makes the program's textures: ``python -m resources.textures.make`` writes them anew.

Each is a tile that repeats without a seam in both directions: noise is periodic because it is
filtered in the frequency domain, cells because distances are taken around the tile, and what is
drawn is drawn once more across each edge. Nothing here comes from a picture of others.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import cos, pi, sin
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

Field = NDArray[np.float64]
Colour = tuple[int, int, int]
Outline = list[tuple[float, float]]

SIZE = 512
# Drawn tiles are averaged down from so many times the size.
FINER = 4
COBALT, PALE, WHITE = (28, 58, 138), (120, 148, 206), (240, 243, 244)


def noise(seed: int, scale: float, stretch: float = 1.0) -> Field:
    """Return periodic noise of mean 0 and deviation 1; ``scale`` is its grain in pixels."""
    random = np.random.default_rng(seed).standard_normal((SIZE, SIZE))
    fy, fx = np.meshgrid(np.fft.fftfreq(SIZE), np.fft.fftfreq(SIZE), indexing="ij")
    soft = np.exp(-2.0 * (pi * scale) ** 2 * (fx**2 + (fy * stretch) ** 2))
    field = np.fft.ifft2(np.fft.fft2(random) * soft).real
    return np.asarray((field - field.mean()) / field.std())


def cells(seed: int, count: int) -> tuple[Field, NDArray[np.intp]]:
    """Return, per pixel, how near the border of its cell is, in pixels, and the cell's number."""
    places = np.random.default_rng(seed).uniform(0.0, SIZE, (count, 2))
    y, x = np.mgrid[0:SIZE, 0:SIZE].astype(float)
    best = np.full((SIZE, SIZE), np.inf)
    second = best.copy()
    owner = np.zeros((SIZE, SIZE), dtype=np.intp)
    other = owner.copy()
    for number, (px, py) in enumerate(places):
        dx, dy = np.abs(x - px), np.abs(y - py)
        distance = np.hypot(np.minimum(dx, SIZE - dx), np.minimum(dy, SIZE - dy))
        nearer = distance < best
        closer = ~nearer & (distance < second)
        second = np.where(nearer, best, np.where(closer, distance, second))
        other = np.where(nearer, owner, np.where(closer, number, other))
        owner[nearer] = number
        best = np.where(nearer, distance, best)
    apart = np.abs(places[owner] - places[other])
    apart = np.minimum(apart, SIZE - apart)
    # The distance to the line halfway between the two nearest places.
    border = (second**2 - best**2) / (2.0 * np.maximum(np.hypot(*np.moveaxis(apart, -1, 0)), 1.0))
    return border, owner


def mix(first: Colour, second: Colour, part: Field) -> Field:
    """Return colours between two, shape (SIZE, SIZE, 3)."""
    share = np.clip(part, 0.0, 1.0)[..., None]
    return np.asarray(np.array(first) * (1.0 - share) + np.array(second) * share)


class Sheet:
    """A tile to draw on in units of the tile; y grows upward, and everything wraps around."""

    def __init__(self, ground: Colour) -> None:
        self.image = Image.new("RGB", (SIZE * FINER, SIZE * FINER), ground)
        self._draw = ImageDraw.Draw(self.image)

    def _wrapped(
        self, points: Iterable[tuple[float, float]]
    ) -> Iterable[list[tuple[float, float]]]:
        side = SIZE * FINER
        outline = [(x * side, (1.0 - y) * side) for x, y in points]
        for across in (-side, 0, side):
            for along in (-side, 0, side):
                yield [(x + across, y + along) for x, y in outline]

    def fill(self, points: Outline, colour: Colour) -> None:
        """Fill an outline."""
        for outline in self._wrapped(points):
            self._draw.polygon(outline, fill=colour)

    def line(self, points: Outline, colour: Colour, width: float) -> None:
        """Draw a line; ``width`` is a part of the tile."""
        for outline in self._wrapped(points):
            self._draw.line(outline, fill=colour, width=round(width * SIZE * FINER), joint="curve")

    def pixels(self) -> Field:
        """Return the tile, averaged down, shape (SIZE, SIZE, 3)."""
        small = self.image.resize((SIZE, SIZE), Image.Resampling.BOX)
        return np.asarray(small, dtype=float)


def petal(
    x: float, y: float, turn: float, length: float, width: float, fat: float = 1.0
) -> Outline:
    """Return a pointed petal that grows from (x, y); ``turn`` in degrees from upright."""
    half = [
        (width * sin(pi * t) ** fat * (1.0 - 0.35 * t), length * t) for t in np.linspace(0, 1, 40)
    ]
    outline = half + [(-px, py) for px, py in reversed(half)]
    c, s = cos(turn * pi / 180.0), sin(turn * pi / 180.0)
    return [(x + c * px + s * py, y - s * px + c * py) for px, py in outline]


def circle(x: float, y: float, radius: float) -> Outline:
    """Return a circle's outline."""
    return [(x + radius * cos(t), y + radius * sin(t)) for t in np.linspace(0, 2 * pi, 60)]


def spiral(x: float, y: float, radius: float, turns: float, start: float) -> Outline:
    """Return a spiral that runs inwards."""
    return [
        (
            x + radius * (1.0 - 0.85 * t) * cos(start + turns * 2 * pi * t),
            y + radius * (1.0 - 0.85 * t) * sin(start + turns * 2 * pi * t),
        )
        for t in np.linspace(0, 1, 90)
    ]


def brushed(pixels: Field, seed: int) -> Field:
    """Let cobalt run a little light and dark, as a brush leaves it."""
    blue = (pixels[..., 2] - pixels[..., 0]).clip(0, 120)[..., None] / 120.0
    return (
        pixels + blue * 9.0 * noise(seed, 9.0)[..., None] + 1.0 * noise(seed + 1, 40.0)[..., None]
    )


def blue_white_bands() -> Field:
    """Rows of breaking waves between double lines."""
    sheet = Sheet(WHITE)
    for y, width in ((0.0, 0.030), (0.055, 0.010), (0.5, 0.030), (0.445, 0.010), (0.555, 0.010)):
        sheet.line([(-0.1, y), (1.1, y)], COBALT, width)
    sheet.line([(-0.1, 0.945), (1.1, 0.945)], COBALT, 0.010)
    for k in range(4):
        x = (k + 0.5) / 4
        sheet.line(spiral(x, 0.25, 0.105, 1.6, pi * 1.1), COBALT, 0.020)
        wave = [
            (x - 0.12 + 0.25 * t, 0.125 + 0.05 * (1 - cos(2 * pi * t)) / 2)
            for t in np.linspace(0, 1, 30).tolist()
        ]
        sheet.line(wave, PALE, 0.016)
        sheet.line([(px, 0.5 - py) for px, py in wave], PALE, 0.012)
    for k in range(8):
        x = (k + 0.5) / 8
        diamond = [(x - 0.0625, 0.75), (x, 0.86), (x + 0.0625, 0.75), (x, 0.64), (x - 0.0625, 0.75)]
        sheet.line(diamond, COBALT, 0.012)
        sheet.fill(circle(x, 0.75, 0.018), COBALT)
        sheet.fill(circle(x + 0.0625, 0.86, 0.010), PALE)
        sheet.fill(circle(x + 0.0625, 0.64, 0.010), PALE)
    return brushed(sheet.pixels(), 3)


def lotus() -> Field:
    """Paint a lotus on a winding stem, in cobalt on white."""
    sheet = Sheet(WHITE)
    stem = [(t, 0.30 + 0.13 * sin(2 * pi * t)) for t in np.linspace(-0.1, 1.1, 90).tolist()]
    sheet.line(stem, COBALT, 0.014)
    for x, y, turn, size in (
        (0.08, 0.42, -50, 0.16),
        (0.40, 0.33, 120, 0.17),
        (0.62, 0.16, -110, 0.16),
        (0.92, 0.26, 60, 0.18),
        (0.24, 0.42, 25, 0.13),
        (0.80, 0.18, 160, 0.13),
    ):
        sheet.fill(petal(x, y, turn, size, size * 0.30), PALE)
        sheet.line(petal(x, y, turn, size, size * 0.30), COBALT, 0.008)
        sheet.line(petal(x, y, turn, size * 0.9, 0.001), COBALT, 0.006)
    for x, y, radius, start in (
        (0.13, 0.24, 0.05, 1.0),
        (0.88, 0.42, 0.05, 4.0),
        (0.5, 0.12, 0.045, 2.5),
    ):
        sheet.line(spiral(x, y, radius, 1.4, start), COBALT, 0.009)
    for turn, length, tone in (
        (-78, 0.24, PALE), (78, 0.24, PALE), (-52, 0.31, WHITE), (52, 0.31, WHITE),
        (-27, 0.36, PALE), (27, 0.36, PALE), (0, 0.40, WHITE),
    ):  # fmt: skip
        outline = petal(0.5, 0.50, turn, length, 0.078)
        sheet.fill(outline, tone)
        sheet.line([*outline, outline[0]], COBALT, 0.011)
        sheet.line(petal(0.5, 0.50, turn, length * 0.82, 0.030), COBALT, 0.005)
    sheet.fill(petal(0.5, 0.47, 0, 0.14, 0.06, 0.6), COBALT)
    for x, y in ((0.0, 0.72), (0.02, 0.94), (0.98, 0.55)):
        for turn in range(0, 360, 72):
            sheet.fill(petal(x, y, turn, 0.055, 0.020), COBALT)
        sheet.fill(circle(x, y, 0.012), WHITE)
    return brushed(sheet.pixels(), 5)


def geometric() -> Field:
    """Paint a running key fret between bands, iron brown on buff."""
    ground, dark = (226, 205, 168), (110, 52, 30)
    sheet = Sheet(ground)
    for y in (0.04, 0.46, 0.54, 0.96):
        sheet.line([(-0.1, y), (1.1, y)], dark, 0.028)
    for k in range(4):
        x, step = k / 4, 0.25 / 6
        fret = [(0, 0), (0, 5), (5, 5), (5, 2), (3, 2), (3, 3.4), (1.6, 3.4), (1.6, 0), (6, 0)]
        sheet.line([(x + px * step, 0.11 + py * 0.056) for px, py in fret], dark, 0.022)
        for turned in (0.0, 0.5):
            middle = x + 0.125 + (turned - 0.25) * 0.25
            triangle = [(middle - 0.0625, 0.60), (middle, 0.74), (middle + 0.0625, 0.60)]
            sheet.fill(triangle, dark)
            sheet.fill([(px + 0.0625, 1.50 - py) for px, py in triangle], (168, 92, 52))
    return sheet.pixels() + 3.0 * noise(11, 2.0)[..., None]


def wood() -> Field:
    """Long grain with darker year rings."""
    y, x = np.mgrid[0:SIZE, 0:SIZE] / SIZE
    del y
    bend = 0.10 * noise(21, 14.0, 8.0) + 0.03 * noise(22, 5.0, 10.0)
    rings = 0.5 + 0.5 * np.sin(2 * pi * (9.0 * x + 6.0 * bend))
    fibre = noise(23, 0.7, 30.0)
    tone = 0.55 * rings**1.6 + 0.10 * fibre + 0.10 * noise(24, 40.0)
    return mix((176, 122, 70), (104, 62, 30), tone + 0.12)


def brick() -> Field:
    """Courses of fired brick in running bond."""
    y, x = np.mgrid[0:SIZE, 0:SIZE] / SIZE
    course = np.floor(y * 8).astype(int)
    along = x * 4 + 0.5 * (course % 2)
    number = (np.floor(along).astype(int) % 4) + 4 * course
    u, v = along % 1.0, (y * 8) % 1.0
    edge = np.minimum(np.minimum(u, 1 - u) * 2.0, np.minimum(v, 1 - v)) + 0.012 * noise(31, 3.0)
    tones = np.random.default_rng(32).uniform(-1, 1, 32)[number]
    body = mix((150, 74, 52), (190, 112, 80), 0.5 + 0.3 * tones + 0.12 * noise(33, 2.5))
    mortar = np.clip((edge - 0.055) / 0.035, 0.0, 1.0)[..., None]
    return np.asarray(np.array((196, 186, 170)) * (1 - mortar) + body * mortar)


def rammed_earth() -> Field:
    """Layers of tamped earth, with grit."""
    y = np.mgrid[0:SIZE, 0:SIZE][0] / SIZE
    level = y * 6 + 0.10 * noise(41, 30.0, 1.0) + 0.03 * noise(42, 6.0)
    part = level % 1.0
    tones = np.array([0.2, 0.7, 0.4, 0.9, 0.3, 0.6])[np.floor(level).astype(int) % 6]
    seam = np.exp(-((np.minimum(part, 1 - part) / 0.05) ** 2))
    tone = tones + 0.10 * noise(43, 1.5) + 0.10 * noise(44, 12.0, 3.0)
    return np.asarray(mix((170, 128, 84), (206, 170, 122), tone) * (1.0 - 0.22 * seam[..., None]))


def earthen_wall() -> Field:
    """Build the wall of a round house: rammed earth with two storeys of small windows."""
    wall = rammed_earth()
    y, x = np.mgrid[0:SIZE, 0:SIZE] / SIZE

    def put(place: tuple[float, float], half: tuple[float, float], colour: Colour) -> None:
        off = np.maximum(np.abs(x - place[0]) - half[0], np.abs(y - place[1]) - half[1])
        inside = np.clip(0.5 - off * SIZE, 0.0, 1.0)[..., None]
        wall[:] = wall * (1.0 - inside) + np.array(colour) * inside

    for place in ((0.25, 0.31), (0.75, 0.31), (0.25, 0.58), (0.75, 0.58)):
        put(place, (0.066, 0.078), (222, 204, 172))
        put(place, (0.050, 0.062), (84, 52, 30))
        put(place, (0.038, 0.050), (30, 24, 22))
        put(place, (0.006, 0.050), (84, 52, 30))
        # The lintel, wider than the frame.
        put((place[0], place[1] - 0.086), (0.080, 0.012), (96, 62, 36))
    return wall


def roof_tile() -> Field:
    """Rows of grey half-round tiles that overlap downwards."""
    y, x = np.mgrid[0:SIZE, 0:SIZE] / SIZE
    y = 1.0 - y
    column = (x * 8) % 1.0
    round_part = np.sin(pi * np.clip((column - 0.12) / 0.76, 0.0, 1.0))
    row = (y * 4) % 1.0
    number = np.floor(x * 8).astype(int) % 8 + 8 * (np.floor(y * 4).astype(int) % 4)
    tones = np.random.default_rng(52).uniform(-1, 1, 32)[number]
    light = 0.25 + 0.75 * round_part**0.7
    lip = np.exp(-((row / 0.05) ** 2)) + 0.6 * np.exp(-(((1.0 - row) / 0.10) ** 2))
    tone = light * (1.0 - 0.55 * lip) + 0.06 * tones + 0.03 * noise(53, 2.0)
    return mix((38, 40, 44), (128, 130, 132), tone)


def crackle(
    ground: Colour, line: Colour, seeds: tuple[int, int, int], counts: tuple[int, int]
) -> Field:
    """Return a net of fine cracks, coarse ones and finer ones between them."""
    coarse, owner = cells(seeds[0], counts[0])
    fine, _ = cells(seeds[1], counts[1])
    tones = np.random.default_rng(seeds[2]).uniform(-1, 1, counts[0])[owner]
    lines = np.maximum(np.exp(-((coarse / 1.5) ** 2)), 0.45 * np.exp(-((fine / 0.9) ** 2)))
    base = np.array(ground) + 3.0 * tones[..., None] + 2.0 * noise(seeds[2], 25.0)[..., None]
    return np.asarray(base * (1.0 - lines[..., None]) + np.array(line) * lines[..., None])


def celadon_crackle() -> Field:
    """Jade green glaze with a quiet net of cracks."""
    return crackle((158, 190, 168), (112, 140, 118), (61, 62, 63), (46, 150))


def raku_crackle() -> Field:
    """White glaze whose cracks have taken up smoke."""
    return crackle((222, 214, 200), (38, 34, 32), (71, 72, 73), (34, 120))


def speckle() -> Field:
    """Oatmeal stoneware with iron specks."""
    specks = noise(81, 1.6) + 0.6 * noise(82, 0.8)
    dark = np.clip((specks - 2.3) / 0.5, 0.0, 1.0)
    warm = np.clip((noise(83, 3.0) - 1.9) / 0.6, 0.0, 1.0)
    base = mix((214, 203, 182), (226, 217, 199), 0.5 + 0.25 * noise(84, 30.0))
    base = base * (1 - 0.5 * warm[..., None]) + np.array((168, 128, 88)) * 0.5 * warm[..., None]
    return np.asarray(base * (1 - dark[..., None]) + np.array((70, 50, 38)) * dark[..., None])


# Drawn tiles keep their edges as PNG with few colours; grainy ones are JPEG.
TILES: dict[str, tuple[Callable[[], Field], str]] = {
    "blue-white-bands": (blue_white_bands, "png"),
    "lotus": (lotus, "png"),
    "geometric": (geometric, "png"),
    "wood": (wood, "jpg"),
    "brick": (brick, "jpg"),
    "rammed-earth": (rammed_earth, "jpg"),
    "earthen-wall": (earthen_wall, "jpg"),
    "roof-tile": (roof_tile, "jpg"),
    "celadon-crackle": (celadon_crackle, "jpg"),
    "raku-crackle": (raku_crackle, "jpg"),
    "speckle": (speckle, "jpg"),
}


def write_all(folder: Path) -> None:
    """Write every tile into a folder."""
    for name, (make, suffix) in TILES.items():
        pixels = np.clip(np.rint(make()), 0, 255).astype(np.uint8)
        image: Any = Image.fromarray(pixels)
        target = folder / f"{name}.{suffix}"
        if suffix == "png":
            image.quantize(48, dither=Image.Dither.NONE).save(target, optimize=True)
        else:
            image.save(target, quality=82, subsampling=0)


if __name__ == "__main__":
    write_all(Path(__file__).parent)
