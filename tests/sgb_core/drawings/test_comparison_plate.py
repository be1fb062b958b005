"""The plate of curves: on its page, nothing over words, numbers as measured."""

from __future__ import annotations

import numpy as np
import pytest

import sgb_core as sgb
from sgb_core.design.comparison import Kind
from sgb_core.drawings.comparison_plate import all_curves, comparison_plate
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
    found = all_curves(BENT)
    (page,) = comparison_plate(BENT, found).pages
    words = [mark.text for mark in page.marks if isinstance(mark, Words)]
    for each in found:
        assert any(f"{each.energy:.4g}/mm" in word for word in words)
    assert f"up to {found[1].deviation:.3g} mm off" in words
    assert len(boxes(page)) == 8 * 2 + 7


def test_all_panels_have_one_scale() -> None:
    (page,) = comparison_plate(BENT).pages
    wide = [
        np.ptp(np.concatenate([path.flat() for path in mark.paths])[:, 1])
        for mark in page.of_layer(Layer.OUTLINE)
    ]
    assert len(wide) == len(Kind)
    # All begin and end at the same points, and this one reaches no farther up or down.
    assert wide[:4] == pytest.approx([wide[0]] * 4, rel=1e-9)


def test_what_such_a_curve_cannot_keep_is_said() -> None:
    straight = sgb.line((1, -3), (1, 0))
    across = sgb.Segment([(1, 0), (1, 1), (2, 2), (2, 3)], sgb.ShapeParameters(1, 6, 1, 1))
    drawing = comparison_plate(sgb.Document(sgb.Profile.of([straight, across], ["G2"])))
    words = [mark.text for mark in drawing.pages[0].marks if isinstance(mark, Words)]
    assert words[words.index("g best plain cubic") + 1] == "cannot keep"
    assert "best plain cubic: G2 at joint 0 is in the way" in drawing.subject


def test_a_point_has_no_plate() -> None:
    with pytest.raises(DrawingError, match="single point"):
        comparison_plate(chain((5, 5), (5, 5)))
