"""Sections of a surface at some angles: quartics, and what laws that change with the height add.

Where the strength of laws of the radius changes along the height, a section is the image of a
quartic under (r, h) → (F(h) r, h), F = Π (1 + k(h)·(v − 1)): v a law's value at the angle, k its
strength. F is positive and C1, so that tangents, limits where a derivative vanishes, and
side of the axis are those of the quartic, mapped.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import comb, factorial
from typing import Any, TypeAlias

import numpy as np

from sgb_core.arrays import Floats, Ints, distinct
from sgb_core.curves.nodes import at_each, gauss, on_nodes, panels
from sgb_core.curves.roots import real_roots
from sgb_core.surfaces.laws.strength import Strength
from sgb_core.surfaces.normals import (
    STILL,
    end_tangents,
    radius_signs,
    surface_normals,
    tangents_at,
    unit_tangents,
)
from sgb_core.values import dataclass

# Taylor coefficients, lowest first.
Series: TypeAlias = Sequence[Floats]
# Heights of keys that a curve touches within this part of its reach are met.
_NO_PANEL = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Stretch:
    """What multiplies the radius of curves by their height: m strengths, and how far they act.

    ``departures`` (..., m) are v − 1 of each curve and law, ``drifts`` their ∂/∂θ.
    """

    strengths: tuple[Strength, ...]
    departures: Floats
    drifts: Floats

    def __getitem__(self, index: Any) -> Stretch:
        return Stretch(self.strengths, self.departures[index], self.drifts[index])

    @property
    def widest(self) -> float:
        """A bound of F, of all curves at any height."""
        found = 1.0
        for k, strength in enumerate(self.strengths):
            along, away = strength.cubics[:, 0], self.departures[..., k]
            products = (along.min() * away, along.max() * away)
            found *= max(1.0, *(1.0 + float(each.max()) for each in products))
        return found

    def factor(self, h: Series) -> list[Floats]:
        """Return the series of F where that of the height is ``h``, as long as that."""
        found: list[Floats] = []
        for strength, away in zip(self.strengths, self._spread(self.departures, h[0]), strict=True):
            along = _composed(strength.jet(h[0], len(h) - 1), h)
            one = [1.0 + away * along[0], *(away * each for each in along[1:])]
            found = _times(found, one) if found else one
        return found

    def turning(self, h: Floats) -> Floats:
        """Return ∂F/∂θ at heights."""
        value, rate = np.ones(()), np.zeros(())
        aways, drifts = self._spread(self.departures, h), self._spread(self.drifts, h)
        for strength, away, drift in zip(self.strengths, aways, drifts, strict=True):
            (along,) = strength.jet(h)
            factor = 1.0 + away * along
            value, rate = value * factor, rate * factor + value * drift * along
        return np.asarray(rate)

    def _spread(self, parts: Floats, h: Floats) -> list[Floats]:
        """Return the parts of each law so that they are broadcast against heights."""
        wide = (..., *(None,) * (h.ndim - parts.ndim + 1))
        return [parts[..., k][wide] for k in range(parts.shape[-1])]

    def mapped(self, points: Floats, vectors: Floats) -> Floats:
        """Return tangent vectors (..., 2) at points (..., 2) of the quartic, mapped."""
        one = np.ones_like(points[..., 1])
        factor, slope = self.factor([points[..., 1], one])
        r = factor * vectors[..., 0] + points[..., 0] * slope * vectors[..., 1]
        return np.stack([r, vectors[..., 1]], axis=-1)

    def of(self, points: Floats) -> Floats:
        """Return points (..., 2), mapped."""
        (factor,) = self.factor([points[..., 1]])
        return np.stack([factor * points[..., 0], points[..., 1]], axis=-1)

    def derivative(self, jet: Sequence[Floats]) -> Floats:
        """Return the last of the derivatives of a curve, 0 to the last (..., 2), mapped."""
        r, h = ([each[..., axis] / factorial(k) for k, each in enumerate(jet)] for axis in range(2))
        order = len(jet) - 1
        return np.stack(
            [factorial(order) * _times(r, self.factor(h))[order], jet[-1][..., 1]], axis=-1
        )


def _times(first: Series, second: Series) -> list[Floats]:
    return [
        np.asarray(sum(first[i] * second[n - i] for i in range(n + 1))) for n in range(len(first))
    ]


def _composed(jet: Sequence[Floats], h: Series) -> list[Floats]:
    """Return the series of a function of the height, known by its derivatives there."""
    step: list[Floats] = [np.zeros_like(h[0]), *h[1:]]
    found: list[Floats] = [jet[-1] / factorial(len(jet) - 1), *(np.zeros_like(x) for x in h[1:])]
    for order in reversed(range(len(jet) - 1)):
        found = _times(found, step)
        found[0] = found[0] + jet[order] / factorial(order)
    return found


@dataclass(frozen=True, slots=True, eq=False)
class Sections:
    """Curves of any number: ``quartics`` (..., 5, 2), their ∂/∂θ ``rates``, and a stretch (...).

    The dots are the same in all three, such as angles and segments; an index picks among them.
    """

    quartics: Floats
    rates: Floats
    stretch: Stretch | None = None

    def __len__(self) -> int:
        return len(self.quartics)

    def __getitem__(self, index: Any) -> Sections:
        """Return some, by an index of the first axes without an ellipsis."""
        stretch = None if self.stretch is None else self.stretch[index]
        return Sections(self.quartics[index], self.rates[index], stretch)

    def of_segment(self, k: int) -> Sections:
        """Return those at place ``k`` of the last axis of the curves."""
        stretch = self.stretch
        if stretch is not None:
            away, drifts = stretch.departures[..., k, :], stretch.drifts[..., k, :]
            stretch = Stretch(stretch.strengths, away, drifts)
        return Sections(self.quartics[..., k, :, :], self.rates[..., k, :, :], stretch)

    def moved(self, scale: float, lift: float) -> Sections:
        """Return the curves ``scale`` times as large, then ``lift`` higher."""
        stretch = self.stretch
        if stretch is not None:
            strengths = tuple(each.moved(scale, lift) for each in stretch.strengths)
            stretch = Stretch(strengths, stretch.departures, stretch.drifts)
        return Sections(scale * self.quartics + (0.0, lift), scale * self.rates, stretch)

    def backwards(self) -> Sections:
        """Return chains, (..., n) along the last axis, run from their ends to their starts."""
        stretch = self.stretch
        if stretch is not None:
            away, drifts = stretch.departures[..., ::-1, :], stretch.drifts[..., ::-1, :]
            stretch = Stretch(stretch.strengths, away, drifts)
        quartics, rates = (part[..., ::-1, ::-1, :] for part in (self.quartics, self.rates))
        return Sections(quartics, rates, stretch)

    def on(self, s: Floats, order: int = 0) -> Floats:
        """Return a derivative by s at (k,) places of all curves, or (..., k) of their own.

        Shape (..., k, 2).
        """
        if self.stretch is None:
            return _on(self.quartics, s, order)
        return self.stretch.derivative([_on(self.quartics, s, n) for n in range(order + 1)])

    def changes_on(self, s: Floats) -> Floats:
        """Return ∂L/∂θ at the same places, (..., k, 2)."""
        rates = _on(self.rates, s, 0)
        return rates if self.stretch is None else self._changed(_on(self.quartics, s, 0), rates)

    def of_each(self, s: Floats, order: int = 0) -> Floats:
        """Return a derivative of each curve at a place of its own, ``s`` (...), shape (..., 2)."""
        return np.asarray(self.on(s[..., None], order)[..., 0, :])

    def changes_of_each(self, s: Floats) -> Floats:
        """Return ∂L/∂θ of each curve at a place of its own."""
        return np.asarray(self.changes_on(s[..., None])[..., 0, :])

    def _changed(self, points: Floats, rates: Floats) -> Floats:
        assert self.stretch is not None
        moved = self.stretch.mapped(points, rates)
        moved[..., 0] += points[..., 0] * self.stretch.turning(points[..., 1])
        return moved

    def tangents_on(self, s: Floats, size: float) -> Floats:
        """Return unit tangents at (k,) places of all curves; see :func:`unit_tangents`."""
        tangents = tangents_at(self.quartics, s, size)
        return self._turned(_on(self.quartics, s, 0), tangents)

    def tangents_of_each(self, s: Floats, size: float) -> Floats:
        """Return the unit tangent of each curve at a place of its own, (..., 2)."""
        at = s[..., None]
        first = _on(self.quartics, at, 1)
        speed = np.hypot(first[..., 0], first[..., 1])
        if (speed > STILL * size).all():
            tangents = first / speed[..., None]
        else:
            second = _on(self.quartics, at, 2)
            tangents = unit_tangents(self.quartics, at, first, second, size)
        if self.stretch is not None:
            tangents = self._turned(_on(self.quartics, at, 0), tangents)
        return np.asarray(tangents[..., 0, :])

    def _turned(self, points: Floats, tangents: Floats) -> Floats:
        return tangents if self.stretch is None else turned_by(self.stretch, points, tangents)

    def end_tangents(self, size: float) -> tuple[Floats, Floats]:
        """Return the true unit tangents at both ends in the direction of travel, (..., 2) each."""
        start, end = end_tangents(self.quartics, size)
        return self._turned(self.quartics[..., 0, :], start), self._turned(
            self.quartics[..., 4, :], end
        )

    @property
    def ends(self) -> tuple[Floats, Floats]:
        """The first and the last points, (..., 2) each."""
        first, last = self.quartics[..., 0, :], self.quartics[..., 4, :]
        return (
            (first, last)
            if self.stretch is None
            else (self.stretch.of(first), self.stretch.of(last))
        )

    def normals_on(self, s: Floats, size: float) -> Floats:
        """Return unit normals along ∂S/∂θ × ∂S/∂s as components on e_ρ, e_θ, e_h, (..., k, 3)."""
        points, change, tangents = self.on(s), self.changes_on(s), self.tangents_on(s, size)
        r = points[..., 0]
        slip = change[..., 0] * tangents[..., 1] - change[..., 1] * tangents[..., 0]
        return surface_normals(tangents, slip, r, radius_signs(r, size), size)

    def breaks(self) -> Floats:
        """Return the places at which the one curve meant crosses heights of keys, increasing."""
        if self.stretch is None:
            return np.zeros(0)
        h = self.quartics[:, 1]
        found = [
            root
            for k, strength in enumerate(self.stretch.strengths)
            if self.stretch.departures[k] != 0.0 or self.stretch.drifts[k] != 0.0
            for key in strength.heights.tolist()
            if float(h.min()) < key < float(h.max())
            for root in real_roots((h - key).tolist())
        ]
        places = distinct(found)
        places = places[(places > _NO_PANEL) & (places < 1.0 - _NO_PANEL)]
        return places[np.append(True, np.diff(places) > _NO_PANEL)] if len(places) else places

    def integrals(
        self, value: Callable[[Sections, Floats], Floats], count: int, each: int, parts: int = 1
    ) -> Floats:
        """Return ∫ value ds of every curve, shape (...).

        By ``count`` Gauss points, and as many more for every law with a strength as ``each`` says,
        in ``parts`` equal panels and between crossings of the heights of keys.
        """
        even = np.linspace(0.0, 1.0, parts + 1)
        if self.stretch is None:
            nodes, weights = panels(even, count) if parts > 1 else gauss(count)
            return np.asarray(value(self, nodes) @ weights)
        count += each * len(self.stretch.strengths)
        lead = self.quartics.shape[:-2]
        flat = self[np.unravel_index(np.arange(int(np.prod(lead))), lead)]
        found = np.zeros(len(flat))
        for alike in _alike(flat):
            edges = distinct(even, flat[alike[0]].breaks())
            nodes, weights = panels(edges, count)
            found[alike] = value(flat[alike], nodes) @ weights
        return found.reshape(lead)


def _alike(sections: Sections) -> list[np.ndarray]:
    """Return numbers of curves (k, 5, 2) in groups that cross the heights of keys alike."""
    assert sections.stretch is not None
    moving = (sections.stretch.departures != 0.0) | (sections.stretch.drifts != 0.0)
    keys = np.concatenate([sections.quartics[..., 1], moving], axis=1)
    _, number = np.unique(keys, axis=0, return_inverse=True)
    number = number.ravel()
    order = np.argsort(number, kind="stable")
    return np.split(order, np.flatnonzero(np.diff(number[order])) + 1)


def turned_by(stretch: Stretch, points: Floats, tangents: Floats) -> Floats:
    """Return unit tangents at points of the quartic, mapped and of unit length again."""
    moved = stretch.mapped(points, tangents)
    length = np.hypot(moved[..., 0], moved[..., 1])
    return np.asarray(moved / np.where(length > 0.0, length, 1.0)[..., None])


def joined_stretch(parts: Sequence[Stretch | None]) -> Stretch | None:
    """Return the stretch of (n,) curves, each with its own of the same laws, or with none."""
    known = [part for part in parts if part is not None]
    if not known:
        return None
    away = np.zeros((len(parts), len(known[0].strengths)))
    for k, part in enumerate(parts):
        if part is not None:
            away[k] = part.departures
    return Stretch(known[0].strengths, away, np.zeros_like(away))


def curves_at(
    quartics: Floats, stretch: Stretch | None, k: Ints, s: Floats, order: int = 0
) -> Floats:
    """Return a derivative of curve ``k[i]`` of (n,) at ``s[i]`` for each i, shape (m, 2).

    Each value is the same to the last bit whatever else is asked for.
    """
    if stretch is None:
        return at_each(quartics, k, s, order)
    return stretch[k].derivative([at_each(quartics, k, s, n) for n in range(order + 1)])


def _on(quartics: Floats, s: Floats, order: int) -> Floats:
    if s.ndim == 1:
        return on_nodes(quartics, s, order)
    control, factor = quartics, 1.0
    for k in range(order):
        control = control[..., 1:, :] - control[..., :-1, :]
        factor *= 4 - k
    return np.asarray(factor * _horner(control, s))


def _horner(control: Floats, s: Floats) -> Floats:
    """Return Bézier curves (..., n + 1, 2) at (..., k) places of their own, shape (..., k, 2).

    Horner's scheme in the Bernstein basis, coordinate by coordinate: far quicker than the basis'
    own values for each place.
    """
    degree = control.shape[-2] - 1
    shape = np.broadcast_shapes((*control.shape[:-2], 1), s.shape)
    rest, found = 1.0 - s, np.empty((*shape, 2))
    for axis in range(2):
        parts = [control[..., k, axis, None] for k in range(degree + 1)]
        value, power = parts[0] * rest if degree else parts[0] + 0.0 * s, np.ones(())
        for k in range(1, degree):
            power = power * s
            value += comb(degree, k) * power * parts[k]
            value *= rest
        found[..., axis] = value + power * s * parts[degree] if degree else value
    return found
