"""The body as the window needs it, and the size at which it holds what is asked."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.body_measures import mass_in_grams
from sgb_core.document.body_state import body_state
from sgb_core.document.edits import EditError
from sgb_core.document.edits.targets import Stretch, held_volume, hold
from sgb_core.document.model import Document
from sgb_core.findings.words import say
from sgb_core.surfaces.variation import Law


def cup(**solid: object) -> Document:
    """Return a straight cup: radius 20, height 60, wall 3, base 4."""
    wall = Segment(np.linspace((20.0, 0.0), (20.0, 60.0), 4))
    changes = {"kind": "vessel", "wall": 3.0, "base": 4.0, **solid}
    return edits.set_solid(Document(Profile.of([wall])), **changes)


def test_a_straight_cup_holds_and_weighs_its_closed_forms() -> None:
    document = edits.set_fill(cup(), 32.0)
    state = body_state(document, document.surface, fine=True)
    assert state.error is None
    assert state.mesh is not None
    assert state.mesh.is_watertight
    assert state.measures is not None
    material = pi * (20.0**2 * 60.0 - 17.0**2 * 56.0)
    assert state.measures.vessel.capacity == pytest.approx(pi * 17.0**2 * 56.0, rel=1e-9)
    assert state.measures.vessel.material_volume == pytest.approx(material, rel=1e-9)
    assert state.measures.filled == pytest.approx(pi * 17.0**2 * 28.0, rel=1e-9)
    assert state.measures.diameter == pytest.approx(40.0, rel=1e-12)
    assert mass_in_grams(document, material) == pytest.approx(material / 1000.0 * 1.9)


def test_the_liquid_is_closed_and_as_high_as_its_line() -> None:
    document = edits.set_fill(cup(), 32.0)
    state = body_state(document, document.surface, fine=True)
    assert state.liquid is not None
    assert state.liquid.is_watertight
    assert state.liquid.bounds[1][2] == pytest.approx(32.0)
    assert state.liquid.volume == pytest.approx(pi * 17.0**2 * 28.0, rel=1e-3)
    (loop,) = state.liquid_section
    np.testing.assert_allclose(loop.max(axis=0), (17.0, 32.0))


def test_coarse_bodies_are_measured_as_well_unless_laws_make_it_slow() -> None:
    document = cup()
    coarse, fine = (body_state(document, document.surface, fine=each) for each in (False, True))
    assert len(coarse.mesh.triangles) < len(fine.mesh.triangles)
    assert coarse.measures.vessel == fine.measures.vessel
    assert coarse.liquid is None
    waved = edits.set_variation(document, (Law("omega", "cosine", 0.0, 1.0, count=2),))
    assert body_state(waved, waved.surface, fine=False).measures is None


def test_what_cannot_be_made_is_one_line() -> None:
    document = cup(wall=25.0)
    state = body_state(document, document.surface, fine=True)
    assert state.mesh is None
    (finding,) = state.findings
    assert "25" in say(finding)


def test_a_bare_surface_has_no_body() -> None:
    document = cup(kind="surface")
    state = body_state(document, document.surface, fine=True)
    assert state.mesh is None
    assert state.findings == ()


@pytest.mark.parametrize("stretch", list(Stretch))
@pytest.mark.parametrize("line", [None, 45.0])
def test_it_holds_what_is_asked(stretch: Stretch, line: float | None) -> None:
    document = edits.set_fill(cup(), line)
    found = hold(document, 350_000.0, stretch)
    assert held_volume(found) == pytest.approx(350_000.0, rel=1e-9)
    assert found.solid == document.solid
    low, high = found.profile.bounds()
    if stretch is Stretch.HEIGHT:
        assert high[0] == pytest.approx(20.0)
    if stretch is Stretch.RADIUS:
        assert high[1] - low[1] == pytest.approx(60.0)


def test_what_no_size_holds_is_said() -> None:
    with pytest.raises(EditError, match="allowed is a number above 0"):
        hold(cup(), 0.0)
    with pytest.raises(EditError):
        hold(cup(), 1e300)
