"""Make fair in a real window: the key, the dialog, what is said and shown, undo, refusals."""

import os
import sys

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.commands.fair_dialog import FairDialog
from app.commands.fairing import told
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.fair import fair
from sgb_core.design.fairing.findings import Keep
from sgb_core.document.model import Document
from sgb_core.surfaces.measures import bending_energy
from sgb_core.surfaces.revolution import RevolutionSurface
from tests.app.helpers import tower
from tests.app.waiting import activate
from tests.app.window_stage import WindowStage
from tests.sgb_core.surfaces.chains import TOWER, chain

pytestmark = pytest.mark.skipif(
    sys.platform == "linux" and not os.environ.get("DISPLAY"), reason="needs a screen"
)
Key, Control = Qt.Key, Qt.KeyboardModifier.ControlModifier
FIGURE_7 = Profile.of(chain(TOWER, (4, 3, 4, 2 / 3)).segments, ["G1", "G1"])
WAVE = [
    [[1, 0], [2, 0], [3, 0.5], [4, 2]],
    [[4, 2], [5, 3.5], [6, 3.5], [7, 2]],
    [[7, 2], [8, 0.5], [9, 0], [10, 0]],
]


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, wait_for_scene=False)
    made.presenter.replace_document(Document(FIGURE_7))
    made.settle()
    yield made
    made.close()


def press(stage, key, modifiers=Control):
    stage.window.profile_view.setFocus()
    QTest.keyClick(stage.window.profile_view, key, modifiers)


def wait(stage):
    stage.until(lambda: not stage.window.jobs.running)
    stage.settle()


def test_one_key_makes_the_whole_profile_fair_in_one_step_of_undo(stage):
    before = stage.document
    press(stage, Key.Key_L)
    wait(stage)
    after = stage.document
    assert bending_energy(after.profile) == pytest.approx(2.198, rel=5e-4)
    assert after.profile.control_points.tobytes() == before.profile.control_points.tobytes()
    said = stage.window.notice_bar.notice.text
    assert "7.546 → 2.198" in said
    assert "no control point" in said
    # The profile before lies under the new one, until the notice goes or something else is done.
    assert stage.presenter.frame.compared.document is before
    press(stage, Key.Key_Z)
    assert stage.document is before
    assert stage.presenter.frame.compared is None


def test_selected_points_say_which_segments(stage):
    stage.presenter.select(1, 2)
    press(stage, Key.Key_L)
    wait(stage)
    old, new = FIGURE_7.segments, stage.document.profile.segments
    assert [a == b for a, b in zip(old, new, strict=True)] == [True, False, True]
    stage.window.notice_bar.dismiss()
    assert stage.presenter.view.before is None


def test_the_dialog_chooses_what_is_least_and_what_is_kept(stage):
    press(stage, Key.Key_L, Control | Qt.KeyboardModifier.ShiftModifier)
    dialog = stage.window.findChild(FairDialog)
    assert dialog.present.text() == "7.546"
    dialog.energy.setCurrentIndex(dialog.energy.findData(Energy.VARIATION))
    dialog.keeps[Keep.VOLUME].setChecked(True)
    before = stage.document
    QTest.mouseClick(dialog.make_fair, Qt.MouseButton.LeftButton)
    wait(stage)
    wanted = fair(before.surface, Energy.VARIATION, keep=[Keep.VOLUME])
    assert stage.document.profile == wanted.profile
    assert stage.document.volume == pytest.approx(before.volume, rel=1e-9)
    assert dialog.present.text() == f"{wanted.after:.5g}"
    # The key goes on as chosen: nothing is left to do.
    activate(stage.qtbot, dialog)
    QTest.keyClick(dialog, Key.Key_Escape)
    assert not dialog.isVisible()
    activate(stage.qtbot, stage.window)
    press(stage, Key.Key_L)
    wait(stage)
    assert "Nothing fairer" in stage.window.notice_bar.notice.text


def test_what_cannot_be_is_said_in_a_line_and_nothing_changes(stage):
    profile = Profile.of(chain(WAVE).segments, ["G2", "G2"])
    stage.presenter.replace_document(Document(profile))
    before = stage.document
    press(stage, Key.Key_L)
    wait(stage)
    assert stage.document is before
    notice = stage.window.notice_bar.notice
    assert notice.level == "warning"
    assert "G2 at joint" in notice.text
    assert "in the way" in notice.text


def test_a_result_for_an_older_document_is_dropped(stage):
    press(stage, Key.Key_L)
    other = tower()
    stage.presenter.replace_document(other)
    wait(stage)
    assert stage.document is other


def test_what_stays_infinite_or_broken_is_told():
    kinked = [[[1, 0], [2, 0], [3, 1], [3, 2]], [[3, 2], [4, 2], [4, 4], [3, 5]]]
    found = fair(RevolutionSurface(Profile.of(chain(kinked).segments, [JointRule.G1])))
    assert told(found, "mm").endswith("No shape parameter restores the rule of joint 1.")
    apex = [[[0, 0], [1, 1], [2, 1], [3, 2]]]
    found = fair(RevolutionSurface(chain(apex)), Energy.SURFACE)
    assert "stays ∞" in told(found, "mm")
    assert "segment 1, whatever" in told(found, "mm")
