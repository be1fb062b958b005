"""Pictures stand in a file once, however many states use them.

The first document or state of a file that has a picture holds it as base64 text; in the others
its SHA-256 stands in its place.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from sgb_core.document.appearance.picture_file import PICTURE, Picture
from sgb_core.document.model import Document
from sgb_core.findings.refusal import RefusalError

_NAME = re.compile(r"[0-9a-f]{64}")


def share(document: Document, tree: Mapping[str, object], known: set[str]) -> dict[str, object]:
    """Return a document's tree in which pictures of ``known`` names stand by their names.

    The names of those that stand in full are added to ``known``.
    """

    def named(own: Document, texts: list[object]) -> list[object]:
        found: list[object] = []
        for picture, text in zip(own.appearance.pictures, texts, strict=True):
            found.append(picture.name if picture.name in known else text)
            known.add(picture.name)
        return found

    shared = _with_own(tree, lambda texts: named(document, texts))
    states = tree.get("states")
    if isinstance(states, list):
        shared["states"] = [
            _with_own(plain, lambda texts, own=own: named(own, texts))  # type: ignore[misc]
            for own, plain in zip(document.states, states, strict=True)
        ]
    source, kept = tree.get("reference"), document.reference
    if isinstance(source, Mapping) and kept is not None and kept.picture is not None:
        name = kept.picture.name
        if name in known:
            shared["reference"] = {**source, "picture": name}
        known.add(name)
    return shared


def pictures_of(document: Document) -> tuple[Picture, ...]:
    """Return the pictures of a document, its states and its reference."""
    found = [picture for own in (document, *document.states) for picture in own.appearance.pictures]
    if document.reference is not None and document.reference.picture is not None:
        found.append(document.reference.picture)
    return tuple(found)


def unshare(tree: Mapping[str, Any], given: Mapping[str, Picture]) -> dict[str, object]:
    """Return the tree of a file with the pictures themselves, each made once, in their places.

    ``given`` are pictures by their names from elsewhere. What is no picture stays as it is, for
    the reader to refuse where it stands.
    """
    by_text: dict[str, Picture] = {}
    by_name = dict(given)

    def made(texts: list[object]) -> list[object]:
        for text in texts:
            if isinstance(text, str) and text not in by_text and not _NAME.fullmatch(text):
                try:
                    picture = by_text[text] = PICTURE.from_plain(text, ())
                except RefusalError:
                    continue
                by_name[picture.name] = picture
        return texts

    def put(texts: list[object]) -> list[object]:
        return [
            by_text.get(text) or by_name.get(text, text) if isinstance(text, str) else text
            for text in texts
        ]

    # A state may stand in the file before what it refers to: all are made first.
    return _everywhere(_everywhere(tree, made), put)


def _everywhere(
    tree: Mapping[str, Any], change: Callable[[list[object]], list[object]]
) -> dict[str, object]:
    changed = _with_pictures(tree, change)
    states = tree.get("states")
    if isinstance(states, list):
        changed["states"] = [
            _with_pictures(state, change) if isinstance(state, dict) else state for state in states
        ]
    return changed


def _with_own(
    tree: Mapping[str, Any], change: Callable[[list[object]], list[object]]
) -> dict[str, object]:
    """Return a tree with its own list of pictures changed, the same where it has none."""
    appearance = tree.get("appearance")
    if not isinstance(appearance, Mapping) or not isinstance(appearance.get("pictures"), list):
        return dict(tree)
    return {**tree, "appearance": {**appearance, "pictures": change(appearance["pictures"])}}


def _with_pictures(
    tree: Mapping[str, Any], change: Callable[[list[object]], list[object]]
) -> dict[str, object]:
    """Return a tree with its own list of pictures changed, and that of its reference."""
    changed = _with_own(tree, change)
    source = tree.get("reference")
    if isinstance(source, Mapping) and source.get("picture") is not None:
        changed["reference"] = {**source, "picture": change([source["picture"]])[0]}
    return changed
