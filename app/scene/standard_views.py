"""The standard views and the largest picture, each declared once. Loads nothing.

So the command line can list them at once.

Azimuth counts from the half-plane θ = 0 towards growing θ; elevation from the horizontal. The
object stands upright whatever its axis: height is up in the picture. "front" looks with θ = 0 to
the right, as the profile editor shows it, so for axis z it looks along +y.
"""

from __future__ import annotations

from math import pi, radians

from sgb_core.values import dataclass

# Beyond this many pixels a side of a picture drivers refuse the memory.
LARGEST_PICTURE = 8192


@dataclass(frozen=True, slots=True)
class StandardView:
    """A direction to look from, in radians, and how menus and the command line offer it.

    ``key`` shows it while the viewport has the keyboard, with Ctrl the ``opposite`` one.
    """

    name: str
    words: str
    keys: str
    icon: str
    azimuth: float
    elevation: float
    key: str = ""
    opposite: str = ""

    @property
    def direction(self) -> tuple[float, float]:
        """Azimuth and elevation."""
        return self.azimuth, self.elevation

    @property
    def is_straight(self) -> bool:
        """Whether it looks along an axis, at one side of the object alone."""
        return all(angle % (pi / 2) == 0.0 for angle in self.direction)


STANDARD_VIEWS = {
    view.name: view
    for view in (
        StandardView(
            "iso", "Three-quarter", "Ctrl+Alt+0", "view-iso", radians(-58.0), radians(21.0)
        ),
        StandardView("front", "Front", "Ctrl+Alt+1", "view-front", -pi / 2, 0.0, "1", "back"),
        StandardView("back", "Back", "Ctrl+Alt+2", "view-front", pi / 2, 0.0),
        StandardView("right", "Right", "Ctrl+Alt+3", "view-side", 0.0, 0.0, "3", "left"),
        StandardView("left", "Left", "Ctrl+Alt+4", "view-side", pi, 0.0),
        StandardView("top", "Top", "Ctrl+Alt+7", "view-top", -pi / 2, pi / 2, "7", "bottom"),
        StandardView("bottom", "Bottom", "Ctrl+Alt+8", "view-top", -pi / 2, -pi / 2),
    )
}
# The keys that show a view while the viewport has the keyboard.
KEYED_VIEWS = ", ".join(view.key for view in STANDARD_VIEWS.values() if view.key)
