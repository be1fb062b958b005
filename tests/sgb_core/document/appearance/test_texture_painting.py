import numpy as np
import pytest

import resources
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document.appearance import pictures
from sgb_core.document.appearance.model import (
    Along,
    Appearance,
    Layer,
    LayerKind,
    MaterialName,
    Picture,
    Texture,
)
from sgb_core.document.appearance.pictures import PictureError, encode_png
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.appearance.texture_painting import (
    follows_shape,
    is_painted,
    paint,
    parts_alike,
    sample,
    varies_around,
)
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.uv import uv_map_of

TEXTURES = sorted(path.stem for path in resources.path("textures").glob("*.[pj][np]g"))
RED, BLUE = "#ff0000", "#0000ff"


@pytest.fixture(autouse=True)
def _library():
    pictures.set_library(resources.texture)


def uv_map(*polygons):
    segments = [Segment(points) for points in polygons or [[(2, 0), (2, 2), (2, 4), (2, 6)]]]
    return uv_map_of(RevolutionSurface.of_degrees(Profile.of(segments)), 24)


def drawn(*layers, size=(4, 200), on=None):
    return paint(Appearance(color="#000000", drawing=layers), on or uv_map(), size)


def is_red(picture):
    return picture[:, 0, 0] > 127


@pytest.mark.parametrize("name", TEXTURES)
def test_the_programs_textures_are_small_and_seamless(name):
    data = resources.texture(name)
    assert len(data) <= 120_000
    tile = pictures.decode(data)[..., :3].astype(float)
    assert tile.shape == (512, 512, 3)
    for axis in (0, 1):
        rows = np.moveaxis(tile, axis, 0)
        across = np.abs(rows[0] - rows[-1]).mean()
        steps = np.abs(np.diff(rows, axis=0)).mean(axis=(1, 2))
        # The step over the edge is one like those inside.
        assert across <= np.quantile(steps, 0.99) + 3.0


@pytest.mark.parametrize("degrees", [0.0, 17.0, 45.0, 90.0, -120.0, 180.0])
def test_no_texture_has_a_seam_at_any_angle(degrees):
    appearance = Appearance(textures=(Texture("lotus", repeat=(5.0, 2.0), rotate_deg=degrees),))
    picture = paint(appearance, uv_map(), (1024, 256)).astype(float)
    steps = np.abs(np.diff(picture, axis=1)).mean(axis=(0, 2))
    across = np.abs(picture[:, 0] - picture[:, -1]).mean()
    assert across <= 1.5 * steps.max()


def test_a_texture_repeats_as_often_as_it_is_told_to():
    appearance = Appearance(textures=(Texture("brick", repeat=(4.0, 2.0)),))
    picture = paint(appearance, uv_map(), (1024, 512)).astype(int)
    assert np.abs(picture - np.roll(picture, 256, axis=1)).max() <= 1
    assert np.abs(picture - np.roll(picture, 256, axis=0)).max() <= 1
    shifted = Appearance(textures=(Texture("brick", repeat=(4.0, 2.0), offset=(0.5, 0.0)),))
    moved = paint(shifted, uv_map(), (1024, 512)).astype(int)
    assert np.abs(moved - np.roll(picture, -128, axis=1)).max() <= 2


def test_a_square_tile_stays_square_without_a_repeat_along():
    # A cylinder of radius 2 and height 6: 4π wide.
    appearance = Appearance(textures=(Texture("brick", repeat=(8.0, 0.0)),))
    along = 8.0 * 6.0 / (4.0 * np.pi)
    wanted = Appearance(textures=(Texture("brick", repeat=(8.0, along)),))
    assert np.array_equal(*(paint(each, uv_map(), (512, 256)) for each in (appearance, wanted)))


def test_a_texture_covers_its_segments_alone():
    two = uv_map([(2, 0), (2, 1), (2, 2), (2, 3)], [(2, 3), (2, 4), (2, 5), (2, 6)])
    white = Picture(encode_png(np.full((4, 4, 3), 255, np.uint8)))
    appearance = Appearance(
        color="#000000", textures=(Texture(white.name, (1, 7)),), pictures=(white,)
    )
    picture = paint(appearance, two, (8, 100))
    assert (picture[:50] == 0).all()
    assert (picture[50:] == 255).all()


def test_a_transparent_picture_lets_the_ground_through():
    pixels = np.full((4, 4, 4), (255, 0, 0, 0), np.uint8)
    clear = Picture(encode_png(pixels))
    appearance = Appearance(color=BLUE, textures=(Texture(clear.name),), pictures=(clear,))
    assert (paint(appearance, uv_map(), (8, 8)) == (0, 0, 255)).all()


def test_painting_again_reads_no_file_again():
    read = []

    def library(name):
        read.append(name)
        return resources.texture(name)

    pictures.set_library(library)
    name = TEXTURES[0]
    looks = [Appearance(textures=(Texture(name, (count, 0.0)),)) for count in (2.0, 2.0, 3.0)]
    first, *again = [paint(look, uv_map(), (64, 64)) for look in looks[:2]]
    assert (again[0] == first).all()
    known = len(read)
    paint(looks[0], uv_map([(2, 0), (3, 2), (2, 4), (2, 6)]), (64, 64))
    assert len(read) == known > 0


def test_an_unknown_texture_is_an_error():
    with pytest.raises(PictureError, match="no-such"):
        paint(Appearance(textures=(Texture("no-such"),)), uv_map(), (8, 8))


def test_bands_and_rings_lie_where_their_numbers_say():
    band = is_red(drawn(Layer(LayerKind.BAND, RED, 0.25, 0.5)))
    assert np.flatnonzero(band)[[0, -1]].tolist() == [50, 99]
    rings = is_red(drawn(Layer(LayerKind.RINGS, RED, 0.0, 1.0, count=4, width=0.5)))
    widths = np.diff(np.flatnonzero(np.diff(rings.astype(int))))
    assert len(widths) == 7
    assert np.abs(widths - 25).max() <= 2
    assert abs(rings.sum() - 100) <= 4


def test_height_and_length_differ_on_a_flat_stretch():
    # A flat floor as long as the wall is high: all heights lie in the upper half of the length.
    on = uv_map([(0, 0), (2, 0), (4, 0), (6, 0)], [(6, 0), (6, 2), (6, 4), (6, 6)])
    by_height = is_red(drawn(Layer(LayerKind.BAND, RED, 0.5, 1.0), on=on))
    by_length = is_red(drawn(Layer(LayerKind.BAND, RED, 0.5, 1.0, Along.LENGTH), on=on))
    assert abs(by_height.sum() - 50) <= 1
    assert by_length.sum() == 100


def test_a_gradient_runs_through_its_stops():
    stops = ((0.0, "#000000"), (0.5, RED), (1.0, BLUE))
    picture = drawn(Layer(LayerKind.GRADIENT, stops=stops)).astype(int)
    assert abs(picture[100, 0, 0] - 253) <= 4
    assert abs(picture[50, 0, 0] - 128) <= 3
    assert abs(picture[150, 0, 2] - 128) <= 3


def test_stripes_lean_and_close_around():
    layer = Layer(LayerKind.STRIPES, RED, count=6, width=0.5, twist=0.25)
    picture = drawn(layer, size=(600, 100))[..., 0] > 127
    assert picture.mean() == pytest.approx(0.5, abs=0.01)
    edges = np.count_nonzero(picture[0] != np.roll(picture[0], 1))
    assert edges == 12
    # A quarter turn over the height is one and a half of six stripes.
    assert (picture[0] != picture[-1]).mean() > 0.9


def test_segments_have_colours_of_their_own():
    two = uv_map([(2, 0), (2, 1), (2, 2), (2, 3)], [(2, 3), (2, 4), (2, 5), (2, 6)])
    red = is_red(drawn(Layer(LayerKind.SEGMENTS, RED, segments=(1, 9)), on=two))
    assert red.tolist() == [False] * 100 + [True] * 100


def test_what_needs_a_picture_and_when_it_changes():
    assert not is_painted(Appearance(MaterialName.METAL))
    assert is_painted(Appearance(MaterialName.WOOD))
    fixed = Appearance(textures=(Texture("lotus", repeat=(8.0, 3.0)),))
    assert not follows_shape(fixed)
    assert varies_around(fixed)
    bands = Appearance(drawing=(Layer(LayerKind.BAND),))
    assert follows_shape(bands)
    assert not varies_around(bands)


def test_sampling_takes_the_nearest_pixel():
    picture = np.arange(12, dtype=np.uint8).reshape(2, 2, 3)
    uv = np.array([(0.0, 0.0), (1.0, 1.0), (0.2, 0.9)])
    assert sample(picture, uv)[:, 0].tolist() == [0, 9, 6]


STRIPES = Layer(LayerKind.STRIPES, RED, count=8, twist=0.3)
TEXT = Layer(LayerKind.TEXT, RED, start=0.3, end=0.6, count=4, text="ab", shift=0.1)


@pytest.mark.parametrize(
    ("look", "parts"),
    [
        (Appearance(textures=(Texture("lotus", repeat=(6.0, 2.0)),)), 6),
        (Appearance(textures=(Texture("lotus", repeat=(12.0, 0.0), rotate_deg=45.0),)), 8),
        (Appearance(textures=(Texture("lotus", repeat=(6.0, 2.0)),), drawing=(STRIPES,)), 2),
        (Appearance(drawing=(STRIPES, TEXT, Layer(LayerKind.BAND))), 4),
        (Appearance(drawing=(Layer(LayerKind.BAND),)), 1),
        (Appearance(MaterialName.WOOD), 3),
        (Appearance(textures=(Texture("brick", repeat=(6.0, 2.0), relief=1.0),), paint=False), 6),
        (Appearance(textures=(Texture("brick", repeat=(6.0, 2.0)),), paint=False), 1),
    ],
)
def test_parts_alike_make_up_the_whole_picture(look, parts):
    assert parts_alike(look) == parts
    on = uv_map([(2, 0), (3, 2), (2, 4), (1, 6)])
    whole = paint(look, on, (32 * parts, 90)).astype(int)
    part = paint(look, on, (32, 90), parts).astype(int)
    assert np.abs(np.tile(part, (1, parts, 1)) - whole).max() <= 1
    relief = relief_of(look)
    if relief is not None:
        u, v = (np.arange(32 * parts) + 0.5) / (32 * parts), (np.arange(90) + 0.5) / 90
        heights = relief.heights(on, 6.0, u, v, 0.1)
        found = relief.heights(on, 6.0, u[:32], v, 0.1, parts)
        assert np.allclose(np.tile(found, (1, parts)), heights)
