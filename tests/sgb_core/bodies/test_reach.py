"""How far sections reach: closed forms, and never less than a fine mesh of the body."""

from math import cos, pi, sin

import numpy as np
import pytest

from sgb_core.bodies.body_mesh import body_mesh
from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.outline import Arc, Role
from sgb_core.bodies.reach import outline_reach
from sgb_core.bodies.region import Outline
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.model import Document


def test_a_circle_is_reached_at_its_own_places() -> None:
    circle = Arc(Role.RIM, centre=(10.0, 5.0), radius=3.0, low=0.3, high=0.3 + 2.0 * pi)
    low, high, widest = outline_reach([Outline((circle,))])
    assert (low, high, widest) == pytest.approx((2.0, 8.0, 13.0), abs=1e-12)
    part = Arc(Role.RIM, centre=(0.0, 0.0), radius=2.0, low=0.2, high=1.0)
    assert outline_reach([Outline((part,))]) == pytest.approx(
        (2.0 * sin(0.2), 2.0 * sin(1.0), 2.0 * cos(0.2))
    )


@pytest.mark.parametrize("solid", [{"kind": "filled"}, {"wall": 2}, {"wall": 3, "side": "outside"}])
@pytest.mark.parametrize("rim", ["flat", "round"])
def test_it_is_what_a_fine_mesh_comes_near_to_from_inside(solid, rim) -> None:
    belly = Segment([(20, 0), (62, 12), (48, 61), (25, 90)])
    pot = edits.set_solid(Document(Profile.of([belly])), **{"kind": "vessel", "rim": rim, **solid})
    low, high, widest = outline_reach(cross_section(pot.surface, pot.solid).outlines)
    mesh = body_mesh(pot.surface, pot.solid, samples=(400, 32))
    radii = np.hypot(mesh.positions[:, 0], mesh.positions[:, 1])
    assert widest - 2e-3 <= radii.max() <= widest + 1e-9
    assert mesh.positions[:, 2].min() == pytest.approx(low, abs=2e-3)
    assert mesh.positions[:, 2].max() == pytest.approx(high, abs=2e-3)
