"""G-code of a path: one move a line, full comments, whole or not at all."""

from __future__ import annotations

import os
from base64 import b64encode
from collections.abc import Callable, Iterator
from typing import BinaryIO

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.document.file.atomic import write_whole
from sgb_core.toolpaths.arcs import runs
from sgb_core.toolpaths.printer import Feeding
from sgb_core.toolpaths.strand import Part
from sgb_core.toolpaths.toolpath import Toolpath

# How far above the path the nozzle moves where it does not print, in mm.
_LIFT = 5.0
_CHUNK = 20_000
_TYPES = {Part.TRAVEL: "TRAVEL", Part.SKIRT: "SKIRT", Part.FLOOR: "FLOOR", Part.WALL: "WALL"}


def write_gcode(
    path: Toolpath,
    target: str | os.PathLike[str],
    name: str,
    *,
    picture: bytes | None = None,
    report: Callable[[float], None] | None = None,
) -> None:
    """Write a path as G-code, whole or not at all.

    ``name`` is the object's; ``picture`` a small PNG for the header. ``report`` is told which part,
    0 to 1, is written; what it raises ends the writing, and an old file stays. Raises FileError
    where the system refuses.
    """

    def write(stream: BinaryIO) -> None:
        lines = list(gcode_lines(path, name, picture))
        for start in range(0, len(lines), _CHUNK):
            text = "\n".join(lines[start : start + _CHUNK]) + "\n"
            stream.write(text.encode("ascii", "replace"))
            if report is not None:
                report(min(1.0, (start + _CHUNK) / len(lines)))

    write_whole(target, write)


def gcode_lines(path: Toolpath, name: str, picture: bytes | None = None) -> Iterator[str]:
    """Yield the lines of the file, without their ends."""
    printer = path.plan.printer
    yield from _head(path, name, picture)
    yield from printer.lines(printer.start)
    yield from ("G21", "G90")
    absolute = printer.feed.absolute
    if printer.feed.unit is not Feeding.NONE:
        yield from ("M82", "G92 E0") if absolute else ("M83",)
    yield from _moves(path)
    yield ";TYPE:END"
    yield from printer.lines(printer.end)


def _head(path: Toolpath, name: str, picture: bytes | None) -> Iterator[str]:
    plan, printer = path.plan, path.plan.printer
    low, high = path.bounds
    one_line = " ".join(name.split())
    yield f"; {one_line}: a continuous path by SGB Studio"
    yield f"; printer: {printer.title}"
    yield f"; layer {plan.layer:g} mm, bead {plan.bead:g} mm, {plan.walls} in the wall"
    size = " x ".join(f"{value:.2f}" for value in high - low)
    yield f"; {path.layer_count} layers, {size} mm, {path.length:.0f} mm long"
    yield f"; {path.extruded_volume:.1f} mm3, about {path.time:.0f} s without acceleration"
    if picture is not None:
        width, height = (int.from_bytes(picture[at : at + 4], "big") for at in (16, 20))
        text = b64encode(picture).decode("ascii")
        yield f"; thumbnail begin {width}x{height} {len(text)}"
        yield from (f"; {text[start : start + 78]}" for start in range(0, len(text), 78))
        yield "; thumbnail end"


def _moves(path: Toolpath) -> Iterator[str]:
    points, printer = path.on_bed, path.plan.printer
    feeds = np.maximum(np.rint(path.speeds * 60.0), 1.0).astype(np.int64)
    marks = _marks(path)
    fed = printer.feed.unit is not Feeding.NONE
    arcs = path.plan.wanted.arcs and np.ptp(points[:, :2]) > 0.0
    ends, words, starts = _arc_words(path, points) if arcs else _line_words(points)
    total = np.rint(np.cumsum(path.volumes)[ends] * printer.feed.e_per_mm3 * 1e5) / 1e5
    pushed = total if printer.feed.absolute else np.diff(total, prepend=0.0)
    travels = (path.parts[ends] == Part.TRAVEL).tolist()
    before = -1
    for k, (end, word) in enumerate(zip(ends.tolist(), words, strict=True)):
        # The first move is told as the travel that it is.
        for place in range(starts[k] + 1, end + 1):
            if place in marks:
                yield from marks[place]
        if travels[k]:
            yield from _travel(path, points[end], end)
            before = -1
            continue
        line = word
        if fed:
            line += f" E{pushed[k]:.5f}"
        feed = int(feeds[end])
        if feed != before:
            line += f" F{feed}"
            before = feed
        yield line


def _marks(path: Toolpath) -> dict[int, list[str]]:
    """Return the comment lines that stand before the move to a point."""
    found: dict[int, list[str]] = {}
    layers = np.diff(path.layers, prepend=-1) != 0
    # A travel says what it is; the layer follows with what is printed.
    prints = path.parts != Part.TRAVEL
    seen = -1
    for place in np.flatnonzero(layers & prints | (np.diff(path.parts, prepend=-1) != 0)).tolist():
        lines = []
        layer = int(path.layers[place])
        if prints[place] and layer != seen:
            lines.append(f";LAYER:{layer}")
            seen = layer
        if place == 0 or path.parts[place] != path.parts[place - 1]:
            lines.append(f";TYPE:{_TYPES[Part(int(path.parts[place]))]}")
        if lines:
            found[place] = lines
    return found


def _line_words(points: Floats) -> tuple[np.ndarray, list[str], list[int]]:
    rows = points.tolist()
    words = ["G1 X%.4f Y%.4f Z%.4f" % (x, y, z) for x, y, z in rows]  # noqa: UP031
    return np.arange(len(rows)), words, list(range(-1, len(rows) - 1))


def _arc_words(path: Toolpath, points: Floats) -> tuple[np.ndarray, list[str], list[int]]:
    """Return the last point of each move, its words, and the point that it starts from."""
    moved = points[0, :2] - path.points[0, :2]
    code = "G2" if path.plan.wanted.clockwise else "G3"
    ends, words, starts = [0], ["G1 X{:.4f} Y{:.4f} Z{:.4f}".format(*points[0])], [-1]
    for run in runs(path):
        x, y, z = points[run.end].tolist()
        word = f"G1 X{x:.4f} Y{y:.4f} Z{z:.4f}"
        if run.centre is not None:
            i = run.centre[0] + moved[0] - points[run.start, 0]
            j = run.centre[1] + moved[1] - points[run.start, 1]
            turn = code if path.parts[run.end] != Part.SKIRT else "G3"
            word = f"{turn} X{x:.4f} Y{y:.4f} Z{z:.4f} I{i:.4f} J{j:.4f}"
        ends.append(run.end)
        words.append(word)
        starts.append(run.start)
    return np.array(ends), words, starts


def _travel(path: Toolpath, point: Floats, place: int) -> Iterator[str]:
    """Yield the moves to a point without printing: up, across, down."""
    printer = path.plan.printer
    x, y, z = point.tolist()
    feed = round(printer.speeds.travel * 60.0)
    height = z + _LIFT if place == 0 else max(z, float(path.points[place - 1, 2])) + _LIFT
    height = min(height, printer.bed.height)
    pulls = place > 0 and printer.retraction > 0.0 and printer.feed.unit is Feeding.FILAMENT
    relative = pulls and not printer.feed.absolute
    if relative:
        yield f"G1 E{-printer.retraction:.5f} F1800"
    yield from (f"G0 Z{height:.4f} F{feed}", f"G0 X{x:.4f} Y{y:.4f}", f"G0 Z{z:.4f}")
    if relative:
        yield f"G1 E{printer.retraction:.5f} F1800"
