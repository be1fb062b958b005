"""Points in the hand as an edit of the document, and what follows them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from app.hand.coordinates import DesignPoint
from app.hand.drag import Gesture
from app.hand.hit_test import PointId
from app.hand.readout import point_name
from app.state import preferences
from app.state.view_state import ViewState
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.model import Document

if TYPE_CHECKING:
    from sgb_core.document.session import Refining


def move_label(profile: Profile, points: tuple[PointId, ...]) -> str:
    """Return the undo entry's name for moving points."""
    if len(points) == 1:
        return f"Move {point_name(profile, points[0])}"
    return f"Move {len(points)} points"


def move_edit(
    gesture: Gesture, start: DesignPoint, end: DesignPoint, *, keep_rules: bool
) -> Callable[[Document], Document]:
    """Return the edit that moves a gesture's points as one of them goes from start to end."""
    stops = not preferences.current().cross_axis
    if len(gesture.points) != 1:
        step = (end.r - start.r, end.h - start.h)
        return lambda d: edits.move_points(
            d, gesture.points, step, keep_rules=keep_rules, stop_at_axis=stops
        )
    segment, index = gesture.points[0]
    if gesture.handle is not None:
        segment, index = gesture.handle.segment, gesture.handle.index
    return lambda d: edits.move_point(
        d,
        segment,
        index,
        end.pair,
        keep_rules=keep_rules,
        scale_legs=gesture.scales,
        stop_at_axis=stops,
    )


def live_fair(view: ViewState, profile: Profile, points: tuple[PointId, ...]) -> Refining | None:
    """Return what keeps the segments beside points fair while they move, None where none is on."""
    if view.live_fair is None:
        return None
    # Imported when it is wanted: the window starts without.
    from sgb_core.design.fairing.energy import Energy
    from sgb_core.document.live_fair import LiveFair, beside

    return LiveFair(beside(profile, points), Energy(view.live_fair))
