"""What a potter calls the segments of a profile, read off where they lie."""

from __future__ import annotations

import numpy as np

from sgb_core.curves.profile import Profile

# A segment is flat when it rises by less than this part of its width.
_FLAT = 0.2
# A longer chain is a tower or a turned leg rather than a pot.
_MOST_PARTS = 9


def segment_names(profile: Profile) -> tuple[str, ...]:
    """Return a potter's word for each segment, "" where none fits.

    A flat lowest segment is the floor; of the others the lowest is the foot, the highest the
    lip, of what is left the widest the belly, the narrowest above it the neck, and what lies
    between those two the shoulder. A single segment, a ring and a chain of more segments than a
    pot has parts have no such names.
    """
    count = len(profile)
    names = [""] * count
    if not 2 <= count <= _MOST_PARTS or profile.closed:
        return tuple(names)
    curve = profile.sample(9)
    middles = curve[:, 4, 1]
    rising = sorted(range(count), key=lambda k: middles[k])
    extent = np.ptp(curve[rising[0]], axis=0)
    if count > 2 and extent[1] < _FLAT * extent[0]:
        names[rising.pop(0)] = "floor"
    names[rising.pop(0)], names[rising.pop()] = "foot", "lip"
    if rising:
        widest = max(rising, key=lambda k: curve[k, :, 0].max())
        names[widest] = "belly"
        above = [k for k in rising if middles[k] > middles[widest]]
        if above:
            neck = min(above, key=lambda k: curve[k, :, 0].min())
            names[neck] = "neck"
            for k in above:
                if middles[k] < middles[neck]:
                    names[k] = "shoulder"
    return tuple(names)
