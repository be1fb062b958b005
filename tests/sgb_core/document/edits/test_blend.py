from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.document import edits
from sgb_core.document.edits.blend import blend
from sgb_core.document.errors import EditError
from sgb_core.document.model import Unit
from sgb_core.surfaces.variation import Law
from tests.sgb_core.document import samples

FIRST = samples.document(rules=("G1", "G1"))
BENT = edits.set_shape_parameter(edits.scale(FIRST, 2.0), None, "omega", 0.8)
BENT = edits.set_revolution(BENT, sweep_deg=180.0)


@given(st.floats(0.0, 1.0))
def test_all_numbers_change_in_proportion(share):
    found = blend(FIRST, BENT, share)
    wanted = (1.0 + share) * FIRST.profile.control_points
    np.testing.assert_allclose(found.profile.control_points, wanted, atol=1e-9)
    start = FIRST.profile.segments[0].shape.omega
    omega = start + share * (0.8 - start)
    assert found.profile.segments[0].shape.omega == pytest.approx(omega)
    assert found.revolution.sweep_deg == pytest.approx(360.0 - 180.0 * share)


def test_the_ends_are_the_two_themselves():
    assert blend(FIRST, BENT, 0.0).profile == FIRST.profile
    last = blend(FIRST, BENT, 1.0)
    np.testing.assert_allclose(last.profile.quartics, BENT.profile.quartics, atol=1e-12)


def test_units_are_true_sizes():
    inches = edits.set_unit(BENT, Unit.IN, convert=True)
    one, other = blend(FIRST, inches, 0.5), blend(FIRST, BENT, 0.5)
    np.testing.assert_allclose(one.profile.control_points, other.profile.control_points)


def test_laws_of_one_kind_change_their_values():
    low, high = (Law("omega", "raised-cosine", 0.0, end) for end in (0.4, 1.0))
    one, other = (replace(FIRST, variation=(law,)) for law in (low, high))
    assert blend(one, other, 0.5).variation[0].end == pytest.approx(0.7)
    with pytest.raises(EditError, match="laws"):
        blend(one, FIRST, 0.5)
    with pytest.raises(EditError, match="laws"):
        blend(one, replace(one, variation=(replace(low, kind="cosine"),)), 0.5)


def test_what_is_not_built_alike_is_refused_in_words():
    with pytest.raises(EditError, match="one has 3 segments and the other 4"):
        blend(FIRST, edits.append_segment(FIRST), 0.5)
    with pytest.raises(EditError, match=r"segments|ring"):
        blend(FIRST, edits.close_profile(FIRST), 0.5)
    with pytest.raises(EditError, match="different axes"):
        blend(FIRST, edits.set_revolution(FIRST, axis="x"), 0.5)
