"""Dark parts of pictures as shapes, against the pixels that they come from."""

from __future__ import annotations

import io

import numpy as np
import pytest
import shapely
from PIL import Image

from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.document import edits
from sgb_core.document.appearance.dark_parts import dark_parts
from sgb_core.document.appearance.model import Appearance
from sgb_core.document.appearance.picture_file import Picture, PictureError
from sgb_core.document.edits import EditError
from tests.sgb_core.document import samples

VASE = samples.document()


def picture_of(grey: np.ndarray) -> Picture:
    stream = io.BytesIO()
    Image.fromarray(grey).save(stream, "PNG")
    return Picture(stream.getvalue())


def blots(size: int = 200) -> np.ndarray:
    y, x = np.mgrid[:size, :size] / size
    ring = np.abs(np.hypot(x - 0.3, y - 0.4) - 0.18) < 0.05
    return np.where(ring | ((x > 0.7) & (y > 0.6)), 0, 255).astype(np.uint8)


def test_dark_parts_cover_as_much_as_the_dark_pixels_and_stand_upright() -> None:
    grey = blots()
    own = picture_of(grey)
    shapes = dark_parts(own.name, own, 0.5)
    area = sum(part.area for part in shapes.parts)
    assert area == pytest.approx((grey == 0).mean(), rel=0.01)
    assert len(shapes.parts) == 2
    ring, corner = shapes.parts
    assert len(ring.interiors) == 1
    # Rows of a file run down: what is low in it is low in the shapes.
    assert corner.bounds[1] < 0.02
    assert ring.centroid.y == pytest.approx(0.6, abs=0.01)


def test_grey_is_cut_by_the_threshold_and_what_is_clear_is_light() -> None:
    grey = np.full((50, 50), 100, np.uint8)
    own = picture_of(grey)
    assert dark_parts(own.name, own, 0.3).parts == ()
    (whole,) = dark_parts(own.name, own, 0.5).parts
    # Its level lies within the soft edge of the last pixels.
    assert 0.9 < whole.area <= 1.0
    clear = picture_of(np.zeros((50, 50, 4), np.uint8))
    assert dark_parts(clear.name, clear, 0.5).parts == ()
    with pytest.raises(PictureError):
        dark_parts("nothing", None, 0.5)


def test_shapes_are_made_once_for_a_picture_and_a_threshold() -> None:
    own = picture_of(blots())
    assert dark_parts(own.name, own, 0.5) is dark_parts(own.name, own, 0.5)
    assert all(shapely.is_valid(part) for part in dark_parts(own.name, own, 0.5).parts)


def test_a_picture_stays_as_long_as_holes_name_it() -> None:
    own = picture_of(blots())
    document = edits.cut_out_picture(VASE, own.data)
    (pattern,) = document.cut_outs
    assert (pattern.shape, pattern.picture) == (HoleShape.PICTURE, own.name)
    for change in (
        lambda d: edits.set_appearance(d, material="celadon"),
        lambda d: edits.apply_look(d, {"material": "raku"}),
        lambda d: edits.replace_appearance(d, Appearance()),
        edits.without_paint,
        lambda d: edits.remove_segment(d, 0),
    ):
        assert change(document).appearance.picture(own.name) is not None
    assert edits.remove_cut_out(document, 0).appearance.pictures == ()
    assert edits.set_cut_out(document, picture="lotus").appearance.pictures == ()
    for wrong in (
        lambda: edits.cut_out_picture(document, b"no picture"),
        lambda: edits.cut_out_picture(document, own.data, 2),
        lambda: edits.remove_cut_out(document, 1),
        lambda: edits.set_cut_out(document, 5, rows=2),
        lambda: edits.set_cut_outs(document, [CutOut(picture="0" * 64)]),
    ):
        with pytest.raises(EditError):
            wrong()


def test_what_is_drawn_comes_in_the_number_that_suits_it() -> None:
    circles = edits.set_cut_out(VASE, shape="circle", bridge=1.5)
    text = edits.set_cut_out(circles, shape="text", text="ab")
    assert (text.cut_outs[0].rows, text.cut_outs[0].around) == (1, 2)
    assert text.cut_outs[0].bridge == 1.5
    assert edits.set_cut_out(text, text="cd").cut_outs[0].around == 2
    back = edits.set_cut_out(text, shape="slot").cut_outs[0]
    assert (back.rows, back.around) == (3, 12)
    assert len(edits.set_cut_out(text, 1, shape="slot").cut_outs) == 2
