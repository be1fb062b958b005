"""The plate section: panels, limits, round trip, states, one clear line for each fault."""

from __future__ import annotations

import json
from dataclasses import replace

import jsonschema
import pytest

import resources
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.edits.plate import plate_panels, set_plate
from sgb_core.document.errors import EditError
from sgb_core.document.file import project_file
from sgb_core.document.file.project_file import FileError
from sgb_core.document.model import Document
from sgb_core.document.plates import (
    PlateCamera,
    PlatePart,
    PlateSettings,
    Projection,
    Variation,
)

PLATE = PlateSettings(
    vary=(Variation("omega", (0.0, 0.5, 1.0), 1), Variation("lambda2", (0.0, 6.0))),
    columns=2,
    labels=False,
    captions=False,
    title="ω against λ₂",
    show=frozenset({PlatePart.CIRCLES, PlatePart.AXES}),
    width_mm=85.0,
    panel_height_mm=40.0,
    dpi=600,
    common_scale=False,
    camera=PlateCamera(12.0, -30.0, Projection.PERSPECTIVE),
)


def chain() -> Document:
    first = Segment(((1, 0), (2, 1), (2, 2), (1, 3)))
    second = Segment(((1, 3), (0.5, 3.5), (0.5, 5), (1, 6)))
    return Document(Profile.of([first, second], ["G1"]))


def test_a_plate_survives_saving_and_fits_the_schema() -> None:
    document = set_plate(chain(), PLATE)
    data = project_file.dumps(document)
    assert project_file.loads(data).plate == PLATE
    schema = json.loads(resources.read("sgb-document.schema.json"))
    jsonschema.Draft202012Validator(schema).validate(json.loads(data))


def test_a_plate_file_needs_nothing_but_its_braces() -> None:
    tree = json.loads(project_file.dumps(chain())) | {"plate": {}}
    assert project_file.loads(json.dumps(tree).encode()).plate == PlateSettings()


def test_unknown_keys_of_a_plate_are_kept() -> None:
    plate = {"vary": [{"parameter": "omega", "values": [0.5], "why": 1}], "paper": "A4"}
    tree = json.loads(project_file.dumps(chain())) | {"plate": plate}
    again = json.loads(project_file.dumps(project_file.loads(json.dumps(tree).encode())))
    assert again["plate"]["paper"] == "A4"
    assert again["plate"]["vary"][0]["why"] == 1


@pytest.mark.parametrize(
    ("plate", "line"),
    [
        ({"vary": [{"parameter": "omega", "values": [2]}]}, r"plate\.vary\[0\]\.values\[0\] is 2"),
        ({"vary": [{"parameter": "width", "values": [1]}]}, r"plate\.vary\[0\]\.parameter"),
        ({"vary": [{"parameter": "omega", "values": []}]}, r"a list of 1 to 24 numbers"),
        ({"dpi": 5}, r"plate\.dpi is 5; allowed is a whole number from 50 to 1200"),
        ({"camera": {"elevation_deg": 91}}, r"plate\.camera\.elevation_deg is 91"),
        ({"show": ["shadow"]}, r"plate\.show\[0\]"),
        ({"width_mm": True}, r"plate\.width_mm is true"),
    ],
)
def test_a_faulty_plate_gets_one_line(plate: dict[str, object], line: str) -> None:
    tree = json.loads(project_file.dumps(chain())) | {"plate": plate}
    with pytest.raises(FileError, match=line) as error:
        project_file.loads(json.dumps(tree).encode())
    assert "\n" not in str(error.value)


def test_two_variations_make_a_table_whose_second_runs_fastest() -> None:
    document = chain()
    panels = plate_panels(document, PLATE)
    shapes = [panel.document.profile.segments[1].shape for panel in panels]
    assert [(s.omega, s.lambda2) for s in shapes] == [
        (omega, lambda2) for omega in (0.0, 0.5, 1.0) for lambda2 in (0.0, 6.0)
    ]
    # ω varies in the second segment alone, λ2 in both; no control point moves.
    assert {panel.document.profile.segments[0].shape.omega for panel in panels} == {0.0}
    for panel in panels:
        points = panel.document.profile.control_points
        assert (points == document.profile.control_points).all()


def test_states_become_panels_and_a_state_never_holds_a_plate() -> None:
    document = edits.store_state(set_plate(chain(), PLATE), "A")
    assert document.states[0].plate is None
    bigger = edits.scale(document, 2.0)
    panels = plate_panels(bigger, PlateSettings(states=("A", "")))
    heights = [panel.document.profile.bounds()[1][1] for panel in panels]
    assert heights == pytest.approx([6.0, 12.0])
    assert edits.switch_state(bigger, "A").plate == PLATE


@pytest.mark.parametrize(
    ("plate", "words"),
    [
        (PlateSettings(states=("gone",)), "no state 'gone'"),
        (PlateSettings(vary=(Variation("omega", (0.5,), 7),)), "no segment 7"),
        (PlateSettings(vary=(Variation("omega", (0.5,) * 24),) * 2), "576 panels"),
    ],
)
def test_what_cannot_be_drawn_is_not_kept(plate: PlateSettings, words: str) -> None:
    with pytest.raises(EditError, match=words):
        set_plate(chain(), plate)


def test_a_variation_out_of_range_cannot_be() -> None:
    with pytest.raises(
        ValueError, match=r"vary\.values\[0\] is 1.5; allowed is a value of omega from 0 to 1"
    ):
        Variation("omega", (1.5,))


def test_a_plate_is_taken_away_again() -> None:
    document = chain()
    with_plate = set_plate(document, PLATE)
    assert set_plate(with_plate, PLATE) is with_plate
    assert set_plate(with_plate, None) == document
    assert replace(with_plate, plate=None) == document
