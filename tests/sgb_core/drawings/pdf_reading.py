"""A small reader of PDF that knows nothing of its writer: paths and words in millimetres."""

from __future__ import annotations

import re
import zlib
from dataclasses import dataclass, field
from io import BytesIO

import numpy as np
from fontTools.ttLib import TTFont

MM = 25.4 / 72.0


@dataclass
class ReadPath:
    """A painted path: its pieces (2 or 4 points in mm), how it is painted and how wide."""

    pieces: list[np.ndarray]
    operator: str
    width: float
    layer: str

    def points(self) -> np.ndarray:
        t = np.linspace(0.0, 1.0, 33)[:, None]
        found = []
        for piece in self.pieces:
            if len(piece) == 2:
                found.append(piece)
                continue
            a, b, c, d = piece
            s = 1 - t
            found.append(s**3 * a + 3 * s * s * t * b + 3 * s * t * t * c + t**3 * d)
        return np.concatenate(found)


@dataclass
class ReadPage:
    size: tuple[float, float]
    paths: list[ReadPath] = field(default_factory=list)
    # Each with its place, the width that the font gives it, and the size of the font.
    words: list[tuple[str, np.ndarray, float, float]] = field(default_factory=list)


@dataclass
class ReadFile:
    pages: list[ReadPage]
    about: dict[str, str]
    font: TTFont


def read_pdf(data: bytes) -> ReadFile:
    start = int(re.search(rb"startxref\n(\d+)\n%%EOF\n$", data)[1])
    table = data[start:].split(b"trailer")[0].split(b"\n")[3:-1]
    objects = {}
    for number, line in enumerate(table, 1):
        offset = int(line[:10])
        head = b"%d 0 obj\n" % number
        assert data[offset:].startswith(head)
        objects[number] = data[offset + len(head) :].split(b"\nendobj\n")[0]
    trailer = data[start:].split(b"trailer")[1]
    catalog = objects[int(re.search(rb"/Root (\d+)", trailer)[1])]
    tree = objects[int(re.search(rb"/Pages (\d+)", catalog)[1])]
    kids = [int(k) for k in re.findall(rb"(\d+) 0 R", re.search(rb"/Kids \[(.*?)\]", tree)[1])]
    assert len(kids) == int(re.search(rb"/Count (\d+)", tree)[1])
    about = objects[int(re.search(rb"/Info (\d+)", trailer)[1])]
    entries = {
        key.decode(): bytes.fromhex(value.decode()).decode("utf-16")
        for key, value in re.findall(rb"/(\w+) <([0-9a-f]+)>", about)
    }
    font_object = next(body for body in objects.values() if b"/Subtype /Type0" in body)
    letters = _letters(_stream(objects, re.search(rb"/ToUnicode (\d+)", font_object)[1]))
    file = next(n for body in objects.values() for n in re.findall(rb"/FontFile2 (\d+)", body))
    font = TTFont(BytesIO(_stream(objects, file)))
    widths = next(
        {int(g): float(w) for g, w in re.findall(rb"(\d+) \[([\d.]+)\]", found[1])}
        for body in objects.values()
        if (found := re.search(rb"/W \[(.*)\] /CIDToGIDMap", body))
    )
    pages = [_page(objects, objects[kid], letters, widths) for kid in kids]
    return ReadFile(pages, entries, font)


def _stream(objects: dict[int, bytes], number: bytes) -> bytes:
    head, _, rest = objects[int(number)].partition(b"\nstream\n")
    length = int(re.search(rb"/Length (\d+)", head)[1])
    return zlib.decompress(rest[:length])


def _letters(table: bytes) -> dict[int, str]:
    return {
        int(glyph, 16): bytes.fromhex(letter.decode()).decode("utf-16-be")
        for glyph, letter in re.findall(rb"<([0-9a-f]{4})> <([0-9a-f]+)>\n", table + b"\n")
    }


def _page(objects, body: bytes, letters: dict[int, str], widths: dict[int, float]) -> ReadPage:
    box = [float(v) for v in re.search(rb"/MediaBox \[(.*?)\]", body)[1].split()]
    page = ReadPage((box[2] * MM, box[3] * MM))
    content = _stream(objects, re.search(rb"/Contents (\d+)", body)[1]).decode()
    matrix, stack, layer, width = np.eye(3), [], "", 1.0
    pieces: list[np.ndarray] = []
    place = first = np.zeros(2)
    text, size = np.eye(3), 1.0
    # An array counts as one operand.
    for token in re.findall(r"\[[^\]]*\]|\S+", content):
        if re.match(r"[-+.\d\[</]", token):
            stack.append(token)
            continue
        n = [float(v) for v in stack if re.fullmatch(r"[-+.\d]+", v)]
        if token == "cm":
            matrix = np.array([[n[0], n[1], 0], [n[2], n[3], 0], [n[4], n[5], 1]]) @ matrix
        elif token == "w":
            width = n[0] * matrix[0, 0] * MM
        elif token == "BDC":
            layer = stack[1][1:]
        elif token == "m":
            place = first = np.array(n)
        elif token == "l":
            pieces.append(np.array([place, n]))
            place = np.array(n)
        elif token == "c":
            pieces.append(np.array([place, n[:2], n[2:4], n[4:]]))
            place = np.array(n[4:])
        elif token == "h":
            if not np.array_equal(place, first):
                pieces.append(np.array([place, first]))
            place = first
        elif token in ("S", "f*"):
            mm = [(p @ matrix[:2, :2] + matrix[2, :2]) * MM for p in pieces]
            page.paths.append(ReadPath(mm, token, width, layer))
            pieces = []
        elif token == "Tf":
            size = n[0]
        elif token == "Tm":
            text = np.array([[n[0], n[1], 0], [n[2], n[3], 0], [n[4], n[5], 1]])
        elif token == "Tj":
            codes = [int(stack[0][k : k + 4], 16) for k in range(1, len(stack[0]) - 1, 4)]
            whole = text @ matrix
            length = sum(widths[code] for code in codes) / 1000 * size * matrix[0, 0] * MM
            words = "".join(letters[code] for code in codes)
            page.words.append((words, whole[2, :2] * MM, length, size * matrix[0, 0] * MM))
        stack = []
    return page
