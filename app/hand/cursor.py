"""The pointer's shape in the profile editor: it tells what a press would do."""

from __future__ import annotations

import math

from PySide6.QtCore import Qt

from app.hand.drag import State, leg_ends
from app.hand.hit_test import Handle, Target
from app.hand.scale_frame import SIDES
from sgb_core.curves.profile import Profile

_ALONG = (
    Qt.CursorShape.SizeHorCursor,
    Qt.CursorShape.SizeBDiagCursor,
    Qt.CursorShape.SizeVerCursor,
    Qt.CursorShape.SizeFDiagCursor,
)


def cursor_for(
    profile: Profile, state: State, active: Handle | None, pan_ready: bool
) -> Qt.CursorShape:
    """Return the shape for a state and the handle under the pointer."""
    if state is State.PANNING:
        return Qt.CursorShape.ClosedHandCursor
    if state is State.BOXING:
        return Qt.CursorShape.CrossCursor
    if pan_ready and state is State.IDLE:
        return Qt.CursorShape.OpenHandCursor
    if active is None or active.segment >= len(profile):
        return Qt.CursorShape.ArrowCursor
    if active.target is Target.LEVEL:
        return Qt.CursorShape.SizeVerCursor
    if active.target is Target.DIMENSION:
        return Qt.CursorShape.PointingHandCursor
    if active.feature is not None:
        return along_cursor(active.feature.angle)
    if active.target is Target.GRIP:
        across, up = SIDES[active.index]
        return along_cursor(math.degrees(math.atan2(up, across)))
    if active.target is Target.CURVE:
        return Qt.CursorShape.PointingHandCursor
    if active.target is Target.QUARTIC:
        near, far = leg_ends(profile.segments[active.segment], active.index)
        angle = math.degrees(math.atan2(far.h - near.h, far.r - near.r))
        return along_cursor(angle)
    return Qt.CursorShape.SizeAllCursor


def along_cursor(angle: float) -> Qt.CursorShape:
    """Return the arrows that point along a direction, in degrees from the right upwards."""
    return _ALONG[round(angle / 45.0) % 4]
