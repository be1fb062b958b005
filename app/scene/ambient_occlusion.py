"""The darkening of hollows: how open each point of what is drawn lies to the light.

It is made anew when the hand rests, aside; while the shape changes each point keeps what it had,
so that nothing jumps and a drag costs nothing more.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias
from weakref import WeakKeyDictionary

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData

from app.scene.actors import Array, SurfacePart, give_openness
from app.state.cut import Cut
from sgb_core.document.body_state import BodyState
from sgb_core.surfaces.ambient_occlusion import (
    FULL,
    QUICK,
    BodyLight,
    Ground,
    RayCounts,
    SurfaceLight,
    body_light,
    surface_edges,
    surface_light,
)
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

Light: TypeAlias = SurfaceLight | BodyLight


@dataclass(frozen=True, slots=True, eq=False)
class Subject:
    """What the light falls on: the body, None for the bare surface, on the ground or not."""

    surface: RevolutionSurface
    body: BodyState | None
    grounded: bool
    cut: Cut

    def same(self, other: Subject | None) -> bool:
        """Whether the light is the same, told from the identity of what there is."""
        return (
            other is not None
            and self.surface is other.surface
            and self.body is other.body
            and self.like(other)
        )

    def like(self, other: Subject) -> bool:
        """Whether the other's light may stand in for a moment: its points answer to these."""
        return (
            (self.body is None) == (other.body is None)
            and len(self.surface.profile) == len(other.surface.profile)
            and self.surface.is_full_turn == other.surface.is_full_turn
            and (self.grounded, self.cut) == (other.grounded, other.cut)
        )

    def light(self, fineness: RayCounts) -> Light:
        """Make the light; a tenth of a second where it is fine."""
        wedge = None if self.cut is Cut.NONE else self.cut.wedge
        if self.body is None:
            return surface_light(self.surface, fineness, grounded=self.grounded, wedge=wedge)
        loops = [
            loop
            for polygon in self.body.section(self.surface.start)
            for loop in (polygon.exterior, *polygon.holes)
        ]
        return body_light(loops, self.surface, fineness, grounded=self.grounded, wedge=wedge)


class AmbientLight:
    """The light in the hollows of what one scene shows."""

    def __init__(self) -> None:
        self._light: Light | None = None
        # Of what the light is, and whether it is fine.
        self._subject: Subject | None = None
        self._fine = False
        # What was made aside, and of what.
        self._ready: tuple[Subject, Light] | None = None
        # What each level, and the body, was last given.
        self._given: WeakKeyDictionary[SurfacePart, Light | None] = WeakKeyDictionary()
        self._given_body: tuple[BodyState | None, Light | None] = (None, None)
        self._on_body: Array = np.zeros(0)

    def take(self, subject: Subject, fine: bool) -> None:
        """Have light for a subject: fine, or that of one like it if there is."""
        known = self._subject
        if subject.same(known) and (self._fine or not fine):
            return
        ready = self._ready
        if ready is not None and subject.same(ready[0]):
            self._subject, self._light = ready
            self._fine, self._ready = True, None
        elif fine or known is None or not subject.like(known):
            self._subject, self._light = subject, subject.light(FULL if fine else QUICK)
            self._fine = fine

    def fine_work(self, subject: Subject) -> Callable[[], None] | None:
        """Return what may be run aside so that fine light is there at once; None where it is."""
        done = self._fine and subject.same(self._subject)
        if done or (self._ready is not None and subject.same(self._ready[0])):
            return None

        def work() -> None:
            self._ready = subject, subject.light(FULL)

        return work

    def lay_on_level(self, level: SurfacePart, *, even: bool) -> None:
        """Write the light to a level of the bare surface; ``even`` leaves no shade on it."""
        light = None if even or not isinstance(self._light, SurfaceLight) else self._light
        if self._given.get(level) is light:
            return
        self._given[level] = light
        _, per_segment, around = level.shape
        if light is None:
            level.take_openness(np.ones((len(level.grid.points), 2)))
        else:
            level.take_openness(light.on_rows(per_segment, around).reshape(-1, 2))

    def lay_on_body(self, state: BodyState, data: vtkPolyData) -> None:
        """Write the light to the drawn mesh of a body."""
        light = self._light
        given = state, light
        if light is None or state.mesh is None or given == self._given_body:
            return
        before, known = self._given_body
        self._given_body = given
        corners = len(state.mesh.corner_positions)
        moving = not state.fine and before is not None and not before.fine
        if not moving or light is not known or len(self._on_body) != corners:
            # A bare surface with a relief is left light: its own is that of another grid.
            found = np.ones(corners)
            if isinstance(light, BodyLight):
                found = light.on_corners(state.mesh, state.surface)
            self._on_body = np.repeat(found[:, None], 2, axis=1)
        give_openness(data, self._on_body)

    def ground(self, surface: RevolutionSurface) -> Ground | None:
        """Return the shaded ground below a surface, None where it hovers."""
        if self._light is None or self._light.ground is None:
            return None
        return self._light.ground.moved_under(surface_edges(surface, QUICK))
