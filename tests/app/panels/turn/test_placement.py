"""Rotation and translation: fields, one undo entry each, and what follows from them."""

import numpy as np
import pytest

from app.panels.turn.placement import PlaceSection
from app.state.presenter import Presenter
from sgb_core.document import edits
from sgb_core.document.file.project_file import dumps, loads
from sgb_core.document.session import Session
from sgb_core.surfaces.measures import bounds, centroid, volume
from sgb_core.surfaces.tessellation import tessellate
from tests.app.helpers import tower
from tests.app.waiting import let_turn, show


@pytest.fixture
def place(qtbot):
    presenter = Presenter(Session(tower()))
    section = PlaceSection(presenter)
    presenter.add_view(section)
    show(qtbot, section)
    section.session, section.presenter = presenter.session, presenter
    return section


def test_a_number_moves_the_object_as_one_step_and_home_brings_it_back(place):
    before = place.session.document
    assert not place.home.isEnabled()
    place.fields["translation", 2].enter(12.5)
    place.fields["rotation_deg", 0].enter(90.0)
    let_turn()
    placement = place.session.document.placement
    assert placement.translation == (0.0, 0.0, 12.5)
    assert placement.rotation_deg == (90.0, 0.0, 0.0)
    assert place.session.undo_label == "Rotate about x"
    assert loads(dumps(place.session.document)) == place.session.document
    place.home.click()
    assert place.session.document.placement == before.placement
    place.presenter.undo()
    place.presenter.undo()
    place.presenter.undo()
    assert place.session.document is before


def test_a_number_out_of_range_is_refused_and_the_field_shows_the_document(place):
    place.fields["translation", 0].enter(1e12)
    let_turn()
    assert place.session.document.placement.translation == (0.0, 0.0, 0.0)
    assert place.fields["translation", 0].value == 0.0


def test_measures_and_meshes_stand_where_the_object_stands():
    still = edits.set_revolution(tower(), sweep_deg=200.0)
    moved = edits.set_placement(still, rotation_deg=(90, 0, 45), translation=(5, -3, 11))
    rotation, shift = moved.placement.matrix, np.array(moved.placement.translation)
    assert centroid(moved.surface) == pytest.approx(rotation @ centroid(still.surface) + shift)
    assert volume(moved.surface) == pytest.approx(volume(still.surface))
    mesh = tessellate(moved.surface, samples=(40, 120))
    plain = tessellate(still.surface, samples=(40, 120))
    assert mesh.positions == pytest.approx(plain.positions @ rotation.T + shift)
    low, high = bounds(moved.surface)
    assert low == pytest.approx(mesh.positions.min(axis=0), abs=0.02)
    assert high == pytest.approx(mesh.positions.max(axis=0), abs=0.02)
