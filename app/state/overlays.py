"""The overlays: what can be shown or hidden with the shape, each declared once.

Loads nothing, so that the command line can list them at once. What draws an overlay asks
:meth:`app.state.view_state.ViewState.shows`.
"""

from __future__ import annotations

from enum import StrEnum


class Overlay(StrEnum):
    """An overlay by its name on the command line, in the order of the menus.

    ``words`` is what people read, ``keys`` its shortcut; ``in_viewport`` tells what the viewport
    draws from what the profile editor alone does, ``at_first`` what a new window shows.
    """

    words: str
    keys: str
    in_viewport: bool
    at_first: bool

    SURFACE = "surface", "Surface", "Alt+1", True, True
    GENERATRIX = "generatrix", "Generatrix", "Alt+2", True, True
    POLYGON = "polygon", "Control polygon", "Alt+3", True, True
    CIRCLES = "circles", "Circles of P1 ✱ and P2 ○", "Alt+4", True, True
    MESH = "mesh", "Mesh lines", "Alt+5", True, False
    AXES = "axes", "Rotation axis", "Alt+6", True, False
    QUARTIC = "quartic", "Quartic points Q", "Alt+7", True, True
    GHOST = "ghost", "Mirrored silhouette", "Alt+8", False, True
    COMB = "comb", "Curvature comb", "Alt+9", False, False
    LIQUID = "liquid", "Liquid up to the fill line", "Alt+0", True, True

    def __new__(
        cls, name: str, words: str, keys: str, in_viewport: bool, at_first: bool
    ) -> Overlay:
        """Make a member whose value is its name."""
        member = str.__new__(cls, name)
        member._value_ = name
        member.words, member.keys = words, keys
        member.in_viewport, member.at_first = in_viewport, at_first
        return member


SHOWN_AT_FIRST = frozenset(overlay for overlay in Overlay if overlay.at_first)
