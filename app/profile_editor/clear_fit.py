"""The largest fit in which no point lies under what lies over the paper."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product

from PySide6.QtCore import QRectF

from app.hand.coordinates import Area, Transform
from sgb_core.arrays import Floats
from sgb_core.values import dataclass

# So far from it, in pixels, a point is free to be grabbed.
CLEAR = 4.0


@dataclass(frozen=True, slots=True)
class Cut:
    """Strips of the paper that a fit leaves free, in pixels."""

    left: float = 0.0
    right: float = 0.0
    top: float = 0.0

    def within(self, area: Area) -> Area:
        """Return what is left of an area."""
        return Area(
            area.left + self.left, area.top + self.top, area.right - self.right, area.bottom
        )

    def joined(self, other: Cut) -> Cut:
        """Return the cut that leaves free what either does."""
        return Cut(
            max(self.left, other.left), max(self.right, other.right), max(self.top, other.top)
        )


def clear_fit(
    fitted: Callable[[Cut], Transform], points: Floats, over: Sequence[QRectF], area: Area
) -> Transform:
    """Return the largest of the fits that hide none of ``points``, shape (n, 2).

    Beside or below each rectangle ``over`` the paper may be left free. Where a point is hidden
    in all of them it is the fit into the whole paper.
    """
    whole = fitted(Cut())
    if not _hides(whole, points, over):
        return whole
    choices = []
    for box in over:
        left, right = box.right() - area.left, area.right - box.left()
        beside = Cut(left=left) if left < right else Cut(right=right)
        choices.append((Cut(), beside, Cut(top=box.bottom() - area.top)))
    fits = []
    for cuts in product(*choices):
        cut = Cut()
        for each in cuts:
            cut = cut.joined(each)
        fits.append(fitted(cut))
    clear = [fit for fit in fits if not _hides(fit, points, over)]
    return max(clear, key=lambda fit: fit.scale, default=whole)


def _hides(transform: Transform, points: Floats, over: Sequence[QRectF]) -> bool:
    places = transform.map(points)
    for box in over:
        low = (box.left() - CLEAR, box.top() - CLEAR)
        high = (box.right() + CLEAR, box.bottom() + CLEAR)
        if ((places > low) & (places < high)).all(axis=1).any():
            return True
    return False
