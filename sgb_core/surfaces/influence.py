"""How far each point of a surface moves per unit of a shape parameter: its exact derivative.

Each parameter slides quartic points along legs of the control polygon, so with the leg fractions
of the key fact ∂L/∂λ1 = −ω/4 B1(s) (P1 − P0), ∂L/∂λ2 = ω/6 B2(s) (P1 − P2) and
∂L/∂λ3 = −ω/4 B3(s) (P2 − P3), Bk the Bernstein polynomials of degree 4, and ∂L/∂ω moves all three.
Turning keeps lengths: the surface moves as far as its section. The polygon is held fixed, so
what a rule moves beyond the segment (C1, G2) is not part of it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.curves.basis import bernstein
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import ParameterName
from sgb_core.surfaces.variation import Law, parameters

# Of each leg: the control point at fraction 0 and the one at fraction 1.
_LEGS = ((0, 1), (2, 1), (3, 2))


def quartic_rates(
    profile: Profile,
    parameter: ParameterName,
    segment: int | None = None,
    laws: Sequence[Law] = (),
    theta: ArrayLike = 0.0,
) -> Floats:
    """Return ∂Q/∂p of the three inner quartic points, shape (*theta.shape, n, 3, 2).

    Per unit of ``parameter`` of one segment, of all where ``segment`` is None; zero elsewhere.
    ``theta`` in radians from the start angle, where laws give the other parameters their values.
    Raises IndexError where the profile has no such segment.
    """
    count = len(profile)
    if segment is not None and not 0 <= segment < count:
        raise IndexError(f"no segment {segment}; the profile has {count}")
    values = parameters(profile, laws, theta)[0]
    l1, l2, l3, w = np.moveaxis(values, -1, 0)
    zero = np.zeros_like(w)
    rates = {
        "lambda1": (-w / 4.0, zero, zero),
        "lambda2": (zero, w / 6.0, zero),
        "lambda3": (zero, zero, -w / 4.0),
        "omega": ((1.0 - l1) / 4.0, (l2 - 3.0) / 6.0, (1.0 - l3) / 4.0),
    }[parameter]
    p = profile.control_points
    legs = np.stack([p[:, far] - p[:, near] for near, far in _LEGS], axis=1)
    moved = np.stack(rates, axis=-1)[..., None] * legs
    if segment is not None:
        others = np.arange(count) != segment
        moved[..., others, :, :] = 0.0
    return np.asarray(moved)


def section_influence(
    profile: Profile,
    parameter: ParameterName,
    s: ArrayLike,
    segment: int | None = None,
    laws: Sequence[Law] = (),
    theta: ArrayLike = 0.0,
) -> Floats:
    """Return |∂L/∂p| at each ``s``, shape (m,), of every segment: shape (*theta.shape, n, m).

    In the document's unit per unit of the parameter; arguments as in :func:`quartic_rates`.
    """
    moved = quartic_rates(profile, parameter, segment, laws, theta)
    step = bernstein(4, s)[..., 1:4] @ moved
    return np.asarray(np.hypot(step[..., 0], step[..., 1]))
