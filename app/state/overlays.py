"""The overlays: what can be shown or hidden with the shape, each declared once.

Loads nothing, so that the command line can list them at once. What draws an overlay asks
:meth:`app.state.view_state.ViewState.shows`.
"""

from __future__ import annotations

from enum import StrEnum


class Overlay(StrEnum):
    """An overlay by its name on the command line, in the order of the menus.

    ``words`` is what people read, ``keys`` its shortcut; ``in_viewport`` tells what the viewport
    draws from what the profile editor alone does, ``at_first`` what a new window shows; ``tip``
    explains what the words do not.
    """

    words: str
    keys: str
    in_viewport: bool
    at_first: bool
    tip: str

    SURFACE = "surface", "Surface", "Alt+1", True, True
    GENERATRIX = "generatrix", "Generatrix", "Alt+2", True, True
    POLYGON = "polygon", "Control polygon", "Alt+3", True, True
    CIRCLES = "circles", "Circles of P1 ✱ and P2 ○", "Alt+4", True, True
    ENDS = (
        "ends",
        "Circles of P0 and P3",
        "Ctrl+Alt+Shift+4",
        True,
        False,
        "The circles that the ends of each segment sweep: whatever the sliders say, the surface "
        "goes through them (the boundary interpolation property)",
    )
    MESH = "mesh", "Mesh lines", "Alt+5", True, False
    RATIONAL_MESH = (
        "mesh-t",
        "Mesh lines at equal steps of t",
        "Ctrl+Alt+Shift+5",
        True,
        False,
        "Meridians at equal steps of the paper's rational parameter t, (24): over a half turn "
        "cos θ = (1 − 2t)/(2t² − 2t + 1). At the quarter turn the angle grows twice as fast as in "
        "the profile's plane: the same surface, other points",
    )
    INTERPOLATED = (
        "interpolated",
        "Interpolated curves A0, A½, A1",
        "Ctrl+Alt+Shift+2",
        True,
        False,
        "The profile in its plane (A0), after a quarter turn (A½) and a half turn (A1), (17): the "
        "continued fraction (10) through these three is the whole half turn (24)",
    )
    AXES = "axes", "Rotation axis", "Alt+6", True, False
    QUARTIC = "quartic", "Quartic points Q", "Alt+7", True, True
    GHOST = "ghost", "Mirrored silhouette", "Alt+8", False, True
    COMB = "comb", "Curvature comb", "Alt+9", False, False
    SLUMP = (
        "slump",
        "Slump line",
        "Ctrl+Alt+P",
        False,
        False,
        "Beside the heights and along the curve of the profile editor: what the printer chosen "
        "under Print path can build, where a turn leans too far beside the one below, and where "
        "it has nothing to rest on",
    )
    PRINT = (
        "print",
        "Print path on its bed",
        "Ctrl+Alt+G",
        True,
        False,
        "In the surface's place, while it rests: the path of the printer chosen, coloured by lean, "
        "layer time, speed or flow, up to any moment, on the printer's bed",
    )
    LIQUID = "liquid", "Liquid up to the fill line", "Alt+0", True, True

    def __new__(
        cls, name: str, words: str, keys: str, in_viewport: bool, at_first: bool, tip: str = ""
    ) -> Overlay:
        """Make a member whose value is its name."""
        member = str.__new__(cls, name)
        member._value_ = name
        member.words, member.keys = words, keys
        member.in_viewport, member.at_first, member.tip = in_viewport, at_first, tip
        return member


SHOWN_AT_FIRST = frozenset(overlay for overlay in Overlay if overlay.at_first)
