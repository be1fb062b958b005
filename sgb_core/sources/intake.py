"""From a file to a profile: read, choose the side, keep what is exact, trace the rest."""

from __future__ import annotations

import os
from math import degrees
from pathlib import Path as FilePath
from typing import Any

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.continuity import JointClass, measure_joints
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment
from sgb_core.design.tracing import Trace, TraceError, trace
from sgb_core.design.tracing.result import trace_of
from sgb_core.document.model import Document, Unit
from sgb_core.document.reference import MAX_NAME, Reference, thinned_points
from sgb_core.findings.finding import Finding
from sgb_core.findings.sources import NoSource, Sides, Wall
from sgb_core.sources.embedded import embedded
from sgb_core.sources.errors import SourceError
from sgb_core.sources.options import Options, Side
from sgb_core.sources.reading import Frame, Half, Reading
from sgb_core.sources.registry import Source, source_for
from sgb_core.sources.sides import mean_of_sides
from sgb_core.values import dataclass

_NOTHING = np.zeros(0, dtype=np.intp)


@dataclass(frozen=True, slots=True)
class Taken:
    """A profile taken from a source, and what is to be said of it.

    ``points`` (N, 2) are those that were traced. ``left_right`` is the root mean square
    difference of the two sides, None where there is one; ``axis`` the abscissa of the axis, or
    its point and direction; ``frame`` how the profile lies in the source. ``kind`` is the
    source's, and ``data`` its bytes where it is a picture.
    """

    trace: Trace
    unit: Unit
    name: str
    kind: str
    axis: tuple[float, ...]
    points: Floats
    left_right: float | None = None
    notes: tuple[Finding, ...] = ()
    frame: Frame | None = None
    data: bytes | None = None

    @property
    def wall(self) -> Wall | None:
        """The wall that the source shows, None where it shows none."""
        return next((note for note in self.notes if isinstance(note, Wall)), None)

    def reference(self) -> Reference:
        """Return where the profile came from, as a project keeps it."""
        found, frame = self.trace, self.frame or Frame((0.0, 0.0))
        x, y = frame.origin
        source = Reference(
            name=self.name[:MAX_NAME],
            kind=self.kind,
            points=() if self.data is not None else thinned_points(self.points),
            axis=self.axis,
            origin=(x, y) if self.data is None else (x, -y),
            scale=frame.scale,
            turn_deg=degrees(frame.turn),
            tolerance=found.tolerance,
            largest_deviation=found.largest_deviation,
            rms_deviation=found.rms_deviation,
            left_right=self.left_right,
        )
        return source if self.data is None else embedded(source, self.data)

    def document(self) -> Document:
        """Return a project of the profile, with where it came from as ``reference``."""
        name = os.path.splitext(self.name)[0]
        return Document(self.trace.profile, name, self.unit, reference=self.reference())


@dataclass(frozen=True, slots=True, eq=False)
class Opened:
    """A source whose file has been read: what it holds, to be taken with any options."""

    name: str
    source: Source
    content: Any
    data: bytes | None = None

    @classmethod
    def of_data(cls, data: bytes, name: str) -> Opened:
        """Return the source in the bytes of a file of this name; raises SourceError."""
        source = source_for(name)
        kept = data if source.kind == "picture" else None
        return cls(FilePath(name).name, source, source.parse(data), kept)

    @classmethod
    def of_file(cls, path: str | os.PathLike[str]) -> Opened:
        """Return the source in a file; raises SourceError, and OSError where it is refused."""
        return cls.of_data(source_for(path).data(path), os.fspath(path))

    def reading(self, options: Options) -> Reading:
        """Return the sides that the source shows; raises SourceError."""
        return self.source.read(self.content, options)

    def traced(self, reading: Reading, options: Options) -> Taken:
        """Return the profile of what was read; raises SourceError."""
        half, left_right, notes = _chosen(reading.right, reading.left, options.side)
        tolerance = options.tolerance or reading.tolerance
        try:
            found = _exact(half, tolerance) if not options.merge else None
            if found is None:
                closed = True if half.closed else None if self.source.closes else False
                found = trace(half.points, tolerance, corners=half.corners, closed=closed)
        except TraceError as error:
            raise SourceError(error.finding) from None
        return Taken(
            found,
            options.unit,
            self.name,
            self.source.kind,
            reading.axis,
            half.points,
            left_right,
            (*reading.notes, *notes),
            reading.frame,
            self.data,
        )


def take(path: str | os.PathLike[str], options: Options) -> Taken:
    """Return the profile that a file holds.

    Raises SourceError, whose line says what is wrong with the file or the options, and OSError
    where the system refuses it.
    """
    opened = Opened.of_file(path)
    return opened.traced(opened.reading(options), options)


def _chosen(
    right: Half | None, left: Half | None, side: Side
) -> tuple[Half, float | None, tuple[Finding, ...]]:
    """Return the side asked for, or the mean of both and how they differ."""
    if side is Side.BOTH and right is not None and left is not None:
        mean, difference = mean_of_sides(right, left)
        return mean, difference, ()
    wanted, other = (left, right) if side is Side.LEFT else (right, left)
    if wanted is not None:
        return wanted, None, ()
    if other is None:
        raise SourceError(NoSource.NO_SIDE)
    return other, None, (Sides.ONE,)


def _exact(half: Half, tolerance: float | None) -> Trace | None:
    """Return the pieces of a drawing as they are, or None where there are other ones too."""
    if half.path is None:
        return None
    segments: list[Segment] = []
    for piece in half.path.pieces:
        found = piece.segments()
        if found is None:
            return None
        segments += found
    profile = Profile(tuple(segments), (), half.closed)
    rules = [
        JointRule.G0 if joint.measured in (JointClass.GAP, JointClass.G0) else JointRule.G1
        for joint in measure_joints(profile)
    ]
    profile = Profile(profile.segments, tuple(rules), half.closed)
    exact = all(piece.is_exact for piece in half.path.pieces)
    within = tolerance if tolerance is not None else 1e-3 * profile.size
    return trace_of(profile, half.points, within, _NOTHING, exact=exact)
