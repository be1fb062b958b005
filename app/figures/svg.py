"""Makes a plate's SVG stand alone: words as words, and the letters they need inside the file."""

from __future__ import annotations

import base64
import re
from html import escape, unescape
from pathlib import Path
from typing import Literal

from matplotlib.font_manager import FontProperties, findfont

from sgb_core.drawings.fonts import subset

_WORDS = re.compile(r">([^<]*)<")
# One text as matplotlib writes it: its source as a comment, then a group with its place.
_GROUP = re.compile(
    r"<!-- (?P<source>(?:(?!-->).)*?) -->\s*"
    r'<g(?P<style>(?: style="[^"]*")?) transform="(?P<place>[^"]*)">\s*<text>\s*'
    r"(?P<body>.*?)</text>\s*</g>",
    re.DOTALL,
)
_SIZE = re.compile(r"font-size: ([0-9.]+)px")
_TOKEN = re.compile(r"\\[a-zA-Z]+|\\[,; ]|[_^]\{[^{}]*\}|[_^].|[0-9.]+|.", re.DOTALL)
_SYMBOLS = {
    "\\lambda": "λ",
    "\\omega": "ω",
    "\\theta": "θ",
    "\\kappa": "κ",
    "\\pi": "π",
}
_SIGNS = {"\\times": "×", "\\pm": "±", "\\leq": "≤", "\\geq": "≥", "-": "−"}
_SPACES = {"\\,": "\u2009", "\\;": "\u2005", "\\ ": "\u2004"}
_RELATIONS = {"=", "<", ">", "≤", "≥"}


def stand_alone(svg: str, family: str) -> str:
    """Return an SVG file whose texts can be read, searched and edited, fonts included."""
    svg = _GROUP.sub(lambda match: _rewritten(match, family), svg)
    letters = "".join(sorted(set(unescape("".join(_WORDS.findall(svg))))))
    faces = [_face(family, "normal", letters)]
    if "italic" in svg:
        faces.append(_face(family, "italic", letters))
    style = f'<style type="text/css">{"".join(faces)}</style>'
    return svg.replace("<defs>", f"<defs>{style}", 1)


def _rewritten(match: re.Match[str], family: str) -> str:
    """Return one text as a run of words instead of placed single letters, where it is simple."""
    size = _SIZE.search(match["body"])
    runs = _runs(unescape(match["source"]))
    if size is None or runs is None:
        return match[0]
    pixels = float(size[1])
    spans = "".join(_span(text, italic, low, pixels) for text, italic, low in runs)
    font = f"font-family: '{family}'; font-size: {size[1]}px; white-space: pre"
    return (
        f'<g{match["style"]} transform="{match["place"]}">'
        f'<text xml:space="preserve" style="{font}">{spans}</text></g>'
    )


def _span(text: str, italic: bool, low: bool, size: float) -> str:
    style = "font-style: italic; " if italic else ""
    if low:
        # A shift that is taken back after it: every reader of SVG knows dy.
        drop = 0.2 * size
        return (
            f'<tspan dy="{drop:.2f}" style="{style}font-size: {0.7 * size:.2f}px">{escape(text)}'
            f'</tspan><tspan dy="{-drop:.2f}">\u200b</tspan>'
        )
    return f'<tspan style="{style}">{escape(text)}</tspan>' if style else escape(text)


def _runs(source: str) -> list[tuple[str, bool, bool]] | None:
    """Return (text, italic, lowered) of a text with mathematics, None where it is not simple."""
    # A dollar that is one, and two dashes, which no comment holds: as matplotlib sets them.
    if "\\$" in source or "- -" in source:
        return None
    runs: list[tuple[str, bool, bool]] = []
    for number, part in enumerate(source.split("$")):
        if number % 2 == 0:
            runs.append((part, False, False))
            continue
        for token in _TOKEN.findall(part):
            run = _run(token)
            if run is None:
                return None
            runs.append(run)
    return [run for run in runs if run[0]]


def _run(token: str) -> tuple[str, bool, bool] | None:
    if token in _SYMBOLS:
        return _SYMBOLS[token], True, False
    if token in _SIGNS or token in _SPACES:
        return {**_SIGNS, **_SPACES}[token], False, False
    if token.startswith("_"):
        text = token[1:].strip("{}")
        return (text, False, True) if text.replace(",", "").isalnum() else None
    if token.startswith(("\\", "^")) or token in "{}":
        return None
    if token == " ":
        return "", False, False
    if token in _RELATIONS:
        return f"\u2005{token}\u2005", False, False
    return (f"{token}\u2009" if token == "," else token), token.isalpha(), False


def _face(family: str, style: Literal["normal", "italic"], letters: str) -> str:
    path = Path(findfont(FontProperties(family=family, style=style)))
    data = base64.b64encode(subset(path, letters, "woff")).decode("ascii")
    return (
        f"@font-face{{font-family:'{family}';font-style:{style};"
        f"src:url(data:font/woff;base64,{data}) format('woff')}}"
    )
