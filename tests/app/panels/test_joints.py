"""The list of joints: the worst first, and a click goes there."""

from itertools import pairwise

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.panels.joints import EMPTY, JointsPanel
from app.state.presenter import Presenter
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document.model import Document
from sgb_core.document.session import Session
from tests.app.waiting import show

ENDS = ((20, 0), (20, 30), (21, 60), (50, 80), (50, 110))
CHAIN = Document(Profile.of([line(a, b) for a, b in pairwise(ENDS)]))


@pytest.fixture
def presenter(qtbot):
    return Presenter(Session(CHAIN))


@pytest.fixture
def panel(qtbot, presenter):
    panel = JointsPanel(presenter)
    presenter.add_view(panel)
    show(qtbot, panel, 260, 200)
    presenter.refresh_now()
    return panel


def rows(panel):
    return [panel.list.item(k).text() for k in range(panel.list.count())]


def test_the_worst_comes_first_and_a_click_goes_there(panel, presenter):
    kinks = [float(row.split("kink ")[1].removesuffix("°")) for row in rows(panel)]
    assert kinks == sorted(kinks, reverse=True)
    assert [row.split()[0] for row in rows(panel)] == ["3–4", "2–3", "1–2"]
    at = panel.list.visualItemRect(panel.list.item(1)).center()
    QTest.mouseClick(panel.list.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert presenter.view.points == {(1, 3)}
    QTest.keyClick(panel.list, Qt.Key.Key_Down)
    assert presenter.view.points == {(0, 3)}


def test_one_segment_says_what_to_do_first(panel, presenter):
    assert not panel.empty.isVisible()
    presenter.replace_document(Document(Profile.of([line((20, 0), (20, 30))])))
    presenter.refresh_now()
    assert panel.empty.isVisible()
    assert panel.empty.label.text() == EMPTY
    assert rows(panel) == []
