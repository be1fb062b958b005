from __future__ import annotations

import json

import jsonschema
import pytest
from hypothesis import HealthCheck, given, settings

import resources
from sgb_core.document import edits
from sgb_core.document.file import json_text, project_file
from sgb_core.document.file.schema import schema
from sgb_core.document.model import Document
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.laws.shape import LawShape
from sgb_core.surfaces.laws.shapes import add_shape
from tests.sgb_core.document import samples
from tests.sgb_core.document.file.test_project_file import BAD
from tests.sgb_core.document.strategies import documents

SCHEMA = json.loads(resources.read("sgb-document.schema.json"))
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
# What a schema cannot say: it knows neither counts of other lists nor distances.
BEYOND = (
    "profile.joints is a list",
    "but ",
    "variation[0].segments[0]",
    "has two keys",
    "5e-324",
)


def test_the_schema_is_one() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


@pytest.mark.parametrize("preset", resources.presets(), ids=lambda preset: preset.name)
def test_presets_follow_the_schema(preset: resources.Preset) -> None:
    VALIDATOR.validate(json.loads(resources.load_preset(preset.name)))


@settings(deadline=None, suppress_health_check=list(HealthCheck), max_examples=50)
@given(documents())
def test_whatever_is_saved_follows_the_schema(document: Document) -> None:
    VALIDATOR.validate(json.loads(project_file.dumps(document)))


@pytest.mark.parametrize(("tree", "text"), BAD, ids=[text[:40] for _, text in BAD])
def test_what_loading_refuses_does_not_follow_the_schema(tree: object, text: str) -> None:
    tree = json.loads(samples.data(tree))
    if any(part in text for part in BEYOND):
        VALIDATOR.validate(tree)
    else:
        assert not VALIDATOR.is_valid(tree)


def test_the_file_beside_the_presets_is_what_the_core_makes() -> None:
    # Made anew by: python -m sgb_core.document.file.schema > resources/sgb-document.schema.json
    assert resources.read("sgb-document.schema.json") == json_text.dump(schema())


def test_a_law_shape_from_outside_is_in_the_schema() -> None:
    tent = LawShape("tent", "Tent", "Up and down", lambda law, t: t, lambda law, t, side: side)
    document = samples.document()
    remove = add_shape(tent)
    try:
        varied = edits.add_law(document, Law("omega", "tent"))
        data = project_file.dumps(varied)
        assert project_file.loads(data) == varied
        jsonschema.Draft202012Validator(schema()).validate(json.loads(data))
        assert not VALIDATOR.is_valid(json.loads(data))
        with pytest.raises(ValueError, match="there is a law 'tent' already"):
            add_shape(tent)
    finally:
        remove()
    with pytest.raises(
        project_file.FileError, match=r'variation\[0\]\.law is "tent"; allowed is "paper"'
    ):
        project_file.loads(data)
