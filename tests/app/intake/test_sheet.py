"""The sheet over a source in a real window: files of every kind, the hand, and what goes in."""

import os
import sys

import numpy as np
import pytest
import shiboken6
from PIL import Image, ImageDraw
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent, QGuiApplication, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from app.intake.commands import Importer
from app.intake.sheet import ImportSheet
from app.intake.view import SourceView
from app.state.presenter import Presenter
from app.theme import theme
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.file import project_file
from sgb_core.document.model import Document
from sgb_core.document.session import Session
from sgb_core.exchange import write
from tests.app.helpers import tower
from tests.app.mouse import drag, press, release
from tests.app.waiting import let_turn, show
from tests.app.window_stage import WindowStage

pytestmark = pytest.mark.skipif(
    sys.platform == "linux" and not os.environ.get("DISPLAY"), reason="needs a screen"
)
JUG = [[[20, 0], [60, 10], [50, 60], [25, 80]], [[25, 80], [15, 90], [20, 110], [30, 115]]]
# Pixels of the pictures drawn here, for each unit of the jug, and where its axis and foot are.
PER_UNIT, AXIS, FOOT = 3.0, 200.0, 380.0


def jug():
    return Document(Profile.of([Segment(points) for points in JUG], ["G0"]), name="Jug")


WIDEST = jug().profile.bounds()[1][0]


def picture(path, lean=0.0):
    """Draw the jug filled, about an axis at the pixel AXIS, its foot at FOOT."""
    side = jug().profile.sample(60).reshape(-1, 2)
    ring = np.concatenate([side, side[::-1] * (-1, 1)])
    fine = 4
    image = Image.new("L", (400 * fine, 400 * fine), 235)
    places = (ring * (PER_UNIT, -PER_UNIT) + (AXIS, FOOT) + 0.5) * fine
    ImageDraw.Draw(image).polygon([tuple(place) for place in places.tolist()], fill=30)
    image = image.rotate(lean, fillcolor=235, center=(AXIS * fine, 200 * fine))
    image.resize((400, 400), Image.Resampling.BOX).save(path)
    return path


class Stage:
    """A document and the sheet over a bare window."""

    def __init__(self, qtbot):
        self.qtbot = qtbot
        self.presenter = Presenter(Session(tower()))
        self.window = QWidget()
        show(qtbot, self.window, 1200, 800)
        self.importer = Importer(self.presenter, self.window)

    @property
    def document(self):
        return self.presenter.document

    def until(self, condition):
        self.qtbot.waitUntil(condition)


@pytest.fixture
def stage(qtbot):
    made = Stage(qtbot)
    yield made
    for sheet in made.window.findChildren(ImportSheet):
        sheet.intake.close()


def opened(stage, path):
    sheet = stage.importer.sheet
    sheet.open_path(path)
    done(stage, sheet)
    return sheet


def done(stage, sheet):
    let_turn()
    stage.until(lambda: not sheet.intake.busy)
    let_turn()


def widest(sheet):
    return sheet.intake.traced.taken.trace.profile.bounds()[1][0]


def click(button):
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def test_a_drawing_replaces_the_profile_in_one_step_and_its_source_stays(stage, tmp_path):
    path = tmp_path / "jug.svg"
    write(jug(), path)
    before = stage.document
    sheet = opened(stage, path)
    assert "2 segments" in sheet.outcome.text()
    assert stage.document is before
    click(sheet.apply_button)
    after = stage.document
    assert len(after.profile) == 2
    assert np.allclose(after.profile.control_points, JUG, atol=1e-9)
    assert (after.reference.name, after.reference.kind) == ("jug.svg", "svg")
    assert after.reference.largest_deviation < 1e-7
    assert project_file.loads(project_file.dumps(after)) == after
    stage.presenter.undo()
    assert stage.document is before


def test_a_drawing_is_added_after_the_end_or_laid_over(stage, tmp_path):
    path = tmp_path / "jug.dxf"
    write(jug(), path)
    before = stage.document
    sheet = opened(stage, path)
    sheet.into.setCurrentIndex(sheet.into.findData("ghost"))
    click(sheet.apply_button)
    assert stage.document is before
    assert len(stage.presenter.view.ghost.profile) == 2
    sheet.into.setCurrentIndex(sheet.into.findData("add"))
    click(sheet.apply_button)
    added = stage.document.profile
    assert len(added) == len(before.profile) + 2
    assert np.allclose(added.segments[3].points[0], before.profile.segments[2].points[3])


def test_the_axis_of_a_picture_is_dragged_and_the_profile_follows(stage, tmp_path):
    sheet = opened(stage, picture(tmp_path / "jug.png"))
    sheet.form.length.enter(115.0)
    done(stage, sheet)
    taken = sheet.intake.traced.taken
    assert taken.axis[0] == pytest.approx(AXIS, abs=0.5)
    assert widest(sheet) == pytest.approx(WIDEST, abs=0.5)
    view = sheet.view
    start = QPointF(*view.transform.map((AXIS, -200.0)).tolist())
    pixels = 10.0 * view.transform.scale
    drag(view, start, start + QPointF(pixels, 0.0))
    done(stage, sheet)
    assert sheet.intake.traced.taken.axis[0] == pytest.approx(AXIS + 10.0, abs=1.0)
    # Both sides' mean: the left one is wider now, the right one narrower.
    assert sheet.intake.traced.taken.left_right > 5.0
    click(sheet.form.find_axis)
    done(stage, sheet)
    assert sheet.form.axis.value == pytest.approx(AXIS, abs=0.5)


def test_a_picture_that_lies_askew_is_turned_upright_by_its_axis(stage, tmp_path):
    sheet = opened(stage, picture(tmp_path / "jug.png", lean=4.0))
    # Pictures turn against the clock: upwards the axis goes to the left.
    assert sheet.form.lean.value == pytest.approx(4.0, abs=0.3)
    found = sheet.intake.traced
    places = found.reading.frame.placed(np.array([[0.0, 0.0], [0.0, found.taken.points[-1, 1]]]))
    lean = np.degrees(np.arctan2(places[0, 0] - places[1, 0], places[1, 1] - places[0, 1]))
    assert lean == pytest.approx(4.0, abs=0.3)


def test_two_points_and_their_distance_say_the_scale(stage, tmp_path):
    sheet = opened(stage, picture(tmp_path / "jug.png"))
    sheet.form.scaling.setCurrentIndex(sheet.form.scaling.findData("points"))
    sheet.form.length.enter(100.0)
    view = sheet.view
    for end, wanted in zip(sheet.form.bar, ((50.0, 390.0), (350.0, 390.0)), strict=True):
        start, to = (QPointF(*view.transform.map((x, -y)).tolist()) for x, y in (end, wanted))
        drag(view, start, to)
    done(stage, sheet)
    (a, b), (c, d) = sheet.form.bar
    pixels = np.hypot(c - a, d - b)
    assert pixels == pytest.approx(300.0, abs=3.0)
    assert sheet.intake.traced.taken.frame.scale == pytest.approx(100.0 / pixels)


def test_clicks_follow_a_line(stage, tmp_path):
    side = jug().profile.sample(60).reshape(-1, 2) * (PER_UNIT, -PER_UNIT) + (AXIS, FOOT)
    image = Image.new("L", (400, 400), 255)
    ImageDraw.Draw(image).line([tuple(place) for place in side.tolist()], fill=0, width=3)
    image.save(tmp_path / "line.png")
    sheet = opened(stage, tmp_path / "line.png")
    sheet.form.way.setCurrentIndex(sheet.form.way.findData("line"))
    sheet.form.axis.enter(AXIS)
    sheet.form.length.enter(115.0)
    assert "Click along the line" in sheet.problem.text()
    view = sheet.view
    for place in (side[0], side[40], side[-1]):
        at = QPointF(*view.transform.map((place[0], -place[1])).tolist())
        press(view, at)
        release(view, at)
    done(stage, sheet)
    assert len(sheet.form.clicks) == 3
    assert widest(sheet) == pytest.approx(WIDEST, abs=0.8)
    QTest.keyClick(view, Qt.Key.Key_Delete)
    assert len(sheet.form.clicks) == 2


def test_the_tolerance_slider_changes_the_chain(stage, tmp_path):
    sheet = opened(stage, picture(tmp_path / "jug.png"))
    fine = len(sheet.intake.traced.taken.trace.profile)
    slider = sheet.form.slider
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_End)
    done(stage, sheet)
    coarse = sheet.intake.traced.taken.trace
    assert coarse.tolerance == pytest.approx(sheet.form.tolerance.value)
    assert len(coarse.profile) < fine
    assert coarse.largest_deviation <= coarse.tolerance


def test_the_picture_goes_behind_the_profile_and_into_the_file(stage, tmp_path):
    path = picture(tmp_path / "jug.png")
    sheet = opened(stage, path)
    before = stage.document
    sheet.into.setCurrentIndex(sheet.into.findData("behind"))
    click(sheet.apply_button)
    after = stage.document
    assert after.profile is before.profile
    assert after.reference.picture.data == path.read_bytes()
    assert after.reference.origin == pytest.approx((AXIS, FOOT), abs=1.5)
    assert project_file.loads(project_file.dumps(after)) == after


def test_the_wall_of_a_half_section_is_offered_as_a_vessel(stage, tmp_path):
    body = '<path d="M0,100 L40,100 L40,10 L36,10 L36,96 L0,96 Z"/>'
    (tmp_path / "cup.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" '
        f'viewBox="0 0 100 100">{body}</svg>'
    )
    sheet = opened(stage, tmp_path / "cup.svg")
    assert sheet.vessel.isVisible()
    sheet.vessel.setChecked(True)
    click(sheet.apply_button)
    assert stage.document.solid.kind == "vessel"
    assert stage.document.solid.wall == pytest.approx(4.0)


def test_another_path_is_chosen_by_a_click(stage, tmp_path):
    (tmp_path / "two.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" '
        'viewBox="0 0 100 100"><path d="M40,100 L40,0"/><path d="M20,80 L10,20"/></svg>'
    )
    sheet = opened(stage, tmp_path / "two.svg")
    assert widest(sheet) == pytest.approx(40.0)
    place = sheet.view.transform.map((15.0, -50.0)).tolist()
    press(sheet.view, QPointF(*place))
    release(sheet.view, QPointF(*place))
    done(stage, sheet)
    assert sheet.form.path.currentData() == 1
    assert widest(sheet) == pytest.approx(20.0)


BAD = {
    "prose.csv": (b"Once upon a time\nthere was a pot", "no two columns"),
    "empty.svg": (b"", "empty"),
    "text.svg": (b'<svg xmlns="http://www.w3.org/2000/svg"><text>a</text></svg>', "no lines"),
    "renamed.png": (b"P6 nothing", "no PNG"),
    "nothing.stl": (b"solid x\nendsolid x\n", "triangles"),
}


def test_bad_input_is_one_line_and_the_document_stays(stage, tmp_path):
    before = stage.document
    for name, (data, words) in BAD.items():
        (tmp_path / name).write_bytes(data)
        sheet = opened(stage, tmp_path / name)
        assert words in sheet.problem.text()
        assert "\n" not in sheet.problem.text()
        assert not sheet.apply_button.isEnabled()
    assert stage.document is before


def test_files_are_dropped_and_pictures_and_tables_are_pasted(qtbot, tmp_path):
    stage = WindowStage(qtbot, wait_for_scene=False)
    window, clipboard = stage.window, QGuiApplication.clipboard()
    path = tmp_path / "jug.csv"
    path.write_text("r;h\n20;0\n40,5;10\n30;30\n")
    dropped = QMimeData()
    dropped.setUrls([QUrl.fromLocalFile(str(path))])
    event = QDropEvent(
        QPointF(50, 50),
        Qt.DropAction.CopyAction,
        dropped,
        Qt.MouseButton.LeftButton,
        Qt.KeyboardModifier.NoModifier,
    )
    window.dropEvent(event)
    sheet = window.importer.sheet
    done(stage, sheet)
    assert event.isAccepted()
    assert sheet.intake.traced.taken.name == "jug.csv"
    clipboard.setText("20\t0\n30\t4\n45\t10\n")
    window.commands["paste"].trigger()
    done(stage, sheet)
    assert widest(sheet) == pytest.approx(45.0, abs=0.5)
    clipboard.setImage(QImage(str(picture(tmp_path / "jug.png"))))
    window.commands["paste"].trigger()
    done(stage, sheet)
    assert sheet.intake.traced.taken.kind == "picture"
    stage.close()


def test_a_mesh_is_read_about_its_axis_and_work_can_be_stopped(stage, tmp_path):
    path = tmp_path / "jug.stl"
    write(edits.set_solid(jug(), kind="filled"), path)
    sheet = opened(stage, path)
    assert widest(sheet) == pytest.approx(WIDEST, abs=0.5)
    before = sheet.intake.traced
    sheet.form.mesh_axis.setCurrentIndex(sheet.form.mesh_axis.findData("z"))
    assert sheet.intake.busy
    click(sheet.stop)
    done(stage, sheet)
    assert sheet.intake.traced is before


def test_a_sheet_that_is_gone_hears_of_no_theme(qtbot):
    view = SourceView()
    shiboken6.delete(view)
    with qtbot.captureExceptions() as raised:
        theme.notifier().changed.emit(theme.current())
    assert not raised
