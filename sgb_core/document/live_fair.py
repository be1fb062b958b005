"""Live fair: while a hand moves points, the segments beside them keep themselves fair."""

from __future__ import annotations

from collections.abc import Collection

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.live import fair_beside
from sgb_core.design.locks.equation import LockEquations
from sgb_core.document.edits.checks import with_profile
from sgb_core.document.lock_plan import lock_equations
from sgb_core.document.model import Document


def beside(profile: Profile, points: Collection[tuple[int, int]]) -> frozenset[int]:
    """Return the segments on both sides of the ends that points (segment, index) belong to."""
    count = len(profile)
    found = set()
    for segment, index in points:
        found.add(segment)
        other = segment + (-1 if index < 2 else 1)
        if profile.closed or 0 <= other < count:
            found.add(other % count)
    return frozenset(found)


class LiveFair:
    """One gesture's fairing: after each tick the shape parameters beside the hand follow it.

    Each search starts from where the last one ended. No control point moves by it, locks and
    joints' rules hold as they did before it; where nothing fair keeps them the tick stays as the
    locks have left it.
    """

    def __init__(self, segments: Collection[int], energy: Energy = Energy.BENDING) -> None:
        self._segments = frozenset(segments)
        self._energy = energy
        self._near: Floats | None = None
        self._start: Document | None = None
        self._locks: list[LockEquations] = []

    def after(self, start: Document, document: Document, *, final: bool) -> Document:
        """Return ``document``, made from ``start``, made fair; ``final`` when the hand lets go."""
        energy = self._energy
        if energy is Energy.SURFACE and document.variation:
            energy = Energy.BENDING
        if document.profile is start.profile or len(document.profile) != len(start.profile):
            return document
        if self._start is not start:
            # Models of bodies are set right once a gesture, as the keeper of the locks does.
            equations = lock_equations(start)
            self._start, self._locks = start, [LockEquations(equations)] if equations else []
        profile, self._near = fair_beside(
            document.surface, energy, self._segments, self._locks, self._near, final=final
        )
        return with_profile(document, profile)
