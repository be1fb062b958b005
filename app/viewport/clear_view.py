"""From where to see all of an object with none of it under what floats over the picture."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRect
from PySide6.QtWidgets import QWidget

from app.scene.camera import Part, Pose

# So far from it, in pixels, a point is free to be grabbed.
CLEAR = 4


def clear_pose(pose: Pose, points: NDArray[np.float64], *over: QWidget) -> Pose:
    """Return the pose moved to see all ``points`` (P, 3), the nearest that hides none of them.

    ``over`` are what floats in the upper right corner of the widget that shows the picture. Left
    of it or below it the picture may be left free; more than half of it is not.
    """
    picture = over[0].parentWidget()
    assert picture is not None
    width, height = max(1, picture.width()), max(1, picture.height())
    aspect = width / height
    whole = pose.fitted(points, aspect)
    boxes = [each.geometry().adjusted(-CLEAR, -CLEAR, CLEAR, CLEAR) for each in over]
    if not _hides(whole, points, height, width, boxes):
        return whole
    sides = {1.0, *(2.0 * box.left() / width - 1.0 for box in boxes)}
    tops = {1.0, *(1.0 - 2.0 * (box.bottom() + 1) / height for box in boxes)}
    parts = [Part(right=right, top=top) for right, top in product(sides, tops)]
    fits = [pose.fitted(points, aspect, each) for each in parts if min(each.right, each.top) > 0.0]
    clear = [each for each in fits if not _hides(each, points, height, width, boxes)]
    return min(clear, key=lambda each: each.distance, default=whole)


def _hides(
    pose: Pose, points: NDArray[np.float64], height: int, width: int, boxes: Sequence[QRect]
) -> bool:
    x, y = pose.places(points).T * (height / 2.0)
    x, y = width / 2.0 + x, height / 2.0 - y
    return any(
        bool(((x > box.left()) & (x <= box.right()) & (y > box.top()) & (y <= box.bottom())).any())
        for box in boxes
    )
