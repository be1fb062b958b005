"""A texture's tiles: where they lie, and that they move with what is dragged."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import resources
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document.appearance import pictures
from sgb_core.document.appearance.model import MAX_REPEATS, Appearance, Texture
from sgb_core.document.appearance.texture_painting import paint
from sgb_core.document.appearance.tiling import tilings
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.uv import uv_map_of

TILE = sorted(path.stem for path in resources.path("textures").glob("*.[pj][np]g"))[0]
PIPE = [[(2, 0), (2, 2), (2, 4), (2, 6)], [(2, 6), (2, 8), (2, 10), (2, 12)]]
SHARES = st.floats(-2.0, 2.0)


def uv_map(segments=PIPE, *, falls=False):
    profile = Profile.of([Segment(points) for points in segments])
    profile = profile.reversed() if falls else profile
    return uv_map_of(RevolutionSurface.of_degrees(profile), 24)


def tiles(tiling, u, v):
    """The place (x, y) counted in tiles, by the formula."""
    w = float(tiling.upwards(np.array(v)))
    return np.array(tiling.around) * u + np.array(tiling.along) * w + tiling.offset


@given(SHARES, SHARES, st.sampled_from((0.0, 90.0, 180.0, 30.0, -77.0)), st.booleans())
def test_what_is_dragged_goes_along(du, dv, turn, falls):
    on = uv_map(falls=falls)
    texture = Texture(TILE, repeat=(5.0, 3.0), offset=(0.3, -0.2), rotate_deg=turn)
    (before,) = tilings(texture, 0.7, on)
    (after,) = tilings(before.moved(texture, du, dv), 0.7, on)
    assert tiles(after, 0.4 + du, 0.2 + dv) == pytest.approx(tiles(before, 0.4, 0.2), abs=1e-9)


@given(st.floats(0.0, 1.0), st.sampled_from((0.0, 90.0, 30.0)), st.booleans())
def test_the_centre_is_the_middle_of_a_tile_near_by(u, turn, falls):
    (tiling,) = tilings(Texture(TILE, repeat=(8.0, 6.0), rotate_deg=turn), 1.0, uv_map(falls=falls))
    around, v = tiling.centre(u)
    assert tiles(tiling, around, v) % 1.0 == pytest.approx((0.5, 0.5), abs=1e-9)
    assert abs(around - u) < 1.0 / 8.0 + 1e-9


def test_a_tile_taller_than_what_it_covers_is_held_inside():
    on = uv_map()
    (tiling,) = tilings(Texture(TILE, segments=(1,), repeat=(1.0, 0.1)), 1.0, on)
    assert (tiling.low, tiling.high) == pytest.approx((0.5, 1.0))
    _, v = tiling.centre(0.3)
    assert tiling.low < v < tiling.high


def test_offsets_stay_in_their_range():
    texture = Texture(TILE, repeat=(900.0, 1.0), offset=(-900.0, 0.0))
    (tiling,) = tilings(texture, 1.0, uv_map())
    moved = tiling.moved(texture, 0.75, 0.0)
    assert abs(moved.offset[0]) < MAX_REPEATS
    assert moved.offset[0] % 1.0 == pytest.approx((-900.0 - 675.0) % 1.0)


def test_the_painted_picture_moves_as_told():
    pictures.set_library(resources.texture)
    on, size = uv_map(), (160, 120)
    texture = Texture(TILE, repeat=(4.0, 3.0))
    (tiling,) = tilings(texture, 1.0, on)
    moved = tiling.moved(texture, 10 / size[0], 7 / size[1])
    before, after = (paint(Appearance(textures=(each,)), on, size) for each in (texture, moved))
    assert not np.array_equal(before, after)
    inside = after[7:, 10:].astype(int) - before[:-7, :-10]
    assert np.abs(inside).max() <= 1
