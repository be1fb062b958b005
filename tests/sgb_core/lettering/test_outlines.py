"""Letters against another reader of the same fonts, and distances against exact ones."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from sgb_core.lettering.distances import REACH, text_distances
from sgb_core.lettering.fonts import TITLES, FontName, font_path
from sgb_core.lettering.outlines import CHORD, text_letters

LETTERS = "HOg&@8ÄŒé%Жß"


@pytest.mark.parametrize("font", FontName)
def test_letters_are_those_that_another_reader_draws(font: FontName) -> None:
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextPath

    drawn = TextPath((0.0, 0.0), LETTERS, size=100.0, prop=FontProperties(fname=font_path(font)))
    rings = [ring for ring in drawn.to_polygons(closed_only=True) if len(ring) > 3]
    # Ink and what it leaves out run opposite ways, so the signed areas add up.
    area = abs(sum(signed_area(ring) for ring in rings))
    high = TextPath((0.0, 0.0), "H", size=100.0, prop=FontProperties(fname=font_path(font)))
    capital = float(high.get_extents().height)
    ours = sum(letter.area for letter in text_letters(LETTERS, font))
    assert ours == pytest.approx(area / capital**2, rel=5e-3)
    assert all(letter.is_valid for letter in text_letters(LETTERS, font))


def signed_area(ring) -> float:
    x, y = np.asarray(ring).T
    return 0.5 * float((x[:-1] * y[1:] - x[1:] * y[:-1]).sum())


def test_capitals_are_one_high_and_letters_follow_each_other() -> None:
    first, second = text_letters("HI", FontName.SANS)
    assert first.bounds[1] == 0.0
    assert first.bounds[3] == 1.0
    assert second.bounds[0] > first.bounds[2]
    assert len(text_letters("H I", FontName.SANS)) == 2
    assert text_letters("   ", FontName.SANS) == ()


def test_an_o_leaves_its_island_out_and_a_font_has_a_title() -> None:
    (letter,) = text_letters("O", FontName.SERIF_BOLD)
    assert len(letter.interiors) == 1
    assert set(TITLES) == set(FontName)
    # What a font has no letter for is its sign for that.
    assert text_letters("\U0001f600", FontName.SANS)[0].area > 0.0


def test_distances_are_those_from_the_outline() -> None:
    text, font = "Ag%", FontName.SERIF
    distances = text_distances(text, font)
    assert distances is not None
    shape = shapely.union_all(text_letters(text, font))
    generator = np.random.default_rng(7)
    left, below, right, above = shape.bounds
    x = generator.uniform(left - 0.2, right + 0.2, 3000)
    y = generator.uniform(below - 0.2, above + 0.2, 3000)
    away = shapely.distance(shape.boundary, shapely.points(x, y))
    exact = np.where(shapely.contains_xy(shape, x, y), away, -away)
    off = np.abs(distances.at(x, y) - np.maximum(exact, -REACH))
    # Samples lie a 48th of a capital apart; only at corners and midlines does it show.
    assert off.max() < 1.0 / 48.0
    assert np.median(off) < 2.0 * CHORD
    assert distances.at(np.array([50.0]), np.array([0.5]))[0] == -REACH
    assert distances.middle == pytest.approx((left + right) / 2.0)
    assert text_distances("  ", font) is None
