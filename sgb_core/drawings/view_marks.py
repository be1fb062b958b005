"""The two halves of an object on paper: section with its material, outside with its edges."""

from __future__ import annotations

from sgb_core.drawings import marks
from sgb_core.drawings.half_view import HalfView
from sgb_core.drawings.page import Area, Layer, Mark, Path, Stroke
from sgb_core.drawings.wanted import Fill, Wanted

# How far the centre line goes beyond the object, and lines of the hatching apart, in mm.
_AXIS_BEYOND = 4.0
HATCH_SPACING = 2.0


def view_marks(
    view: HalfView,
    origin: tuple[float, float],
    factor: float,
    wanted: Wanted,
    *,
    edge_to_axis: bool,
) -> list[Mark]:
    """Return both halves with the axis at ``origin``; ``edge_to_axis`` draws it dashed, beyond."""
    x, y = origin
    left = wanted.mirror < 0.0
    made: list[Mark] = []

    def placed(path: Path, mirrored: bool) -> Path:
        return path.moved(factor, origin, mirrored)

    for part in view.material:
        paths = tuple(placed(path, left) for path in part)
        if wanted.fill is Fill.FILLED:
            made.append(Area(Layer.MATERIAL, paths))
        else:
            lines = marks.hatch(paths, HATCH_SPACING)
            made += [lines] if lines is not None else []
        made.append(Stroke.of(Layer.OUTLINE, *paths))
    outlines = [placed(path, left) for path in view.bare]
    outlines += [placed(path, not left) for path in view.outside]
    if outlines:
        made.append(Stroke.of(Layer.OUTLINE, *outlines))
    made += _edges(view, origin, factor, wanted.mirror)
    low, high = y + view.low * factor, y + view.high * factor
    beyond = _AXIS_BEYOND if edge_to_axis else 0.0
    made.append(marks.line(Layer.AXIS, (x, low - beyond), (x, high + beyond)))
    return made


def _edges(view: HalfView, origin: tuple[float, float], factor: float, mirror: float) -> list[Mark]:
    """Return edges as level lines from the axis; those that bound the view are as wide as it."""
    x, y = origin
    made: list[Mark] = []
    near = 1e-6 * max(view.height, view.reach)
    for circles, side in ((view.edges, -mirror), (view.inside, mirror)):
        for r, h in circles:
            bounds = side == -mirror and (h <= view.low + near or h >= view.high - near)
            layer = Layer.OUTLINE if bounds else Layer.EDGES
            level = y + h * factor
            made.append(marks.line(layer, (x, level), (x + side * r * factor, level)))
    return made
