"""The notice bar says one thing at a time and offers to mend it."""

import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtWidgets import QApplication, QLabel, QPushButton, QWidget

from app.state.presenter import Presenter
from app.window.notice_bar import NoticeBar
from sgb_core.document import edits
from sgb_core.document.session import Session
from tests.app.helpers import tower


@pytest.fixture
def presenter(qtbot):
    return Presenter(Session(tower()))


@pytest.fixture
def bar(qtbot, presenter):
    bar = NoticeBar(presenter)
    qtbot.addWidget(bar)
    return bar


def test_it_is_hidden_until_there_is_something_to_say(bar, presenter):
    assert bar.isHidden()
    presenter.notify("Saved vase.sgb.")
    assert bar.isVisible()
    assert any("Saved vase.sgb." in label.text() for label in bar.findChildren(QLabel))


def test_its_button_mends_and_closes(qtbot, bar, presenter):
    mended = []
    presenter.notify("Could not save.", "error", "Save as…", lambda: mended.append(True))
    button = next(b for b in bar.findChildren(QPushButton) if b.text() == "Save as…")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert mended == [True]
    assert bar.isHidden()


def test_a_notice_goes_with_its_cause_and_not_while_the_hand_moves(bar, presenter):
    low = presenter.document.height
    presenter.notify("Too low", "warning", holds=lambda frame: frame.document.height <= low)
    presenter.refresh_now()
    assert bar.isVisible()
    presenter.begin("Height")
    presenter.apply(lambda document: edits.set_height(document, 2.0 * low))
    presenter.refresh_now()
    assert bar.isVisible()
    presenter.commit()
    presenter.refresh_now()
    assert bar.isHidden()


def test_it_lies_over_its_parent_and_moves_nothing(qtbot, presenter):
    window = QWidget()
    qtbot.addWidget(window)
    window.resize(420, 500)
    below = QLabel("the viewport", window)
    below.setGeometry(0, 0, 420, 500)
    bar = NoticeBar(presenter, window)
    window.show()
    before = below.geometry()
    presenter.notify("A long warning that says what, where and what to do. " * 3, "warning", "Mend")
    assert below.geometry() == before
    for width in (420, 900, 300):
        window.resize(width, 500)
        QApplication.processEvents()
        assert window.rect().contains(bar.geometry())
        text = next(each for each in bar.findChildren(QLabel) if "long warning" in each.text())
        assert text.height() >= text.heightForWidth(text.width())


def test_the_buttons_of_a_narrow_viewport_stay_free(qtbot, presenter):
    window = QWidget()
    qtbot.addWidget(window)
    bar = NoticeBar(presenter, window)
    presenter.notify("Could not open vase.sgb: it is damaged.", "error")
    for width in (268, 420, 900):
        window.resize(width, 500)
        bar.place()
        buttons = QRect(width - 122, 10, 112, 30)
        assert not bar.geometry().intersects(buttons), width
        assert window.rect().contains(bar.geometry()), width


def test_what_the_button_says_next_stays(qtbot, bar, presenter):
    presenter.notify("First", "warning", "Next", lambda: presenter.notify("Second", "warning"))
    button = next(b for b in bar.findChildren(QPushButton) if b.text() == "Next")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert bar.isVisible()
    assert bar.notice.text == "Second"


def test_a_complaint_goes_with_the_document_it_was_about_and_an_offer_stays(bar, presenter):
    presenter.notify("Could not open broken.sgb", "error")
    presenter.refresh_now()
    assert bar.isVisible()
    presenter.replace_document(tower())
    presenter.notify("The new one has a gap", "warning")
    presenter.refresh_now()
    assert bar.notice.text == "The new one has a gap"
    presenter.replace_document(tower())
    presenter.refresh_now()
    assert bar.isHidden()
    # An offer about a document goes with it too; one about the program does not.
    presenter.notify("G1 moved P2", "info", "Undo", lambda: None)
    presenter.replace_document(tower())
    presenter.refresh_now()
    assert bar.isHidden()
    presenter.notify("Work was set aside", "warning", "Restore", lambda: None, stays=True)
    presenter.replace_document(tower())
    presenter.refresh_now()
    assert bar.isVisible()


def test_what_nobody_can_read_yet_does_not_pass(qtbot, presenter):
    window = QWidget()
    qtbot.addWidget(window)
    window.resize(800, 500)
    bar = NoticeBar(presenter, window)
    window.show()
    qtbot.waitExposed(window)
    presenter.notify("Preferences hold until the program ends.")
    over = QWidget(window)
    over.setGeometry(window.rect())
    over.show()
    bar._timer.setInterval(1)
    qtbot.wait(30)
    assert bar.isVisible()
    assert bar.foot > window.mapToGlobal(QPoint(0, 0)).y()
    over.hide()
    qtbot.waitUntil(bar.isHidden)
    assert bar.foot == 0
