"""What differs between two profiles of as many segments: shape parameters and control points."""

from __future__ import annotations

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import PARAMETERS
from sgb_core.findings.joints import Moved


def moved(before: Profile, after: Profile) -> tuple[Moved, ...]:
    """Return what an edit moved, segment by segment: shape parameters first, then P0 to P3.

    Raises ValueError where the numbers of segments differ.
    """
    found = []
    for number, (old, new) in enumerate(zip(before.segments, after.segments, strict=True)):
        for name in PARAMETERS:
            values = getattr(old.shape, name), getattr(new.shape, name)
            if values[0] != values[1]:
                found.append(Moved(number, name, *values))
        for index, places in enumerate(zip(old.points.tolist(), new.points.tolist(), strict=True)):
            if places[0] != places[1]:
                was, now = ((r, h) for r, h in places)
                found.append(Moved(number, f"P{index}", was, now))
    return tuple(found)
