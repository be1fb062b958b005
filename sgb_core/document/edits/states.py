"""Named states of a document: kept in its file, stored, shown again, renamed, thrown away.

A state is a document of its own, without states, under the state's name. It shares its unchanged
parts with the document it was taken from, so keeping many costs little.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import count
from string import ascii_uppercase

from sgb_core.document.edits.checks import checked
from sgb_core.document.edits.whole import set_unit
from sgb_core.document.errors import EditError
from sgb_core.document.model import MAX_STATES, Document
from sgb_core.document.plates import MAX_STATE_NAME
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import check_text
from sgb_core.findings.edits import NoState, StateNameLength, StateTaken, TooMany


def state(document: Document, name: str) -> Document:
    """Return a state of a document as it was stored; raises EditError where there is none."""
    return document.states[_index(document, name)]


def state_in_unit(document: Document, name: str) -> Document:
    """Return a state in the unit of the document, fit to be laid over it at its true size."""
    return set_unit(state(document, name), document.unit, convert=True)


def free_state_name(document: Document) -> str:
    """Return the next name that no state has: A, B, ... Z, then A2, B2 and so on."""
    taken = {each.name for each in document.states}
    return next(name for name in _names() if name not in taken)


def present_state(document: Document) -> str | None:
    """Return the name of the first state that the document equals, None where it differs."""
    return next(
        (each.name for each in document.states if _frozen(document, each.name) == each), None
    )


def store_state(document: Document, name: str) -> Document:
    """Keep the document as it is now under a name; a state of that name is replaced.

    Raises EditError for a name no file can hold and beyond MAX_STATES states.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> kept = sgb.edits.store_state(cylinder, "first")
    >>> doubled = sgb.edits.scale(kept, 2)
    >>> doubled.height, sgb.edits.switch_state(doubled, "first").height
    (120.0, 60.0)
    """
    stored = _frozen(document, _checked_name(name))
    names = [each.name for each in document.states]
    states = list(document.states)
    if name in names:
        if states[names.index(name)] == stored:
            return document
        states[names.index(name)] = stored
    else:
        if len(states) >= MAX_STATES:
            raise EditError(TooMany("states", MAX_STATES))
        states.append(stored)
    return replace(document, states=tuple(states))


def switch_state(document: Document, name: str) -> Document:
    """Make the document as it was when the state was stored; its name and states stay."""
    wanted = state(document, name)
    shown = replace(
        wanted,
        name=document.name,
        states=document.states,
        plate=document.plate,
        reference=document.reference,
        extra=document.extra,
    )
    return document if shown == document else shown


def rename_state(document: Document, name: str, new: str) -> Document:
    """Give a state another name; raises EditError where another state has it."""
    index = _index(document, name)
    if new == name:
        return document
    _free(document, _checked_name(new))
    return _with_state(document, index, replace(document.states[index], name=new))


def duplicate_state(document: Document, name: str, new: str) -> Document:
    """Keep a copy of a state under another name, directly after it."""
    index = _index(document, name)
    _free(document, _checked_name(new))
    if len(document.states) >= MAX_STATES:
        raise EditError(TooMany("states", MAX_STATES))
    copy = replace(document.states[index], name=new)
    states = (*document.states[: index + 1], copy, *document.states[index + 1 :])
    return replace(document, states=states)


def delete_state(document: Document, name: str) -> Document:
    """Throw a state away; the document itself stays as it is."""
    index = _index(document, name)
    return replace(document, states=document.states[:index] + document.states[index + 1 :])


def _frozen(document: Document, name: str) -> Document:
    return replace(document, name=name, states=(), plate=None, reference=None, extra=NO_EXTRA)


def _index(document: Document, name: str) -> int:
    for index, each in enumerate(document.states):
        if each.name == name:
            return index
    raise EditError(NoState(name))


def _free(document: Document, name: str) -> None:
    if any(each.name == name for each in document.states):
        raise EditError(StateTaken(name))


def _with_state(document: Document, index: int, changed: Document) -> Document:
    states = list(document.states)
    states[index] = changed
    return replace(document, states=tuple(states))


def _checked_name(name: str) -> str:
    if not 1 <= len(name) <= MAX_STATE_NAME:
        raise EditError(StateNameLength(MAX_STATE_NAME))
    checked(lambda: check_text(name, ("name",)))
    return name


def _names() -> Iterator[str]:
    for turn in count(1):
        yield from (letter if turn == 1 else f"{letter}{turn}" for letter in ascii_uppercase)
