"""Smooth changes of the view: from one pose to another in a fifth of a second."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import exp, log, pi

import numpy as np
from PySide6.QtCore import QEasingCurve, QObject, QVariantAnimation
from PySide6.QtWidgets import QApplication, QStyle

from app.scene.camera import Pose
from app.state import preferences

MILLISECONDS = 200
# A smaller part of the view angle cannot be told from a parallel projection.
_FLAT = 0.02


def wanted() -> bool:
    """Whether views change smoothly: the preference, and the system's wish for less motion."""
    style = QApplication.style()
    still = style.styleHint(QStyle.StyleHint.SH_Widget_Animation_Duration) == 0
    return not still and preferences.current().animate_views


def between(first: Pose, second: Pose, part: float) -> Pose:
    """Return the pose at a part, 0 to 1, of the way; the turn is about the pivot.

    The shorter way around; distances grow by equal factors. A change of projection narrows or
    widens the view angle while what lies at the focal point keeps its size.
    """
    if part >= 1.0:
        return second
    offsets = [
        pose.basis @ (np.asarray(pose.focal) - np.asarray(pose.pivot)) for pose in (first, second)
    ]
    around = (second.azimuth - first.azimuth + pi) % (2.0 * pi) - pi
    pivot = np.asarray(first.pivot) * (1.0 - part) + np.asarray(second.pivot) * part
    pose = replace(
        second,
        azimuth=first.azimuth + part * around,
        elevation=first.elevation + part * (second.elevation - first.elevation),
        distance=exp((1.0 - part) * log(first.distance) + part * log(second.distance)),
        pivot=(float(pivot[0]), float(pivot[1]), float(pivot[2])),
    )
    if first.parallel != second.parallel:
        opening = 1.0 - part if second.parallel else part
        pose = replace(pose, parallel=False, opening=max(_FLAT, opening))
    focal = pivot + ((1.0 - part) * offsets[0] + part * offsets[1]) @ pose.basis
    return replace(pose, focal=(float(focal[0]), float(focal[1]), float(focal[2])))


class Glide(QObject):
    """Shows poses on the way, one per picture, until the goal or until it is stopped."""

    def __init__(self, parent: QObject, show: Callable[[Pose], object]) -> None:
        super().__init__(parent)
        self._show = show
        self._ends: tuple[Pose, Pose] | None = None
        self._animation = QVariantAnimation(self)
        self._animation.setStartValue(0.0)
        self._animation.setEndValue(1.0)
        self._animation.setDuration(MILLISECONDS)
        self._animation.setEasingCurve(QEasingCurve.Type.OutCubic)
        self._animation.valueChanged.connect(self._step)

    @property
    def active(self) -> bool:
        """Whether the view is on its way."""
        return self._ends is not None

    def start(self, first: Pose, goal: Pose) -> None:
        """Begin at ``first``; a glide under way is given up."""
        self.stop()
        self._ends = first, goal
        self._animation.start()

    def stop(self) -> None:
        """Stop where it is."""
        self._ends = None
        self._animation.stop()

    def _step(self, part: float) -> None:
        if self._ends is None:
            return
        first, goal = self._ends
        if part >= 1.0:
            self._ends = None
        self._show(between(first, goal, float(part)))
