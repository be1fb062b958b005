"""What of the view can be changed is what it has."""

from typing import get_type_hints

from app.state.view_state import ViewChanges, ViewState


def test_every_field_of_the_view_can_be_changed_and_no_other():
    assert get_type_hints(ViewChanges) == get_type_hints(ViewState)
