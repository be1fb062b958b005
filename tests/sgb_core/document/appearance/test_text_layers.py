"""Text as a layer: painted where its outline lies, raised by its depth."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.appearance.cover import text_line
from sgb_core.document.appearance.model import Along, Appearance, Layer, LayerKind
from sgb_core.document.appearance.texture_painting import paint, varies_around
from sgb_core.document.model import Document
from sgb_core.lettering.outlines import text_letters
from sgb_core.surfaces.uv import uv_map_of

TUBE = Document(Profile.of([line((40.0, 0.0), (40.0, 100.0))]))
LABEL = Layer(LayerKind.TEXT, color="#000000", start=0.3, end=0.5, count=2, text="Rb")


def covered(layer: Layer, document: Document = TUBE, size=(2000, 800)) -> np.ndarray:
    look = Appearance(color="#ffffff", drawing=(layer,))
    picture = paint(look, uv_map_of(document.surface, 64), size)
    return 1.0 - picture[..., 0] / 255.0


def test_as_much_is_painted_as_the_letters_cover() -> None:
    ink = 20.0**2 * sum(letter.area for letter in text_letters(LABEL.text, LABEL.font))
    share = covered(LABEL).mean()
    assert share * 2.0 * np.pi * 40.0 * 100.0 == pytest.approx(2.0 * ink, rel=5e-3)
    assert varies_around(Appearance(drawing=(LABEL,)))


def test_it_stands_on_the_lower_position_and_reads_from_left_to_right() -> None:
    found = covered(LABEL)
    rows = np.flatnonzero(found.max(axis=1) > 0.5)
    # No letter of it goes below the line; the b is as high as its stem.
    assert rows[0] == pytest.approx(0.3 * 800, abs=4.0)
    columns = np.flatnonzero(found[:, :1000].max(axis=0) > 0.5)
    middle = (columns[0] + columns[-1]) / 2.0
    assert middle == pytest.approx(500.0, abs=2.0)
    # The stem of the R is the first of its columns, from the line to the top of capitals.
    stem = found[240:400, columns[0] + 5]
    assert stem.mean() > 0.95


@pytest.mark.parametrize("shift", [0.1, -0.25])
def test_a_shift_moves_it_around(shift: float) -> None:
    moved = covered(Layer(LayerKind.TEXT, color="#000000", start=0.3, end=0.5, shift=shift))
    still = covered(Layer(LayerKind.TEXT, color="#000000", start=0.3, end=0.5))
    assert np.abs(np.roll(still, round(2000 * shift), axis=1) - moved).max() < 0.05


def test_by_length_it_stands_upright_on_a_profile_drawn_downwards() -> None:
    falling = Document(Profile.of([line((40.0, 100.0), (40.0, 0.0))]))
    layer = Layer(
        LayerKind.TEXT, color="#000000", start=0.5, end=0.7, count=2, text="Rb", by=Along.LENGTH
    )
    # Its rows count from the other end.
    assert np.abs(covered(layer, falling)[::-1] - covered(LABEL)).max() < 0.05


def test_letters_keep_their_proportions_where_the_wall_leans() -> None:
    cone = Document(Profile.of([line((20.0, 0.0), (60.0, 80.0))]))
    layer = Layer(LayerKind.TEXT, start=0.4, end=0.6)
    lying = text_line(layer, uv_map_of(cone.surface, 64))
    assert lying is not None
    assert lying.height == pytest.approx(0.2 * np.hypot(40.0, 80.0), rel=0.01)
    assert lying.around == pytest.approx(2.0 * np.pi * 40.0, rel=0.02)
    flat = Document(Profile.of([line((20.0, 0.0), (60.0, 0.0))]))
    assert text_line(layer, uv_map_of(flat.surface, 64)) is None
    assert covered(layer, flat).max() == 0.0
    assert covered(Layer(LayerKind.TEXT, start=0.4, end=0.4)).max() == 0.0
    assert covered(Layer(LayerKind.TEXT, text="   ")).max() == 0.0


def test_raised_letters_stand_by_their_depth_with_the_volume_of_their_outline() -> None:
    look = edits.set_appearance(TUBE, drawing=(LABEL,))
    raised = edits.set_relief(look, "layer", 0, depth=1.5, edge=1.5)
    mesh = raised.body().mesh(tolerance=0.3)
    radius = np.hypot(mesh.positions[:, 0], mesh.positions[:, 1])
    assert radius.max() == pytest.approx(41.5, abs=0.16)
    assert radius.min() == pytest.approx(40.0, abs=0.16)
    letters = text_letters(LABEL.text, LABEL.font)
    ink = 20.0**2 * shapely.union_all(letters).area
    # Soft edges lie half inside and half outside of the outline.
    added = 2.0 * ink * (41.5**2 - 40.0**2) / 80.0
    assert raised.body().worked.added == pytest.approx(added, rel=0.05)
    plain = edits.without_paint(raised)
    assert plain.appearance.drawing == raised.appearance.drawing
    assert np.array_equal(plain.body().mesh(tolerance=0.3).positions, mesh.positions)
    assert covered_by(plain) == 0.0


def covered_by(document: Document) -> float:
    look = document.appearance
    picture = paint(look, uv_map_of(document.surface, 64), (200, 80))
    return float(np.ptp(picture.astype(float), axis=(0, 1)).max())
