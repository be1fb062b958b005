"""The line at the foot of the window takes what room there is, and no more."""

from dataclasses import replace

import pytest
from PySide6.QtWidgets import QApplication, QMainWindow

from app.state.jobs import Job, Jobs
from app.state.presenter import Presenter
from app.theme import theme
from app.window.status_bar import StatusBar
from sgb_core.document import edits
from sgb_core.document.session import Session
from sgb_core.surfaces.variation import Law
from tests.app.helpers import tower


@pytest.fixture
def bar(qtbot):
    theme.apply(QApplication.instance(), "light")
    presenter = Presenter(Session(tower()))
    window = QMainWindow()
    qtbot.addWidget(window)
    bar = StatusBar(presenter, Jobs(window))
    window.setStatusBar(bar)
    window.resize(1000, 200)
    window.show()
    qtbot.waitExposed(window)
    bar.refresh(presenter.frame)
    bar.window_it_is_in = window
    bar.presenter = presenter
    return bar


def labels(bar):
    return [bar._joint, bar._size, bar._volume, bar._verdict]


def test_a_narrow_window_keeps_the_verdict_and_its_width(bar, qtbot):
    window = bar.window_it_is_in
    assert all(label.isVisible() for label in labels(bar))
    window.resize(bar._verdict.width() + 60, 200)
    qtbot.waitUntil(lambda: not bar._joint.isVisible())
    assert window.width() == bar._verdict.width() + 60
    assert bar._verdict.isVisible()
    window.resize(1000, 200)
    qtbot.waitUntil(lambda: all(label.isVisible() for label in labels(bar)))


def test_work_under_way_finds_room_beside_what_is_said(bar, qtbot):
    window = bar.window_it_is_in
    window.resize(sum(label.width() for label in labels(bar)) + 60, 200)
    qtbot.waitUntil(lambda: all(label.isVisible() for label in labels(bar)))
    width = window.width()
    job = Job("Fitting the profile", lambda _: None, lambda _: None, lambda _: None)
    bar._jobs.running.append(job)
    bar._jobs.changed.emit()
    assert bar._cancel.isVisible()
    assert not bar._volume.isVisible()
    QApplication.processEvents()
    assert window.width() == width
    bar._jobs.running.clear()
    bar._jobs.changed.emit()
    assert bar._volume.isVisible()


def test_the_volume_follows_the_hand_but_with_laws_waits_for_it(bar):
    presenter = bar.presenter
    law = Law("lambda2", "cosine", 1.0, 3.0)
    for laws, follows in (((), True), ((law,), False)):
        presenter.do("Laws", lambda d, laws=laws: replace(d, variation=laws))
        bar.refresh(presenter.frame)
        said = bar._volume.text()
        presenter.begin("Scale")
        presenter.apply(lambda d: edits.scale(d, 2.0))
        bar.refresh(presenter.frame)
        assert (bar._volume.text() != said) is follows
        presenter.commit()
        bar.refresh(presenter.frame)
        assert bar._volume.text() != said


def test_a_label_follows_its_text_both_ways(bar):
    label = bar._joint
    label.setText("x")
    narrow = label.width()
    label.setText("a much longer text than there was before")
    assert label.width() > 3 * narrow
    label.setText("x")
    assert label.width() == narrow
