"""What the measuring tool has hold of, and what it says of it."""

from __future__ import annotations

from app.hand.coordinates import DesignPoint, Transform, decimals_for, number
from app.hand.guides import guide_lines
from app.hand.hit_test import PointId, Target, pick
from app.hand.readout import point_name
from app.hand.snapping import AXIS_REACH, MAGNET_REACH, DragKeys, Snapping, land
from app.state.presenter import Frame
from app.state.window_reader import WINDOW
from sgb_core.bodies.wall_depth import wall_depth_at
from sgb_core.curves.measuring import along, between, on_curve, opening
from sgb_core.curves.nearest import foot_point
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.findings.errors import FindingError
from sgb_core.values import dataclass

# Two ways of measuring are begun by the first two places; the third ends both.
MOST = 3


@dataclass(frozen=True, slots=True)
class Spot:
    """A place that is measured from or to: a control point, on the curve, or anywhere.

    ``point`` is (segment, index) of a control point; ``curve`` (segment, s) of a place on the
    profile, an end of a segment included.
    """

    place: DesignPoint
    point: PointId | None = None
    curve: tuple[int, float] | None = None


def spot_at(
    frame: Frame, paper: Transform, cursor: DesignPoint, keys: DragKeys, last: Spot | None
) -> Spot:
    """Return the spot that the hand means: points, curve and guides draw it, Ctrl lets go.

    Shift goes straight across or up from the ``last`` spot.
    """
    profile = frame.document.profile
    if keys.constrain and last is not None:
        snapping = Snapping(None, AXIS_REACH / paper.scale)
        return Spot(land(last.place, cursor, keys, snapping).point)
    if keys.free:
        return Spot(cursor)
    at = paper.to_screen(cursor)
    found = pick(profile, paper, at, selected=frame.view.segment, quartics=False)
    if found is None:
        guides, reach = guide_lines(frame.document.guides), MAGNET_REACH / paper.scale
        snapping = Snapping(None, AXIS_REACH / paper.scale, guides=guides, guide_reach=reach)
        return Spot(land(cursor, cursor, keys, snapping).point)
    if found.target is Target.POINT:
        ends = {0: 0.0, 3: 1.0}
        curve = (found.segment, ends[found.index]) if found.index in ends else None
        place = DesignPoint.of(profile.segments[found.segment].points[found.index])
        return Spot(place, (found.segment, found.index), curve)
    s, foot, _ = foot_point(profile.segments[found.segment], cursor.r, cursor.h)
    return Spot(DesignPoint(*foot), None, (found.segment, s))


def told_lines(frame: Frame, scale: float, placed: tuple[Spot, ...], here: Spot) -> list[str]:
    """Return what is read between the placed spots and the one that the hand is at."""
    unit, decimals = str(frame.document.unit), decimals_for(1.0 / scale)

    def length(value: float) -> str:
        return f"{number(value, decimals)} {unit}"

    if not placed:
        return _lines_at(frame, here, decimals)
    last = placed[-1]
    way = between(last.place.pair, here.place.pair)
    lines = [
        f"{length(way.length)}   ∠ {number(way.angle_deg, 1)}°",
        f"Δr {number(way.dr, decimals)}   Δh {number(way.dh, decimals)} {unit}",
    ]
    if last.curve is not None and here.curve is not None:
        curved = along(frame.document.profile, last.curve, here.curve)
        if curved is not None:
            lines.append(f"{length(curved)} along the curve")
    if len(placed) == MOST - 1:
        angle = opening(placed[0].place.pair, last.place.pair, here.place.pair)
        if angle is not None:
            lines.insert(0, f"∠ {number(angle, 2)}° between both")
    return lines


def _lines_at(frame: Frame, here: Spot, decimals: int) -> list[str]:
    """Return what is read at one place: where it is, how it bends, how thick the wall is."""
    document = frame.document
    profile, unit = document.profile, str(document.unit)
    r, h = here.place.pair
    lines = [f"r {number(r, decimals)}   h {number(h, decimals)} {unit}"]
    if here.point is not None:
        lines.insert(0, point_name(profile, here.point))
    if here.curve is None:
        return lines
    segment, s = here.curve
    if here.point is None:
        lines.insert(0, f"{WINDOW.segment(segment)}   s = {s:.3f}")
    lines.append(f"⌀ {number(2.0 * abs(r), decimals)} {unit}")
    read = on_curve(profile, segment, s)
    bend = "straight" if read.radius is None else f"R {number(read.radius, decimals)} {unit}"
    slope = "" if read.angle_deg is None else f"   tangent ∠ {number(read.angle_deg, 1)}°"
    lines.append(f"{bend}{slope}" if read.angle_deg is not None else "no tangent")
    try:
        wall = wall_depth_at(document.surface, document.solid, segment, s)
    except FindingError:
        wall = None
    if wall is not None:
        lines.append(f"wall {number(wall, decimals)} {unit}")
    return lines


def dimension_of(placed: tuple[Spot, ...], here: Spot) -> Dimension | None:
    """Return what is measured as a dimension that the project can keep, None where it cannot.

    A distance between two control points, the radius of curvature on the curve, the diameter at a
    control point's height.
    """
    if placed and placed[-1].point is not None and here.point is not None:
        if placed[-1].point == here.point:
            return None
        return Dimension(DimensionKind.DISTANCE, points=(placed[-1].point, here.point))
    if placed:
        return None
    if here.point is not None:
        return Dimension(DimensionKind.DIAMETER_AT, height=here.place.h)
    if here.curve is not None:
        return Dimension(DimensionKind.RADIUS, segment=here.curve[0], s=here.curve[1])
    return None
