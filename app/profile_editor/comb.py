"""The curvature comb of the profile: teeth along its normals."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import Qt

from app.hand.canvas import Canvas
from sgb_core.arrays import Floats
from sgb_core.curves.comb import Comb, comb, outward_sign, typical_curvature
from sgb_core.curves.continuity import JointClass, JointReport
from sgb_core.curves.profile import Profile

COMB_TEETH = 41
COMB_PIXELS = 64.0
ROOMY = 400.0
# No tooth is longer than so many typical ones.
LONGEST = 3.0


def draw_comb(
    canvas: Canvas,
    profile: Profile,
    joints: Sequence[JointReport],
    length: float,
    before: Profile | None = None,
) -> None:
    """Draw the curvature comb: teeth along the normal, as long as the curvature is large.

    Teeth stand on the outer side of the bend, in one colour where the profile bulges out and in
    another where it is hollow. At a smooth joint that is not G2 a line shows how far it jumps.
    The comb of a profile ``before`` is a dashed line, drawn to the same scale.
    """
    found = comb(profile, COMB_TEETH)
    largest = typical_curvature(found)
    if largest == 0.0:
        return
    outward = outward_sign(profile)
    # In a small editor the comb must leave room for the curve.
    pixels = COMB_PIXELS * length * min(1.0, min(canvas.area.width, canvas.area.height) / ROOMY)
    foot, tip = _teeth(canvas, found, pixels / largest, LONGEST * pixels)
    for feet, tips, bend in zip(foot, tip, outward * found.curvature, strict=True):
        keep = np.isfinite(bend)
        _draw_teeth(canvas, feet[keep], tips[keep], bend[keep])
    for report in joints:
        sides = profile.neighbours(report.joint)
        pair = np.stack([tip[sides[0], -1], tip[sides[1], 0]])
        # At a kink the two sides point apart; there is no jump to measure by eye.
        if report.measured in (JointClass.G1, JointClass.C1) and np.isfinite(pair).all():
            canvas.polyline(pair, canvas.pen("warning", 2.0, 230, Qt.PenStyle.DotLine))
    if before is not None:
        pen = canvas.pen("compare", 1.4, 235, Qt.PenStyle.DashLine)
        for tips in _teeth(canvas, comb(before, COMB_TEETH), pixels / largest, LONGEST * pixels)[1]:
            canvas.polyline(tips[np.isfinite(tips).all(axis=1)], pen)


def _teeth(canvas: Canvas, found: Comb, scale: float, most: float) -> tuple[Floats, Floats]:
    """Return the feet and tips of the teeth, (n, K, 2), in pixels, none longer than ``most``."""
    height = np.clip(found.curvature * scale, -most, most)
    foot = canvas.transform.map(found.positions)
    # The comb stands away from the centre of curvature; the screen's y runs down.
    return foot, foot - height[..., None] * found.normals * (1.0, -1.0)


def _draw_teeth(canvas: Canvas, feet: Floats, tips: Floats, bend: Floats) -> None:
    names = np.where(bend >= 0.0, "bend_out", "bend_in")
    for a, b, name in zip(feet, tips, names, strict=True):
        canvas.line(a, b, canvas.pen(str(name), 1.0, 110))
    for k in range(len(tips) - 1):
        canvas.line(tips[k], tips[k + 1], canvas.pen(str(names[k]), 1.5, 230))
