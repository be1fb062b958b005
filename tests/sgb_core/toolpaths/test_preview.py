"""The picture in the head of a file, read back as an interface of the firmware does."""

from __future__ import annotations

import re
from base64 import b64decode
from dataclasses import replace
from io import BytesIO
from math import cos, sin

import numpy as np
import pytest
from PIL import Image

from sgb_core.toolpaths.gcode import gcode_lines
from sgb_core.toolpaths.plan_path import toolpath
from sgb_core.toolpaths.preview import preview
from sgb_core.toolpaths.printer import Firmware
from sgb_core.toolpaths.settings import Wanted
from tests.sgb_core.toolpaths.printing import CLAY, chain, roomy

BIG = roomy(CLAY)


def seen(document) -> np.ndarray:
    """Return the picture in the file of a document's path, shape (300, 300, 4)."""
    path = toolpath(document, BIG, Wanted(layer=0.5, anyway=True))
    text = "\n".join(gcode_lines(path, "Cup", preview(path)))
    head, size, body = re.search(
        r"; thumbnail begin (\d+x\d+) (\d+)\n(.*?); thumbnail end", text, re.DOTALL
    ).groups()
    data = body.replace("; ", "").replace("\n", "")
    assert (head, len(data)) == ("300x300", int(size))
    return np.asarray(Image.open(BytesIO(b64decode(data))))


@pytest.mark.parametrize(("radius", "height"), [(30.0, 80.0), (50.0, 25.0)])
def test_a_cylinder_is_seen_from_above_in_its_true_proportions(radius, height) -> None:
    picture = seen(chain((radius, 0.0), (radius, height)))
    rows, columns = np.nonzero(picture[..., 3] > 128)
    wide, high = np.ptp(columns) + 1, np.ptp(rows) + 1
    expected = (height * cos(0.42) + 2.0 * radius * sin(0.42)) / (2.0 * radius)
    assert high / wide == pytest.approx(expected, rel=0.03)
    assert max(wide, high) == pytest.approx(0.88 * 300, rel=0.03)
    # The front wall has no hole.
    middle = picture[:, 150, 3]
    assert (middle[rows.max() - 40 : rows.max()] > 0).all()


def test_an_upper_part_hides_what_lies_behind_and_walls_are_shaded_by_their_side() -> None:
    picture = seen(chain((40.0, 0.0), (40.0, 60.0))).astype(int)
    front = picture[200, :, 0][picture[200, :, 3] == 255]
    assert np.ptp(front) > 80
    assert front[0] > front[-1]


def test_marlin_reads_no_picture() -> None:
    path = toolpath(
        chain((30.0, 0.0), (30.0, 40.0)), replace(BIG, firmware=Firmware.MARLIN), Wanted(layer=1.0)
    )
    assert preview(path) is None
    assert not any("thumbnail" in line for line in gcode_lines(path, "Cup", preview(path)))
