"""Documents of which no part is left out, and edits of all of them, for what files must keep."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from hypothesis import strategies as st

from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.curves.profile import JointRule
from sgb_core.design.locks.dimension import KINDS, Dimension, DimensionKind, Quantity
from sgb_core.document import edits
from sgb_core.document.appearance.model import Raised
from sgb_core.document.guides import Guide, GuideAt
from sgb_core.document.model import Document
from sgb_core.document.reference import Reference
from sgb_core.lettering.fonts import FontName
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.twist import Ease, Twist
from tests.sgb_core.document.strategies import (
    coordinates,
    documents,
    extras,
    laws,
    looks,
    picture_files,
    plates,
    random_edits,
)

Edit = Callable[[Document], Document]
_SMOOTH = (JointRule.G1, JointRule.C1, JointRule.G2)
_NAMES = st.sampled_from(["one", "two", "three"])

lengths = st.floats(1e-3, 1e6)
twists = st.builds(Twist, st.floats(-100.0, 100.0), st.sampled_from(list(Ease)), extras)
guides = st.builds(Guide, st.sampled_from(list(GuideAt)), coordinates, extras)
letters = st.characters(min_codepoint=32, max_codepoint=0x17F, exclude_characters="\x7f")
cut_outs = st.builds(
    CutOut,
    st.sampled_from(list(HoleShape)),
    lengths,
    lengths,
    st.integers(1, 60),
    st.integers(1, 400),
    st.booleans(),
    st.floats(0.0, 1e6),
    st.floats(0.0, 1e6),
    st.floats(0.0, 1e6),
    extras,
    text=st.text(
        st.characters(min_codepoint=32, max_codepoint=0x17F, exclude_characters="\x7f"),
        min_size=1,
        max_size=9,
    ),
    font=st.sampled_from(list(FontName)),
    picture=st.sampled_from(["geometric", "lotus"]),
    threshold=st.floats(0.0, 1.0),
)
references = st.builds(
    Reference,
    st.text(max_size=12),
    st.sampled_from(["", "picture", "points", "mesh"]),
    st.none() | picture_files,
    st.lists(st.tuples(coordinates, coordinates), max_size=4).map(tuple),
    st.lists(st.floats(-1e6, 1e6), max_size=6).map(tuple),
    st.tuples(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6)),
    lengths,
    st.floats(-360.0, 360.0),
    *(st.none() | st.floats(0.0, 1e6) for _ in range(4)),
    st.floats(0.0, 1.0),
    st.booleans(),
    st.booleans(),
    extras,
)


@st.composite
def dimensions(draw: st.DrawFn, segments: int, joints: int) -> Dimension:
    """Return a dimension, locked or not, of a profile of so many segments and joints."""
    kinds = [kind for kind in DimensionKind if joints or kind is not DimensionKind.JOINT]
    kind = draw(st.sampled_from(kinds))
    facts = KINDS[kind]
    points = st.tuples(st.integers(0, segments - 1), st.integers(0, 3))
    given: dict[str, st.SearchStrategy] = {
        "height": coordinates,
        "segment": st.integers(0, segments - 1),
        "s": st.floats(0.0, 1.0),
        "joint": st.integers(0, max(joints - 1, 0)),
        "rule": st.sampled_from(_SMOOTH),
    }
    named = st.lists(points, min_size=facts.points, max_size=facts.points, unique=True)
    locked = draw(st.booleans())
    counted = locked and facts.quantity is not Quantity.NONE
    return Dimension(
        kind,
        locked,
        draw(st.floats(1e-6, 1e9)) if counted else None,
        draw(named.map(tuple)),
        **{name: draw(given[name]) for name in facts.needs},
        extra=draw(extras),
    )


@st.composite
def whole_documents(draw: st.DrawFn, most: int = 3) -> Document:
    """Return a document with every section that a file has."""
    document = draw(documents(most))
    count, joints = len(document.profile), len(document.profile.rules)
    return replace(
        document,
        twist=draw(twists),
        cut_outs=tuple(draw(st.lists(cut_outs, max_size=2))),
        dimensions=tuple(draw(st.lists(dimensions(count, joints), max_size=3))),
        guides=tuple(draw(st.lists(guides, max_size=3))),
        reference=draw(st.none() | references),
    )


@st.composite
def whole_edits(draw: st.DrawFn) -> Edit:
    """Return an edit of any part, with arguments that fit most documents and not all."""
    number, other = draw(st.integers(0, 3)), draw(st.integers(0, 3))
    name, new, flag = draw(_NAMES), draw(_NAMES), draw(st.booleans())
    value, depth = draw(coordinates), draw(st.floats(-5.0, 5.0))
    turns, share = draw(st.floats(-100.0, 100.0)), draw(st.floats(0.0, 1.0))
    guide, look, law = draw(guides), draw(looks()), draw(laws(1))
    picture = draw(picture_files).data
    dimension, hole = draw(dimensions(1, 1)), draw(cut_outs)
    plate, reference = draw(st.none() | plates), draw(st.none() | references)
    raised = draw(st.sampled_from(list(Raised)))

    def of_law(change: Callable[[Law], Law]) -> Edit:
        return lambda d: edits.replace_law(d, number, change((*d.variation, *[law] * 4)[number]))

    choices: list[Edit] = [
        lambda d: edits.store_state(d, name),
        lambda d: edits.switch_state(d, name),
        lambda d: edits.rename_state(d, name, new),
        lambda d: edits.duplicate_state(d, name, new),
        lambda d: edits.delete_state(d, name),
        lambda d: edits.add_guide(d, guide),
        lambda d: edits.move_guide(d, number, value),
        lambda d: edits.remove_guide(d, number),
        lambda d: edits.add_dimension(d, dimension),
        lambda d: edits.remove_dimension(d, number),
        lambda d: edits.set_lock(d, number, flag),
        lambda d: edits.set_cut_outs(d, [hole]),
        lambda d: edits.set_cut_out(d, number, shape=hole.shape, text=name, font=hole.font),
        lambda d: edits.remove_cut_out(d, number),
        lambda d: edits.cut_out_picture(d, picture, number),
        edits.without_paint,
        lambda d: edits.set_twist(d, turns=turns),
        lambda d: edits.replace_appearance(d, look),
        lambda d: edits.set_relief(d, "layer", number, depth=depth, edge=share),
        lambda d: edits.set_relief(d, "texture", number, depth=depth, raised=raised),
        lambda d: edits.set_plate(d, plate),
        lambda d: edits.set_reference(d, reference),
        lambda d: edits.add_law(d, law),
        lambda d: edits.move_law(d, number, other),
        of_law(edits.as_keyframes),
        of_law(
            lambda found: edits.with_strength(
                edits.with_parameter(found, "radius"), share, abs(depth)
            )
        ),
        of_law(lambda found: edits.without_strength(found, other)),
        edits.push_inside_axis,
        edits.fit_wall,
        edits.flat_rim,
        edits.no_drain_hole,
        edits.no_foot_ring,
    ]
    return draw(st.sampled_from(choices) | random_edits())
