"""One section that laws stretch by the height: its lengths, its energy, and a chain of cubics.

Such a section is no chain of quartics. Integrals are taken of the curve itself; where a profile is
asked for, cubic Hermite interpolants between halved places stand for it.
"""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats, Ints
from sgb_core.curves.profile import MAX_SEGMENTS, Profile
from sgb_core.curves.segment import Segment
from sgb_core.surfaces.curvature import cross
from sgb_core.surfaces.quadrature import Panels, integrate_each
from sgb_core.surfaces.sections import Sections

# Cubics stay within this part of the size of the section, where that needs no more than allowed.
NEAR = 1e-8
_BETWEEN = np.linspace(0.0, 1.0, 10)[1:-1]


def stretched_profile(sections: Sections, profile: Profile) -> Profile:
    """Return the section of a profile, (n,) curves, as plain cubics within 1e-8 of its size.

    Segments that nothing stretches are one cubic chain, too: all have ω = 0.
    """
    deepest = int(np.log2(max(1, MAX_SEGMENTS // len(sections))))
    found: list[Segment] = []
    for k in range(len(sections)):
        curve = sections[k]
        marks = np.concatenate([[0.0], curve.breaks(), [1.0]])
        depth = max(0, deepest - int(np.ceil(np.log2(len(marks) - 1))))
        for low, high in zip(marks[:-1].tolist(), marks[1:].tolist(), strict=True):
            found += _cubics(curve, low, high, NEAR * profile.size, depth)
    rules = ["free"] * (len(found) if profile.closed else len(found) - 1)
    return Profile.of(found, rules, profile.closed)


def _cubics(curve: Sections, low: float, high: float, near: float, depth: int) -> list[Segment]:
    ends = np.array([low, high])
    (first, last), rates = curve.on(ends), curve.on(ends, 1) * ((high - low) / 3.0)
    cubic = np.array([first, first + rates[0], last - rates[1], last])
    t, s = _BETWEEN[:, None], 1.0 - _BETWEEN[:, None]
    points = s**3 * cubic[0] + 3 * s**2 * t * cubic[1] + 3 * s * t**2 * cubic[2] + t**3 * cubic[3]
    off = points - curve.on(low + (high - low) * _BETWEEN)
    if depth == 0 or float(np.hypot(off[:, 0], off[:, 1]).max()) <= near:
        return [Segment(cubic)]
    middle = (low + high) / 2.0
    return [
        *_cubics(curve, low, middle, near, depth - 1),
        *_cubics(curve, middle, high, near, depth - 1),
    ]


def _panels(sections: Sections) -> Panels:
    """Return panels between crossings of the heights of keys, shrinking towards both ends."""
    toward = np.append(0.0, 4.0 ** np.arange(-8.0, 0.0))
    even = np.unique(np.concatenate([toward, 1.0 - toward]))
    marks = [np.union1d(even, sections[k].breaks()) for k in range(len(sections))]
    which = np.repeat(np.arange(len(marks)), [len(each) - 1 for each in marks])
    low = np.concatenate([each[:-1] for each in marks])
    return low, np.concatenate([each[1:] for each in marks]), which


def section_lengths(sections: Sections) -> Floats:
    """Return the arc length of each of (n,) curves."""

    def speed(s: Floats, k: Ints) -> Floats:
        first = sections[k].of_each(s, 1)
        return np.asarray(np.hypot(first[..., 0], first[..., 1]))

    return integrate_each(speed, _panels(sections), len(sections))


def section_energy(sections: Sections) -> float:
    """Return ∫ κ² dl over (n,) curves none of which has a vanishing derivative that counts."""

    def density(s: Floats, k: Ints) -> Floats:
        some = sections[k]
        first, second = some.of_each(s, 1), some.of_each(s, 2)
        pace = np.hypot(first[..., 0], first[..., 1])
        still = pace == 0.0
        return np.where(still, 0.0, cross(first, second) ** 2 / np.where(still, 1.0, pace) ** 5)

    return float(integrate_each(density, _panels(sections), len(sections), 1e-12).sum())
