"""Fill line, material and shrinkage; the object at another size, unit and axis."""

from __future__ import annotations

import json
from dataclasses import replace
from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.edits import EditError
from sgb_core.document.edits.targets import Stretch, held_volume, hold
from sgb_core.document.errors import FileError
from sgb_core.document.file import project_file
from sgb_core.document.manufacture import DENSITIES, Shrinkage, Stage
from sgb_core.document.model import Document, Unit
from sgb_core.surfaces import measures
from sgb_core.surfaces.revolution import Axis
from sgb_core.surfaces.tessellation import tessellate
from tests.sgb_core.document import samples


def test_shrinkage_means_what_its_convention_says() -> None:
    of_wet = Shrinkage(12.0, Stage.WET, Stage.FIRED)
    assert of_wet.factor(Stage.WET) == pytest.approx(1.0 / 0.88, rel=1e-15)
    of_fired = Shrinkage(12.0, Stage.FIRED, Stage.FIRED)
    assert of_fired.factor(Stage.WET) == pytest.approx(1.12, rel=1e-15)
    for shrinkage in (of_wet, of_fired):
        other_way = replace(shrinkage, drawn=Stage.WET)
        assert other_way.factor(Stage.WET) == 1.0
        product = other_way.factor(Stage.FIRED) * shrinkage.factor(Stage.WET)
        assert product == pytest.approx(1.0, rel=1e-15)


def test_sections_round_trip_and_defaults_are_left_out() -> None:
    plain = samples.document()
    assert b"shrinkage" not in project_file.dumps(plain)
    made = edits.set_shrinkage(plain, percent=8.5, of="fired", drawn="wet")
    made = edits.set_material(edits.set_fill(made, 7.25), name="porcelain")
    read = project_file.loads(project_file.dumps(made))
    assert read == made
    assert read.manufacture.material.density == DENSITIES["porcelain"]


@pytest.mark.parametrize(
    ("section", "text"),
    [
        ({"shrinkage": {"percent": 51}}, "shrinkage.percent is 51; allowed is a number from 0"),
        ({"shrinkage": {"of": "dry"}}, 'shrinkage.of is "dry"; allowed is "wet", "fired"'),
        ({"material": {"density": 0}}, "material.density is 0; allowed is a number above 0"),
        ({"material": {"name": ""}}, 'material.name is ""; allowed is a text of 1 to 60'),
        ({"fill": {"height": "full"}}, 'fill.height is "full"; allowed is null or a number'),
        ({"fill": 3}, "fill is 3; allowed is an object"),
    ],
)
def test_bad_sections_are_one_line(section: dict[str, object], text: str) -> None:
    with pytest.raises(FileError) as caught:
        project_file.loads(samples.data(samples.tree(**section)))
    assert str(caught.value).startswith(text)


def test_an_edit_is_held_to_the_same_limits() -> None:
    plain = samples.document()
    for edit in (
        lambda: edits.set_shrinkage(plain, percent=99.0),
        lambda: edits.set_material(plain, density=-1.0),
        lambda: edits.set_material(plain, name="\ud800"),
        lambda: edits.set_fill(plain, float("nan")),
    ):
        with pytest.raises(EditError):
            edit()
    assert edits.set_fill(plain, None) is plain


def test_the_fill_line_follows_the_profile() -> None:
    filled = edits.set_fill(samples.document(), 5.0)
    assert edits.scale(filled, 2.0).manufacture.fill.height == 10.0
    assert edits.set_height(filled, 20.0).manufacture.fill.height == pytest.approx(10.0)
    assert edits.set_unit(filled, "cm", True).manufacture.fill.height == pytest.approx(0.5)
    assert edits.set_unit(filled, "cm", False).manufacture.fill.height == 5.0


@given(height=st.floats(1.0, 500.0), below=st.floats(0.0, 40.0), factor=st.floats(0.1, 10.0))
def test_a_line_below_the_rim_stays_so_when_the_shape_changes(height, below, factor) -> None:
    filled = edits.set_fill(samples.document(), below_rim=below)
    rim = max(filled.profile[0].points[0, 1], filled.profile[-1].points[3, 1])
    assert filled.fill_height == rim - below
    for changed in (
        edits.scale(filled, factor),
        edits.set_height(filled, height),
        edits.mirror_height(filled),
        edits.reverse_profile(filled),
        edits.append_segment(filled),
        edits.move_point(filled, 0, 0, (3.0, -height)),
    ):
        assert changed.rim_height - changed.fill_height == pytest.approx(below, abs=1e-9)
    enlarged = edits.for_export(filled, factor=factor)
    assert enlarged.manufacture.fill.below_rim == pytest.approx(factor * below)
    converted = edits.set_unit(filled, "cm", True)
    assert converted.manufacture.fill.below_rim == pytest.approx(below / 10)
    assert edits.set_unit(filled, "cm", False).manufacture.fill.below_rim == below


def test_a_dragged_line_stays_given_as_it_was() -> None:
    plain = samples.document()
    below = edits.move_fill(edits.set_fill(plain, below_rim=2.0), plain.rim_height - 3.0)
    assert below.manufacture.fill.below_rim == pytest.approx(3.0)
    assert edits.move_fill(below, plain.rim_height + 1.0).manufacture.fill.below_rim == 0.0
    assert edits.move_fill(edits.set_fill(plain, 4.0), 5.0).manufacture.fill.height == 5.0
    assert edits.set_fill(below).fill_height is None


def test_a_line_below_the_rim_is_saved_and_read_and_one_of_two_is_refused() -> None:
    filled = edits.set_fill(samples.document(), below_rim=10.0)
    data = json.loads(project_file.dumps(filled))
    assert data["fill"] == {"below_rim": 10}
    assert project_file.loads(json.dumps(data).encode()).manufacture == filled.manufacture
    for wrong in ({"below_rim": -1}, {"below_rim": "rim"}, {"height": 3, "below_rim": 10}):
        with pytest.raises(FileError, match=r"fill\.below_rim"):
            project_file.loads(json.dumps({**data, "fill": wrong}).encode())


def test_a_vessel_holds_its_volume_below_the_rim() -> None:
    cup = edits.set_solid(
        Document(Profile.of([line((20, 0), (20, 60))])), kind="vessel", wall=3, base=4
    )
    filled = edits.set_fill(cup, below_rim=10.0)
    assert held_volume(filled) == pytest.approx(pi * 17**2 * 46)
    for stretch in Stretch:
        mug = hold(filled, 350_000.0, stretch)
        assert held_volume(mug) == pytest.approx(350_000.0, rel=1e-9)
        assert mug.rim_height - mug.fill_height == pytest.approx(10.0)


def test_for_export_keeps_the_true_size() -> None:
    document = edits.set_solid(samples.document(), kind="vessel", wall=0.5)
    exported = edits.for_export(document, unit=Unit.IN)
    assert exported.unit is Unit.IN
    assert measures.volume(exported.surface) * 25.4**3 == pytest.approx(
        measures.volume(document.surface), rel=1e-12
    )
    assert exported.solid.wall * 25.4 == pytest.approx(0.5)
    twice = edits.for_export(document, factor=2.0)
    assert measures.volume(twice.surface) == pytest.approx(8.0 * measures.volume(document.surface))
    assert edits.for_export(document) == document


def test_another_axis_mirrors_nothing() -> None:
    document = edits.set_revolution(samples.document(), sweep_deg=100.0)
    drawn = tessellate(document.surface, samples=(4, 12))
    turned = tessellate(edits.for_export(document, axis=Axis.Y).surface, samples=(4, 12))
    np.testing.assert_allclose(turned.positions[:, [2, 0, 1]], drawn.positions, atol=1e-12)
    np.testing.assert_array_equal(turned.faces, drawn.faces)
