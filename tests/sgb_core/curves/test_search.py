"""Searches on an interval against roots and minima known in closed form."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves.search import least, sign_change

places = st.floats(-1.0, 3.0)


@given(at=places, rises=st.booleans())
def test_a_sign_change_is_found_to_rounding(at: float, rises: bool) -> None:
    way = 1.0 if rises else -1.0
    found = sign_change(lambda u: way * np.sinh(u - at), -1.5, 3.5)
    assert found == pytest.approx(at, abs=4e-15)


@given(at=places, known=places)
def test_the_least_of_one_valley_is_found(at: float, known: float) -> None:
    found = least(lambda x: np.cosh(x - at), -1.5, known, 3.5)
    assert found == pytest.approx(at, abs=1e-6)


def test_the_best_place_known_stays_where_the_search_finds_none_better() -> None:
    def walls(x: float) -> float:
        return 0.0 if x == 0.25 else 1.0 + x

    assert least(walls, 0.0, 0.25, 1.0) == 0.25
