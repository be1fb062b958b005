"""The two halves of an object on paper: section with its material, outside with its edges."""

from __future__ import annotations

from sgb_core.drawings import marks
from sgb_core.drawings.half_view import HalfView
from sgb_core.drawings.page import Area, Layer, Mark, Path, Pen, Stroke
from sgb_core.drawings.wanted import Fill
from sgb_core.values import dataclass

# Lines of the hatching apart, in mm.
HATCH_SPACING = 2.0
_HAIRLINE = Pen(0.1)


@dataclass(frozen=True, slots=True)
class ViewLook:
    """How the halves are drawn: pens in mm, the fill, how far the axis goes beyond the object."""

    outline: Pen
    axis: Pen
    fill: Fill
    beyond: float = 0.0
    spacing: float = HATCH_SPACING


def view_marks(
    view: HalfView, origin: tuple[float, float], factor: float, mirror: float, look: ViewLook
) -> list[Mark]:
    """Return both halves with the axis at ``origin``.

    The section stands on the right where ``mirror`` is 1, on the left where it is −1.
    """
    x, y = origin
    left = mirror < 0.0
    made: list[Mark] = []

    def placed(path: Path, mirrored: bool) -> Path:
        return path.moved(factor, origin, mirrored)

    for part in view.material:
        paths = tuple(placed(path, left) for path in part)
        pen = look.outline
        if look.fill is Fill.FILLED:
            made.append(Area(Layer.MATERIAL, paths))
            # A wide line would make a filled wall look thicker than it is.
            pen = _HAIRLINE
        else:
            lines = marks.hatch(paths, look.spacing)
            made += [lines] if lines is not None else []
        made.append(Stroke.of(Layer.OUTLINE, *paths, pen=pen))
    outlines = [placed(path, left) for path in view.bare]
    outlines += [placed(path, not left) for path in view.outside]
    if outlines:
        made.append(Stroke.of(Layer.OUTLINE, *outlines, pen=look.outline))
    made += _edges(view, origin, factor, mirror, look)
    low, high = y + view.low * factor - look.beyond, y + view.high * factor + look.beyond
    made.append(Stroke.of(Layer.AXIS, Path.through(((x, low), (x, high))), pen=look.axis))
    return made


def _edges(
    view: HalfView, origin: tuple[float, float], factor: float, mirror: float, look: ViewLook
) -> list[Mark]:
    """Return edges as level lines from the axis; those that bound the view are as wide as it."""
    x, y = origin
    made: list[Mark] = []
    near = 1e-6 * max(view.height, view.reach)
    for circles, side in ((view.edges, -mirror), (view.inside, mirror)):
        for r, h in circles:
            bounds = side == -mirror and (h <= view.low + near or h >= view.high - near)
            layer, pen = (Layer.OUTLINE, look.outline) if bounds else (Layer.EDGES, None)
            level = y + h * factor
            path = Path.through(((x, level), (x + side * r * factor, level)))
            made.append(Stroke.of(layer, path, pen=pen))
    return made
