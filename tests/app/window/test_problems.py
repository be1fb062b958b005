"""What is wrong is said over the viewport with the one button that mends it, and goes with it."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QPushButton

from app.state.problems import problems
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.model import Document
from tests.app.window_stage import WindowStage

CUP = edits.set_solid(
    Document(Profile.of([line((40, 0), (40, 60)), line((40, 60), (50, 90))])), kind="vessel"
)


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, wait_for_scene=False)
    made.presenter.replace_document(CUP)
    made.settle()
    yield made
    made.close()


def said(stage):
    notice = stage.window.notice_bar.notice
    return None if notice is None else (notice.level, notice.text, notice.action)


def mend(stage):
    bar = stage.window.notice_bar
    button = next(b for b in bar.findChildren(QPushButton) if b.text() == bar.notice.action)
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    stage.settle()


def test_a_wall_too_thick(stage):
    viewport = stage.window.surface_view.geometry()
    stage.presenter.do("Wall", lambda document: edits.set_solid(document, wall=70.0))
    stage.until(lambda: said(stage) is not None)
    level, text, action = said(stage)
    assert (level, action) == ("warning", "Largest wall that fits")
    assert text.startswith("Wall: ")
    assert "solid" not in text
    assert stage.window.notice_bar.isVisible()
    assert stage.window.surface_view.geometry() == viewport
    mend(stage)
    assert 30.0 < stage.document.solid.wall < 50.0
    assert stage.session.undo_label == "Largest wall that fits"
    stage.until(lambda: stage.presenter.frame.body.error is None)
    assert said(stage) is None


def test_a_hollow_that_the_wall_seals_off(stage):
    waist = [line((0, 0), (30, 0)), line((30, 0), (6, 60)), line((6, 60), (40, 100))]
    hourglass = edits.set_solid(Document(Profile.of(waist)), kind="vessel", wall=2.0)
    stage.presenter.replace_document(hourglass)
    stage.settle()
    stage.presenter.do("Wall", lambda document: edits.set_solid(document, wall=12.0))
    stage.until(lambda: said(stage) is not None)
    level, text, action = said(stage)
    assert (level, action) == ("warning", "Largest wall that fits")
    assert "sealed off" in text
    bar = stage.window.notice_bar
    for label in bar.findChildren(QLabel):
        if label.isVisible() and label.wordWrap():
            assert label.height() >= label.heightForWidth(label.width())
    mend(stage)
    assert 3.0 < stage.document.solid.wall < 7.0
    stage.until(lambda: stage.presenter.frame.body.doubts == ())
    assert said(stage) is None


def test_a_warning_goes_with_its_cause_and_never_over_to_another_file(stage):
    beyond = edits.move_point(CUP, 0, 1, (-90.0, 20.0))
    stage.presenter.do("Move", lambda _: beyond)
    stage.settle()
    assert said(stage) == ("warning", "Segment 1 goes through the axis.", "Push inside")
    stage.presenter.undo()
    stage.settle()
    assert said(stage) is None
    stage.presenter.redo()
    stage.settle()
    assert said(stage) is not None
    stage.presenter.replace_document(CUP)
    stage.settle()
    assert said(stage) is None


def test_points_are_pushed_inside_the_axis(stage):
    stage.presenter.do("Move", lambda d: edits.move_point(d, 0, 1, (-90.0, 20.0)))
    stage.settle()
    mend(stage)
    assert not stage.presenter.frame.evaluation.axis_crossings
    assert stage.session.undo_label == "Push inside"
    assert said(stage) is None


def test_a_gap_is_joined_and_a_rule_is_kept(stage):
    apart = Document(Profile.of([line((40, 0), (40, 60)), line((45, 65), (50, 90))], ["free"]))
    stage.presenter.replace_document(apart)
    stage.settle()
    assert said(stage)[2] == "Join the gap"
    mend(stage)
    assert stage.presenter.frame.evaluation.joints[0].measured == "G0"
    kinked = Document(Profile.of([line((40, 0), (40, 60)), line((40, 60), (50, 90))], ["G1"]))
    stage.presenter.replace_document(kinked)
    stage.settle()
    assert said(stage)[2] == "Make it G1"
    mend(stage)
    assert stage.presenter.frame.evaluation.joints[0].measured == "G1"
    point = Segment([(40, 60)] * 4)
    stuck = Document(Profile.of([line((40, 0), (40, 60)), point], ["G1"]))
    stage.presenter.replace_document(stuck)
    stage.settle()
    if said(stage) is not None:
        mend(stage)
    assert problems(stage.presenter.frame) == ()


BENT = edits.set_solid(
    Document(Profile.of([Segment([(20, 0), (60, 30), (60, 30), (20, 60)])])), kind="vessel", wall=2
)


def test_a_bend_too_tight_for_the_wall(stage):
    stage.presenter.replace_document(BENT)
    stage.settle()
    assert said(stage) is None
    stage.presenter.do("Wall", lambda document: edits.set_solid(document, wall=12.0))
    stage.until(lambda: said(stage) is not None)
    level, text, action = said(stage)
    assert (level, action) == ("warning", "Largest wall that fits")
    assert "curvature" in text
    mend(stage)
    assert 2.0 < stage.document.solid.wall < 12.0
    stage.until(lambda: stage.presenter.frame.body.doubts == ())
    assert said(stage) is None


def test_a_ring_without_room_and_a_rim_that_cannot_be_round(stage):
    narrow = Document(Profile.of([line((2, 0), (40, 60))]))
    pointed = edits.set_solid(narrow, kind="vessel", wall=3.0, base=1.0, foot_ring=4.0)
    stage.presenter.replace_document(pointed)
    stage.until(lambda: said(stage) is not None)
    assert said(stage)[2] == "No foot ring"
    mend(stage)
    assert stage.document.solid.foot_ring == 0.0
    stage.until(lambda: stage.presenter.frame.body.error is None)
    assert said(stage) is None
    dish = Document(Profile.of([line((40, 0), (45, 1))]))
    lipped = edits.set_solid(dish, kind="vessel", wall=1.5, base=0.2, rim="round")
    stage.presenter.replace_document(lipped)
    stage.until(lambda: said(stage) is not None)
    assert said(stage)[2] == "Flat rim"
    mend(stage)
    stage.until(lambda: problems(stage.presenter.frame) == ())
    assert said(stage) is None
