"""From a file to a profile: read, choose the side, keep what is exact, trace the rest."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path as FilePath

import numpy as np

from sgb_core.curves.continuity import JointClass, measure_joints
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment
from sgb_core.design.tracing import Trace, TraceError, trace
from sgb_core.design.tracing.result import trace_of
from sgb_core.document.model import Document, Unit
from sgb_core.findings.finding import Finding
from sgb_core.findings.sources import NoSource, Sides
from sgb_core.sources.errors import SourceError
from sgb_core.sources.options import Options, Side
from sgb_core.sources.reading import Half
from sgb_core.sources.registry import source_for
from sgb_core.sources.sides import mean_of_sides

_NOTHING = np.zeros(0, dtype=np.intp)


@dataclass(frozen=True, slots=True)
class Taken:
    """A profile taken from a source, and what is to be said of it.

    ``left_right`` is the root mean square difference of the two sides, None where there is one;
    ``axis`` the abscissa of the axis, or its point and direction. ``kind`` is the source's.
    """

    trace: Trace
    unit: Unit
    name: str
    kind: str
    axis: tuple[float, ...]
    left_right: float | None = None
    notes: tuple[Finding, ...] = ()

    def document(self) -> Document:
        """Return a project of the profile, with where it came from as ``reference``."""
        found = self.trace
        reference = {
            "name": self.name,
            "kind": self.kind,
            "axis": list(self.axis),
            "tolerance": found.tolerance,
            "points": found.points,
            "largest_deviation": found.largest_deviation,
            "rms_deviation": found.rms_deviation,
            "left_right": self.left_right,
        }
        name = os.path.splitext(self.name)[0]
        return Document(found.profile, name, self.unit, extra={"reference": reference})


def take(path: str | os.PathLike[str], options: Options) -> Taken:
    """Return the profile that a file holds.

    Raises SourceError, whose line says what is wrong with the file or the options, and OSError
    where the system refuses it.
    """
    source = source_for(path)
    name = FilePath(path).name
    reading = source.read(source.data(path), options)
    half, left_right, notes = _chosen(reading.right, reading.left, options.side)
    tolerance = options.tolerance or reading.tolerance
    try:
        found = _exact(half, tolerance) if not options.merge else None
        if found is None:
            closed = True if half.closed else None if source.closes else False
            found = trace(half.points, tolerance, corners=half.corners, closed=closed)
    except TraceError as error:
        raise SourceError(error.finding) from None
    said = (*reading.notes, *notes)
    return Taken(found, options.unit, name, source.kind, reading.axis, left_right, said)


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
