"""The plate of curves on one polygon: on its page, nothing over words, numbers as measured."""

from __future__ import annotations

import numpy as np
import pytest

from sgb_core.design.comparison import compared
from sgb_core.drawings.comparison_plate import comparison_plate
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.page import Layer, Words
from tests.sgb_core.drawings.looking import boxes, outside, overlaps
from tests.sgb_core.drawings.shapes import BENT, OTHERS, chain, preset

DOCUMENTS = {
    name: OTHERS[name] for name in ("bent", "plate", "mast", "flat", "speck", "beyond the axis")
} | {name: preset(name) for name in ("ring", "figure-2")}


@pytest.mark.parametrize("name", DOCUMENTS)
def test_it_fits_and_nothing_lies_over_words(name: str) -> None:
    (page,) = comparison_plate(DOCUMENTS[name]).pages
    assert (overlaps(page), outside(page)) == ([], [])
    assert page.width == 175.0


def test_the_words_are_what_is_measured() -> None:
    found = compared(BENT.profile)
    (page,) = comparison_plate(BENT, found).pages
    words = [mark.text for mark in page.marks if isinstance(mark, Words)]
    for each in found:
        assert any(f"{each.energy:.4g}/mm" in word for word in words)
    assert f"up to {found[1].deviation:.3g} mm off" in words
    assert len(boxes(page)) == 4 * 2 + 3


def test_four_panels_at_one_scale() -> None:
    (page,) = comparison_plate(BENT).pages
    wide = [
        np.ptp(np.concatenate([path.flat() for path in mark.paths])[:, 1])
        for mark in page.of_layer(Layer.OUTLINE)
    ]
    assert len(wide) == 4
    # All begin and end at the same points, and this one reaches no farther up or down.
    assert wide == pytest.approx([wide[0]] * 4, rel=1e-9)


def test_a_point_has_no_plate() -> None:
    with pytest.raises(DrawingError, match="single point"):
        comparison_plate(chain((5, 5), (5, 5)))
