"""Guides under the hand: where they lie, and which one is meant."""

from __future__ import annotations

from collections.abc import Sequence

from app.hand.coordinates import Area, Paper, ScreenPoint
from sgb_core.document.guides import Guide, GuideAt

GUIDE_REACH = 4.0


def guide_lines(guides: Sequence[Guide]) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return the radii of upright guides and the heights of level ones."""
    radii, heights = (
        tuple(each.value for each in guides if each.at is at)
        for at in (GuideAt.RADIUS, GuideAt.HEIGHT)
    )
    return radii, heights


def pick_guide(guides: Sequence[Guide], paper: Paper, at: ScreenPoint) -> int | None:
    """Return the number of the guide that a press at ``at`` would grab."""
    under = paper.to_design(at).pair
    apart = [abs(under[each.at.coordinate] - each.value) * paper.scale for each in guides]
    nearest = min(range(len(apart)), key=apart.__getitem__, default=None)
    return nearest if nearest is not None and apart[nearest] <= GUIDE_REACH else None


def ruler_at(area: Area, at: ScreenPoint) -> GuideAt | None:
    """Return which guide is pulled from the ruler under a place: parallel to the ruler."""
    if at.x < area.left and at.y <= area.bottom:
        return GuideAt.RADIUS
    if at.y > area.bottom and at.x >= area.left:
        return GuideAt.HEIGHT
    return None
