"""How finely a surface must be sampled so that its mesh stays within a tolerance."""

from __future__ import annotations

from math import acos, ceil, pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.segment import DEGENERATE_LEG
from sgb_core.findings.errors import FindingError
from sgb_core.findings.surfaces import TooManyTriangles
from sgb_core.surfaces.fineness import check_tolerance
from sgb_core.surfaces.helix import UNTWISTED, twisted_counts
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sections import Sections
from sgb_core.surfaces.transfinite import turn_parameter
from sgb_core.surfaces.turn import Spacing, column_angles, creases

MAX_TRIANGLES = 20_000_000
# Shares of the tolerance spent along the section and around; the rest is for merged samples.
_QUARTERS = np.array([0.0, 0.25, 0.5, 0.75])
# Places at which curves that are no quartics are looked at, and what bends may be between them.
_LOOKS = np.linspace(0.0, 1.0, 33)
_BETWEEN = 1.2
ALONG = 0.45
AROUND = 0.45


def check_triangle_count(intervals: float, columns: float) -> None:
    """Raise FindingError where a grid would have more than 20 million triangles."""
    count = 2.0 * intervals * columns
    if count > MAX_TRIANGLES:
        raise FindingError(TooManyTriangles(count, MAX_TRIANGLES))


def samples_for_tolerance(
    surface: RevolutionSurface, tolerance: float, spacing: Spacing = "angle"
) -> tuple[tuple[int, ...], int]:
    """Return (NS of each segment, NT) so that the mesh is within ``tolerance`` of the surface.

    Along the section a chord over Δs is within max|L''| Δs²/8, and |L''| is at most 12 times the
    largest second difference of the quartic points. Around it is within |r|max (1 − cos(Δθ/2)).
    With laws the section's own change over Δθ is added, from its second differences over the
    columns; a twist asks for rows as near to each other as its helices need. Raises FindingError,
    a ValueError, unless 0 < tolerance < ∞, and for more than 20 million triangles.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.samples_for_tolerance(cylinder.surface, 0.05)
    ((1,), 47)
    """
    check_tolerance(tolerance)
    share = tolerance if surface.twisting is None else UNTWISTED * tolerance
    if surface.laws:
        counts, columns = _varying_samples(surface, share, spacing)
    else:
        counts = _section_counts(surface.section[None], ALONG * share, surface.profile.size)
        low, high = surface.profile.bounds()
        widest = float(max(abs(low[0]), abs(high[0])))
        columns = _columns(surface, _angle_step(widest, AROUND * share), spacing)
    check_triangle_count(counts.sum(), columns)
    counts = twisted_counts(surface, counts, int(columns), tolerance)
    check_triangle_count(counts.sum(), columns)
    return tuple(int(count) for count in counts), int(columns)


def _section_counts(sections: Sections, tolerance: float, size: float) -> Floats:
    """Return the intervals of each segment, as floats, for sections of shape (M, n)."""
    bends = np.diff(sections.quartics, 2, axis=-2)
    bound = 12.0 * np.hypot(bends[..., 0], bends[..., 1]).max(axis=(0, 2))
    straight = _straight(sections.quartics, size)
    if sections.stretch is not None:
        bends = sections.on(_LOOKS, 2)
        bound = _BETWEEN * np.hypot(bends[..., 0], bends[..., 1]).max(axis=(0, 2))
        straight &= np.ptp(sections.quartics[..., 1], axis=-1).max(axis=0) <= DEGENERATE_LEG * size
    counts = np.ceil(np.sqrt(bound / (8.0 * tolerance)))
    counts[straight] = 1.0
    return np.asarray(np.clip(counts, 1.0, None))


def _straight(quartics: Floats, size: float) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Which segments run straight from end to end without turning back, in all versions."""
    chord = quartics[..., 4, :] - quartics[..., 0, :]
    length = np.hypot(chord[..., 0], chord[..., 1])[..., None]
    unit = chord / np.where(length > 0.0, length, 1.0)
    steps = np.diff(quartics, axis=-2)
    forward = np.einsum("...kx,...x->...k", steps, unit)
    aside = steps[..., 0] * unit[..., None, 1] - steps[..., 1] * unit[..., None, 0]
    noise = DEGENERATE_LEG * size
    straight = (np.abs(aside) <= noise).all(axis=-1) & (forward >= -noise).all(axis=-1)
    return np.asarray((straight & (length[..., 0] > noise)).all(axis=0))


def _angle_step(radius: float, tolerance: float) -> float:
    """Return the Δθ whose chord is within ``tolerance`` of a circle, at most 120°."""
    if radius <= tolerance:
        return 2.0 * pi / 3.0
    # 1 − cos x loses its digits for small x, where x²/2 is exact enough and on the safe side.
    ratio = tolerance / radius
    half = acos(1.0 - ratio) if ratio > 1e-4 else float(np.sqrt(2.0 * ratio))
    return min(2.0 * half, 2.0 * pi / 3.0)


def columns_for_radius(surface: RevolutionSurface, radius: float, tolerance: float) -> int:
    """Return how many equal steps over the sweep keep chords of a circle within ``tolerance``."""
    return int(_columns(surface, _angle_step(radius, tolerance), "angle"))


def _columns(surface: RevolutionSurface, step: float, spacing: Spacing) -> float:
    reach = surface.sweep
    if spacing == "rational":
        # dθ/dt is at most 4.
        reach = 4.0 * float(turn_parameter(surface.sweep))
    return float(max(ceil(reach / step - 1e-12), int(surface.sweep / pi + 1e-9) + 1))


def _varying_samples(
    surface: RevolutionSurface, tolerance: float, spacing: Spacing
) -> tuple[Floats, float]:
    # Half of the share around is for the circle, half for the section's change; the rest is for
    # the twist that the diagonal of a quad cuts off.
    size = surface.profile.size
    reach = surface.sweep
    if spacing == "rational":
        reach = 4.0 * float(turn_parameter(surface.sweep))
    probe = np.linspace(0.0, surface.sweep, 257)
    sections = surface.sections(probe)
    least = max(64.0, float(_section_counts(sections, 0.35 * tolerance, size).sum()))
    widest = float(np.abs(_shown(sections)[..., 0]).max())
    step = _angle_step(widest, 0.22 * tolerance)
    sharp = len(creases(surface))
    columns = max(_columns(surface, step, spacing), 2.0 * sharp + 2.0 if sharp else 1.0)
    # An even number of columns has one on the crease halfway around.
    creased = any(pi in law.creases for law in surface.laws)
    while True:
        if creased and surface.is_full_turn and columns % 2:
            columns += 1.0
        check_triangle_count(least, columns)
        equal = ceil(columns * (surface.sweep / reach) - 1e-9)
        edges = column_angles(surface, equal)
        gaps = np.diff(edges)
        fine = np.append((edges[:-1, None] + gaps[:, None] * _QUARTERS).ravel(), edges[-1])
        sections = surface.sections(fine)
        change = _interpolation_error(_shown(sections)) / (0.2 * tolerance)
        # Columns moved onto creases leave wider gaps behind.
        if sharp:
            change = max(change, (float(gaps.max()) / step) ** 2 / 1.0001)
        if change <= 1.0:
            break
        columns = float(ceil(columns * min(2.0, max(1.1, np.sqrt(change)))))
    counts = _section_counts(sections, 0.35 * tolerance, size)
    twists = np.diff(_shown_rates(sections), axis=-2)
    twist = np.hypot(twists[..., 0], twists[..., 1]).max(axis=(0, 2))
    counts = np.maximum(counts, np.ceil(twist * reach / columns / (0.1 * tolerance)))
    return counts, columns


def _shown(sections: Sections) -> Floats:
    """Return what stands for curves (M, n, k, 2): quartic points, or places where they stretch."""
    return sections.quartics if sections.stretch is None else sections.on(_LOOKS)


def _shown_rates(sections: Sections) -> Floats:
    """Return ∂/∂θ of such points; neighbouring ones as far apart as those of a quartic."""
    if sections.stretch is None:
        return sections.rates
    return np.asarray(sections.changes_on(_LOOKS) * ((len(_LOOKS) - 1) / 4.0))


def _interpolation_error(quartics: Floats) -> float:
    """Return how far sections lie from those interpolated between every fourth one."""
    start, end = quartics[:-1:4], quartics[4::4]
    worst = 0.0
    for k in range(1, 4):
        between = start + (end - start) * (k / 4.0)
        error = quartics[k:-1:4] - between
        worst = max(worst, float(np.hypot(error[..., 0], error[..., 1]).max()))
    return worst
