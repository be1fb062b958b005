"""A profile made ready for a body: run from foot to rim, checked, with samples for its wall."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from math import hypot

import numpy as np
import shapely

from sgb_core.arrays import Floats, Ints, Mask, frozen
from sgb_core.curves.continuity import JointClass, gap_at, measure_joints
from sgb_core.curves.crossings import axis_crossings
from sgb_core.curves.intersections import self_intersections
from sgb_core.curves.nodes import at_each, on_nodes
from sgb_core.curves.profile import GAP, Profile
from sgb_core.curves.roots import extremes_of_all, roots_of_each
from sgb_core.findings.bodies import NoBody, NoBodyFor, UnfitProfile
from sgb_core.findings.errors import FindingError
from sgb_core.findings.joints import Gap
from sgb_core.surfaces.curvature import cross
from sgb_core.surfaces.normals import tangents_of_each
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.section import AXIS, snapped
from sgb_core.surfaces.sections import Sections, Stretch, curves_at, turned_by
from sgb_core.values import dataclass

# Comparing all pieces of the curve with all others takes seconds in longer chains.
MOST_COMPARED = 100
_PROBE = np.linspace(0.0, 1.0, 33)
# A curve within the first of these parts of the size of a line, and running back along it by more
# than the second, lies on itself.
_FLAT, _BACK = 1e-8, 1e-6


class SolidError(FindingError):
    """A body that cannot be made, with the finding why."""


@dataclass(frozen=True, eq=False)
class Meridian:
    """Quartics (n, 5, 2) run head to tail from foot to rim, on the positive side of the axis.

    ``stretch`` (n,) maps them where laws change along the height; ``numbers`` are the segments'
    numbers in the profile. ``closed`` rings run counter-clockwise. ``mirrored`` says that the
    profile lay at r < 0, ``reverse`` that it is run backwards. ``size`` is the profile's.
    """

    quartics: Floats
    numbers: tuple[int, ...]
    closed: bool
    mirrored: bool
    reverse: bool
    size: float
    stretch: Stretch | None = None

    @property
    def curves(self) -> Sections:
        """The drawn curves, (n,)."""
        return Sections(self.quartics, np.zeros_like(self.quartics), self.stretch)

    @cached_property
    def ends(self) -> tuple[Floats, Floats]:
        """The first and last points of the segments, (n, 2) each."""
        return self.curves.ends

    @property
    def foot(self) -> Floats:
        """The lower end, (2,)."""
        return np.asarray(self.ends[0][0])

    @property
    def rim(self) -> Floats:
        """The upper end, (2,)."""
        return np.asarray(self.ends[1][-1])

    def at_each(self, k: Ints, s: Floats, order: int = 0) -> Floats:
        """Return a derivative of curve ``k[i]`` at ``s[i]`` for each i, shape (m, 2)."""
        return curves_at(self.quartics, self.stretch, k, s, order)

    @property
    def lowest(self) -> float:
        """The least height of the profile; below the foot where it is a punt's."""
        return extremes_of_all(self.quartics[:, :, 1])[0]

    @property
    def foot_on_axis(self) -> bool:
        """Whether the lower end lies on the axis."""
        return not self.closed and bool(self.foot[0] <= AXIS * self.size)

    @property
    def rim_on_axis(self) -> bool:
        """Whether the upper end lies on the axis: there is no rim."""
        return not self.closed and bool(self.rim[0] <= AXIS * self.size)

    def end_directions(self) -> tuple[Floats, Floats]:
        """Return the unit tangents at the start and the end of each segment, (n, 2) each."""
        return self.curves.end_tangents(self.size)


def meridian_of(surface: RevolutionSurface, section: Sections | None = None) -> Meridian:
    """Return the meridian of a surface; ``section`` (n,) is that of one angle of a law.

    The run is reversed where the last end is the lower one; ends at one height keep the way on
    which the enclosed volume is positive. Raises SolidError for gaps and beyond the axis.
    """
    profile = surface.profile
    size = profile.size
    stretch = None if section is None else section.stretch
    if section is None:
        _check_drawn(profile)
    else:
        _check_whole(section, size)
    curves = np.array(profile.quartics if section is None else section.quartics)
    first, last = curves[0, 0], curves[-1, 4]
    closed = profile.closed or (
        len(curves) > 1 and hypot(*(last - first)) <= GAP * size and bool(first[0] > AXIS * size)
    )
    mirrored = bool(curves[..., 0].sum() < 0.0)
    if mirrored:
        curves[..., 0] *= -1.0
    rise = 0.0 if closed else float(last[1] - first[1])
    if abs(rise) <= GAP * size:
        rise = surface.mean_flux
    numbers = tuple(range(len(curves)))
    if rise < 0.0:
        curves, numbers = curves[::-1, ::-1], numbers[::-1]
        stretch = None if stretch is None else stretch[::-1]
    curves = snapped(curves, size)
    if section is not None and on_nodes(curves, _PROBE)[..., 0].min() < -AXIS * size:
        raise SolidError(NoBody.BEYOND_AXIS)
    if not curves[..., 0].any():
        raise SolidError(NoBodyFor.ON_AXIS)
    return Meridian(frozen(curves), numbers, closed, mirrored, rise < 0.0, size, stretch)


def _check_drawn(profile: Profile) -> None:
    for report in measure_joints(profile):
        if report.measured is JointClass.GAP:
            raise SolidError(UnfitProfile(gap_at(profile, report)))
    for beyond in axis_crossings(profile):
        raise SolidError(UnfitProfile(beyond))


def _check_whole(section: Sections, size: float) -> None:
    """Refuse sections torn apart: a law of the radius may govern only some segments."""
    starts, ends = section.ends
    steps = starts[1:] - ends[:-1]
    gaps = np.hypot(steps[:, 0], steps[:, 1])
    if len(gaps) and gaps.max() > GAP * size:
        first = int(np.argmax(gaps))
        raise SolidError(UnfitProfile(Gap(first, first + 1, float(gaps[first]))))


def check_simple(
    surface: RevolutionSurface, meridian: Meridian, grids: Mapping[int, Floats]
) -> None:
    """Raise SolidError where the profile crosses itself, saying where."""
    inner = [grids[number][:-1] for number in meridian.numbers]
    of = np.repeat(np.arange(len(inner)), [len(s) for s in inner])
    points = meridian.at_each(of, np.concatenate(inner))
    end = meridian.foot if meridian.closed else meridian.rim
    ring = np.concatenate([points, end[None]])
    if _is_folded_flat(ring, meridian.size):
        raise SolidError(NoBodyFor.TOO_FLAT)
    if shapely.LineString(ring).is_simple:
        return
    if len(surface.profile) > MOST_COMPARED:
        raise SolidError(NoBodyFor.CROSSES_ITSELF)
    for crossing in self_intersections(surface.profile):
        if not crossing.touches:
            raise SolidError(UnfitProfile(crossing))


def _is_folded_flat(points: Floats, size: float) -> bool:
    """Whether a curve runs forth and back along one straight line, as far as can be told."""
    away = points - points.mean(axis=0)
    long = np.linalg.eigh(away.T @ away)[1][:, 1]
    if np.ptp(cross(long, away)) > _FLAT * size:
        return False
    steps = np.diff(away @ long)
    return bool(min(steps[steps > 0.0].sum(), -steps[steps < 0.0].sum()) > _BACK * size)


def sample_grids(
    meridian: Meridian, offsets: tuple[float, ...], tolerance: float, least: int = 4
) -> dict[int, Floats]:
    """Return for each segment's number the s between which all its traces are nearly straight.

    ``offsets`` are the distances by which the segment is moved (0 for the drawn curve itself); the
    chords stay within ``tolerance``. Extremes of r and h, which moving keeps, are sampled.
    """
    quartics = meridian.quartics
    each = np.arange(len(quartics))
    # Where the chain is sampled at first: evenly, and at the extremes. Where it is stretched those
    # of the quartics stand for its own, and strengths have keys.
    even = np.linspace(0.0, 1.0, least + 1)
    roots = [roots_of_each(np.diff(quartics[:, :, axis], axis=1)) for axis in range(2)]
    if meridian.stretch is not None:
        breaks = [meridian.curves[k].breaks() for k in each.tolist()]
        of = np.repeat(each, [len(found) for found in breaks])
        roots.append((np.concatenate(breaks), of))
    s = np.concatenate([np.tile(even, len(each)), *(root for root, _ in roots)])
    which = np.concatenate([np.repeat(each, len(even)), *(number for _, number in roots)])
    which, s = _far_enough(which, s)
    for _ in range(9):
        inside = which[1:] == which[:-1]
        middle, of = ((s[1:] + s[:-1]) / 2.0)[inside], which[1:][inside]
        far = _bent(meridian, s, which, middle, offsets, tolerance)
        if not far.any():
            break
        s, which = np.concatenate([s, middle[far]]), np.concatenate([which, of[far]])
        order = np.lexsort((s, which))
        s, which = s[order], which[order]
    parts = np.split(frozen(s), np.flatnonzero(np.diff(which)) + 1)
    return dict(zip(meridian.numbers, parts, strict=True))


def _tangents(meridian: Meridian, k: Ints, s: Floats) -> Floats:
    plain = at_each(meridian.quartics, k, s, 1)
    tangents = tangents_of_each(meridian.quartics, k, s, plain, meridian.size)
    if meridian.stretch is None:
        return tangents
    return turned_by(meridian.stretch[k], at_each(meridian.quartics, k, s), tangents)


def _far_enough(which: Ints, s: Floats) -> tuple[Ints, Floats]:
    """Return segments' parameters in order, without those that nearly repeat the next."""
    order = np.lexsort((s, which))
    which, s = which[order], s[order]
    last = np.append(which[1:] != which[:-1], True)
    kept = last | np.append(np.diff(s) > 1e-6, True)
    which, s = which[kept], s[kept]
    last = np.append(which[1:] != which[:-1], True)
    s[last], s[np.roll(last, 1)] = 1.0, 0.0
    return which, s


def _bent(
    meridian: Meridian,
    s: Floats,
    which: Ints,
    middle: Floats,
    offsets: tuple[float, ...],
    tolerance: float,
) -> Mask:
    """Whether the traces from each parameter to its segment's next are not straight enough.

    ``middle`` are the parameters halfway.
    """
    inside = which[1:] == which[:-1]
    of = which[1:][inside]
    at, on = np.concatenate([s, middle]), np.concatenate([which, of])
    points, tangents = meridian.at_each(on, at), _tangents(meridian, on, at)
    normals = np.stack([-tangents[:, 1], tangents[:, 0]], axis=1)
    start = np.flatnonzero(inside)
    end, halfway = start + 1, len(s) + np.arange(len(middle))
    far = np.zeros(len(middle), dtype=bool)
    for offset in offsets:
        moved = points + offset * normals
        sag = moved[halfway] - (moved[start] + moved[end]) / 2.0
        chord = moved[end] - moved[start]
        length = np.hypot(chord[:, 0], chord[:, 1])
        aside = np.abs(cross(sag, chord)) / np.where(length > 0.0, length, 1.0)
        # Where the chord turns back on itself the sag along it counts as well.
        back = np.hypot(sag[:, 0], sag[:, 1]) > 0.3 * length + tolerance
        far |= (aside > tolerance) | back
    # Segments that turn sharply within one step.
    far |= (tangents[start] * tangents[end]).sum(axis=1) < 0.5
    return far
