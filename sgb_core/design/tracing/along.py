"""How far data are from a profile, place by place along it: what a picture of a trace colours."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.design.tracing.feet import weights
from sgb_core.design.tracing.result import distances


def deviations_along(profile: Profile, points: Floats, places: int) -> Floats:
    """Return the largest distance of the points nearest to each place, shape (segments, places).

    Places are at equal steps of s in each segment, ends included; between points distances are
    interpolated.
    """
    # Imported late: it takes a while to load.
    from scipy.spatial import cKDTree

    samples = (weights(np.linspace(0.0, 1.0, places)) @ profile.quartics).reshape(-1, 2)
    nearest = cKDTree(samples).query(points)[1]
    found = np.full(len(samples), -np.inf)
    np.maximum.at(found, nearest, distances(profile, points))
    known = np.flatnonzero(found > -np.inf)
    filled = np.interp(np.arange(len(samples)), known, found[known])
    return np.asarray(filled.reshape(len(profile), places))
