import base64
import json

import jsonschema
import numpy as np
import pytest
from hypothesis import given

import resources
from sgb_core.document import edits
from sgb_core.document.appearance.finishes import FINISHES, base_color
from sgb_core.document.appearance.model import Appearance, MaterialName
from sgb_core.document.appearance.pictures import PictureError, check_picture, decode, encode_png
from sgb_core.document.edits import EditError
from sgb_core.document.file import project_file
from sgb_core.document.file.project_file import FileError
from tests.sgb_core.document.samples import document as vase
from tests.sgb_core.document.strategies import looks

SCHEMA = jsonschema.Draft202012Validator(json.loads(resources.read("sgb-document.schema.json")))


def fields_of(appearance):
    names = [name for name in Appearance.__dataclass_fields__ if name != "extra"]
    return {name: getattr(appearance, name) for name in names}


@given(looks())
def test_a_look_comes_back_from_the_file_and_fits_the_schema(appearance):
    document = edits.set_appearance(vase(), **fields_of(appearance))
    data = project_file.dumps(document)
    SCHEMA.validate(json.loads(data))
    assert project_file.loads(data).appearance == appearance == document.appearance


def test_a_plain_look_leaves_no_trace_in_the_file():
    assert b"appearance" not in project_file.dumps(vase())


def read(section):
    tree = json.loads(project_file.dumps(vase()))
    tree["appearance"] = section
    data = json.dumps(tree).encode()
    try:
        return project_file.loads(data).appearance
    except FileError:
        # What the reader refuses the schema refuses too, as far as a schema can tell.
        tree["appearance"].pop("pictures", None)
        raise


@pytest.mark.parametrize(
    ("section", "place"),
    [
        ({"material": "gold"}, "appearance.material"),
        ({"color": "red"}, "appearance.color"),
        ({"shadow": 1}, "appearance.shadow"),
        ({"textures": [{"image": "../secret"}]}, "appearance.textures[0].image"),
        ({"textures": [{"image": "a" * 64}]}, "appearance.textures[0].image"),
        ({"textures": [{"image": "wood", "repeat": [0, 1]}]}, "appearance.textures[0].repeat"),
        ({"textures": [{"image": "wood", "segments": [-1]}]}, "appearance.textures[0].segments[0]"),
        ({"drawing": [{"kind": "gradient"}]}, "appearance.drawing[0].stops"),
        ({"drawing": [{"kind": "band", "from": 2}]}, "appearance.drawing[0].from"),
        ({"map": {"of": "radius", "low": 2, "high": 1}}, "appearance.map.high"),
        ({"map": {"of": "mood"}}, "appearance.map.of"),
        ({"map": {"of": "influence", "parameter": "mu"}}, "appearance.map.parameter"),
        ({"pictures": ["no picture"]}, "appearance.pictures[0]"),
    ],
)
def test_what_breaks_the_rules_is_named(section, place):
    with pytest.raises(FileError) as refused:
        read(section)
    assert str(refused.value).startswith(place)
    assert "\n" not in str(refused.value)


def test_unknown_keys_are_kept():
    document = project_file.loads(
        json.dumps(
            {**json.loads(project_file.dumps(vase())), "appearance": {"sheen": 0.3}}
        ).encode()
    )
    assert json.loads(project_file.dumps(document))["appearance"] == {"sheen": 0.3}


def picture(width=6, height=4):
    pixels = np.arange(width * height * 3, dtype=np.uint8).reshape(height, width, 3)
    return pixels, encode_png(pixels)


def test_a_picture_of_the_users_travels_inside_the_project():
    pixels, data = picture()
    document = edits.add_picture(vase(), data)
    name = document.appearance.textures[0].image
    back = project_file.loads(project_file.dumps(document))
    assert back.appearance.picture(name).data == data
    assert np.array_equal(decode(data)[..., :3], pixels)
    assert (decode(data)[..., 3] == 255).all()
    bare = edits.set_appearance(document, textures=())
    assert bare.appearance.pictures == ()


def test_what_is_no_picture_is_refused():
    for data in (b"", b"GIF89a", b"\x89PNG\r\n\x1a\n" + b"0" * 40):
        with pytest.raises(PictureError):
            check_picture(data)
        with pytest.raises(EditError):
            edits.add_picture(vase(), data)
    section = {"pictures": [base64.b64encode(b"GIF89a").decode()]}
    with pytest.raises(FileError):
        read(section)


def test_a_picture_too_large_is_refused_unopened():
    _, data = picture(1, 1)
    # The header's width and height, as large as they go.
    bomb = data[:16] + (60_000).to_bytes(4, "big") * 2 + data[24:]
    with pytest.raises(PictureError):
        check_picture(bomb)


def test_an_edit_that_changes_nothing_gives_the_same_document():
    document = vase()
    assert edits.set_appearance(document, material="clay", shadow=False) is document
    with pytest.raises(EditError):
        edits.set_appearance(document, material="gold")
    with pytest.raises(TypeError, match="colour"):
        edits.set_appearance(document, colour="#ffffff")


def test_every_material_has_its_numbers():
    assert set(FINISHES) == set(MaterialName)
    for name in MaterialName:
        assert base_color(Appearance(name)) == FINISHES[name].color
        assert base_color(Appearance(name, "#102030")) == "#102030"
