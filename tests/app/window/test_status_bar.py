"""The line at the foot of the window takes what room there is, and no more."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication, QMainWindow

from app.state.jobs import Job, Jobs
from app.state.presenter import Presenter
from app.theme import theme
from app.window.status_bar import StatusBar
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.body_state import body_state
from sgb_core.document.model import Document
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
    assert not bar._size.isVisible()
    QApplication.processEvents()
    assert window.width() == width
    bar._jobs.running.clear()
    bar._jobs.changed.emit()
    assert bar._size.isVisible()


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


def test_a_vessel_says_what_it_holds_and_never_its_outside(bar):
    presenter = bar.presenter
    cup = edits.set_solid(
        Document(Profile.of([line((40, 0), (40, 80))])), kind="vessel", wall=4, base=5
    )
    presenter.replace_document(edits.set_fill(cup, below_rim=10.0))
    bar.refresh(presenter.frame)
    assert bar._volume.text() == ""
    presenter.set_body(body_state(presenter.document, presenter.document.surface, fine=True))
    bar.refresh(presenter.frame)
    # π·36²·65 and π·36²·75 mm³.
    assert bar._volume.text() == "Holds 265 ml to the line · 305 ml to the brim"
    presenter.do("No line", edits.set_fill)
    presenter.set_body(body_state(presenter.document, presenter.document.surface, fine=True))
    QSettings().setValue("measures/liquid", "fl oz")
    bar.refresh(presenter.frame)
    assert bar._volume.text() == "Holds 10.3 fl oz to the brim"
    QSettings().setValue("measures/liquid", "")
    presenter.do("Large", lambda document: edits.scale(document, 3.0))
    presenter.set_body(body_state(presenter.document, presenter.document.surface, fine=True))
    bar.refresh(presenter.frame)
    assert bar._volume.text() == "Holds 9.93 l to the brim"
    presenter.do("Filled", lambda document: edits.set_solid(document, kind="filled"))
    bar.refresh(presenter.frame)
    assert bar._volume.text() == "Solid, …"
    presenter.do("Bare", lambda document: edits.set_solid(document, kind="surface"))
    presenter.set_body(None)
    bar.refresh(presenter.frame)
    assert bar._volume.text() == "Encloses 10.9 l"


def test_at_rest_no_volume_is_shown_of_what_was_there_before(bar):
    presenter = bar.presenter
    cup = edits.set_solid(
        Document(Profile.of([line((40, 0), (40, 80))])), kind="vessel", wall=4, base=5
    )
    presenter.replace_document(cup)
    presenter.set_body(body_state(cup, cup.surface, fine=True))
    bar.refresh(presenter.frame)
    said = bar._volume.text()
    assert said == "Holds 305 ml to the brim"
    # Under the hand the number follows as soon as it can, and does not flicker.
    presenter.begin("Scale")
    presenter.apply(lambda d: edits.scale(d, 2.0))
    bar.refresh(presenter.frame)
    assert bar._volume.text() == said
    presenter.commit()
    bar.refresh(presenter.frame)
    assert bar._volume.text() == "Holds …"
    presenter.set_body(body_state(presenter.document, presenter.document.surface, fine=True))
    bar.refresh(presenter.frame)
    assert bar._volume.text() == "Holds 2.81 l to the brim"


def test_a_label_follows_its_text_both_ways(bar):
    label = bar._joint
    label.setText("x")
    narrow = label.width()
    label.setText("a much longer text than there was before")
    assert label.width() > 3 * narrow
    label.setText("x")
    assert label.width() == narrow


def test_the_diameter_is_that_of_the_whole_turn_under_a_law_of_the_radius(bar):
    presenter = bar.presenter
    cup = Document(Profile.of([line((40, 0), (40, 80))]))
    law = Law("radius", "lobes", 1.0, 1.25, count=8)
    presenter.replace_document(replace(cup, variation=(law,)))
    bar.refresh(presenter.frame)
    assert bar._size.text() == "Height 80 mm · ⌀ 100 mm"
    # While the hand moves, what is dear waits; then it is told.
    presenter.begin("Radius")
    presenter.apply(lambda d: replace(d, variation=(replace(law, end=1.5),)))
    bar.refresh(presenter.frame)
    assert bar._size.text() == "Height 80 mm · ⌀ 100 mm"
    presenter.commit()
    bar.refresh(presenter.frame)
    assert bar._size.text() == "Height 80 mm · ⌀ 120 mm"


@pytest.mark.parametrize(
    ("solid", "said"),
    [
        ({"wall": 4, "rim": "flat"}, "Height 80 mm · ⌀ 120 mm"),
        ({"wall": 4, "side": "outside", "base": 5}, "Height 85 mm · ⌀ 128.2 mm"),
        ({"wall": 4, "foot_ring": 6}, "Height 86 mm · ⌀ 120 mm"),
    ],
)
def test_the_size_of_a_body_is_that_with_which_it_leaves(bar, solid, said):
    presenter = bar.presenter
    cone = Document(Profile.of([line((40, 0), (60, 80))]))
    presenter.replace_document(edits.set_solid(cone, kind="vessel", **solid))
    document = presenter.document
    presenter.set_body(body_state(document, document.surface, fine=True))
    bar.refresh(presenter.frame)
    assert bar._size.text() == said


def test_a_round_rim_takes_from_the_diameter_that_is_told(bar):
    presenter = bar.presenter
    cone = Document(Profile.of([line((40, 0), (60, 80))]))
    presenter.replace_document(edits.set_solid(cone, kind="vessel", wall=4, rim="round"))
    document = presenter.document
    # At rest nothing is told of another body, nor of one that is not made yet.
    bar.refresh(presenter.frame)
    assert bar._size.text() == "Height … · ⌀ …"
    presenter.set_body(body_state(cone, cone.surface, fine=True))
    bar.refresh(presenter.frame)
    assert bar._size.text() == "Height … · ⌀ …"
    made = body_state(document, document.surface, fine=True)
    presenter.set_body(made)
    bar.refresh(presenter.frame)
    low, high = made.mesh.bounds
    told = float(bar._size.text().split("⌀ ")[1].removesuffix(" mm"))
    assert told == pytest.approx(high[0] - low[0], abs=0.05)
    assert told < 119.5


def test_where_no_body_can_be_made_the_size_is_that_of_the_line(bar):
    presenter = bar.presenter
    tube = Document(Profile.of([line((40, 0), (40, 80))]))
    presenter.replace_document(edits.set_solid(tube, kind="vessel", wall=50))
    document = presenter.document
    presenter.set_body(body_state(document, document.surface, fine=True))
    bar.refresh(presenter.frame)
    assert bar._size.text() == "Height 80 mm · ⌀ 80 mm"
