"""Printers and shapes for the tests, and a reader of G-code that knows nothing of its writer."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

import resources
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document.model import Document
from sgb_core.toolpaths.printer import Bed, Limits, Printer, printer_of
from sgb_core.toolpaths.strand import Part
from sgb_core.toolpaths.toolpath import Toolpath

PLASTIC = printer_of(resources.printers()[0].read_bytes())
CLAY = printer_of(resources.printers()[2].read_bytes())
AUGER = printer_of(resources.printers()[4].read_bytes())


def roomy(printer: Printer) -> Printer:
    """Return a printer for which nothing is too large, too thin or too thick."""
    wide = Limits(printer.layer.usual, 1e-3, 150.0)
    return replace(
        printer, bed=Bed(20_000.0, 20_000.0, 20_000.0), layer=wide, bead=replace(wide), skirt=0
    )


def chain(*points: tuple[float, float]) -> Document:
    """Return a document of straight lines, one segment each."""
    return Document(Profile.of([line(a, b) for a, b in pairwise(points)]))


BIG = roomy(PLASTIC)
CYLINDER = chain((30.0, 0.0), (30.0, 21.3))


def wall_of(path: Toolpath) -> np.ndarray:
    """Return the points of a path's wall, shape (k, 3)."""
    return path.points[path.parts == Part.WALL]


@dataclass
class Read:
    """What a file of G-code does: the tip's places, what each move pushes, and its kind."""

    places: list[tuple[float, float, float]] = field(default_factory=list)
    pushed: list[float] = field(default_factory=list)
    kinds: list[str] = field(default_factory=list)
    layers: list[int] = field(default_factory=list)
    seconds: float = 0.0


def read(lines: list[str]) -> Read:
    """Follow the moves of a file; arcs are cut into short chords."""
    found = Read()
    place, feed, kind, layer = np.zeros(3), 0.0, "", -1
    relative_e, total, relative_xyz = True, 0.0, False
    for text in lines:
        if text.startswith(";TYPE:"):
            kind = text[6:]
        elif text.startswith(";LAYER:"):
            layer = int(text[7:])
        code, *words = text.split(";")[0].split() or [""]
        values = {
            word[0]: float(word[1:]) for word in words if re.fullmatch(r"[A-Z]-?[\d.]+", word)
        }
        if code in ("M82", "M83"):
            relative_e = code == "M83"
        if code in ("G90", "G91"):
            relative_xyz = code == "G91"
        if code == "G92":
            total = values.get("E", total)
        if code not in ("G0", "G1", "G2", "G3") or relative_xyz or kind in ("", "END"):
            continue
        feed = values.get("F", feed)
        goal = np.array([values.get(axis, old) for axis, old in zip("XYZ", place, strict=True)])
        push = values.get("E", 0.0 if relative_e else total)
        if not relative_e:
            push, total = push - total, push
        steps = _arc(place, goal, values, code == "G3") if code in ("G2", "G3") else [goal]
        for step in steps:
            found.seconds += float(np.linalg.norm(step - place)) / (feed / 60.0)
            found.places.append(tuple(step.tolist()))
            found.pushed.append(push / len(steps))
            found.kinds.append(kind)
            found.layers.append(layer)
            place = step
    return found


def _arc(start, goal, values, counter) -> list[np.ndarray]:
    centre = start[:2] + np.array([values["I"], values["J"]])
    a, b = start[:2] - centre, goal[:2] - centre
    assert abs(np.hypot(*a) - np.hypot(*b)) < 2e-3
    swept = (np.arctan2(b[1], b[0]) - np.arctan2(a[1], a[0])) % (2.0 * np.pi)
    swept = swept if counter else swept - 2.0 * np.pi
    found = []
    for share in np.linspace(0.0, 1.0, 33)[1:]:
        angle = np.arctan2(a[1], a[0]) + share * swept
        xy = centre + np.hypot(*a) * np.array([np.cos(angle), np.sin(angle)])
        found.append(np.array([*xy, start[2] + share * (goal[2] - start[2])]))
    found[-1] = goal
    return found
