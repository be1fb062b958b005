"""Random documents and random edits for the property tests of this package."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from hypothesis import strategies as st

from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document import edits
from sgb_core.document.appearance.model import (
    Along,
    Appearance,
    Background,
    ColourMap,
    Layer,
    LayerKind,
    Lighting,
    MapKind,
    MaterialName,
    Scale,
    Shading,
    Texture,
)
from sgb_core.document.appearance.picture_file import Picture
from sgb_core.document.appearance.pictures import encode_png
from sgb_core.document.edits.segments import Kind
from sgb_core.document.manufacture import Fill, Manufacture, Material, Shrinkage, Stage
from sgb_core.document.model import Document, Revolution, Unit
from sgb_core.document.plates import (
    PlateCamera,
    PlatePart,
    PlateSettings,
    Projection,
    Variation,
)
from sgb_core.surfaces.laws.law import MAX_WAVES
from sgb_core.surfaces.laws.shapes import SHAPES
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis
from sgb_core.surfaces.variation import Law

RANGES = {"lambda1": 4.0, "lambda2": 6.0, "lambda3": 4.0, "omega": 1.0}


def parts_of(top: float) -> st.SearchStrategy[float]:
    """Return numbers from 0 to ``top``, the ends and the neutral values among them often."""
    marks = [v for v in (0.0, 1.0, 3.0, top) if v <= top]
    return st.one_of(st.sampled_from(marks), st.floats(0.0, top))


coordinates = st.one_of(
    st.integers(-20, 20).map(float), st.floats(-100.0, 100.0), st.floats(-1e9, 1e9)
)
shapes = st.builds(ShapeParameters, parts_of(4.0), parts_of(6.0), parts_of(4.0), parts_of(1.0))
leaves = (
    st.none()
    | st.booleans()
    | st.integers(-(2**70), 2**70)
    | st.text(max_size=5)
    | st.floats(allow_nan=False, allow_infinity=False)
)
json_values = st.recursive(
    leaves,
    lambda inner: (
        st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=3), inner, max_size=3)
    ),
    max_leaves=6,
)
extras = st.dictionaries(st.sampled_from(["note", "x-colour", "Δ", ""]), json_values, max_size=2)


# As often as not the same strength at every height.
strengths = st.just(()) | st.lists(
    st.tuples(st.integers(0, 20).map(lambda step: step / 20.0), st.floats(0.0, 1.0)),
    max_size=4,
    unique_by=lambda key: key[0],
).map(tuple)


@st.composite
def laws(draw: st.DrawFn, count: int) -> Law:
    parameter = draw(st.sampled_from([*RANGES, "radius"]))
    value = st.floats(0.5, 2.0) if parameter == "radius" else parts_of(RANGES[parameter])
    numbers = st.lists(st.integers(0, count - 1), min_size=1, max_size=count, unique=True)
    kind = draw(st.sampled_from(list(SHAPES)))
    least = SHAPES[kind].least_count
    turns = st.lists(st.integers(0, 359).map(float), min_size=1, max_size=4, unique=True)
    keys = tuple((turn, draw(st.floats(0.0, 1.0))) for turn in draw(turns))
    return Law(
        parameter,  # type: ignore[arg-type]
        kind,
        draw(value),
        draw(value),
        draw(st.none() | numbers.map(lambda found: tuple(sorted(found)))),
        draw(st.integers(least, 9) | st.just(MAX_WAVES)) if "count" in SHAPES[kind].uses else 1,
        draw(st.floats(0.0, 1.0)),
        draw(st.floats(0.0, 1.0)),
        draw(st.floats(0.01, 90.0)),
        keyframes=keys if kind == "keyframes" else (),
        along=draw(strengths) if parameter == "radius" else (),
        extra=draw(extras),
    )


@st.composite
def profiles(draw: st.DrawFn, most: int = 5) -> Profile:
    count = draw(st.integers(1, most))
    closed = draw(st.booleans())
    points = np.array(draw(st.lists(coordinates, min_size=8 * count, max_size=8 * count))).reshape(
        count, 4, 2
    )
    rules = draw(
        st.lists(
            st.sampled_from(list(JointRule)),
            min_size=count - (not closed),
            max_size=count - (not closed),
        )
    )
    for joint, rule in enumerate(rules):
        if rule is not JointRule.FREE or joint == count - 1:
            points[(joint + 1) % count, 0] = points[joint, 3]
    ends = st.booleans()
    segments = tuple(
        Segment(p, draw(shapes), draw(extras), holds_start=draw(ends), holds_end=draw(ends))
        for p in points
    )
    return Profile(segments, tuple(rules), closed, draw(extras))


shares = st.floats(0.0, 1.0)
colours = st.integers(0, 0xFFFFFF).map(lambda number: f"#{number:06x}")
numbers = st.lists(st.integers(0, 9), max_size=3).map(tuple)
picture_files = st.integers(0, 3).map(
    lambda shade: Picture(encode_png(np.full((2, 3, 3), 60 * shade, dtype=np.uint8)))
)
textures = st.builds(
    Texture,
    st.sampled_from(["lotus", "wood", "any-name"]),
    st.none() | numbers,
    st.tuples(st.floats(1.0, 50.0), st.floats(0.0, 50.0)),
    st.tuples(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0)),
    st.floats(-360.0, 360.0),
    extras,
)
layers = st.builds(
    Layer,
    st.sampled_from(list(LayerKind)),
    colours,
    shares,
    shares,
    st.sampled_from(list(Along)),
    st.integers(1, 1000),
    shares,
    st.floats(-3.0, 3.0),
    st.lists(st.tuples(shares, colours), min_size=2, max_size=4).map(tuple),
    numbers,
    extras,
)
maps = st.builds(
    ColourMap,
    st.sampled_from(list(MapKind)),
    st.none() | st.floats(-5.0, -1.0),
    st.none() | st.floats(1.0, 5.0),
    st.sampled_from(list(Scale)),
    st.sampled_from(list(RANGES)),
    st.none() | st.integers(0, 9),
    extras,
)


@st.composite
def looks(draw: st.DrawFn) -> Appearance:
    """Return a look, some of its textures the document's own pictures."""
    pictures = draw(st.lists(picture_files, max_size=2, unique=True).map(tuple))
    laid = draw(st.lists(textures, max_size=2).map(tuple))
    own = tuple(Texture(picture.name) for picture in pictures)
    return Appearance(
        draw(st.sampled_from(list(MaterialName))),
        draw(st.none() | colours),
        draw(st.sampled_from(list(Lighting))),
        draw(st.sampled_from(list(Background))),
        draw(st.sampled_from(list(Shading))),
        draw(st.booleans()),
        draw(st.booleans()),
        draw(st.booleans()),
        (*laid, *own),
        draw(st.lists(layers, max_size=2).map(tuple)),
        draw(st.none() | maps),
        pictures,
    )


@st.composite
def variations(draw: st.DrawFn) -> Variation:
    parameter = draw(st.sampled_from(list(RANGES)))
    values = draw(st.lists(parts_of(RANGES[parameter]), min_size=1, max_size=3).map(tuple))
    segment = draw(st.none() | st.integers(0, 9))
    return Variation(parameter, values, segment, draw(extras))  # type: ignore[arg-type]


plates = st.builds(
    PlateSettings,
    st.lists(variations(), max_size=2).map(tuple),
    st.lists(st.text(max_size=8), max_size=2).map(tuple),
    st.integers(0, 48),
    st.booleans(),
    st.booleans(),
    st.text(max_size=8),
    st.frozensets(st.sampled_from(list(PlatePart))),
    st.floats(20.0, 600.0),
    st.none() | st.floats(5.0, 600.0),
    st.integers(50, 1200),
    st.booleans(),
    st.builds(
        PlateCamera,
        st.floats(-400.0, 400.0),
        st.floats(-90.0, 90.0),
        st.sampled_from(list(Projection)),
        extras,
    ),
    extras,
)
manufactures = st.just(Manufacture()) | st.builds(
    Manufacture,
    st.builds(Fill, st.none() | coordinates, extra=extras)
    | st.builds(Fill, below_rim=st.floats(0.0, 1e9), extra=extras),
    st.builds(Material, st.text(min_size=1, max_size=8), st.floats(1e-3, 100.0), extras),
    st.builds(
        Shrinkage,
        st.floats(0.0, 50.0),
        st.sampled_from(list(Stage)),
        st.sampled_from(list(Stage)),
        extras,
    ),
)


@st.composite
def documents(draw: st.DrawFn, most: int = 5, states: int = 2) -> Document:
    names = draw(st.lists(st.text(min_size=1, max_size=8), max_size=states, unique=True))
    profile = draw(profiles(most))
    lengths = st.floats(0.0, 50.0)
    triples = st.tuples(coordinates, coordinates, coordinates)
    return Document(
        profile,
        draw(st.text(max_size=8)),
        draw(st.sampled_from(list(Unit))),
        Revolution(
            draw(st.sampled_from(list(Axis))),
            draw(st.floats(-720.0, 720.0) | st.floats(-1e9, 1e9)),
            draw(st.just(360.0) | st.floats(1e-3, 360.0)),
            draw(extras),
        ),
        tuple(draw(st.lists(laws(len(profile)), max_size=3))),
        Solid(
            draw(st.sampled_from(list(BodyKind))),
            draw(st.floats(1e-3, 50.0)),
            draw(st.sampled_from(list(WallSide))),
            draw(lengths),
            draw(st.sampled_from(list(Rim))),
            draw(lengths),
            draw(lengths),
            draw(extras),
        ),
        draw(st.just(Placement()) | st.builds(Placement, triples, triples, extras)),
        draw(extras),
        manufacture=draw(manufactures),
        appearance=draw(st.just(Appearance()) | looks()),
        states=tuple(replace(draw(documents(2, states=0)), name=name) for name in names),
        plate=draw(st.none() | plates) if states else None,
    )


@st.composite
def random_edits(draw: st.DrawFn) -> Callable[[Document], Document]:
    """Return an edit with arguments that fit most documents and not all."""
    segment, index = draw(st.integers(0, 5)), draw(st.integers(0, 3))
    name = draw(st.sampled_from(list(RANGES)))
    value = draw(parts_of(RANGES[name]))
    position = (draw(coordinates), draw(coordinates))
    ratio = draw(st.floats(0.05, 20.0))
    keep = draw(st.booleans())
    keys = draw(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3)), min_size=1, max_size=4))
    rule = draw(st.sampled_from(list(JointRule)))
    unit = draw(st.sampled_from(list(Unit)))
    kind = draw(st.sampled_from(list(Kind)))
    s = draw(st.floats(0.02, 0.98))
    choices: list[Callable[[Document], Document]] = [
        lambda d: edits.set_shape_parameter(d, segment, name, value),
        lambda d: edits.set_shape_parameter(d, None, name, value),
        lambda d: edits.reset_shape(d, segment, None),
        lambda d: edits.reset_shape(d, None, name),
        lambda d: edits.set_leg_fraction(d, segment, index % 3, s),
        lambda d: edits.move_point(d, segment, index, position, keep_rules=keep),
        lambda d: edits.move_points(d, keys, position, keep_rules=keep),
        edits.append_segment,
        edits.prepend_segment,
        lambda d: edits.insert_segment(d, segment),
        lambda d: edits.remove_segment(d, segment),
        lambda d: edits.reverse_segment(d, segment),
        edits.reverse_profile,
        lambda d: edits.split_segment(d, segment, s)[0],
        lambda d: edits.merge_segments(d, segment)[0],
        lambda d: edits.set_rule(d, segment, rule),
        edits.close_profile,
        edits.open_profile,
        edits.head_to_tail,
        lambda d: edits.append_kind(d, kind)[0],
        edits.append_mirror_image,
        lambda d: edits.mirror_segment(d, segment),
        lambda d: edits.move_segment(d, segment, 1 if keep else -1),
        lambda d: edits.set_yielding(d, segment, "earlier" if keep else "later"),
        lambda d: edits.add_law(d, Law(name, "paper", 0.0, value)),
        lambda d: edits.remove_law(d, segment),
        lambda d: edits.scale(d, ratio),
        lambda d: edits.set_height(d, ratio),
        lambda d: edits.set_largest_diameter(d, ratio),
        edits.mirror_height,
        lambda d: edits.set_unit(d, unit, keep),
        lambda d: edits.set_revolution(d, start_deg=value, sweep_deg=10.0 * ratio),
        lambda d: edits.set_solid(d, kind="vessel", wall=value),
        lambda d: edits.set_placement(d, translation=(value, 0.0, ratio)),
        lambda d: edits.rename(d, f"{value}"),
        lambda d: edits.set_fill(d, value),
        lambda d: edits.set_material(d, density=ratio),
        lambda d: edits.set_shrinkage(d, percent=10.0 * s, of="fired"),
    ]
    return draw(st.sampled_from(choices))
