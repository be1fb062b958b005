"""The elements of an SVG file: well-formed, of bounded size, with nothing from elsewhere."""

from __future__ import annotations

import re
from xml.etree import ElementTree

from sgb_core.findings.sources import NoSource, TooMuch, Unreadable
from sgb_core.sources.errors import SourceError
from sgb_core.sources.svg_viewports import local_name, named_by, without_viewports

_MOST_ELEMENTS, _DEEPEST = 200_000, 100


def svg_tree(data: bytes) -> ElementTree.Element:
    """Return the root of an SVG file, all of its names in SVG's own namespace.

    Symbols, ``use`` elements and nested drawings have become plain groups. Raises SourceError for
    what is no SVG, defines entities, or would be too large once its ``use`` elements are drawn.
    """
    # Entities are one way in which a small file becomes a large one, ``use`` is the other.
    if re.search(rb"<!ENTITY", data, re.IGNORECASE):
        raise SourceError(NoSource.ENTITIES)
    try:
        root = ElementTree.fromstring(data)
    except (ElementTree.ParseError, ValueError, LookupError) as error:
        raise SourceError(Unreadable("SVG", str(error))) from None
    if local_name(root) != "svg":
        raise SourceError(Unreadable("SVG", f"its root is <{local_name(root)}>"))
    _check_depth(root)
    _Sizes(root).size(root, 0)
    return without_viewports(root)


def _check_depth(root: ElementTree.Element) -> None:
    layer, depth, count = [root], 0, 0
    while layer:
        depth, count = depth + 1, count + len(layer)
        if depth > _DEEPEST:
            raise SourceError(TooMuch("elements inside each other", _DEEPEST))
        if count > _MOST_ELEMENTS:
            raise SourceError(TooMuch("elements", _MOST_ELEMENTS))
        layer = [child for element in layer for child in element]


class _Sizes:
    """How many elements are drawn for one, with those that ``use`` names."""

    def __init__(self, root: ElementTree.Element) -> None:
        self._named = {element.get("id"): element for element in root.iter() if element.get("id")}
        self._known: dict[int, int] = {}
        self._open: set[int] = set()

    def size(self, element: ElementTree.Element, depth: int) -> int:
        key = id(element)
        if key in self._known:
            return self._known[key]
        if key in self._open:
            raise SourceError(NoSource.USES_ITSELF)
        if depth > _DEEPEST:
            raise SourceError(TooMuch("elements inside each other", _DEEPEST))
        self._open.add(key)
        total = 1 + sum(self.size(child, depth + 1) for child in element)
        if local_name(element) == "use":
            target = self._named.get(named_by(element))
            total += self.size(target, depth + 1) if target is not None else 0
        self._open.remove(key)
        if total > _MOST_ELEMENTS:
            raise SourceError(TooMuch("elements", _MOST_ELEMENTS))
        self._known[key] = total
        return total
