from __future__ import annotations

from contextlib import suppress

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sgb_core.document.edits import EditError
from sgb_core.document.file import project_file
from sgb_core.document.model import Document
from sgb_core.findings.refusal import RefusalError
from tests.sgb_core.document.whole_strategies import whole_documents, whole_edits

calm = settings(deadline=None, suppress_health_check=list(HealthCheck))


@calm
@given(whole_documents(5))
def test_a_document_comes_back_exactly(document: Document) -> None:
    data = project_file.dumps(document)
    again = project_file.loads(data)
    assert again == document
    assert project_file.dumps(again) == data


@settings(calm, max_examples=60)
@given(whole_documents(), st.lists(whole_edits(), min_size=1, max_size=8))
def test_whatever_edits_make_can_be_saved_and_loaded(document: Document, steps: list) -> None:
    for step in steps:
        with suppress(EditError, RefusalError):
            document = step(document)
        assert project_file.loads(project_file.dumps(document)) == document


@calm
@given(whole_documents(), whole_edits())
def test_an_edit_keeps_what_it_does_not_concern(document: Document, step) -> None:
    with suppress(EditError, RefusalError):
        edited = step(document)
        assert edited.extra == document.extra
        assert edited.profile.extra == document.profile.extra
        if edited == document:
            assert edited is document
