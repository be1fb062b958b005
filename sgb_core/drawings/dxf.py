"""A page as DXF for CAD programs: the object at true size in millimetres, the sheet around it.

x is the distance from the axis of the first object, y its height; the sheet and all words are
enlarged by as much as the page shows the object smaller.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.document.file.dxf_file import dxf_bytes
from sgb_core.drawings.page import (
    PENS,
    Anchor,
    Area,
    Drawing,
    Page,
    Path,
    Stroke,
    Words,
)

_MILLIMETRES = 4
_STYLE = "SHEET"
# Widths that DXF knows, in hundredths of a millimetre.
_WEIGHTS = np.array([0, 5, 9, 13, 15, 18, 20, 25, 30, 35, 40, 50, 53, 60, 70, 80, 90, 100])


def drawing_dxf(drawing: Drawing, number: int = 0) -> bytes:
    """Return one page of a drawing, on layers that are called as the page's, in capitals."""
    return dxf_bytes(lambda: _made(drawing, drawing.pages[number]))


def _made(drawing: Drawing, page: Page) -> Any:
    import ezdxf
    from ezdxf.enums import TextEntityAlignment as Align

    made = ezdxf.new("R2010", setup=["linetypes"])
    made.header["$INSUNITS"] = _MILLIMETRES
    made.header["$MEASUREMENT"] = 1
    # Dashes are those of the paper; the line types of ezdxf count in inches or centimetres.
    made.header["$LTSCALE"] = 0.2 / page.scale
    made.header.custom_vars.append("Title", drawing.title)
    within = f"{drawing.tolerance / page.scale:g} mm"
    made.header.custom_vars.append("Subject", f"{drawing.subject}; curves within {within}")
    made.styles.add(_STYLE, font="DejaVuSans.ttf")
    for layer in page.layers:
        pen = PENS[layer]
        linetype = "CENTER" if pen.dashes else "CONTINUOUS"
        made.layers.add(layer.upper(), linetype=linetype, lineweight=_weight(pen.width))
    space = made.modelspace()
    anchors = {
        Anchor.START: Align.LEFT,
        Anchor.MIDDLE: Align.CENTER,
        Anchor.END: Align.RIGHT,
    }
    for layer in page.layers:
        for mark in page.of_layer(layer):
            look: dict[str, Any] = {"layer": layer.upper()}
            if isinstance(mark, Words):
                text = space.add_text(
                    mark.text,
                    height=mark.height / page.scale,
                    rotation=mark.turn_deg,
                    dxfattribs={**look, "style": _STYLE},
                )
                (place,) = _placed(np.array([mark.at]), page).tolist()
                text.set_placement(place, align=anchors[mark.anchor])
            elif isinstance(mark, Area):
                _fill(space, mark, page, look)
            else:
                _stroke(space, mark, page, look)
    return made


def _weight(width: float) -> int:
    return int(_WEIGHTS[np.abs(_WEIGHTS - 100.0 * width).argmin()])


def _placed(points: Floats, page: Page) -> Floats:
    """Return points of the page in the object's own millimetres."""
    return np.asarray((points - np.asarray(page.origin)) / page.scale)


def _stroke(space: Any, stroke: Stroke, page: Page, look: dict[str, Any]) -> None:
    own = PENS[stroke.layer]
    if stroke.pen.width != own.width:
        look = {**look, "lineweight": _weight(stroke.pen.width)}
    if stroke.pen.colour != own.colour:
        look = {**look, "true_color": int(stroke.pen.colour[1:], 16)}
    for path in stroke.paths:
        for run in _runs(path):
            points = _placed(run, page).tolist()
            if len(run) == 2:
                space.add_line(*points, dxfattribs=look)
            else:
                _spline(space.add_spline(degree=3, dxfattribs=look), points)


def _runs(path: Path) -> list[Floats]:
    """Return lines (2, 2), and neighbouring cubics as one run of (3 n + 1, 2) Bézier points."""
    runs: list[list[Floats]] = []
    for piece in path.pieces:
        if len(piece) == 4 and runs and len(runs[-1][0]) == 4:
            runs[-1].append(piece)
        else:
            runs.append([piece])
    return [
        np.concatenate([run[0], *(piece[1:] for piece in run[1:])]) if len(run[0]) == 4 else run[0]
        for run in runs
    ]


def _spline(spline: Any, points: list[list[float]]) -> None:
    """Make a spline of Bézier curves: inner knots three times, so that each keeps its own."""
    count = (len(points) - 1) // 3
    spline.control_points = [(*point, 0.0) for point in points]
    inner = [float(k) for k in range(1, count) for _ in range(3)]
    spline.knots = [0.0] * 4 + inner + [float(count)] * 4


def _fill(space: Any, area: Area, page: Page, look: dict[str, Any]) -> None:
    hatch = space.add_hatch(dxfattribs=look)
    hatch.rgb = tuple(int(area.colour[k : k + 2], 16) for k in (1, 3, 5))
    for path in area.paths:
        corners = _placed(path.flat(), page)
        hatch.paths.add_polyline_path(corners.tolist(), is_closed=True)
