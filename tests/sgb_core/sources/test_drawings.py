"""Published drawings of jars: the outline followed between eight clicks holds what is published."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

from sgb_core.sources import Options, ScaleBar, take
from tests.sgb_core.design.tracing.paths import volume
from tests.sgb_core.design.tracing.test_vessels import VESSELS, vessel_points

CLICKS, LITRE = 8, 1000.0
# Where the scale bar of 30 cm begins and ends, and the place of the published points' axis and
# foot at that scale, in pixels. A pixel of the axis is 0.3 to 0.5 % of the volume.
PLACES = {
    "027": (10.2, 1190.9, 530.5, 1408.0),
    "031": (158.2, 1338.9, 733.2, 1726.2),
    "033": (64.1, 1252.7, 707.7, 1501.3),
    "036": (147.1, 1335.7, 909.6, 2234.2),
    "040": (334.8, 1518.5, 822.6, 1907.0),
    "042": (185.1, 1370.7, 757.3, 1635.1),
    "046": (167.7, 1343.7, 804.1, 1873.7),
    "052": (353.6, 1537.5, 930.4, 2257.7),
    "054": (392.6, 1576.5, 985.8, 2700.5),
    "057": (312.4, 1498.3, 872.8, 2655.1),
    "060": (132.9, 1318.4, 718.5, 1552.9),
    "063": (144.4, 1328.7, 751.7, 1990.0),
    "066": (188.2, 1380.5, 956.0, 2464.0),
    "069": (308.2, 1489.3, 881.8, 2188.7),
    "071": (389.2, 1570.3, 908.4, 2773.9),
    "074": (23.1, 1211.1, 657.7, 1475.4),
    "076": (224.1, 1412.1, 800.2, 1612.6),
    "079": (29.1, 1217.1, 643.6, 1278.0),
}


@pytest.mark.skipif(not VESSELS.exists(), reason="the data are not here")
@pytest.mark.parametrize("name", sorted(PLACES))
def test_a_drawing_followed_by_eight_clicks_holds_the_published_volume(name: str) -> None:
    start, end, axis, foot = PLACES[name]
    outline = vessel_points(VESSELS / f"{name}-points.csv")
    along = np.append(0.0, np.cumsum(np.hypot(*np.diff(outline, axis=0).T)))
    marks = np.linspace(0.0, along[-1], CLICKS)
    scale = 30.0 / (end - start)
    clicks = tuple(
        (
            axis + float(np.interp(mark, along, outline[:, 0])) / scale,
            foot - float(np.interp(mark, along, outline[:, 1])) / scale,
        )
        for mark in marks
    )
    bar = ScaleBar((start, 0.0), (end, 0.0), 30.0)
    options = Options(scale_bar=bar, axis=axis, clicks=clicks, tolerance=0.2)
    found = take(VESSELS / f"{name}.jpg", options).trace.profile
    with Path(VESSELS / "published.csv").open(encoding="utf-8") as table:
        row = next(row for row in csv.DictReader(table) if row["vessel"] == name)
    assert volume(found) / LITRE == pytest.approx(float(row["body_volume_l"]), rel=0.015)
