"""The values behind the colour maps: one number at each row (and column) of a sweep grid."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.solid import Solid
from sgb_core.bodies.wall_depth import wall_depths
from sgb_core.curves.segment import SYMBOLS
from sgb_core.document.appearance.model import ColourMap, MapKind, Scale
from sgb_core.surfaces.influence import section_influence
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.turn import grid_columns

# Half the step of the difference quotients of the normal where laws hold, in s and in radians;
# their error is a millionth of the curvature.
_STEP = 1e-4
# Automatic limits leave out this part of the values at each end: apexes have infinite curvature.
_TAILS = 0.05
_BARE = Solid()
# Steps in a segment, and columns with laws, whose values make the automatic limits.
_LIMITS_FROM = (24, 16)
# The colours part at 0 where the smaller side reaches this part of the larger.
_TWO_SIDED = 0.05
_SIGNED = {MapKind.MERIDIAN, MapKind.PARALLEL, MapKind.GAUSSIAN, MapKind.MEAN}
_TAILED = _SIGNED | {MapKind.THICKNESS}


def map_values(
    surface: RevolutionSurface,
    shown: ColourMap,
    per_segment: int,
    columns: int,
    solid: Solid = _BARE,
) -> Floats:
    """Return the values on a grid's rows, shape (rows, 1), or (rows, columns + 1) with laws.

    Rows are ``per_segment`` + 1 to a segment. Lengths in the document's unit, curvatures in its
    inverse (Gaussian: its inverse square), positive where the surface bends away from its outer
    side; overhang in degrees, by how much the outer side faces down, 90 for a ceiling. Infinite
    at the apex of a cone. The wall thickness is that of ``solid`` along the normal, not a number
    where there is none. Zebra stripes have no values: all are 0.
    """
    s = np.linspace(0.0, 1.0, per_segment + 1)
    angles = np.array([surface.start])
    if surface.laws:
        angles = surface.start + grid_columns(surface, columns)[0]
    if shown.of is MapKind.INFLUENCE:
        count = len(surface.profile)
        segment = shown.segment if shown.segment is None or shown.segment < count else None
        turned = angles - surface.start
        found = section_influence(
            surface.profile,
            shown.parameter,
            s,
            segment,
            surface.laws,
            turned,
            surface.sections(turned),
        )
        return np.asarray(found.reshape(len(angles), -1).T)
    if shown.of is MapKind.THICKNESS:
        try:
            return wall_depths(surface, solid, s, columns)
        except SolidError:
            # The panels say why there is no body.
            return np.full((len(surface.profile) * len(s), 1), np.nan)
    grid = [
        _of_segment(surface, shown.of, k, s[:, None], angles) for k in range(len(surface.profile))
    ]
    return np.concatenate(grid)


def _of_segment(
    surface: RevolutionSurface, kind: MapKind, segment: int, s: Floats, theta: Floats
) -> Floats:
    shape = (len(s), len(theta))
    if kind is MapKind.ZEBRA:
        return np.zeros(shape)
    if kind in (MapKind.RADIUS, MapKind.HEIGHT):
        frame = surface.directions(theta)
        point = surface.point(segment, s, theta) - np.asarray(surface.placement.translation)
        way = 0 if kind is MapKind.RADIUS else 2
        along = np.einsum("rcx,cx->rc", point, frame[:, way])
        return np.asarray(np.abs(along) if kind is MapKind.RADIUS else along)
    if kind is MapKind.OVERHANG:
        normal = surface.normal(segment, s, theta)
        up = surface.directions(np.zeros(1))[0, 2]
        return np.asarray(np.degrees(np.arcsin(np.clip(-(normal @ up), -1.0, 1.0))))
    if kind in (MapKind.MERIDIAN, MapKind.PARALLEL) or not surface.laws:
        meridian, parallel = surface.curvatures(segment, s, theta)
        if kind is MapKind.MERIDIAN:
            return meridian
        if kind is MapKind.PARALLEL:
            return parallel
        gaussian, mean = meridian * parallel, (meridian + parallel) / 2.0
    else:
        gaussian, mean = _by_difference(surface, segment, s, theta)
    return np.asarray(gaussian if kind is MapKind.GAUSSIAN else mean)


def _by_difference(
    surface: RevolutionSurface, segment: int, s: Floats, theta: Floats
) -> tuple[Floats, Floats]:
    """Return the Gaussian and the mean curvature from how the exact normal turns."""
    inside = np.clip(s, _STEP, 1.0 - _STEP)
    # At the edge of the sweep the section jumps where the laws do; look inward.
    inner = np.clip(theta, surface.start + _STEP, surface.start + surface.sweep - _STEP)
    along, around = surface.partials(segment, inside, inner)

    def turned(ds: float, dt: float) -> Floats:
        ahead = surface.normal(segment, inside + ds, inner + dt)
        return np.asarray((ahead - surface.normal(segment, inside - ds, inner - dt)) / (2 * _STEP))

    by_s, by_t = turned(_STEP, 0.0), turned(0.0, _STEP)

    def dot(a: Floats, b: Floats) -> Floats:
        return np.asarray(np.einsum("...x,...x->...", a, b))

    e, f, g = dot(along, along), dot(along, around), dot(around, around)
    l, m, n = dot(by_s, along), dot(by_s, around), dot(by_t, around)  # noqa: E741
    area = e * g - f * f
    with np.errstate(divide="ignore", invalid="ignore"):
        gaussian = np.where(area > 0.0, (l * n - m * m) / area, np.inf)
        mean = np.where(area > 0.0, (e * n - 2.0 * f * m + g * l) / (2.0 * area), np.inf)
    return np.asarray(gaussian), np.asarray(mean)


def map_limits(
    surface: RevolutionSurface, shown: ColourMap, solid: Solid = _BARE
) -> tuple[float, float]:
    """Return the limits of a map on a surface, the same however finely it is drawn or written."""
    if shown.low is not None and shown.high is not None:
        return limits_of(shown, np.zeros(1))
    return limits_of(shown, map_values(surface, shown, *_LIMITS_FROM, solid))


def limits_of(shown: ColourMap, values: Floats) -> tuple[float, float]:
    """Return the lowest and the highest value that have a colour of their own.

    What the map does not fix is taken from the values without their tails; where they change
    sign the limits lie evenly about 0.
    """
    if shown.of is MapKind.OVERHANG:
        low, high = -90.0, 90.0
    else:
        finite = values[np.isfinite(values)]
        low, high = (0.0, 1.0)
        if finite.size:
            tails = _TAILS if shown.of in _TAILED else 0.0
            low, high = (float(q) for q in np.quantile(finite, (tails, 1.0 - tails)))
        if shown.of in (MapKind.INFLUENCE, MapKind.THICKNESS):
            low = 0.0
        if is_diverging(shown, low, high):
            high = max(-low, high)
            low = -high
    low = low if shown.low is None else shown.low
    high = high if shown.high is None else shown.high
    if not high > low:
        reach = max(abs(low), abs(high), 1e-6) * 1e-6
        low, high = low - reach, high + reach
    return low, high


def is_diverging(shown: ColourMap, low: float, high: float) -> bool:
    """Whether the colours part at 0."""
    if shown.scale is not Scale.AUTO:
        return shown.scale is Scale.DIVERGING
    reach = min(-low, high)
    return shown.of in _SIGNED and reach > _TWO_SIDED * max(-low, high)


def shares_of(values: Floats, low: float, high: float) -> Floats:
    """Return where values lie between the limits, cut to 0 and 1; not a number becomes 0."""
    with np.errstate(invalid="ignore"):
        part = (values - low) / (high - low)
    return np.asarray(np.clip(np.nan_to_num(part, nan=0.0, posinf=1.0, neginf=0.0), 0.0, 1.0))


TITLES = {
    MapKind.RADIUS: ("Radius", "{unit}"),
    MapKind.HEIGHT: ("Height", "{unit}"),
    MapKind.MERIDIAN: ("Meridian curvature", "1/{unit}"),
    MapKind.PARALLEL: ("Parallel curvature", "1/{unit}"),
    MapKind.GAUSSIAN: ("Gaussian curvature", "1/{unit}²"),
    MapKind.MEAN: ("Mean curvature", "1/{unit}"),
    MapKind.OVERHANG: ("Overhang", "°"),
    MapKind.THICKNESS: ("Wall thickness", "{unit}"),
    MapKind.INFLUENCE: ("Influence", "{unit} per unit"),
    MapKind.ZEBRA: ("Zebra stripes", ""),
}


def title_of(shown: ColourMap, unit: str) -> str:
    """Return what stands above the colour bar: the quantity and its unit."""
    title, measure = TITLES[shown.of]
    if shown.of is MapKind.INFLUENCE:
        title = f"Influence of {SYMBOLS[shown.parameter]}"
    return f"{title} ({measure.format(unit=unit)})" if measure else title
