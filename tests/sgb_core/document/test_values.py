"""Values cannot be wrong: refused when made, and whatever is made can be saved and loaded."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sgb_core.bodies.solid import Solid
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.appearance.model import Appearance, ColourMap, Layer, Texture
from sgb_core.document.appearance.picture_file import Picture
from sgb_core.document.file import project_file
from sgb_core.document.manufacture import Fill, Manufacture, Material, Shrinkage
from sgb_core.document.model import Document, Revolution
from sgb_core.document.plates import PlateCamera, PlateSettings, Variation
from sgb_core.findings.refusal import RefusalError
from sgb_core.surfaces.laws.law import MAX_WAVES, Law
from sgb_core.surfaces.placement import Placement
from tests.sgb_core.document import samples
from tests.sgb_core.document.strategies import documents, extras, json_values

PROFILE = samples.document().profile
LINE = [[1, 0], [1, 1], [1, 2], [1, 3]]
APART = Segment(np.array(LINE) + 1.0)

WRONG: list[tuple[Callable[[], object], str]] = [
    (lambda: Solid(wall=-5), "solid.wall is -5; allowed is a positive number, at most 1e9"),
    (lambda: Solid(kind="ball"), 'solid.kind is "ball"; allowed is "surface", "filled", "vessel"'),
    (lambda: Solid(base=True), "solid.base is true; allowed is a number of at least 0"),
    (lambda: ShapeParameters(lambda2=7.0), "lambda2 is 7.0; allowed is a number from 0 to 6"),
    (lambda: Segment([[1, 2]]), "segment.points is a list of 1; allowed is a list of 4 points"),
    (lambda: Segment([*LINE[:3], [1, 2e9]]), "segment.points[3][1] is 2000000000.0; allowed"),
    (lambda: Segment(LINE, 3), "segment.shape is 3; allowed is a ShapeParameters"),
    (lambda: Segment(LINE, holds_end=1), "segment.holds_end is 1; allowed is true or false"),
    (lambda: Segment(LINE, extra={"omega": 1}), 'segment.extra is "omega"; allowed is a key that'),
    (lambda: Profile(()), "profile.segments is a list of 0; allowed is a list of 1 to 2000"),
    (lambda: Profile((3,)), "profile.segments[0] is 3; allowed is a Segment"),
    (lambda: Profile.of([APART], ["G7"]), 'profile.joints[0] is "G7"; allowed is "free"'),
    (lambda: Profile.of([APART], ["G1"]), "profile.joints is a list of 1; allowed is a list of 0"),
    (lambda: Law("omega", "lambda9"), 'law.law is "lambda9"; allowed is "paper", "raised-cosine"'),
    (lambda: Law("height", "paper"), 'law.parameter is "height"; allowed is "lambda1", "lambda2"'),
    (lambda: Law("omega", "paper", 0, 2), "law.to is 2.0; allowed is a number from 0 to 1"),
    (lambda: Law("omega", "cosine", count=MAX_WAVES + 1), "law.n is 1001; allowed is a whole"),
    (lambda: Law("omega", "keyframes"), "law.keyframes is a list of 0; allowed is a list of 1 to"),
    (lambda: Law("omega", "paper", segments=(-1,)), "law.segments[0] is -1; allowed is a whole"),
    (lambda: Revolution(sweep_deg=0), "revolution.sweep_deg is 0; allowed is a number above 0"),
    (lambda: Revolution(start_deg=1e300), "revolution.start_deg is 1e+300; allowed is a number"),
    (lambda: Placement((0, 0)), "placement.rotation_deg is a list of 2; allowed is a list of 3"),
    (lambda: Placement(translation=(0, 0, 2e9)), "placement.translation[2] is 2000000000.0; allow"),
    (lambda: Fill("full"), 'fill.height is "full"; allowed is null or a number from -1e9 to 1e9'),
    (lambda: Material(""), 'material.name is ""; allowed is a text of 1 to 60 characters'),
    (lambda: Material(density=0), "material.density is 0; allowed is a number above 0"),
    (lambda: Shrinkage(percent=51), "shrinkage.percent is 51; allowed is a number from 0 to 50"),
    (lambda: Manufacture(fill=3), "fill is 3; allowed is a Fill"),
    (lambda: Texture("../x"), 'texture.image is "../x"; allowed is the name of a texture'),
    (lambda: Layer("gradient"), "layer.stops is a list of 0; allowed is a list of 2 to 50 pairs"),
    (lambda: ColourMap("radius", 2, 1), "map.high is 1.0; allowed is a number above the lower"),
    (lambda: Picture(b"no"), "picture is b'no'; allowed is a PNG or JPEG picture"),
    (lambda: Appearance(color="red"), 'appearance.color is "red"; allowed is a colour "#rrggbb"'),
    (
        lambda: Appearance(textures=(Texture("0" * 64),)),
        'appearance.textures[0].image is "000000000000000000000000000000000000...; allowed is the',
    ),
    (lambda: PlateCamera(elevation_deg=91), "camera.elevation_deg is 91; allowed is a number from"),
    (lambda: PlateSettings(dpi=5), "plate.dpi is 5; allowed is a whole number from 50 to 1200"),
    (lambda: Variation("omega", ()), "vary.values is a list of 0; allowed is a list of 1 to 24"),
    (lambda: Document(3), "profile is 3; allowed is a Profile"),
    (lambda: Document(PROFILE, unit="furlong"), 'unit is "furlong"; allowed is "mm", "cm", "in"'),
    (lambda: Document(PROFILE, "\ud800"), "name holds half a character"),
    (lambda: Document(PROFILE, extra={"format": 1}), 'extra is "format"; allowed is a key that'),
    (
        lambda: Document(PROFILE, variation=(Law("omega", "paper", segments=(0, 3)),)),
        "variation[0].segments[1] is 3; allowed is a segment number from 0 to 2",
    ),
    (
        lambda: Document(Profile.of([Segment(LINE), APART], ["G1"])),
        'profile.joints[0] is "G1", but segments 0 and 1 are 2.23607 apart; allowed is "free", or',
    ),
    (
        lambda: Document(Profile.of([Segment(LINE)], closed=True)),
        "profile.closed is true, but the last point is 3 from the first",
    ),
    (
        lambda: Document(PROFILE, states=(Document(PROFILE, "A"),) * 2),
        "states[1].name is that of an earlier state; allowed is a name of its own",
    ),
    (
        lambda: Document(PROFILE, states=(Document(PROFILE, "A", plate=PlateSettings()),)),
        "states[0].plate is ",
    ),
    (
        lambda: Document(PROFILE, states=(Document(PROFILE, ""),)),
        'states[0].name is ""; allowed is a text of 1 to 60 characters',
    ),
]


@pytest.mark.parametrize(("make", "line"), WRONG, ids=[line[:40] for _, line in WRONG])
def test_a_wrong_value_is_refused_when_it_is_made(make: Callable[[], object], line: str) -> None:
    with pytest.raises(RefusalError) as caught:
        make()
    assert str(caught.value).startswith(line.removesuffix("…"))
    assert str(caught.value).isprintable()


def test_the_file_tells_the_same_as_the_value_alone() -> None:
    for section, make in (
        ({"solid": {"wall": -5}}, lambda: Solid(wall=-5)),
        ({"revolution": {"start_deg": 1e10}}, lambda: Revolution(start_deg=1e10)),
        ({"placement": {"translation": [0, 0, "a"]}}, lambda: Placement(translation=(0, 0, "a"))),
        ({"unit": "furlong"}, lambda: Document(PROFILE, unit="furlong")),
    ):
        with pytest.raises(project_file.FileError) as from_file:
            project_file.loads(samples.data(samples.tree(**section)))
        with pytest.raises(RefusalError) as alone:
            make()
        assert from_file.value.finding == alone.value.finding
        assert str(from_file.value) == str(alone.value)


def test_the_file_names_its_own_place() -> None:
    laws = [{"parameter": "omega", "law": "paper"}] * 2
    tree = samples.tree(variation=[*laws, {"parameter": "omega", "law": "cosine", "n": 5000}])
    with pytest.raises(
        project_file.FileError, match=r"^variation\[2\]\.n is 5000; allowed is a whole"
    ):
        project_file.loads(samples.data(tree))
    state = {"name": "A", "profile": samples.tree()["profile"], "solid": {"wall": 0}}
    with pytest.raises(project_file.FileError, match=r"^states\[0\]\.solid\.wall is 0; allowed is"):
        project_file.loads(samples.data(samples.tree(states=[state])))


@settings(deadline=None, suppress_health_check=list(HealthCheck), max_examples=60)
@given(documents())
def test_whatever_can_be_made_can_be_saved_and_loaded_again(document: Document) -> None:
    data = project_file.dumps(document)
    again = project_file.loads(data)
    assert again == document
    assert project_file.dumps(again) == data


ODD = json_values | st.sampled_from([0, 1, -1, 0.5, 2, 1e10, "mm", (), (1, 2, 3), "G1", (0.0,)])


@settings(deadline=None, suppress_health_check=list(HealthCheck), max_examples=120)
@given(documents(most=2), st.data())
def test_with_any_field_replaced_it_is_refused_or_can_be_saved(
    document: Document, data: st.DataObject
) -> None:
    """What is given may be of any type: the constructor refuses it, or the file holds it."""
    name = data.draw(st.sampled_from(("revolution", "solid", "placement", "appearance")))
    part = getattr(document, name)
    field = data.draw(st.sampled_from([each.name for each in dataclasses.fields(part)]))
    try:
        odd = replace(document, **{name: replace(part, **{field: data.draw(ODD | extras)})})
    except RefusalError:
        return
    assert project_file.loads(project_file.dumps(odd)) == odd
