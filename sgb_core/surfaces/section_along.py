"""The section of a surface at its start angle by its arc length, whatever laws make of it."""

from __future__ import annotations

import numpy as np

from sgb_core.curves.along import Along, along
from sgb_core.curves.nodes import gauss
from sgb_core.curves.polyline import distances
from sgb_core.curves.segment import NEUTRAL
from sgb_core.surfaces.curvature import cross
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sections import Sections
from sgb_core.surfaces.stretched_section import section_lengths

# Places of a plain cubic that is no cubic any more, by which distances from it are told.
_FINE = np.linspace(0.0, 1.0, 2049)
_NODES = 6


def along_section(surface: RevolutionSurface, per_segment: int) -> tuple[Along, ...]:
    """Return samples of each segment of the section at the start angle, as :func:`along` does.

    Where laws stretch it by the height the plain cubic is stretched like it.
    """
    profile = surface.shape_at(surface.start)
    if not surface.fades:
        return along(profile, per_segment)
    sections = surface.section
    plain = profile.with_segments(segment.with_shape(NEUTRAL) for segment in profile.segments)
    cubics = Sections(plain.quartics, sections.rates, sections.stretch).on(_FINE)
    s = np.linspace(0.0, 1.0, per_segment)
    points, first, second = (sections.on(s, order) for order in range(3))
    speed = np.hypot(first[..., 0], first[..., 1])
    with np.errstate(divide="ignore", invalid="ignore"):
        curvature = cross(first, second) / speed**3
    nodes, weights = gauss(_NODES)
    inner = s[:-1, None] + np.diff(s)[:, None] * nodes
    rates = sections.on(inner.ravel(), 1)
    pace = np.hypot(rates[..., 0], rates[..., 1]).reshape(len(sections), *inner.shape)
    whole = section_lengths(sections)
    start, found = 0.0, []
    for k in range(len(sections)):
        lengths = np.concatenate([[0.0], np.cumsum((pace[k] @ weights) * np.diff(s))])
        lengths *= whole[k] / lengths[-1] if lengths[-1] > 0.0 else 1.0
        away = distances(points[k], cubics[k])
        found.append(Along(s, points[k], start + lengths, curvature[k], away))
        start += float(whole[k])
    return tuple(found)
