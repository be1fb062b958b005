"""A texture in the viewport: grabbed at a tile that faces the viewer, dragged over the surface."""

from __future__ import annotations

from dataclasses import replace
from math import tau

import numpy as np

from app.hand import texture_place
from app.hand.coordinates import ScreenPoint
from app.hand.snapping import DragKeys
from app.state.presenter import Frame, Presenter
from app.viewport.half_plane import Lens
from sgb_core.arrays import Floats
from sgb_core.document.model import Document
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.uv import UVMap
from sgb_core.values import dataclass

# Rounds of Newton's method from where the hand was to where it is, and how far one may go.
_ROUNDS, _FARTHEST = 6, 0.08
_STEP = 1e-4


@dataclass(frozen=True, slots=True)
class TextureGrip:
    """The handle of one texture, by its number; ``at`` is where it is once a hand holds it."""

    number: int
    at: tuple[float, float] | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Sheet:
    """The surface by shares u of the turn and v of the generatrix' length, as it is seen."""

    surface: RevolutionSurface
    on: UVMap
    lens: Lens

    @classmethod
    def of(cls, document: Document, lens: Lens) -> Sheet:
        """Return the sheet of a document's surface."""
        return cls(document.surface, texture_place.unrolled(document), lens)

    def in_space(self, u: float, v: float) -> Floats:
        """Return the place of the surface, shape (3,)."""
        row = float(np.interp(v, self.on.shares, np.arange(len(self.on.lengths))))
        segment = min(int(row // (self.on.per_segment + 1)), len(self.surface.profile) - 1)
        s = min(max((row - segment * (self.on.per_segment + 1)) / self.on.per_segment, 0.0), 1.0)
        theta = self.surface.start + u * self.surface.sweep
        return self.surface.point(segment, s, theta)

    def on_screen(self, u: float, v: float) -> Floats:
        """Return the pixel where a place is seen, shape (2,)."""
        return self.lens.to_screen(self.in_space(u, v))

    @property
    def facing(self) -> float:
        """The share of the turn that faces the viewer, inside the turn."""
        across, around, _ = self.surface.directions(np.asarray(self.surface.start))
        back = self.lens.pose.basis[2]
        angle = float(np.arctan2(back @ around, back @ across)) % tau
        sweep = self.surface.sweep
        beyond = min(tau - angle, angle - sweep) if angle > sweep else 0.0
        return angle / sweep if beyond <= 0.0 else float(angle - sweep <= tau - angle)

    def under(self, at: ScreenPoint, near: tuple[float, float]) -> tuple[float, float]:
        """Return the (u, v) seen at a pixel, on the side of ``near``; at a silhouette there."""
        place, goal = np.array(near), np.array((at.x, at.y))
        for _ in range(_ROUNDS):
            here = self.on_screen(*place)
            columns = []
            for k in (0, 1):
                # Inwards from an end of the generatrix.
                step = _STEP if k == 0 or place[1] < 0.5 else -_STEP
                ahead = place + step * np.eye(2)[k]
                columns.append((self.on_screen(*ahead) - here) / step)
            way = np.linalg.lstsq(np.array(columns).T, goal - here, rcond=1e-3)[0]
            longest = float(np.abs(way).max())
            place = place + way * min(1.0, _FARTHEST / max(longest, 1e-12))
            place[1] = min(max(place[1], 0.0), 1.0)
        return float(place[0]), float(place[1])


@dataclass(frozen=True, slots=True)
class TextureDrag:
    """A drag of a texture: where on the surface it was grabbed, and where the hand is now."""

    press: ScreenPoint
    number: int
    grabbed: tuple[float, float]
    now: tuple[float, float]
    moved: bool = False
    label = "Texture"

    @property
    def held(self) -> TextureGrip:
        """The grip, where the hand has taken it."""
        return TextureGrip(self.number, self.now)

    def pulled(
        self, presenter: Presenter, frame: Frame, lens: Lens, at: ScreenPoint, keys: DragKeys
    ) -> TextureDrag:
        """Move the texture to under the hand; Shift holds it around, or along."""
        now = Sheet.of(frame.document, lens).under(at, self.now)
        du, dv = now[0] - self.grabbed[0], now[1] - self.grabbed[1]
        if keys.constrain:
            du, dv = (0.0, dv) if abs(at.y - self.press.y) > abs(at.x - self.press.x) else (du, 0.0)
        presenter.apply(lambda d: texture_place.moved(d, self.number, du, dv))
        return replace(self, now=now, moved=True)


def grip_places(document: Document, sheet: Sheet) -> dict[int, tuple[float, float]]:
    """Return the (u, v) at which each texture is grabbed: a tile that faces the viewer."""
    found = {}
    for number in range(len(document.appearance.textures)):
        tiling = texture_place.laid(document, number, sheet.on)
        if tiling is not None:
            found[number] = tiling.centre(sheet.facing)
    return found
