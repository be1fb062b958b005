"""An end of a segment that laws stretch by the height, as joints are measured."""

from __future__ import annotations

from math import hypot, isfinite

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.continuity import EndView, Vector
from sgb_core.curves.many_joints import ManyEnds
from sgb_core.surfaces.sections import Stretch
from sgb_core.values import dataclass

# Where a key lies at the end itself, what bends there is that of the side on which the curve lies.
_ASIDE = 1e-12


@dataclass(frozen=True, slots=True)
class StretchedEnd(EndView):
    """An end seen through (r, h) → (F(h) r, h): ``jet`` are F, F' and F'' at its radius ``r``."""

    r: float
    jet: tuple[float, float, float]

    @classmethod
    def of(cls, view: EndView, stretch: Stretch, size: float) -> StretchedEnd:
        """Return an end of a curve as the stretch of its segment at one angle, (m,), shows it."""
        r, h = view.at
        step = view.tangent(size)
        aside = 0.0 if step is None else float(np.copysign(_ASIDE * size, step[1]))
        series = [np.array(h + aside), np.array(1.0), np.array(0.0)]
        factor, slope, half = (float(each) for each in stretch.factor(series))
        return cls(
            (factor * r, h),
            view.legs,
            view.fraction,
            view.weight,
            view.far_fraction,
            r,
            (factor, slope, 2.0 * half),
        )

    def _mapped(self, step: Vector) -> Vector:
        factor, slope, _ = self.jet
        return factor * step[0] + self.r * slope * step[1], step[1]

    def derivative(self) -> Vector:
        """Return the derivative at this end, walking away from it."""
        return self._mapped(EndView.derivative(self))

    def tangent(self, size: float) -> Vector | None:
        """Return the true tangent's direction, or None for a single point."""
        step = EndView.tangent(self, size)
        return None if step is None else self._mapped(step)

    def curvature(self) -> float:
        """Return the signed curvature: of κ along T, κ N and the second derivative of the map."""
        plain = EndView.curvature(self)
        x, y = EndView.derivative(self)
        length = hypot(x, y)
        if not isfinite(plain) or length == 0.0:
            return plain
        x, y = x / length, y / length
        _, slope, bend = self.jet
        ahead, aside = self._mapped((x, y)), self._mapped((-plain * y, plain * x))
        push = aside[0] + self.r * bend * y * y + 2.0 * slope * x * y
        return (ahead[0] * aside[1] - ahead[1] * push) / hypot(*ahead) ** 3


def stretched_ends(ends: ManyEnds, stretch: Stretch, size: float) -> ManyEnds:
    """Return many ends, (...), as the stretch of each, (..., m), shows them.

    To first order the map is linear, which takes legs to legs; its second derivative bends.
    """
    shape = np.broadcast_shapes(stretch.departures.shape[:-1], np.shape(ends.fraction))
    tangents = ends.tangent(size)
    way = np.sign(np.nan_to_num(tangents[..., 1]))
    r = np.broadcast_to(ends.at[..., 0], shape)
    h = np.broadcast_to(ends.at[..., 1], shape) + _ASIDE * size * way
    factor, slope, half = stretch.factor([h, np.ones(shape), np.zeros(shape)])

    def mapped(steps: Floats) -> Floats:
        ahead = factor * steps[..., 0] + r * slope * steps[..., 1]
        return np.stack([ahead, np.broadcast_to(steps[..., 1], ahead.shape)], axis=-1)

    at = np.stack([factor * r, np.broadcast_to(ends.at[..., 1], shape)], axis=-1)
    along, (x, y) = mapped(tangents), np.moveaxis(tangents, -1, 0)
    push = r * 2.0 * half * y * y + 2.0 * slope * x * y
    bend = -along[..., 1] * push / np.hypot(along[..., 0], along[..., 1]) ** 3
    return ManyEnds(at, mapped(ends.legs), ends.fraction, ends.weight, ends.far_fraction, bend)
