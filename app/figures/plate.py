"""What a plate is: panels in rows and columns, as frozen values that draw nothing."""

from __future__ import annotations

from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from app.scene.camera import Pose
from sgb_core.document.body_state import BodyState
from sgb_core.document.model import Document
from sgb_core.values import dataclass

Array: TypeAlias = NDArray[np.float64]
Mark = Literal["", "*", "o", "."]

# Okabe and Ito's colours, told apart by every kind of eye, in the order in which they are taken.
BLUE, VERMILION, GREEN, PURPLE = "#0072b2", "#d55e00", "#009e73", "#a6548a"
ORANGE, SKY, BLACK = "#e69f00", "#56b4e9", "#000000"
CYCLE = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK)
GREY = "#6b7278"
TINT = "#a9d8c4"

# Widths that journals ask for, and a slide, in millimetres.
WIDTHS = {"One column": 85.0, "Two columns": 175.0, "Slide": 254.0}


@dataclass(frozen=True, slots=True)
class SurfacePanel:
    """A document seen by the plate's camera.

    ``caption`` lines are text with mathematics between dollar signs, ``remark`` ones stand below
    in grey. ``show`` names overlays of
    generatrix, polygon, circles and axes. ``tint`` is the surface's colour; ``bands`` pairs of
    (height, colour) from low to high paint it by height, ``stripes`` one colour a segment.
    ``outline`` are further curves (r, h) drawn dashed in the profile's plane. ``body`` is what is
    drawn in the surface's place.
    """

    document: Document
    label: str = ""
    caption: tuple[str, ...] = ()
    remark: tuple[str, ...] = ()
    show: frozenset[str] = frozenset({"generatrix"})
    tint: str = TINT
    bands: tuple[tuple[float, str], ...] = ()
    stripes: tuple[str, ...] = ()
    outline: tuple[Array, ...] = ()
    body: BodyState | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """A line of a flat panel: points (N, 2), right and up, with its look and its name."""

    points: Array
    colour: str = BLACK
    width: float = 1.2
    dashes: tuple[float, ...] = ()
    mark: Mark = ""
    name: str = ""


@dataclass(frozen=True, slots=True)
class CurvePanel:
    """Curves in a plane with equal scales; ``axes`` names what is right and what is up.

    ``legend`` says where the curves' names stand: in matplotlib's words, or the lower left corner
    as parts of the panel.
    """

    curves: tuple[Curve, ...]
    axes: tuple[str, str]
    label: str = ""
    caption: tuple[str, ...] = ()
    remark: tuple[str, ...] = ()
    legend: Literal["best", "lower right"] | tuple[float, float] = "best"


Panel: TypeAlias = SurfacePanel | CurvePanel


@dataclass(frozen=True, slots=True)
class Plate:
    """Panels in reading order, all of one kind, in ``columns`` columns.

    ``width_mm`` is the whole width; ``panel_height_mm`` that of one panel without its caption,
    None to take what the contents need. ``pose`` gives the direction and the projection; every
    panel is seen from the same place, at the same scale, unless ``common_scale`` is off.
    """

    panels: tuple[Panel, ...]
    columns: int
    pose: Pose
    width_mm: float = WIDTHS["Two columns"]
    dpi: int = 300
    panel_height_mm: float | None = None
    common_scale: bool = True
    title: str = ""

    @property
    def rows(self) -> int:
        """How many rows the panels fill."""
        return -(-len(self.panels) // self.columns)
