from dataclasses import replace

import numpy as np
import pytest

import resources
from sgb_core.document import edits
from sgb_core.document.appearance import pictures
from sgb_core.document.appearance.model import (
    Along,
    Appearance,
    ColourMap,
    Layer,
    LayerKind,
    MapKind,
    Texture,
)
from sgb_core.document.appearance.pictures import encode_png
from sgb_core.document.appearance.texture_painting import paint
from sgb_core.document.file.project_file import dumps, loads
from sgb_core.surfaces.uv import uv_map_of
from tests.sgb_core.document import samples

PAINTED = Appearance(
    textures=(Texture("wood", segments=(1,)), Texture("lotus"), Texture("brick", segments=(0, 2))),
    drawing=(Layer(LayerKind.SEGMENTS, segments=(2,)), Layer(LayerKind.RINGS)),
    map=ColourMap(MapKind.INFLUENCE, segment=2),
)


@pytest.fixture
def three():
    chain = samples.document(rules=("G1", "G1"))
    assert len(chain.profile) == 3
    return replace(chain, appearance=PAINTED)


def followed(document):
    assert loads(dumps(document)) == document
    look = document.appearance
    covered = {}
    for each in look.textures:
        known = covered.get(each.image, ())
        covered[each.image] = None if each.segments is None else (*known, *each.segments)
    assert covered["lotus"] is None
    assert look.drawing[-1].kind is LayerKind.RINGS
    painted = look.drawing[0].segments if len(look.drawing) == 2 else ()
    return covered.get("wood", ()), covered.get("brick", ()), painted, look.map.segment


@pytest.mark.parametrize(
    ("edit", "wanted"),
    [
        (edits.append_segment, ((1,), (0, 2), (2,), 2)),
        (edits.prepend_segment, ((2,), (1, 3), (3,), 3)),
        (lambda d: edits.insert_segment(d, 1), ((2,), (0, 3), (3,), 3)),
        (lambda d: edits.remove_segment(d, 0), ((0,), (1,), (1,), 1)),
        (lambda d: edits.remove_segment(d, 1), ((), (0, 1), (1,), 1)),
        (lambda d: edits.remove_segment(d, 2), ((1,), (0,), (), None)),
        (lambda d: edits.split_segment(d, 1, 0.5)[0], ((1, 2), (0, 3), (3,), 3)),
        (lambda d: edits.merge_segments(d, 0)[0], ((), (0, 1), (1,), 1)),
        (edits.reverse_profile, ((1,), (0, 2), (0,), 0)),
        (lambda d: edits.reverse_segment(d, 1), ((1,), (0, 2), (2,), 2)),
        (lambda d: edits.move_segment(d, 2, -1), ((2,), (0, 1), (1,), 1)),
        (edits.close_profile, ((1,), (0, 2), (2,), 2)),
    ],
)
def test_paint_follows_its_segments(three, edit, wanted):
    assert followed(edit(three)) == wanted


def test_a_picture_goes_with_its_last_texture(three):
    png = encode_png(np.full((4, 4, 3), 90, np.uint8))
    pictured = edits.add_picture(three, png)
    own = pictured.appearance.textures[0]
    only = edits.set_appearance(pictured, textures=(replace(own, segments=(2,)),))
    assert only.appearance.pictures
    assert edits.remove_segment(only, 2).appearance.pictures == ()


@pytest.mark.parametrize("kind", [LayerKind.GRADIENT, LayerKind.BAND, LayerKind.RINGS])
def test_a_reversed_profile_looks_the_same(three, kind):
    layer = Layer(
        kind, by=Along.LENGTH, start=0.1, end=0.4, stops=((0.0, "#112233"), (0.3, "#ddeeff"))
    )
    painted = replace(three, appearance=Appearance(drawing=(layer,)))
    turned = edits.reverse_profile(painted)
    pictures = [
        paint(each.appearance, uv_map_of(each.surface, 32), (4, 200)) for each in (painted, turned)
    ]
    apart = np.abs(pictures[0].astype(int) - pictures[1][::-1].astype(int))
    assert np.ptp(pictures[0]) > 50
    assert apart.max() <= 1
    assert edits.reverse_profile(turned).appearance.drawing[0].start == pytest.approx(0.1)


@pytest.fixture
def _library():
    pictures.set_library(resources.texture)


@pytest.mark.usefixtures("_library")
@pytest.mark.parametrize("reverse", [False, True])
@pytest.mark.parametrize("degrees", [0.0, 30.0, 90.0, 180.0])
@pytest.mark.parametrize("along", [0.0, 2.4])
def test_a_texture_runs_on_over_the_halves_of_a_segment(along, degrees, reverse):
    texture = Texture("lotus", (1, 2), (5.0, along), (0.3, 0.2), degrees)
    whole = replace(
        samples.document(rules=("G1", "G1")), appearance=Appearance(textures=(texture,))
    )
    if reverse:
        whole = edits.reverse_profile(whole)
    divided, _ = edits.split_segment(whole, 1, 0.37)
    assert [each.segments for each in divided.appearance.textures].count((1,)) == 1
    assert loads(dumps(divided)) == divided
    before, after = (
        paint(each.appearance, uv_map_of(each.surface, 96), (192, 600)).astype(int)
        for each in (whole, divided)
    )
    off = np.abs(before - after).max(axis=-1)
    # Borders fall on whole rows of pixels; beside that it is the same picture.
    assert np.quantile(off, 0.9) < 24
    assert off.mean() < 8
