"""Guides: added, moved, removed, kept in the file, and as large as the object."""

import pytest

import sgb_core as sgb
from sgb_core.document import edits
from sgb_core.document.errors import EditError
from sgb_core.document.file import project_file
from sgb_core.document.guides import MAX_GUIDES, Guide, GuideAt
from sgb_core.findings.refusal import RefusalError
from tests.sgb_core.design.locks.samples import locked, pot, wavy


def guided():
    document = sgb.Document(wavy(2))
    for guide in (Guide("r", 30.0), Guide("h", -4.5)):
        document = edits.add_guide(document, guide)
    return document


def test_they_are_added_once_moved_and_removed():
    document = guided()
    assert [(each.at, each.value) for each in document.guides] == [("r", 30.0), ("h", -4.5)]
    assert edits.add_guide(document, Guide(GuideAt.RADIUS, 30.0)) is document
    moved = edits.move_guide(document, 1, 12.0)
    assert moved.guides[1] == Guide("h", 12.0)
    assert moved.guides[0] is document.guides[0]
    assert edits.remove_guide(moved, 0).guides == (Guide("h", 12.0),)
    bare = edits.remove_guides(moved)
    assert bare.guides == ()
    assert edits.remove_guides(bare) is bare


def test_what_cannot_be_is_refused_in_words():
    document = guided()
    with pytest.raises(EditError, match="there is no guide 2; allowed is 0 to 1"):
        edits.remove_guide(document, 2)
    with pytest.raises(EditError, match=r"guide\.value"):
        edits.move_guide(document, 0, 2e9)
    with pytest.raises(RefusalError, match=r'guide\.at is "x"; allowed is "r", "h"'):
        Guide("x", 1.0)
    for value in range(MAX_GUIDES - 2):
        document = edits.add_guide(document, Guide("r", 100.0 + value))
    with pytest.raises(EditError, match="a project keeps at most 100 guides"):
        edits.add_guide(document, Guide("h", 1.0))


def test_they_are_kept_in_the_file_and_old_files_have_none():
    document = guided()
    again = project_file.loads(project_file.dumps(document))
    assert again.guides == document.guides
    assert project_file.loads(project_file.dumps(sgb.Document(wavy(1)))).guides == ()


def test_they_are_as_large_as_the_object_and_change_nothing_of_it():
    document = guided()
    inches = edits.set_unit(document, "in", convert=True)
    assert [each.value for each in inches.guides] == pytest.approx([30.0 / 25.4, -4.5 / 25.4])
    assert document.volume == sgb.Document(wavy(2)).volume
    held = locked(pot(2), "capacity")
    assert edits.add_guide(held, Guide("h", 3.0)).profile is held.profile
