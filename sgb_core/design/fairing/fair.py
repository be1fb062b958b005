"""Make a profile fair: the least energy that keeps its joints' rules and what else is asked for.

Segments that no equation couples are each a search of their own over the whole box of leg
fractions; coupled ones (C1 and G2 joints, kept measures, moving points) are solved together from
several starts.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import PARAMETER_RANGES, ShapeParameters
from sgb_core.design.demands.kept import Kept
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.findings import Change, Faired, Freedom, Keep, Status
from sgb_core.design.fairing.measure import endless_segments, profile_energy
from sgb_core.design.fairing.task import Task
from sgb_core.findings.errors import FindingError
from sgb_core.findings.fairing import NoFairing
from sgb_core.surfaces.laws.law import RADIUS
from sgb_core.surfaces.revolution import RevolutionSurface

_COORDINATES = ("r", "h")


def fair(
    surface: RevolutionSurface,
    energy: Energy = Energy.BENDING,
    free: Freedom = Freedom.SHAPE,
    *,
    segments: Collection[int] | None = None,
    keep: Collection[Keep] = (),
    locks: Sequence[Kept] = (),
    fixed: Collection[tuple[int, int]] = (),
    near: Profile | None = None,
) -> Faired:
    """Return the fairest profile of a surface.

    ``locks`` are kept besides ``keep``, told in the size of the profile; ``fixed`` points
    (segment, point) stay where they are; ``near`` is a profile almost as fair as can be, from
    which the search goes on, where one is known.
    ``segments`` are those that may change, all by default. Laws hold: what they govern stays, and
    the section at θ = 0 is made fair, as drawn where laws multiply the radius. Raises
    LocksExcludeError where nothing keeps all that is asked for, IndexError for a segment that is
    not there, FindingError for the surface's energy where laws hold.
    """
    drawn = tuple(law for law in surface.laws if law.parameter != RADIUS)
    if surface.laws and energy is Energy.SURFACE:
        raise FindingError(NoFairing.LAWS)
    count = len(surface.profile)
    chosen = range(count) if segments is None else sorted(set(segments))
    for segment in chosen:
        if not 0 <= segment < count:
            raise IndexError(f"there is no segment {segment}; allowed is 0 to {count - 1}")
    surface = replace(surface, laws=drawn)
    section = surface.profile_at(surface.start)
    task = Task.of(section, energy, free, chosen, keep, surface.laws, locks, fixed, near)
    faired = task.solve().profile(section, task.start)
    endless = task.limits.endless
    before = profile_energy(section, energy, surface.sweep)
    after = profile_energy(faired, energy, surface.sweep)
    if after is None and not endless:
        # The search ran into a shape of infinite energy: there is no fairest one to take.
        endless, faired, after = endless_segments(section, energy), section, before
    profile = stored(surface, faired)
    moved = changes(surface.profile, profile)
    status = Status.FAIRER if moved else Status.UNCHANGED
    return Faired(
        profile,
        energy,
        before,
        after,
        moved,
        (*task.kept, *(each for each in Keep if each in keep)),
        task.unmet,
        endless,
        Status.ENDLESS if endless else status,
    )


def changes(before: Profile, after: Profile) -> tuple[Change, ...]:
    """Return what differs between two profiles of as many segments, number by number."""
    found = []
    for k, (old, new) in enumerate(zip(before.segments, after.segments, strict=True)):
        if new is old:
            continue
        for name in PARAMETER_RANGES:
            values = getattr(old.shape, name), getattr(new.shape, name)
            if values[0] != values[1]:
                found.append(Change(k, name, *values))
        for point in range(4):
            for axis, letter in enumerate(_COORDINATES):
                values = float(old.points[point, axis]), float(new.points[point, axis])
                if values[0] != values[1]:
                    found.append(Change(k, f"P{point}.{letter}", *values))
    return tuple(found)


def stored(surface: RevolutionSurface, faired: Profile) -> Profile:
    """Return the stored profile with what changed of its section at θ = 0."""
    if not surface.laws:
        return faired
    segments = []
    for k, (stored, new) in enumerate(zip(surface.profile.segments, faired.segments, strict=True)):
        governed = {law.parameter for law in surface.laws if law.applies_to(k)}
        values = {
            name: getattr(stored.shape if name in governed else new.shape, name)
            for name in PARAMETER_RANGES
        }
        segments.append(stored.with_points(new.points).with_shape(ShapeParameters(**values)))
    return surface.profile.with_segments(segments)
