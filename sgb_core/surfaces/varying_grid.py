"""The live path of a surface with laws: a section for each column, written in single precision."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sections import Sections, Stretch
from sgb_core.surfaces.turn import grid_columns
from sgb_core.surfaces.twist import Twisting
from sgb_core.values import dataclass

SingleFloats: TypeAlias = NDArray[np.float32]

# Multiplications of a matrix product below which the linear algebra library starts no threads.
_ONE_THREAD = 250_000
# Numbers of one of eight arrays that are worked on together: of more the cache holds too few, of
# fewer each call costs more than its numbers. An eighth of it takes 1.4 times as long.
_IN_CACHE = 49_152
# Below these parts of the size a radius or a derivative may vanish but for rounding.
_NEAR_AXIS, _NEARLY_STILL = 1e-5, 1e-5


def multiply(left: SingleFloats, right: SingleFloats, out: SingleFloats) -> None:
    """Write ``left`` @ ``right`` into ``out``, in pieces that one thread multiplies.

    A product this thin is as fast as memory is; more threads only wait for each other, up to a
    hundred times as long where the processors are busy.
    """
    rows = max(1, _ONE_THREAD // right.size)
    for start in range(0, len(left), rows):
        piece = slice(start, start + rows)
        np.matmul(left[piece], right, out=out[piece])


class VaryingWriter:
    """Writes points and normals of surfaces with laws into arrays that keep their memory.

    A few rows at a time, so that all that is computed of them stays in the processor's cache.
    Where a derivative vanishes or the axis is met, as at a pole, a row is written anew with the
    limits that hold there.
    """

    def __init__(self, segment_count: int, per_segment: int, columns: int) -> None:
        self._shape = (segment_count, per_segment + 1, columns)
        self._s = np.linspace(0.0, 1.0, per_segment + 1)
        self._values = basis.bernstein(4, self._s).astype(np.float32)
        self._slopes = basis.bernstein(3, self._s).astype(np.float32)
        self._block = max(1, min(per_segment + 1, _IN_CACHE // columns))
        self._made = np.empty((8, self._block, columns), np.float32)

    def write(
        self,
        surface: RevolutionSurface,
        points: SingleFloats,
        normals: SingleFloats,
        *,
        flipped: bool,
    ) -> None:
        """Fill ``points`` and ``normals``, each shape (rows, columns, 3), float32."""
        turned, sides = grid_columns(surface, self._shape[2] - 1)
        sections = surface.sections(turned, sides)
        directions = surface.directions(surface.start + turned)
        axes = np.ascontiguousarray(directions.transpose(1, 2, 0), np.float32)
        quartics, rates = sections.quartics, sections.rates
        # Differences are taken first: far from the origin they lose no digits to the position.
        slopes = 4.0 * (quartics[..., 1:, :] - quartics[..., :-1, :])
        # One product per segment: its points as rows, the columns of the grid as columns.
        control = [
            np.ascontiguousarray(part.transpose(1, 3, 2, 0), np.float32)
            for part in (quartics, slopes, rates)
        ]
        size, moved = surface.profile.size, surface.placement.translation
        points, normals = points.reshape(*self._shape, 3), normals.reshape(*self._shape, 3)
        for segment in range(self._shape[0]):
            parts = [part[segment] for part in control]
            for start in range(0, self._shape[1], self._block):
                rows = slice(start, start + self._block)
                made = self._evaluate(parts, rows)
                if sections.stretch is not None:
                    _stretch(made, sections.stretch[:, segment])
                if surface.twisting is None:
                    _place(made, axes, moved, points[segment, rows])
                    doubtful = _turn_normals(made, axes, size, flipped, normals[segment, rows])
                else:
                    spin = _Spin.of(surface.twisting, made)
                    spin.place(axes, moved, points[segment, rows])
                    doubtful = _turn_normals(
                        made, axes, size, flipped, normals[segment, rows], spin
                    )
                for row in (start + doubtful).tolist():
                    found = self._limit(sections[:, segment], row, size)
                    frame = directions
                    if surface.twisting is not None:
                        place = sections[:, segment].on(self._s[row : row + 1])[:, 0]
                        found = surface.twisting.normals(found, place)
                        frame = surface.directions(
                            surface.turned(surface.start + turned, place[:, 1])
                        )
                    placed = np.einsum("ci,cij->cj", found, frame)
                    normals[segment, row] = -placed if flipped else placed

    def _evaluate(self, parts: list[SingleFloats], rows: slice) -> SingleFloats:
        """Return r, h, their derivatives by s, and by θ, and room for two more, on some rows."""
        values, slopes = self._values[rows], self._slopes[rows]
        made = self._made[:, : len(values)]
        for k, (matrix, part) in enumerate(zip((values, slopes, values), parts, strict=True)):
            for axis in range(2):
                multiply(matrix, part[axis], made[2 * k + axis])
        return made

    def _limit(self, sections: Sections, row: int, size: float) -> Floats:
        """Return the components of one row's normals, shape (columns, 3), in double precision."""
        # With the next row, whose side of the axis counts there; the last one with that before.
        first = min(row, len(self._s) - 2)
        return sections.normals_on(self._s[first : first + 2], size)[:, row - first]


@dataclass(frozen=True, slots=True, eq=False)
class _Spin:
    """What a twist does to places of one block: their r and h, cos τ, sin τ and r τ'."""

    r: SingleFloats
    h: SingleFloats
    cosine: SingleFloats
    sine: SingleFloats
    pull: SingleFloats

    @classmethod
    def of(cls, twisting: Twisting, made: SingleFloats) -> _Spin:
        """Return what it does where ``made`` holds r and h."""
        r, h = made[0].copy(), made[1].copy()
        angle = twisting.angle(h)
        pull = r * twisting.rate(h)
        parts = (part.astype(np.float32) for part in (np.cos(angle), np.sin(angle), pull))
        return cls(r, h, *parts)

    def place(
        self, axes: SingleFloats, moved: tuple[float, float, float], out: SingleFloats
    ) -> None:
        """Write the points r (cos τ e_ρ + sin τ e_θ) + h e_h, moved."""
        ahead, aside = self.r * self.cosine, self.r * self.sine
        for c in range(3):
            out[..., c] = ahead * axes[0, c] + aside * axes[1, c] + self.h * axes[2, c]
            if moved[c]:
                out[..., c] += np.float32(moved[c])

    def normals(
        self, ahead: SingleFloats, back: SingleFloats, down: SingleFloats
    ) -> tuple[SingleFloats, SingleFloats, SingleFloats]:
        """Return twisted unit normals ahead e_ρ − back e_θ − down e_h, on the columns' axes."""
        down = down - self.pull * back
        unit = 1.0 / np.sqrt(ahead * ahead + back * back + down * down)
        return (
            unit * (ahead * self.cosine + back * self.sine),
            unit * (back * self.cosine - ahead * self.sine),
            unit * down,
        )


def _stretch(made: SingleFloats, stretch: Stretch) -> None:
    """Map places and derivatives of quartics, in rows of columns: (r, h) → (F r, h)."""
    r, h, dr, dh, lean, rise = made[:6]
    # As a rule heights are the same in all columns.
    level = h.T if np.ptp(h, axis=1).any() else h[:, :1].T
    factor, slope = stretch.factor([level, np.ones_like(level)])
    turning = stretch.turning(level).T
    factor, slope = factor.T, slope.T
    lean[...] = factor * lean + r * (turning + slope * rise)
    dr[...] = factor * dr + r * slope * dh
    r *= factor.astype(np.float32)


def _place(
    made: SingleFloats,
    axes: SingleFloats,
    moved: tuple[float, float, float],
    out: SingleFloats,
) -> None:
    """Write the points r e_ρ + h e_h, moved."""
    r, h, one, two = made[0], made[1], made[6], made[7]
    for c in range(3):
        np.multiply(r, axes[0, c], out=one)
        np.multiply(h, axes[2, c], out=two)
        if moved[c]:
            np.add(two, np.float32(moved[c]), out=two)
        np.add(one, two, out=out[..., c])


def _turn_normals(
    made: SingleFloats,
    axes: SingleFloats,
    size: float,
    flipped: bool,
    out: SingleFloats,
    spin: _Spin | None = None,
) -> NDArray[np.intp]:
    """Write ±(h_s e_ρ − w e_θ − r_s e_h)/|…| with w = (r_θ h_s − h_θ r_s)/r.

    The sign is that of r, reversed where flipped. Returns the rows on which a radius or a
    derivative nearly vanishes, so that this tells nothing.
    """
    r, _, dr, dh, lean, rise, one, two = made
    np.multiply(lean, dh, out=lean)
    np.multiply(rise, dr, out=rise)
    np.subtract(lean, rise, out=lean)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        np.divide(lean, r, out=lean)
        np.multiply(dh, dh, out=one)
        np.multiply(dr, dr, out=two)
        np.add(one, two, out=one)
        np.abs(r, out=two)
        still = one.min(axis=1) <= (_NEARLY_STILL * size) ** 2
        doubtful = still | (two.min(axis=1) <= _NEAR_AXIS * size)
        np.multiply(lean, lean, out=two)
        np.add(one, two, out=one)
        np.sqrt(one, out=one)
        np.copysign(one, r, out=one)
        np.divide(-1.0 if flipped else 1.0, one, out=one)
        for part in (dh, lean, dr):
            np.multiply(part, one, out=part)
        if spin is not None:
            dh[...], lean[...], dr[...] = spin.normals(dh, lean, dr)
        for c in range(3):
            np.multiply(dh, axes[0, c], out=one)
            np.multiply(lean, axes[1, c], out=two)
            np.subtract(one, two, out=one)
            np.multiply(dr, axes[2, c], out=two)
            np.subtract(one, two, out=out[..., c])
    return np.flatnonzero(doubtful)
