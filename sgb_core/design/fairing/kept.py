"""What is kept besides the joints' rules, as equations or as what may not move."""

from __future__ import annotations

from collections.abc import Callable, Collection

from sgb_core.design.demands import measures
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.kept import KeptMeasure
from sgb_core.design.demands.measures import Measured
from sgb_core.design.fairing.findings import Keep

_LENGTHS: dict[Keep, Callable[[Chain], Measured]] = {
    Keep.VOLUME: lambda chain: measures.volume(chain.quartics),
    Keep.HEIGHT: lambda chain: measures.height(chain.quartics),
    Keep.MAX_DIAMETER: lambda chain: measures.largest_diameter(chain.quartics),
}


def kept_measures(keep: Collection[Keep], start: Chain) -> list[KeptMeasure]:
    """Return the equations that keep measures as they are at the start.

    The ends' own places, and with them rim and foot, never move; their tangents are the business
    of the unknowns.
    """
    found = []
    for each in Keep:
        if each in keep and each in _LENGTHS:
            value = _LENGTHS[each](start).value
            found.append(KeptMeasure(each, _LENGTHS[each], value, max(abs(value), 1e-3)))
    return found
