"""The ``states`` section of a project file, read and checked."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from sgb_core.document.errors import FileError
from sgb_core.document.file.fields import Fields, Node
from sgb_core.document.model import MAX_STATE_NAME, MAX_STATES, Document


def read_states(
    node: Node, read_document: Callable[[Fields, str], Document]
) -> tuple[Document, ...]:
    """Return the named states; ``read_document`` reads one state's fields under its name."""
    if not node.is_given:
        return ()
    found: dict[str, Document] = {}
    for item in node.array(f"a list of at most {MAX_STATES} states", 0, MAX_STATES):
        fields = item.object('an object {"name": ..., "profile": ...}')
        name = fields["name"].text("")
        if not 1 <= len(name) <= MAX_STATE_NAME:
            fields["name"].fail(f"a text of 1 to {MAX_STATE_NAME} characters")
        if name in found:
            raise FileError(
                f"{item.path}.name is that of an earlier state; allowed is a name of its own"
            )
        state = read_document(fields, name)
        found[name] = replace(state, extra=fields.rest())
    return tuple(found.values())
