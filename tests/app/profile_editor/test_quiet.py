"""The picture of the profile editor where forty segments crowd: the shape is what one sees."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from app.hand.canvas import Canvas
from app.hand.readout import Label, class_text
from app.theme import theme
from sgb_core.document import edits
from tests.app.profile_editor.bench import Bench, vase


def many(document, count):
    while len(document.profile) < count:
        for k in reversed(range(min(len(document.profile), count - len(document.profile)))):
            document = edits.split_segment(document, k, 0.5)[0]
    return document


def pixels(bench, name):
    """How many pixels of the editor are nearly of a palette's colour."""
    image = bench.view.grab().toImage().convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    rows = rows[:, : image.width() * 3].reshape(image.height(), image.width(), 3)
    colour = getattr(theme.current(), name)
    wanted = np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)])
    return int((np.abs(rows.astype(int) - wanted).max(axis=-1) < 25).sum())


def test_forty_segments_show_less_than_two_do(qtbot):
    few, crowd = Bench(qtbot, vase("G1")), Bench(qtbot, many(vase("G1"), 40))
    for name in ("circle_p1", "circle_p2", "polygon"):
        assert pixels(crowd, name) <= pixels(few, name)
    assert pixels(crowd, "generatrix") > 0.6 * pixels(few, "generatrix")


def test_the_selected_segment_is_shown_in_full_among_forty(qtbot):
    bench = Bench(qtbot, many(vase("G1"), 40))
    bench.presenter.select(20)
    bench.settle()
    at = bench.place(20, 1)
    bench.drag(at, at + QPointF(12.0, 0.0))
    assert bench.undo_entries == ["Move P1 of segment 21"]


@pytest.mark.parametrize("at", [(20.0, 0.0), (45.0, 30.0), (38.0, 60.0), (15.0, 112.0)])
def test_no_label_lies_on_the_curve_or_on_another(qtbot, monkeypatch, at):
    bench = Bench(qtbot, vase("G1"))
    bench.move(bench.screen(at), Qt.MouseButton.NoButton)
    drawn = []

    def noted(canvas, box, text, color, halo=True):
        drawn.append((QRectF(box), text))

    monkeypatch.setattr(Canvas, "text", noted)
    bench.view.grab()
    labels = [box for box, text in drawn if text.startswith(("P", "G"))]
    assert len(labels) >= 3
    curve = bench.view.transform.map(bench.document.profile.sample(400)).reshape(-1, 2)
    for k, box in enumerate(labels):
        inside = box.adjusted(2.0, 2.0, -2.0, -2.0)
        assert not any(inside.contains(QPointF(*place)) for place in curve.tolist())
        assert not any(box.intersects(other) for other in labels[:k])


def test_joints_say_what_they_are_near_the_pointer_only(qtbot, monkeypatch):
    bench = Bench(qtbot, edits.set_rule(vase(), 0, "G1"))
    said = []
    monkeypatch.setattr(Canvas, "text", lambda _canvas, _box, text, *_rest: said.append(text))
    bench.move(bench.screen((5.0, 100.0)), Qt.MouseButton.NoButton)
    bench.view.grab()
    name = class_text(bench.document.joints[0])
    assert name not in said
    bench.move(bench.place(0, 3), Qt.MouseButton.NoButton)
    bench.view.grab()
    assert name in said, said


def test_the_heads_up_label_keeps_off_the_curve(qtbot, monkeypatch):
    bench = Bench(qtbot, vase("G1"))
    boxes = []
    monkeypatch.setattr(Label, "paint", lambda _label, _canvas, box: boxes.append(QRectF(box)))
    for at in (bench.place(0, 3), bench.place(1, 3), bench.screen((44.0, 30.0))):
        bench.move(at, Qt.MouseButton.NoButton)
        bench.view.grab()
        curve = bench.view.transform.map(bench.document.profile.sample(400)).reshape(-1, 2)
        assert not any(boxes[-1].contains(QPointF(*place)) for place in curve.tolist())


def test_the_heads_up_label_goes_with_the_pointer(qtbot, monkeypatch):
    bench = Bench(qtbot, vase("G1"))
    told = []
    monkeypatch.setattr(Label, "paint", lambda label, _canvas, _box: told.append(label))
    bench.move(bench.place(0, 3), Qt.MouseButton.NoButton)
    bench.view.grab()
    assert told
    told.clear()
    QApplication.sendEvent(bench.view, QEvent(QEvent.Type.Leave))
    bench.view.grab()
    assert told == []


def test_the_heads_up_label_keeps_off_what_lies_over_the_picture(qtbot, monkeypatch):
    bench = Bench(qtbot, vase("G1"))
    boxes = []
    monkeypatch.setattr(Label, "paint", lambda _label, _canvas, box: boxes.append(QRectF(box)))
    # In a narrow editor the label has room on no side of the pointer between tools and dial.
    bench.view.resize(384, 480)
    bench.settle()
    bench.key(Qt.Key.Key_P)
    over = bench.view._over()
    middle = (over[0].right() + over[1].left()) / 2.0
    for x in np.linspace(middle - 30.0, middle + 30.0, 7):
        bench.move(bench.screen((15.0, 112.0)), Qt.MouseButton.NoButton)
        bench.click(bench.screen((15.0, 112.0)))
        bench.move(QPointF(x, over[1].center().y()), Qt.MouseButton.NoButton)
        bench.view.grab()
        assert not any(boxes[-1].intersects(each) for each in over)
        bench.key(Qt.Key.Key_Escape)
