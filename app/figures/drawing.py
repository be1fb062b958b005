"""Draws a plate: the shaded surfaces as pictures inside curves, marks and text that stay vector."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from app.figures.layout import INCH, LINE, NUMBERS, Box, Layout, caption_lines, lay_out
from app.figures.lines import SpaceLine, space_lines, surface_cloud
from app.figures.plate import GREY, Array, Curve, CurvePanel, Panel, Plate, SurfacePanel
from app.figures.projection import farthest_about, hidden, natural_aspect, project, runs
from app.scene.actors import rgb
from app.scene.camera import Pose
from app.scene.raster import Raster, surface_raster
from app.theme.palette import LIGHT
from sgb_core.document.body_state import body_state
from sgb_core.document.evaluation import evaluate

# Of a line behind the surface: what is left of its colour.
BEHIND = 0.28
MARKERS = {"*": (6, 2, 0), "o": "o", ".": "o"}
MARK_SIZES = {"*": 3.4, "o": 2.6, ".": 1.9}

Progress = Callable[[float], None]


def with_bodies(plate: Plate, *, fine: bool, progress: Progress = lambda _: None) -> Plate:
    """Return a plate whose panels have the bodies of their documents; nothing is drawn yet."""
    panels: list[Panel] = []
    for number, panel in enumerate(plate.panels):
        if isinstance(panel, SurfacePanel):
            document = panel.document
            body = body_state(document, document.surface, fine=fine, measured=False)
            panel = replace(panel, body=body)
        panels.append(panel)
        progress((number + 1) / len(plate.panels))
    return replace(plate, panels=tuple(panels))


def panel_poses(plate: Plate, layout: Layout) -> list[Pose]:
    """Return from where each surface panel is seen: all from one place, unless scales differ."""
    clouds = [_cloud(panel) for panel in plate.panels if isinstance(panel, SurfacePanel)]
    if plate.common_scale and clouds:
        return [plate.pose.fitted(np.concatenate(clouds), layout.aspect)] * len(clouds)
    return [plate.pose.fitted(cloud, layout.aspect) for cloud in clouds]


def plate_layout(plate: Plate) -> Layout:
    """Return where everything stands."""
    if isinstance(plate.panels[0], CurvePanel):
        boxes = np.array([_extent(p) for p in plate.panels if isinstance(p, CurvePanel)])
        extent = boxes[:, 1].max(axis=0) - boxes[:, 0].min(axis=0)
        return lay_out(plate, float(np.clip(extent[0] / max(extent[1], 1e-9), 0.6, 1.8)))
    panels = [p for p in plate.panels if isinstance(p, SurfacePanel)]
    return lay_out(plate, natural_aspect(plate.pose, [_cloud(p) for p in panels]))


def panel_raster(panel: SurfacePanel, pose: Pose, box: Box, *, fine: bool = True) -> Raster:
    """Draw the surface of one panel; only where VTK may draw, in the window its own thread."""
    palette = replace(LIGHT, surface=panel.tint)
    paint = (lambda section: _colours(panel, section)) if panel.bands or panel.stripes else None
    size = (box.width, box.height)
    evaluation = evaluate(panel.document)
    return surface_raster(evaluation, pose, size, palette, paint, body=panel.body, fine=fine)


def draw(plate: Plate, progress: Progress = lambda _: None, *, fine: bool = True) -> Figure:
    """Return the whole plate as a figure, bodies and rasters included."""
    plate = with_bodies(plate, fine=True, progress=lambda part: progress(0.3 * part))
    layout = plate_layout(plate)
    rasters = []
    poses = iter(panel_poses(plate, layout))
    for number, (panel, box) in enumerate(zip(plate.panels, layout.panels, strict=True)):
        if isinstance(panel, SurfacePanel):
            rasters.append(panel_raster(panel, next(poses), box, fine=fine))
        progress(0.3 + 0.5 * (number + 1) / len(plate.panels))
    drawn = compose(plate, layout, rasters)
    progress(1.0)
    return drawn


def compose(plate: Plate, layout: Layout, rasters: list[Raster]) -> Figure:
    """Put rasters, one for each surface panel, lines and text together."""
    poses = iter(panel_poses(plate, layout))
    figure = Figure(figsize=(layout.width / plate.dpi, layout.height / plate.dpi), dpi=plate.dpi)
    figure.patch.set_facecolor("white")
    waiting = iter(rasters)
    for panel, box in zip(plate.panels, layout.panels, strict=True):
        axes = figure.add_axes(
            (
                box.left / layout.width,
                box.bottom / layout.height,
                box.width / layout.width,
                box.height / layout.height,
            )
        )
        if isinstance(panel, CurvePanel):
            _draw_curves(axes, panel, layout)
        else:
            _draw_surface(axes, panel, next(poses), next(waiting), layout)
        numbers = NUMBERS if isinstance(panel, CurvePanel) else 0.0
        _write_caption(figure, panel, box, layout, plate.dpi, numbers)
    if plate.title:
        top = 1.0 - 4.0 / INCH * plate.dpi / layout.height
        figure.text(0.5, top, plate.title, ha="center", va="center", size=1.25 * layout.type_size)
    return figure


def _draw_surface(
    axes: Axes, panel: SurfacePanel, pose: Pose, raster: Raster, layout: Layout
) -> None:
    aspect = layout.aspect
    axes.set_xlim(-aspect, aspect)
    axes.set_ylim(-1.0, 1.0)
    axes.axis("off")
    axes.imshow(
        raster.image,
        extent=(-aspect, aspect, -1.0, 1.0),
        aspect="auto",
        interpolation="none",
        zorder=1,
    )
    size = float(np.linalg.norm(np.ptp(_cloud(panel), axis=0)))
    farthest = farthest_about(raster.depth)
    for line in space_lines(panel):
        seen, depth = project(pose, line.points)
        behind = hidden(farthest, seen, depth, aspect, size)
        if line.kind == "outline":
            # A target is compared with what is drawn, so it is never behind it.
            behind[:] = False
        if line.mark:
            for flag in (True, False):
                _draw_marks(axes, line, seen[behind == flag], flag)
            continue
        for first, last, flag in runs(behind):
            _draw_line(axes, line, seen[first : last + 1], flag)


def _draw_line(axes: Axes, line: SpaceLine, points: Array, behind: bool) -> None:
    (artist,) = axes.plot(
        points[:, 0],
        points[:, 1],
        color=_paler(line.colour) if behind else line.colour,
        lw=line.width * (0.75 if behind else 1.0),
        solid_capstyle="butt" if behind else "round",
        zorder=2 + line.layer + (0 if behind else 10),
        clip_on=False,
    )
    artist.set_gid(f"{line.kind}-hidden" if behind else line.kind)
    if line.dashes:
        artist.set_dashes(line.dashes)


def _draw_marks(axes: Axes, line: SpaceLine, points: Array, behind: bool) -> None:
    if len(points) == 0:
        return
    mark = line.mark
    colour = _paler(line.colour) if behind else line.colour
    # Single points, such as P1 itself, are larger than the marks along a circle.
    (artist,) = axes.plot(
        points[:, 0],
        points[:, 1],
        ls="none",
        marker=MARKERS[mark],
        ms=MARK_SIZES[mark] * (1.7 if line.kind == "polygon" and mark != "." else 1.0),
        mec=colour,
        mew=0.9 if line.kind == "polygon" else 0.55,
        mfc=colour if mark == "." else "none",
        zorder=2 + line.layer + (0 if behind else 10),
        clip_on=False,
    )
    artist.set_gid(f"{line.kind}-marks-hidden" if behind else f"{line.kind}-marks")


def _draw_curves(axes: Axes, panel: CurvePanel, layout: Layout) -> None:
    size = layout.type_size
    low, high = _extent(panel)
    room = 0.07 * float((high - low).max())
    spans = high - low + 2 * room
    # Equal scales in a box of the given shape: the shorter direction gets more room.
    wide = max(spans[0], spans[1] * layout.aspect)
    middle = (low + high) / 2.0
    axes.set_xlim(middle[0] - wide / 2, middle[0] + wide / 2)
    axes.set_ylim(middle[1] - wide / layout.aspect / 2, middle[1] + wide / layout.aspect / 2)
    axes.tick_params(labelsize=0.85 * size, length=2.0, width=0.5, pad=1.5, direction="in")
    axes.locator_params(nbins=5)
    for side, spine in axes.spines.items():
        spine.set_linewidth(0.5)
        spine.set_visible(side in ("left", "bottom"))
    axes.set_xlabel(f"${panel.axes[0]}$", size=size, labelpad=1.0)
    up = f"${panel.axes[1]}$"
    axes.text(0.02, 0.99, up, transform=axes.transAxes, size=size, ha="left", va="top")
    for curve in panel.curves:
        _draw_curve(axes, curve)
    if any(curve.name for curve in panel.curves):
        axes.legend(
            fontsize=0.85 * size,
            frameon=False,
            loc=panel.legend,
            handlelength=1.8,
            borderaxespad=0.3,
        )


def _extent(panel: CurvePanel) -> tuple[Array, Array]:
    """Return the corners of what a flat panel holds, with room for names to the right."""
    points = np.concatenate([curve.points for curve in panel.curves])
    low, high = points.min(axis=0), points.max(axis=0)
    if panel.legend == "lower right":
        high[0] += 0.2 * (high[0] - low[0])
    return low, high


def _draw_curve(axes: Axes, curve: Curve) -> None:
    (line,) = axes.plot(
        curve.points[:, 0],
        curve.points[:, 1],
        color=curve.colour,
        lw=curve.width if not curve.mark else 0.0,
        marker=MARKERS[curve.mark] if curve.mark else "",
        ms=1.5 * MARK_SIZES[curve.mark] if curve.mark else 0.0,
        mfc=curve.colour if curve.mark == "." else "none",
        mew=0.8,
        label=curve.name or "_",
        clip_on=False,
    )
    if curve.dashes:
        line.set_dashes(curve.dashes)


def _write_caption(
    figure: Figure, panel: Panel, box: Box, layout: Layout, dpi: int, numbers: float
) -> None:
    """Write the lines below a panel, each smaller where it would run into its neighbour's."""
    for number, (text, is_remark) in enumerate(caption_lines(panel)):
        y = box.bottom - (numbers + 1.0 + LINE * (number + 0.5)) / INCH * dpi
        size = layout.type_size * (0.9 if is_remark else 1.0)
        artist = figure.text(
            (box.left + box.width / 2) / layout.width,
            y / layout.height,
            text,
            ha="center",
            va="center",
            size=size,
            color=GREY if is_remark else "black",
        )
        width = artist.get_window_extent().width
        if width > 0.92 * layout.pitch:
            artist.set_fontsize(size * 0.92 * layout.pitch / width)


def _cloud(panel: SurfacePanel) -> Array:
    surface = panel.document.surface
    lines = [line.points for line in space_lines(panel)]
    mesh = None if panel.body is None else panel.body.mesh
    shape = surface_cloud(surface) if mesh is None else mesh.positions
    return np.concatenate([shape, *lines])


def _colours(panel: SurfacePanel, section: Array) -> Array:
    if panel.stripes:
        chosen = [rgb(panel.stripes[k % len(panel.stripes)]) for k in range(len(section))]
        return np.broadcast_to(np.array(chosen)[:, None], (*section.shape[:2], 3))
    at = [height for height, _ in panel.bands]
    colours = np.array([rgb(colour) for _, colour in panel.bands])
    heights = section[..., 1]
    return np.stack([np.interp(heights, at, channel) for channel in colours.T], axis=-1)


def _paler(colour: str) -> tuple[float, float, float]:
    red, green, blue = (1.0 - BEHIND * 1.6 * (1.0 - channel) for channel in rgb(colour))
    return red, green, blue
