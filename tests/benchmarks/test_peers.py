"""A plate of how many segments others need for the same outlines at the same tolerance.

It is drawn where SGB_PLATE says, else into a folder of its own.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageDraw, ImageFont

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.design.tracing import trace
from sgb_core.sources import Options, Side, take
from tests.sgb_core.design.tracing.peers import kurbo_joints, plain_cubics, potrace_joints
from tests.sgb_core.design.tracing.test_peers import FILES, PIXEL

# Pixels of a cell of the plate, of the words before a row, and of a joint; drawn so much finer.
_WIDE, _HIGH, _WORDS, _JOINT, _FINE = 100, 190, 150, 3.5, 3
_INK, _LINE, _MARK = (40, 40, 40), (150, 150, 150), (200, 80, 0)


def _joints(profile: Profile) -> Floats:
    return np.array([profile.segments[0].points[0], *(s.points[3] for s in profile.segments)])


def _own(points: Floats) -> Floats:
    return _joints(trace(points, PIXEL).profile)


def _cubics(points: Floats) -> Floats:
    with plain_cubics():
        return _joints(trace(points, PIXEL).profile)


def _kurbo(points: Floats) -> Floats:
    return kurbo_joints(points, PIXEL)


def _potrace(points: Floats) -> Floats:
    # Where it ends the first piece is where the last begins: the side's own ends are two joints.
    return np.concatenate([potrace_joints(points, PIXEL), points[:1]])


PROGRAMS: Mapping[str, Callable[[Floats], Floats]] = {
    "this tracer": _own,
    "plain cubics": _cubics,
    "kurbo": _kurbo,
    "potrace": _potrace,
}


class _Plate:
    def __init__(self, columns: int, rows: int) -> None:
        size = (_WORDS + columns * _WIDE, rows * _HIGH)
        self._picture = Image.new("RGB", (size[0] * _FINE, size[1] * _FINE), "white")
        self._draw = ImageDraw.Draw(self._picture)
        self._font = ImageFont.load_default(15 * _FINE)

    def words(self, text: str, x: float, y: float) -> None:
        self._draw.text((x * _FINE, y * _FINE), text, fill=_INK, font=self._font)

    def outline(self, points: Floats, joints: Floats, column: int, row: int) -> None:
        low, high = points.min(axis=0), points.max(axis=0)
        scale = min((_WIDE - 24) / (high - low)[0], (_HIGH - 44) / (high - low)[1])

        def places(of: Floats) -> list[tuple[float, float]]:
            x = _WORDS + column * _WIDE + 12 + (of[:, 0] - low[0]) * scale
            y = row * _HIGH + 8 + (high[1] - of[:, 1]) * scale
            return [(a * _FINE, b * _FINE) for a, b in zip(x.tolist(), y.tolist(), strict=True)]

        self._draw.line(places(points), fill=_LINE, width=2 * _FINE)
        reach = _JOINT * _FINE
        for x, y in places(joints):
            self._draw.ellipse([x - reach, y - reach, x + reach, y + reach], fill=_MARK)
        self.words(str(len(joints) - 1), _WORDS + column * _WIDE + 12, (row + 1) * _HIGH - 28)

    def save(self, path: Path) -> None:
        size = self._picture.width // _FINE, self._picture.height // _FINE
        self._picture.resize(size, Image.Resampling.LANCZOS).quantize(32).save(path, optimize=True)


@pytest.mark.skipif(not FILES, reason="the data are not here")
def test_peers_side_by_side(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("kurbopy")
    pytest.importorskip("potrace")
    sides = [take(path, Options(scale=1.0, side=Side.LEFT)).points for path in FILES]
    plate = _Plate(len(sides), len(PROGRAMS))
    counts: dict[str, list[int]] = {}
    for row, (name, joints_of) in enumerate(PROGRAMS.items()):
        for column, points in enumerate(sides):
            joints = joints_of(points)
            counts.setdefault(name, []).append(len(joints) - 1)
            plate.outline(points, joints, column, row)
        plate.words(name, 10, row * _HIGH + 60)
        plate.words(f"{np.mean(counts[name]):.1f} on average", 10, row * _HIGH + 84)
    path = Path(os.environ.get("SGB_PLATE", tmp_path / "peers.png"))
    plate.save(path)
    own = np.array(counts["this tracer"])
    with capsys.disabled():
        print(f"\n{path}")
        for name, found in counts.items():
            print(f"{name:14}" + "".join(f"{n:4}" for n in found), f"{np.mean(own / found):8.2f}")
    assert path.stat().st_size > 10_000
