"""A drawing as PDF (ISO 32000-1): layers, words with embedded letters, titles; always the same.

The letters are the part of one TrueType font that the words need, with a table that leads from
each back to its character, so that words are found and copied.
"""

from __future__ import annotations

import hashlib
import zlib
from io import BytesIO
from math import cos, radians, sin
from typing import Any

from sgb_core.drawings import fonts
from sgb_core.drawings.page import Anchor, Area, Drawing, Layer, Mark, Page, Path, Stroke, Words
from sgb_core.lettering.fonts import font_path
from sgb_core.values import dataclass

_POINTS = 72.0 / 25.4


def pdf_bytes(drawing: Drawing) -> bytes:
    """Return all pages of a drawing as one file."""
    return _Writer(drawing).made()


@dataclass(frozen=True, slots=True)
class _Letters:
    """The embedded font: the glyph and the advance (thousandths of the em) of each letter."""

    data: bytes
    glyphs: dict[str, int]
    advances: dict[str, float]
    box: tuple[int, int, int, int]
    ascent: int
    descent: int


def _letters(letters: str) -> _Letters:
    from fontTools.ttLib import TTFont

    data = fonts.subset(font_path(), letters or " ")
    font: Any = TTFont(BytesIO(data))
    part = 1000.0 / font["head"].unitsPerEm
    names = font.getBestCmap()
    glyphs, advances = {}, {}
    for letter in letters:
        name = names.get(ord(letter), ".notdef")
        glyphs[letter] = font.getGlyphID(name)
        advances[letter] = font["hmtx"][name][0] * part
    head, lines = font["head"], font["hhea"]
    box = (head.xMin, head.yMin, head.xMax, head.yMax)
    left, low, right, high = (round(value * part) for value in box)
    ascent, descent = round(lines.ascent * part), round(lines.descent * part)
    return _Letters(data, glyphs, advances, (left, low, right, high), ascent, descent)


class _Writer:
    """Numbers the objects of one file."""

    def __init__(self, drawing: Drawing) -> None:
        self._drawing = drawing
        self._objects: list[bytes] = []
        text = "".join(page.letters for page in drawing.pages)
        self._letters = _letters("".join(sorted(set(text))))
        self._layers: dict[Layer, int] = {}

    def _add(self, body: str | bytes) -> int:
        self._objects.append(body.encode("latin-1") if isinstance(body, str) else body)
        return len(self._objects)

    def _stream(self, data: bytes, entries: str = "") -> int:
        packed = zlib.compress(data, 9)
        head = f"<< /Length {len(packed)} /Filter /FlateDecode {entries}>>\nstream\n"
        return self._add(head.encode("latin-1") + packed + b"\nendstream")

    def made(self) -> bytes:
        drawing = self._drawing
        font = self._font()
        used = {layer for page in drawing.pages for layer in page.layers}
        for layer in Layer:
            if layer in used:
                self._layers[layer] = self._add(f"<< /Type /OCG /Name {_text(layer)} >>")
        properties = " ".join(f"/{layer} {ref} 0 R" for layer, ref in self._layers.items())
        resources = f"<< /Font << /F {font} 0 R >> /Properties << {properties} >> >>"
        contents = [self._stream(self._content(page)) for page in drawing.pages]
        # The pages come next, then the node that holds them.
        parent = len(self._objects) + len(contents) + 1
        pages = [
            self._add(
                f"<< /Type /Page /Parent {parent} 0 R /Resources {resources} "
                f"/MediaBox [0 0 {_number(page.width * _POINTS)} "
                f"{_number(page.height * _POINTS)}] /Contents {content} 0 R >>"
            )
            for page, content in zip(drawing.pages, contents, strict=True)
        ]
        kids = " ".join(f"{number} 0 R" for number in pages)
        self._add(f"<< /Type /Pages /Kids [{kids}] /Count {len(pages)} >>")
        groups = " ".join(f"{number} 0 R" for number in self._layers.values())
        # A printer that fits the page to the paper would spoil the scale.
        root = self._add(
            f"<< /Type /Catalog /Pages {parent} 0 R /Lang (en) "
            f"/OCProperties << /OCGs [{groups}] /D << /Order [{groups}] >> >> "
            "/ViewerPreferences << /DisplayDocTitle true /PrintScaling /None >> >>"
        )
        return self._file(root, self._add(self._about()))

    def _about(self) -> str:
        drawing = self._drawing
        entries = {
            "Title": drawing.title,
            "Subject": f"{drawing.subject}; curves within {drawing.tolerance:g} mm",
            "Keywords": ", ".join(drawing.keywords),
            "Creator": "SGB Studio",
        }
        words = " ".join(f"/{key} {_text(value)}" for key, value in entries.items() if value)
        if drawing.date:
            words += f" /CreationDate (D:{drawing.date.replace('-', '')})"
        return f"<< {words} >>"

    def _font(self) -> int:
        letters = self._letters
        name = f"/{_tag(letters.data)}+{fonts.FAMILY.replace(' ', '')}"
        data = self._stream(letters.data, f"/Length1 {len(letters.data)} ")
        box = " ".join(map(str, letters.box))
        descriptor = self._add(
            f"<< /Type /FontDescriptor /FontName {name} /Flags 32 /FontBBox [{box}] "
            f"/ItalicAngle 0 /Ascent {letters.ascent} /Descent {letters.descent} "
            f"/CapHeight {round(1000.0 / fonts.em(1.0))} /StemV 80 /FontFile2 {data} 0 R >>"
        )
        widths = " ".join(
            f"{letters.glyphs[c]} [{_number(letters.advances[c])}]" for c in letters.glyphs
        )
        descendant = self._add(
            f"<< /Type /Font /Subtype /CIDFontType2 /BaseFont {name} "
            "/CIDSystemInfo << /Registry (Adobe) /Ordering (Identity) /Supplement 0 >> "
            f"/FontDescriptor {descriptor} 0 R /DW 600 /W [{widths}] /CIDToGIDMap /Identity >>"
        )
        back = self._stream(_to_unicode(letters.glyphs).encode("ascii"))
        return self._add(
            f"<< /Type /Font /Subtype /Type0 /BaseFont {name} /Encoding /Identity-H "
            f"/DescendantFonts [{descendant} 0 R] /ToUnicode {back} 0 R >>"
        )

    def _content(self, page: Page) -> bytes:
        scale = f"{_POINTS:.10f}"
        lines = [f"q {scale} 0 0 {scale} 0 0 cm 1 j"]
        for layer in page.layers:
            lines.append(f"/OC /{layer} BDC")
            lines += [self._mark(mark) for mark in page.of_layer(layer)]
            lines.append("EMC")
        return "\n".join([*lines, "Q"]).encode("ascii")

    def _mark(self, mark: Mark) -> str:
        if isinstance(mark, Words):
            return self._words(mark)
        paths = " ".join(map(_path, mark.paths))
        if isinstance(mark, Area):
            return f"{_colour(mark.colour)} rg {paths} f*"
        assert isinstance(mark, Stroke)
        pen = mark.pen
        dashes = " ".join(map(_number, pen.dashes))
        return f"{_number(pen.width)} w [{dashes}] 0 d {_colour(pen.colour)} RG {paths} S"

    def _words(self, words: Words) -> str:
        letters, size = self._letters, fonts.em(words.height)
        share = {Anchor.START: 0.0, Anchor.MIDDLE: 0.5, Anchor.END: 1.0}[words.anchor]
        back = -share * fonts.width(words.text, words.height)
        c, s = cos(radians(words.turn_deg)), sin(radians(words.turn_deg))
        place = (c, s, -s, c, words.at[0] + back * c, words.at[1] + back * s)
        codes = "".join(f"{letters.glyphs[letter]:04x}" for letter in words.text)
        matrix = " ".join(map(_number, place))
        return f"BT 0 g /F {_number(size)} Tf {matrix} Tm <{codes}> Tj ET"

    def _file(self, root: int, about: int) -> bytes:
        parts = [b"%PDF-1.7\n%\xe2\xe3\xcf\xd3\n"]
        offsets, length = [], len(parts[0])
        for number, body in enumerate(self._objects, 1):
            offsets.append(length)
            parts.append(b"%d 0 obj\n%s\nendobj\n" % (number, body))
            length += len(parts[-1])
        count = len(self._objects) + 1
        table = "".join(f"{offset:010d} 00000 n \n" for offset in offsets)
        mark = hashlib.md5(b"".join(parts), usedforsecurity=False).hexdigest()
        parts.append(
            f"xref\n0 {count}\n0000000000 65535 f \n{table}"
            f"trailer\n<< /Size {count} /Root {root} 0 R /Info {about} 0 R "
            f"/ID [<{mark}> <{mark}>] >>\nstartxref\n{length}\n%%EOF\n".encode("ascii")
        )
        return b"".join(parts)


def _path(path: Path) -> str:
    x, y = path.pieces[0][0]
    words = [f"{_number(x)} {_number(y)} m"]
    for piece in path.pieces:
        numbers = " ".join(_number(value) for value in piece[1:].ravel())
        words.append(f"{numbers} {'l' if len(piece) == 2 else 'c'}")
    return " ".join([*words, "h"] if path.closed else words)


def _colour(colour: str) -> str:
    return " ".join(_number(int(colour[k : k + 2], 16) / 255.0) for k in (1, 3, 5))


def _to_unicode(glyphs: dict[str, int]) -> str:
    pairs = sorted({glyph: letter for letter, glyph in glyphs.items()}.items())
    blocks = []
    # A block holds a hundred at most.
    for low in range(0, len(pairs), 100):
        part = pairs[low : low + 100]
        rows = "\n".join(
            f"<{glyph:04x}> <{letter.encode('utf-16-be').hex()}>" for glyph, letter in part
        )
        blocks.append(f"{len(part)} beginbfchar\n{rows}\nendbfchar")
    return "\n".join(
        (
            "/CIDInit /ProcSet findresource begin 12 dict begin begincmap",
            "/CMapName /Letters def /CMapType 2 def",
            "1 begincodespacerange <0000> <ffff> endcodespacerange",
            *blocks,
            "endcmap CMapName currentdict /CMap defineresource pop end end",
        )
    )


def _tag(data: bytes) -> str:
    """Return the six capitals by which a part of a font is known."""
    digest = hashlib.sha256(data).digest()
    return "".join(chr(ord("A") + byte % 26) for byte in digest[:6])


def _text(words: str) -> str:
    """Return a text string of PDF: UTF-16, which holds every character."""
    return f"<{(chr(0xFEFF) + words).encode('utf-16-be', 'replace').hex()}>"


def _number(value: float) -> str:
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
