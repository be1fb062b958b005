"""CSV of the generatrix: points along each segment in full double precision."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import BinaryIO

import numpy as np

from sgb_core.curves.along import along
from sgb_core.curves.profile import Profile
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.format import Format, Request
from sgb_core.fields.kinds import Range, Said
from sgb_core.findings.refusal import Argument
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sampling import samples_for_tolerance
from sgb_core.surfaces.section_along import along_section

# Points per segment of a generatrix where nobody asks for another number.
PER_SEGMENT = 65
# More points than this would fill the memory with text.
MOST_POINTS = 10_000_000

_POINTS = Range(high=MOST_POINTS, whole=True, said=f"at most {MOST_POINTS}")
_PER_SEGMENT = Said("2 or more")
HEADER = "segment,s,r,h"
CURVATURE_HEADER = f"{HEADER},length,curvature,deviation"


def csv_lines(thing: Profile | RevolutionSurface, per_segment: int | Sequence[int]) -> list[str]:
    """Return the header and one line a point, s from 0 to 1 inclusive in each segment.

    Of a surface it is the section at its start angle.

    ``per_segment`` ≥ 2 points, one number for all segments or one for each. Numbers are the
    shortest that read back as the same double. Raises ExportError for fewer than 2 and for more
    than 10 million points altogether.
    """
    profile = thing if isinstance(thing, Profile) else thing.shape_at(thing.start)
    count = len(profile)
    counts = [per_segment] * count if isinstance(per_segment, int) else list(per_segment)
    if sum(counts) > MOST_POINTS:
        raise ExportError(Argument("the number of points", sum(counts), _POINTS))
    lines = [HEADER]
    section = None if isinstance(thing, Profile) or not thing.fades else thing.section
    for index, (segment, points) in enumerate(zip(profile.segments, counts, strict=True)):
        if points < 2:
            raise ExportError(Argument("the number of points per segment", points, _PER_SEGMENT))
        parameters = np.linspace(0.0, 1.0, points)
        # The ends are the control points themselves, not these within rounding.
        if section is None:
            rows = segment.point(parameters)
            rows[0], rows[-1] = segment.points[0], segment.points[3]
        else:
            rows = section[index].on(parameters)
            rows[0], rows[-1] = section[index].ends
        lines += [
            f"{index},{s!r},{r!r},{h!r}"
            for s, (r, h) in zip(parameters.tolist(), rows.tolist(), strict=True)
        ]
    return lines


def curvature_lines(thing: Profile | RevolutionSurface, per_segment: int) -> list[str]:
    """Return :func:`csv_lines` with arc length, curvature and the distance from the plain cubic.

    A curvature that is not finite is left empty. Raises ExportError as csv_lines does.
    """
    rows = csv_lines(thing, per_segment)[1:]
    if isinstance(thing, Profile):
        parts = along(thing, per_segment)
    else:
        parts = along_section(thing, per_segment)
    samples = [
        (length, curvature, deviation)
        for part in parts
        for length, curvature, deviation in zip(
            part.length.tolist(), part.curvature.tolist(), part.deviation.tolist(), strict=True
        )
    ]
    return [
        CURVATURE_HEADER,
        *(
            f"{row},{length!r},{curvature!r},{deviation!r}"
            if isfinite(curvature)
            else f"{row},{length!r},,{deviation!r}"
            for row, (length, curvature, deviation) in zip(rows, samples, strict=True)
        ),
    ]


def write_csv(
    thing: Profile | RevolutionSurface, stream: BinaryIO, per_segment: int | Sequence[int]
) -> None:
    """Write :func:`csv_lines`, in the unit of the profile."""
    stream.write(("\n".join(csv_lines(thing, per_segment)) + "\n").encode("ascii"))


def _write(request: Request, stream: BinaryIO) -> None:
    """Write the generatrix at the same steps of s as the mesh would have."""
    surface, fineness = request.document.surface, request.fineness
    per_segment: int | list[int] = PER_SEGMENT
    if fineness.samples is not None:
        per_segment = fineness.samples[0] + 1
    elif fineness.tolerance is not None:
        along, _ = samples_for_tolerance(surface, fineness.tolerance)
        per_segment = [intervals + 1 for intervals in along]
    write_csv(surface, stream, per_segment)


FORMAT = Format(
    ".csv",
    "Generatrix as CSV",
    _write,
    lambda _document: f"Points of the generatrix in full precision, {PER_SEGMENT} a segment",
    meshed=False,
    tolerance=None,
    any_axis=False,
)
