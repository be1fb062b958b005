from __future__ import annotations

import base64
import itertools
import json
import os
import random
import stat
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.appearance.pictures import encode_png
from sgb_core.document.errors import FileError
from sgb_core.document.file import journal as journals
from sgb_core.document.file import private, project_file, recovery
from sgb_core.document.file.journal import Journal
from sgb_core.document.file.records import record, records
from sgb_core.document.file.recovery import Recoverable, aside, recoverable
from sgb_core.document.model import Document
from sgb_core.fields.extra import Extra
from tests.sgb_core.document import samples

DOCUMENT = samples.document()
PICTURE = encode_png(np.random.default_rng(1).integers(0, 256, (64, 64, 4), np.uint8))


class Place:
    """A folder of journals and one of locks, and what the next start finds there."""

    def __init__(self, root: Path) -> None:
        self.folder, self.locks = root / "journals", root / "locks"

    def journal(self) -> Journal:
        return Journal(self.folder, self.locks)

    def found(self) -> list[Recoverable]:
        return recoverable(self.folder, self.locks)


@pytest.fixture
def place(tmp_path: Path) -> Place:
    return Place(tmp_path)


def worked(document: Document, steps: int) -> list[Document]:
    """Return what follows from a document step by step, by edits of several of its sections."""
    made = []
    for step in range(steps):
        if step % 3 == 0:
            document = edits.set_shape_parameter(document, 0, "lambda2", 1.0 + step % 5)
        elif step % 3 == 1:
            document = edits.rename(document, f"step {step}")
        else:
            document = edits.store_state(document, f"state {step}")
        made.append(document)
    return made


def test_what_a_crash_left_is_found_with_its_place(place: Place, tmp_path: Path) -> None:
    assert place.found() == []
    journal = place.journal()
    assert journal.write(DOCUMENT, tmp_path / "vase.sgb")
    assert not journal.write(DOCUMENT)
    journal.close()
    (found,) = place.found()
    assert found.document == DOCUMENT
    assert found.target == tmp_path / "vase.sgb"
    assert found.entry == journal.entry
    assert found.steps == 1


def test_every_step_is_appended_and_the_last_is_found(place: Place) -> None:
    journal, size = place.journal(), 0
    for document in worked(DOCUMENT, 12):
        journal.write(document)
        assert journal.entry.stat().st_size > size
        size = journal.entry.stat().st_size
    journal.close()
    (found,) = place.found()
    assert found.document == document
    assert found.steps == 12


def test_a_torn_or_damaged_end_loses_no_step_before_it(place: Place) -> None:
    journal, ends, documents = place.journal(), [], worked(DOCUMENT, 8)
    for document in documents:
        journal.write(document)
        ends.append(journal.entry.stat().st_size)
    journal.close()
    whole, drawn = journal.entry.read_bytes(), random.Random(7)
    for cut in {*ends, *(end - 1 for end in ends[1:]), *drawn.sample(range(ends[0], ends[-1]), 40)}:
        last = max(k for k, end in enumerate(ends) if end <= cut)
        for torn in (whole[:cut], whole[:cut] + b"\0" * 64, whole[:cut] + whole[: len(whole) // 2]):
            # Whole records after the cut would be steps: only the part that is none is damage.
            if cut in ends and torn.endswith(whole[: len(whole) // 2]):
                continue
            journal.entry.write_bytes(torn)
            (found,) = place.found()
            assert found.document == documents[last]


def test_a_damaged_byte_hides_what_follows_it_and_nothing_else() -> None:
    lines = [record({"step": k}) for k in range(5)]
    data = bytearray(b"".join(lines))
    data[len(lines[0]) + len(lines[1]) + 12] ^= 1
    assert [json.loads(text) for text in records(bytes(data))] == [{"step": 0}, {"step": 1}]


def test_an_entry_or_folder_taken_away_is_written_anew(place: Place) -> None:
    journal = place.journal()
    first, second, third = worked(DOCUMENT, 3)
    journal.write(first)
    journal.entry.unlink()
    journal.write(second)
    assert journal.entry.exists()
    journal.entry.unlink()
    place.folder.rmdir()
    journal.write(third)
    journal.close()
    (found,) = place.found()
    assert (found.document, found.steps) == (third, 3)


def test_pictures_are_written_once(place: Place) -> None:
    pictured = edits.add_picture(DOCUMENT, PICTURE)
    stored = edits.store_state(pictured, "kept")
    journal = place.journal()
    journal.write(pictured)
    first = journal.entry.stat().st_size
    journal.write(stored)
    journal.write(edits.set_appearance(stored, color="#123456"))
    grown = journal.entry.stat().st_size - first
    assert grown < len(PICTURE)
    journal.close()
    (found,) = place.found()
    assert found.document == edits.set_appearance(stored, color="#123456")


def long_document(segments: int) -> Document:
    ends = [(20.0 + k % 3, 5.0 * k) for k in range(segments + 1)]
    return Document(Profile.of([line(a, b) for a, b in itertools.pairwise(ends)]))


@pytest.mark.parametrize("prepared", [False, True])
def test_a_step_of_one_segment_is_short_however_long_the_profile(
    place: Place, prepared: bool
) -> None:
    document, journal = long_document(500), place.journal()
    if prepared:
        journal.prepare(document)
    before = 0
    for segment in (3, 499, 3):
        for value in (2.0, 5.0):
            document = edits.set_shape_parameter(document, segment, "lambda2", value)
            journal.write(document)
            grown = journal.entry.stat().st_size - before
            assert before == 0 or grown < 1000
            before += grown
    # A step of other parts than the segments, and one that changes their number.
    document = edits.set_rule(document, 7, "free")
    journal.write(document)
    document, _ = edits.split_segment(edits.rename(document, "shorter"), 4, 0.25)
    journal.write(document)
    document = edits.set_shape_parameter(document, 5, "omega", 0.5)
    journal.write(document)
    journal.close()
    (found,) = place.found()
    assert (found.document, found.steps) == (document, 9)


def test_many_segments_at_once_come_back_to_the_last_bit(place: Place) -> None:
    document, journal = long_document(60), place.journal()
    held = replace(document.profile[5], holds_end=True, extra=Extra({"note": "x", "Δ": [1]}))
    point = replace(document.profile[7], points=document.profile[7].points * (-0.0, 1.0 / 3.0))
    segments = [*document.profile.segments[:5], held, *document.profile.segments[6:]]
    segments[7] = point
    document = replace(document, profile=Profile.of(segments, ["free"] * 59))
    for made in (
        document,
        edits.scale(document, 1.0 / 3.0),
        edits.set_shape_parameter(edits.scale(document, 1.0 / 3.0), None, "omega", 0.1),
    ):
        journal.write(made)
        (found,) = recoverable(place.folder, place.locks.with_name("others"))
        assert found.document == made
        for one, other in zip(found.document.profile, made.profile, strict=True):
            assert one.points.tobytes() == other.points.tobytes()
            assert one.shape == other.shape
    journal.close()


@pytest.mark.parametrize(
    "packed",
    [
        3,
        "no base64!",
        base64.b64encode(b"short").decode(),
        base64.b64encode(np.full(12, np.nan).tobytes()).decode(),
        base64.b64encode(np.zeros(24).tobytes()).decode(),
    ],
)
def test_packed_segments_that_make_no_sense_are_set_aside(place: Place, packed: object) -> None:
    tree = project_file.tree_of(samples.document(samples.VASE[:1]))
    place.folder.mkdir()
    first = record({"step": 1, "sections": {"profile": {"profile": tree["profile"]}}})
    changed = {"numbers": [0], "packed": packed, "more": {}}
    second = record({"step": 2, "sections": {}, "segments": changed})
    (place.folder / "0.recovery").write_bytes(first + second)
    assert place.found() == []
    assert len(aside(place.folder)) == 1


@pytest.mark.parametrize("wrong", [{"7": {}}, {"x": {}}, [], {"0": 3}])
def test_a_step_of_a_segment_that_is_not_there_is_set_aside(place: Place, wrong: object) -> None:
    tree = project_file.tree_of(samples.document(samples.VASE[:1]))
    place.folder.mkdir()
    first = record({"step": 1, "sections": {"profile": {"profile": tree["profile"]}}})
    second = record({"step": 2, "sections": {}, "segments": wrong})
    (place.folder / "0.recovery").write_bytes(first)
    assert len(place.found()) == 1
    (place.folder / "0.recovery").write_bytes(first + second)
    assert place.found() == []
    assert len(aside(place.folder)) == 1


def test_a_large_entry_is_begun_anew(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(journals, "LARGE", 2000)
    journal = place.journal()
    documents = [edits.rename(DOCUMENT, "n" * (1 + k)) for k in range(200)]
    for document in documents:
        journal.write(document)
    size, first = journal.entry.stat().st_size, len(project_file.dumps(DOCUMENT))
    assert size < 2000 + 2 * journals.GROWN * first
    journal.close()
    (found,) = place.found()
    assert (found.document, found.steps) == (documents[-1], 200)


def test_the_newest_comes_first_and_broken_ones_are_set_aside(place: Place) -> None:
    for size in (2, 1):
        journal = place.journal()
        journal.write(samples.document(samples.VASE[:size]))
        journal.close()
    (place.folder / "0-broken.recovery").write_bytes(b"{")
    (place.folder / "x.recovery").write_bytes(b'{"target": 3, "document": {}}')
    (place.folder / "y.recovery").write_bytes(record({"sections": {"profile": {"profile": 3}}}))
    (place.folder / "z.recovery").symlink_to(place.folder / "elsewhere")
    found = place.found()
    assert [len(item.document.profile) for item in found] == [1, 2]
    assert [item.target for item in found] == [None, None]
    assert {left.name[0] for left in aside(place.folder)} == {"0", "x", "y", "z"}


def test_an_entry_of_the_first_version_is_read(place: Place) -> None:
    place.folder.mkdir()
    entry = {"target": "vase.sgb", "document": project_file.tree_of(DOCUMENT)}
    (place.folder / "77-abc.recovery").write_text(json.dumps(entry))
    (found,) = place.found()
    assert (found.document, found.target) == (DOCUMENT, Path("vase.sgb"))


def test_work_of_running_programs_is_not_offered(place: Place) -> None:
    journal = place.journal()
    journal.write(DOCUMENT)
    assert place.found() == []
    assert journal.entry.exists()
    journal.clear()
    assert not journal.entry.exists()
    journal.clear()
    assert journal.write(DOCUMENT)


def test_found_work_goes_to_one_journal_alone(place: Place) -> None:
    left = place.journal()
    left.write(DOCUMENT)
    left.close()
    (item,) = place.found()
    first, second = place.journal(), place.journal()
    assert first.adopt(item)
    assert not second.adopt(item)
    assert not left.entry.exists()
    first.close()
    assert [each.document for each in place.found()] == [DOCUMENT]


def test_entries_are_private_and_links_are_not_followed(place: Place, tmp_path: Path) -> None:
    place.folder.mkdir(mode=0o755)
    journal = place.journal()
    journal.write(DOCUMENT)
    assert stat.S_IMODE(place.folder.stat().st_mode) == private.FOLDER_MODE
    assert stat.S_IMODE(place.locks.stat().st_mode) == private.FOLDER_MODE
    assert stat.S_IMODE(journal.entry.stat().st_mode) == private.FILE_MODE
    victim = tmp_path / "victim"
    victim.write_bytes(b"untouched")
    journal.entry.unlink()
    journal.entry.symlink_to(victim)
    journal.write(replace(DOCUMENT, name="other"))
    assert victim.read_bytes() == b"untouched"
    assert not journal.entry.is_symlink()
    os.symlink(tmp_path, tmp_path / "link")
    with pytest.raises(FileError, match="link"):
        Journal(tmp_path / "link", place.locks).write(DOCUMENT)


def test_what_a_kill_left_is_cleaned_away(place: Place) -> None:
    journal = place.journal()
    journal.write(DOCUMENT)
    half = place.folder / ".sgb-0123456789abcdef.tmp"
    half.write_bytes(b"half")
    (place.locks / f"{4567:016}.lock").touch()
    recovery.clean(place.folder, place.locks)
    assert not half.exists()
    assert [each.stem for each in place.locks.iterdir()] == [journal.entry.stem]
    journal.clear()


def test_a_folder_that_cannot_be_made_is_one_line(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(FileError, match="cannot write"):
        Journal(tmp_path / "file", tmp_path / "locks").write(DOCUMENT)
