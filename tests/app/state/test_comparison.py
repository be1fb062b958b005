"""What the present document is compared with."""

import pytest

from app.state.presenter import Presenter
from sgb_core.curves.segment import ShapeParameters
from sgb_core.document import edits
from sgb_core.document.edits.compare import plain_cubic
from sgb_core.document.session import Session
from sgb_core.surfaces.variation import Law
from tests.app.helpers import tower

SHAPE = ShapeParameters(2.0, 4.0, 1.0, 0.5)


@pytest.fixture
def presenter(qapp):
    return Presenter(Session(tower(SHAPE)))


def test_nothing_unless_asked(presenter):
    assert presenter.frame.compared is None


def test_the_last_save_stays_while_the_document_moves_on(presenter):
    saved = presenter.document
    presenter.set_view(compare="saved")
    first = presenter.frame.compared
    assert first.document == saved
    presenter.do("ω", lambda d: edits.set_shape_parameter(d, 0, "omega", 1.0))
    assert presenter.frame.compared is first
    presenter.session.mark_saved()
    assert presenter.frame.compared.document == presenter.document


def test_the_last_save_is_seen_in_the_present_unit(presenter):
    presenter.set_view(compare="saved")
    presenter.do("cm", lambda d: edits.set_unit(d, "cm", convert=True))
    compared = presenter.frame.compared.document
    assert compared.profile.size == pytest.approx(presenter.document.profile.size)


def test_a_document_never_saved_has_nothing_to_compare_with(qapp):
    presenter = Presenter(Session(tower(SHAPE), saved=False))
    presenter.set_view(compare="saved")
    assert presenter.frame.compared is None


def test_the_plain_cubic_follows(presenter):
    presenter.do("law", lambda d: edits.add_law(d, Law("omega", "paper", 0.0, 1.0)))
    presenter.set_view(compare="cubic")
    compared = presenter.frame.compared.document
    assert all(s.shape.omega == 0.0 for s in compared.profile.segments)
    assert compared.variation == ()
    presenter.do("move", lambda d: edits.move_point(d, 0, 1, (7.0, 12.5)))
    assert presenter.frame.compared.document == plain_cubic(presenter.document)


def test_a_named_state(presenter):
    presenter.do("keep", lambda d: edits.store_state(d, "A"))
    presenter.do("ω", lambda d: edits.set_shape_parameter(d, 0, "omega", 1.0))
    presenter.set_view(ghost_state="A", compare="cubic")
    compared = presenter.frame.compared
    assert compared.document.profile.segments[0].shape.omega == 0.5
    presenter.set_view(ghost_state="gone")
    assert presenter.frame.compared is None
