"""The picture behind the profile: painted where it belongs, moved, turned, scaled by the hand."""

from dataclasses import replace
from io import BytesIO

import numpy as np
import pytest
from PIL import Image
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QImage

from sgb_core.document import edits
from sgb_core.document.appearance.picture_file import Picture
from sgb_core.document.reference import Reference
from tests.app.profile_editor.bench import ALT, NONE, SHIFT, Bench, vase

# A picture with one red patch; the axis is its column 50, the foot its row 90.
PATCH, ORIGIN, SCALE = (70, 50), (50.0, 90.0), 1.25


def source(**fields):
    image = Image.new("RGB", (100, 100), (255, 255, 255))
    image.paste((255, 0, 0), (PATCH[0] - 4, PATCH[1] - 4, PATCH[0] + 5, PATCH[1] + 5))
    stream = BytesIO()
    image.save(stream, "PNG")
    picture = Picture(stream.getvalue())
    return Reference("photo.png", "picture", picture, origin=ORIGIN, scale=SCALE, **fields)


@pytest.fixture
def bench(qtbot):
    reference = source(opacity=1.0, locked=False)
    return Bench(qtbot, edits.set_reference(vase(), reference))


def red(bench):
    """Return the middle of what is red in the editor, (x, y), None where nothing is."""
    picture = bench.view.grab().toImage().convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(picture.constBits(), np.uint8)
    rows = rows.reshape(picture.height(), picture.bytesPerLine())[:, : 3 * picture.width()]
    pixels = rows.reshape(picture.height(), picture.width(), 3).astype(int)
    # Grid lines lie over the patch: what is nearly red counts.
    found = (pixels[..., 0] > 180) & (pixels[..., 1] < 90) & (pixels[..., 2] < 90)
    y, x = np.nonzero(found)
    return None if len(x) < 20 else np.array([(x.min() + x.max()) / 2, (y.min() + y.max()) / 2])


def place(bench, reference):
    return bench.view.transform.map(reference.placed(PATCH))


def test_a_place_of_the_picture_lies_where_the_frame_says(bench):
    expected = (SCALE * (PATCH[0] - ORIGIN[0]), SCALE * (ORIGIN[1] - PATCH[1]))
    assert bench.document.reference.placed(PATCH) == pytest.approx(expected)
    assert red(bench) == pytest.approx(place(bench, bench.document.reference), abs=2.0)
    for field in ({"turn_deg": 12.0}, {"scale": 0.8}, {"origin": (40.0, 80.0)}):
        bench.presenter.do("x", lambda d, field=field: edits.change_reference(d, **field))
        bench.settle()
        assert red(bench) == pytest.approx(place(bench, bench.document.reference), abs=2.5)
    bench.presenter.do("x", lambda d: edits.change_reference(d, shown=False))
    bench.settle()
    assert red(bench) is None


@pytest.mark.parametrize("turn", [0.0, 10.0])
def test_it_is_dragged_in_one_step(bench, turn):
    bench.presenter.do("x", lambda d: edits.change_reference(d, turn_deg=turn))
    bench.key(Qt.Key.Key_B)
    before = bench.document.reference.placed(PATCH)
    start = QPointF(200, 300)
    bench.drag(start, start + QPointF(30, -20))
    after = bench.document.reference.placed(PATCH)
    scale = bench.view.transform.scale
    assert (after - before) * scale == pytest.approx([30.0, 20.0], abs=0.01)
    assert bench.undo_entries[-1] == "Move the picture"
    bench.presenter.undo()
    assert bench.document.reference.placed(PATCH) == pytest.approx(before)


def test_shift_turns_and_alt_scales_about_the_foot_on_the_axis(bench):
    bench.key(Qt.Key.Key_B)
    before = bench.document.reference
    bench.drag(bench.screen((40.0, 40.0)), bench.screen((0.0, 56.5685)), modifiers=SHIFT)
    after = bench.document.reference
    r, h = before.placed(PATCH)
    turned = (np.cos(np.pi / 4) * r - np.sin(np.pi / 4) * h, np.sin(np.pi / 4) * (r + h))
    assert after.placed(PATCH) == pytest.approx(turned, abs=0.5)
    bench.presenter.undo()
    bench.drag(bench.screen((0.0, 30.0)), bench.screen((0.0, 60.0)), modifiers=ALT)
    assert bench.document.reference.placed(PATCH) == pytest.approx([2 * r, 2 * h], abs=0.5)


def test_a_locked_picture_stays_and_arrows_nudge(bench):
    bench.key(Qt.Key.Key_B)
    before = bench.document.reference
    bench.key(Qt.Key.Key_Right)
    step = bench.document.reference.placed(PATCH) - before.placed(PATCH)
    assert step * bench.view.transform.scale == pytest.approx([1.0, 0.0])
    bench.presenter.do("x", lambda d: edits.change_reference(d, locked=True))
    locked = bench.document
    bench.drag(QPointF(200, 300), QPointF(260, 300), modifiers=NONE)
    bench.key(Qt.Key.Key_Right)
    assert bench.document is locked


def test_points_of_other_sources_are_shown_too(qtbot):
    bench = Bench(qtbot, vase())
    blank = bench.view.grab().toImage()
    points = tuple((r, 40.0) for r in np.linspace(10.0, 40.0, 30).tolist())
    reference = replace(Reference("scan.csv", "points"), points=points, opacity=1.0)
    bench.presenter.do("x", lambda d: edits.set_reference(d, reference))
    bench.settle()
    assert bench.view.grab().toImage() != blank
