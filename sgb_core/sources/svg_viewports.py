"""What an SVG file draws by reference or in boxes of its own, as plain groups.

``use`` elements become copies of what they name, symbols and nested ``svg`` elements groups with
the transform that their viewBox means (SVG 2, 8.2 and 5.6). The reader then needs neither.
"""

from __future__ import annotations

import re
from xml.etree import ElementTree

_SVG = "{http://www.w3.org/2000/svg}"
_HREFS = ("href", "{http://www.w3.org/1999/xlink}href")
# Of a box or a reference, not of the group that it becomes.
_BOX = frozenset(
    {"x", "y", "width", "height", "viewBox", "preserveAspectRatio", "transform", *_HREFS}
)
_LENGTH = re.compile(r"^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([a-zA-Z]*|%)\s*$")
# User units of the units of length: 96 to the inch.
_INCH = 96.0
_UNITS = {
    "": 1.0,
    "px": 1.0,
    "in": _INCH,
    "mm": _INCH / 25.4,
    "cm": _INCH / 2.54,
    "q": _INCH / 101.6,
    "pt": _INCH / 72.0,
    "pc": _INCH / 6.0,
}
_ALIGNED = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}
_ASPECT = re.compile(r"x(Min|Mid|Max)Y(Min|Mid|Max)(?:\s+(meet|slice))?")
_Viewport = tuple[float, float]


def without_viewports(root: ElementTree.Element) -> ElementTree.Element:
    """Return a tree that draws the same, of groups and shapes alone.

    What ``use`` elements name must not name them in turn; the tree's size is the caller's care.
    """
    named = {element.get("id", ""): element for element in root.iter() if element.get("id")}
    box = _box(root.get("viewBox"))
    if box is not None:
        viewport = (box[2], box[3])
    else:
        viewport = (_length(root.get("width"), 0.0, 0.0), _length(root.get("height"), 0.0, 0.0))
    whole = ElementTree.Element(root.tag, root.attrib)
    whole.extend(_children(root, viewport, named))
    return whole


def local_name(element: ElementTree.Element) -> str:
    """Return the name of an element without its namespace."""
    return str(element.tag).rpartition("}")[2]


def named_by(use: ElementTree.Element) -> str:
    """Return the name of the element of this file that a ``use`` draws, '' for none."""
    link = next((use.get(href, "") for href in _HREFS if use.get(href)), "")
    return link[1:] if link.startswith("#") else ""


def _children(
    element: ElementTree.Element, viewport: _Viewport, named: dict[str, ElementTree.Element]
) -> list[ElementTree.Element]:
    found = (_drawn(child, viewport, named) for child in element)
    return [child for child in found if child is not None]


def _drawn(
    element: ElementTree.Element, viewport: _Viewport, named: dict[str, ElementTree.Element]
) -> ElementTree.Element | None:
    name = local_name(element)
    if name == "symbol":
        # Drawn where it is named, not where it stands.
        return None
    if name == "svg":
        place = [
            _length(element.get(key), 0.0, side) for key, side in zip("xy", viewport, strict=True)
        ]
        return _boxed(element, element, place, viewport, named)
    if name == "use":
        target = named.get(named_by(element))
        if target is None:
            return None
        group = ElementTree.Element(f"{_SVG}g", _own(element))
        x, y = (
            _length(element.get(key), 0.0, side) for key, side in zip("xy", viewport, strict=True)
        )
        group.set("transform", f"{element.get('transform', '')} translate({x!r} {y!r})".strip())
        if local_name(target) in ("symbol", "svg"):
            inner = _boxed(target, element, [0.0, 0.0], viewport, named)
        else:
            inner = _drawn(target, viewport, named)
        if inner is not None:
            group.append(inner)
        return group
    copy = ElementTree.Element(element.tag, element.attrib)
    copy.text = element.text
    copy.extend(_children(element, viewport, named))
    return copy


def _boxed(
    element: ElementTree.Element,
    sized_by: ElementTree.Element,
    place: list[float],
    viewport: _Viewport,
    named: dict[str, ElementTree.Element],
) -> ElementTree.Element | None:
    """Return the group that a symbol or a nested ``svg`` is, None for one without an extent."""
    width, height = (
        _length(sized_by.get(key, element.get(key)), side, side)
        for key, side in zip(("width", "height"), viewport, strict=True)
    )
    box = _box(element.get("viewBox"))
    # Without a size of its own in a drawing of none it keeps the scale that it has.
    for key, size in (("width", width), ("height", height)):
        if size <= 0.0 and sized_by.get(key, element.get(key)) is not None:
            return None
    (x, y), across, up = place, 1.0, 1.0
    inside = (width, height)
    if box is not None:
        inside = (box[2], box[3])
        if width > 0.0 and height > 0.0:
            across, up = width / box[2], height / box[3]
        ratio = element.get("preserveAspectRatio", "").strip()
        if ratio != "none":
            match = _ASPECT.match(ratio)
            parts = match.groups() if match else ("Mid", "Mid", "meet")
            across = up = max(across, up) if parts[2] == "slice" else min(across, up)
            x += _ALIGNED[parts[0]] * (width - across * box[2]) if width > 0.0 else 0.0
            y += _ALIGNED[parts[1]] * (height - up * box[3]) if height > 0.0 else 0.0
        x, y = x - across * box[0], y - up * box[1]
    group = ElementTree.Element(f"{_SVG}g", _own(element))
    matrix = f"matrix({across!r} 0 0 {up!r} {x!r} {y!r})"
    group.set("transform", f"{element.get('transform', '')} {matrix}".strip())
    group.extend(_children(element, inside, named))
    return group


def _own(element: ElementTree.Element) -> dict[str, str]:
    return {key: value for key, value in element.attrib.items() if key not in _BOX}


def _box(text: str | None) -> tuple[float, float, float, float] | None:
    """Return the four numbers of a viewBox, None where it has no extent."""
    try:
        x, y, width, height = (float(word) for word in re.split(r"[\s,]+", (text or "").strip()))
    except ValueError:
        return None
    return (x, y, width, height) if 0.0 < width < 1e300 and 0.0 < height < 1e300 else None


def _length(text: str | None, default: float, whole: float) -> float:
    """Return a length in user units; per cent are of ``whole``."""
    match = _LENGTH.match(text or "")
    if match is None:
        return default
    if match[2] == "%":
        return float(match[1]) / 100.0 * whole
    return float(match[1]) * _UNITS.get(match[2].lower(), 1.0)
