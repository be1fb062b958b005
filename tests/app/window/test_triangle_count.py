"""The status bar tells how many triangles an export would write now."""

from time import sleep

import pytest
from PySide6.QtWidgets import QApplication

from app.state.jobs import Job, Jobs
from app.state.presenter import Presenter
from app.theme import theme
from app.window.status_bar import StatusBar
from sgb_core.bodies.solid import BodyKind
from sgb_core.document import edits
from sgb_core.document.body_state import body_state
from sgb_core.document.session import Session
from sgb_core.exchange.body import exported_mesh
from tests.app.helpers import tower
from tests.app.window_stage import WindowStage


def wanted(document):
    count = len(exported_mesh(document).triangles)
    return f"{count:,} triangles".replace(",", "\u2009")


@pytest.fixture
def bar(qtbot):
    theme.apply(QApplication.instance(), "light")
    presenter = Presenter(Session(tower()))
    bar = StatusBar(presenter, Jobs())
    qtbot.addWidget(bar)
    presenter.add_view(bar)
    presenter.refresh_now()
    bar.presenter = presenter
    return bar


def test_triangles_follow_the_document_once_the_hand_rests(bar, qtbot):
    presenter = bar.presenter
    qtbot.waitUntil(lambda: bar._triangles.text() == wanted(presenter.document))
    first = bar._triangles.text()
    presenter.begin("Taper")
    presenter.apply(lambda d: edits.set_shape_parameter(d, 0, "omega", 1.0))
    presenter.refresh_now()
    assert bar._triangles.text() == first
    presenter.apply(lambda d: edits.set_revolution(d, sweep_deg=90.0))
    presenter.commit()
    qtbot.waitUntil(lambda: bar._triangles.text() == wanted(presenter.document))
    assert bar._triangles.text() != first


def test_of_a_body_the_shown_mesh_is_counted(bar, qtbot):
    presenter = bar.presenter
    presenter.do("Filled", lambda d: edits.set_solid(d, kind=BodyKind.FILLED))
    presenter.refresh_now()
    assert bar._triangles.text() == ""
    state = body_state(presenter.document, presenter.frame.evaluation.surface, fine=False)
    presenter.set_body(state)
    presenter.refresh_now()
    assert bar._triangles.text().replace("\u2009", "") == f"{len(state.mesh.triangles)} triangles"
    presenter.do("Surface", lambda d: edits.set_solid(d, kind=BodyKind.SURFACE))
    qtbot.waitUntil(lambda: bar._triangles.text() == wanted(presenter.document))


def test_a_window_that_closes_waits_for_every_piece_of_work(qtbot):
    """Whoever keeps jobs of its own: their pool may not be deleted while a thread wants Python."""
    stage, ended = WindowStage(qtbot), []

    def work(_report):
        sleep(0.2)
        ended.append(True)

    keepers = stage.window.findChildren(Jobs)
    assert len(keepers) >= 2
    for jobs in keepers:
        jobs.start(Job("", work, lambda _: None, lambda _: None))
    stage.close()
    assert len(ended) == len(keepers)
