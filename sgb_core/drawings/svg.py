"""A page as SVG: true size, one group a layer, words as words with their letters in the file."""

from __future__ import annotations

import base64
from html import escape

from sgb_core.drawings import fonts
from sgb_core.drawings.page import Anchor, Area, Drawing, Mark, Page, Path, Pen, Stroke, Words
from sgb_core.lettering.fonts import font_path

_ANCHORS = {Anchor.START: "start", Anchor.MIDDLE: "middle", Anchor.END: "end"}


def svg_bytes(drawing: Drawing, number: int = 0) -> bytes:
    """Return one page of a drawing; a user unit is a millimetre, y runs downwards."""
    page = drawing.pages[number]
    width, height = _number(page.width), _number(page.height)
    title, subject = escape(drawing.title, quote=False), escape(drawing.subject, quote=False)
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<svg xmlns="http://www.w3.org/2000/svg" '
        'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        f'width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}">',
        f"  <title>{title}</title>",
        f"  <desc>{subject}; curves within {drawing.tolerance:g} mm</desc>",
    ]
    if page.letters:
        lines.append(f"  <style>{_face(page.letters)}</style>")
    for layer in page.layers:
        lines.append(f'  <g id="{layer}" inkscape:groupmode="layer" inkscape:label="{layer}">')
        lines += [f"    {_mark(mark, page)}" for mark in page.of_layer(layer)]
        lines.append("  </g>")
    lines.append("</svg>")
    return ("\n".join(lines) + "\n").encode()


def _face(letters: str) -> str:
    data = base64.b64encode(fonts.subset(font_path(), letters, "woff")).decode("ascii")
    return (
        f"@font-face{{font-family:'{fonts.FAMILY}';"
        f"src:url(data:font/woff;base64,{data}) format('woff')}}"
    )


def _mark(mark: Mark, page: Page) -> str:
    if isinstance(mark, Stroke):
        return f'<path fill="none" {_pen(mark.pen)} d="{_data(mark.paths, page)}"/>'
    if isinstance(mark, Area):
        data = _data(mark.paths, page)
        return f'<path fill="{mark.colour}" fill-rule="evenodd" stroke="none" d="{data}"/>'
    return _words(mark, page)


def _pen(pen: Pen) -> str:
    dashes = ""
    if pen.dashes:
        dashes = f' stroke-dasharray="{" ".join(map(_number, pen.dashes))}"'
    return (
        f'stroke="{pen.colour}" stroke-width="{_number(pen.width)}"{dashes} '
        'stroke-linecap="butt" stroke-linejoin="round"'
    )


def _words(words: Words, page: Page) -> str:
    x, y = words.at[0], page.height - words.at[1]
    turn = f' transform="rotate({_number(-words.turn_deg)} {_number(x)} {_number(y)})"'
    return (
        f'<text x="{_number(x)}" y="{_number(y)}"{turn if words.turn_deg else ""} '
        f'font-family="{fonts.FAMILY}" font-size="{_number(fonts.em(words.height))}" '
        f'text-anchor="{_ANCHORS[words.anchor]}">{escape(words.text, quote=False)}</text>'
    )


def _data(paths: tuple[Path, ...], page: Page) -> str:
    return " ".join(_path(path, page) for path in paths)


def _path(path: Path, page: Page) -> str:
    def point(place: tuple[float, float]) -> str:
        return f"{_number(place[0])} {_number(page.height - place[1])}"

    words = [f"M {point(path.pieces[0][0])}"]
    for piece in path.pieces:
        words.append(("L " if len(piece) == 2 else "C ") + " ".join(map(point, piece[1:])))
    return " ".join([*words, "Z"] if path.closed else words)


def _number(value: float) -> str:
    """Return a decimal number without an exponent, which some readers do not know."""
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
