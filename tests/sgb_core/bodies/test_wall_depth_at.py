"""The wall at one place is that of the whole profile's wall there."""

import numpy as np
import pytest

import sgb_core as sgb
from sgb_core.bodies.wall_depth import wall_depth_at, wall_depths
from sgb_core.surfaces.laws.law import Law
from tests.sgb_core.design.locks.samples import pot, wavy


@pytest.mark.parametrize("place", [(0, 0.0), (1, 0.37), (2, 1.0)])
def test_it_is_what_all_depths_say(place):
    document = pot(3)
    segment, s = place
    found = wall_depth_at(document.surface, document.solid, segment, s)
    every = wall_depths(document.surface, document.solid, np.array([s]), 1).reshape(-1)
    assert found == pytest.approx(float(every[segment]), abs=1e-12)


def test_in_the_middle_of_a_wall_it_is_the_wall_and_without_a_body_nothing():
    document = pot(3)
    assert wall_depth_at(document.surface, document.solid, 1, 0.5) == 3.0
    bare = sgb.Document(wavy(3))
    assert wall_depth_at(bare.surface, bare.solid, 1, 0.5) is None


def test_with_laws_it_is_that_of_the_section_at_the_start():
    document = sgb.edits.add_law(pot(3), Law("omega", "raised-cosine", 0.0, 1.0))
    assert wall_depth_at(document.surface, document.solid, 1, 0.5) == pytest.approx(3.0)
