"""What is saved can be opened: saving obeys the limits of reading, or says no and why."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sgb_core.document import edits
from sgb_core.document.appearance.pictures import encode_png
from sgb_core.document.errors import FileError
from sgb_core.document.file import json_text, project_file
from sgb_core.document.model import Document
from sgb_core.fields.extra import Extra
from tests.sgb_core.document import samples


def noise(seed: int, side: int) -> bytes:
    """Return a PNG of about 4 side² bytes: noise cannot be made smaller."""
    return encode_png(np.random.default_rng(seed).integers(0, 256, (side, side, 4), np.uint8))


def with_states(document: Document, count: int) -> Document:
    for number in range(count):
        document = edits.store_state(document, f"state {number}")
    return document


def test_eight_states_with_a_picture_of_3_mb_are_saved_and_loaded(tmp_path: Path) -> None:
    picture = noise(1, 880)
    assert 3_000_000 < len(picture) < 4_000_000
    document = with_states(edits.add_picture(samples.document(), picture), 8)
    project_file.save(document, tmp_path / "pot.sgb")
    assert (tmp_path / "pot.sgb").stat().st_size < 1.4 * len(picture)
    again = project_file.load(tmp_path / "pot.sgb")
    assert again == document
    # Opened once too.
    own = again.appearance.pictures[0]
    assert all(state.appearance.pictures[0] is own for state in again.states)


def test_a_picture_of_states_alone_stands_once_too() -> None:
    pictured = with_states(edits.add_picture(samples.document(), noise(2, 64)), 2)
    bare = edits.set_appearance(pictured, textures=(), pictures=())
    tree = json.loads(project_file.dumps(bare))
    lengths = [len(state["appearance"]["pictures"][0]) for state in tree["states"]]
    assert sorted(lengths)[0] == 64 < sorted(lengths)[1]
    assert project_file.loads(project_file.dumps(bare)) == bare
    # A state may stand before the one that it refers to.
    tree["states"].reverse()
    assert len(project_file.loads(json.dumps(tree).encode()).states) == 2


def test_a_picture_written_in_full_everywhere_is_read() -> None:
    document = with_states(edits.add_picture(samples.document(), noise(3, 16)), 2)
    tree = json.loads(project_file.dumps(document))
    for state in tree["states"]:
        state["appearance"]["pictures"] = tree["appearance"]["pictures"]
    assert project_file.loads(json.dumps(tree).encode()) == document


def test_the_name_of_a_picture_that_is_nowhere_is_refused_where_it_stands() -> None:
    document = with_states(edits.add_picture(samples.document(), noise(3, 16)), 1)
    tree = json.loads(project_file.dumps(document))
    tree["appearance"]["pictures"] = []
    tree["appearance"]["textures"] = []
    with pytest.raises(FileError, match=r"states\[0\]\.appearance\.pictures\[0\]"):
        project_file.loads(json.dumps(tree).encode())


def refused(document: Document, folder: Path) -> str:
    """Return why a document is not saved; the file that was there stays as it was."""
    path = folder / "pot.sgb"
    path.write_bytes(b"old")
    with pytest.raises(FileError) as caught:
        project_file.save(document, path)
    assert path.read_bytes() == b"old"
    assert [each.name for each in folder.iterdir()] == ["pot.sgb"]
    return str(caught.value)


def test_more_than_is_read_is_not_written(tmp_path: Path) -> None:
    document = samples.document()
    many = replace(document, extra=Extra({"note": [0] * (json_text.MAX_VALUES + 1)}))
    assert "more than 500000 values" in refused(many, tmp_path)
    large = replace(document, extra=Extra({"note": "x" * json_text.MAX_BYTES}))
    assert "larger than 32 MB" in refused(large, tmp_path)


def test_the_depth_that_is_read_is_the_depth_that_is_written(tmp_path: Path) -> None:
    document = samples.document()

    def nested(depth: int) -> Document:
        value: object = 1
        for _ in range(depth):
            value = [value]
        profile = replace(document.profile, extra=Extra({"note": value}))
        return replace(document, profile=profile)

    deepest = nested(json_text.MAX_DEPTH - 2)
    assert project_file.loads(project_file.dumps(deepest)) == deepest
    assert "nested deeper" in refused(nested(json_text.MAX_DEPTH - 1), tmp_path)
    # In a state it stands two levels deeper.
    assert "nested deeper" in refused(with_states(deepest, 1), tmp_path)
