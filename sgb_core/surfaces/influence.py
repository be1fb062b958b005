"""How far each point of a surface moves per unit of a shape parameter: its exact derivative.

Each parameter slides quartic points along legs of the control polygon, so ∂L/∂p is the sum of
∂f/∂p Bk(s) (far − near) over the legs: f a leg's fraction, near and far its control points at the
fractions 0 and 1, Bk the Bernstein polynomial of degree 4 of its quartic point.
Turning keeps lengths: the surface moves as far as its section. The polygon is held fixed, so
what a rule moves beyond the segment (C1, G2) is not part of it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import LAMBDAS, ParameterName
from sgb_core.surfaces.sections import Sections
from sgb_core.surfaces.variation import Law, parameters, radius_factors


def quartic_rates(
    profile: Profile,
    parameter: ParameterName,
    segment: int | None = None,
    laws: Sequence[Law] = (),
    theta: ArrayLike = 0.0,
) -> Floats:
    """Return ∂Q/∂p of the three inner quartic points, shape (*theta.shape, n, 3, 2).

    Per unit of ``parameter`` of one segment, of all where ``segment`` is None; zero elsewhere.
    Laws of the radius stretch them.
    ``theta`` in radians from the start angle, where laws give the other parameters their values.
    Raises IndexError where the profile has no such segment.
    """
    count = len(profile)
    if segment is not None and not 0 <= segment < count:
        raise IndexError(f"no segment {segment}; the profile has {count}")
    values = parameters(profile, laws, theta)[0]
    by_lambda, by_omega = basis.leg_fraction_rates(*np.moveaxis(values, -1, 0))
    if parameter == "omega":
        rates = np.stack(by_omega, axis=-1)
    else:
        rates = np.stack(by_lambda, axis=-1) * [name == parameter for name in LAMBDAS]
    p = profile.control_points
    legs = np.stack([p[:, far] - p[:, near] for near, far in basis.LEGS], axis=1)
    moved = rates[..., None] * legs
    if segment is not None:
        others = np.arange(count) != segment
        moved[..., others, :, :] = 0.0
    moved[..., 0] *= radius_factors(profile, laws, theta)[0][..., None]
    return np.asarray(moved)


def section_influence(
    profile: Profile,
    parameter: ParameterName,
    s: ArrayLike,
    segment: int | None = None,
    laws: Sequence[Law] = (),
    theta: ArrayLike = 0.0,
    sections: Sections | None = None,
) -> Floats:
    """Return |∂L/∂p| at each ``s``, shape (m,), of every segment: shape (*theta.shape, n, m).

    In the document's unit per unit of the parameter; arguments as in :func:`quartic_rates`.
    ``sections`` are those at ``theta``, which say what stretches them by the height: held fixed,
    as the heights of its keys are.
    """
    moved = quartic_rates(profile, parameter, segment, laws, theta)
    step = basis.bernstein(4, s)[..., 1:4] @ moved
    if sections is not None and sections.stretch is not None:
        step = sections.stretch.mapped(basis.bernstein(4, s) @ sections.quartics, step)
    return np.asarray(np.hypot(step[..., 0], step[..., 1]))
