"""Documents that drawings are tried on."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

import resources
from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.curves.primitives import arc, line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.file import project_file
from sgb_core.document.model import Document, Revolution, Unit

SHAPE = ShapeParameters(2.0, 4.0, 0.5, 0.9)


def preset(name: str) -> Document:
    return project_file.loads(resources.load_preset(name))


def chain(*points: tuple[float, float], **more) -> Document:
    return Document(Profile.of([line(a, b) for a, b in pairwise(points)]), **more)


CUP = replace(
    chain((20, 0), (20, 60), name="Cup <&> ⌀"), solid=Solid(BodyKind.VESSEL, wall=3.0, base=4.0)
)
BENT = Document(
    Profile.of(
        [
            Segment([(20, 0), (45, 5), (50, 30), (35, 50)], SHAPE),
            Segment([(35, 50), (20, 70), (18, 80), (25, 95)], SHAPE),
        ]
    ),
    name="Bent",
    solid=Solid(BodyKind.VESSEL, wall=2.5, base=3.0, rim=Rim.ROUND),
)


def many(count: int = 50) -> Document:
    """Return a wavy wall of many segments."""
    heights = np.linspace(0.0, 240.0, count + 1)
    radii = 40.0 + 12.0 * np.sin(heights / 18.0)
    return chain(*zip(radii.tolist(), heights.tolist(), strict=True), name="Many")


OTHERS = {
    "cup": CUP,
    "bent": BENT,
    "bent, wall outside": replace(
        BENT, solid=replace(BENT.solid, side=WallSide.OUTSIDE, rim=Rim.FLAT)
    ),
    "foot ring": replace(
        CUP, solid=replace(CUP.solid, foot_ring=5.0, drain_hole=8.0), unit=Unit.CM
    ),
    "plate": replace(
        chain((60, 0), (60, 6), (150, 22)), solid=Solid(BodyKind.VESSEL, wall=2.0, base=3.0)
    ),
    "mast": chain((30, 0), (30, 900), (4, 1800), name="A mast"),
    "closed": replace(
        Document(Profile.of([arc((0, 30), 30.0, -np.pi / 2, np.pi / 2)[0]])),
        solid=Solid(BodyKind.VESSEL, wall=2.0, base=0.0),
    ),
    "quarter": replace(CUP, revolution=Revolution(sweep_deg=90.0)),
    "filled": replace(BENT, solid=Solid(BodyKind.FILLED), unit=Unit.IN),
    "many": many(),
    "beyond the axis": chain((-10, 0), (20, 30), (5, 60)),
    "long name": replace(CUP, name="A very long name indeed " * 12),
    "needle": chain((0.4, 0), (0.4, 300)),
    "flat": chain((10, 0), (40, 0)),
    "speck": chain((0.001, 0), (0.002, 0.001)),
    "huge": chain((4e8, 0), (2e8, 9e8)),
}
