"""What a print path can be coloured by, and the colours from the least to the largest value."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np

# Imported for its side effect: it says where colour tables come from.
import resources.library  # noqa: F401
from app.theme.palette import DARK, Palette
from sgb_core.arrays import Floats
from sgb_core.document.appearance.colour_tables import table
from sgb_core.document.appearance.pictures import Pixels
from sgb_core.toolpaths.strand import Part
from sgb_core.toolpaths.toolpath import Toolpath
from sgb_core.values import dataclass

SHADES = 48


@dataclass(frozen=True, slots=True)
class PathMeasure:
    """A number of each move: what it is called, its unit, and the values, shape (k,)."""

    words: str
    unit: str
    values: Callable[[Toolpath], Floats]

    def limits(self, path: Toolpath) -> tuple[float, float]:
        """Return the least and the largest value of what is printed."""
        values = self.values(path)[path.parts != Part.TRAVEL]
        return float(values.min()), float(values.max())

    def shares(self, path: Toolpath) -> Floats:
        """Return where each move's value lies between least and largest, 0 to 1, shape (k,)."""
        low, high = self.limits(path)
        shares = (self.values(path) - low) / (high - low or 1.0)
        return np.asarray(np.clip(np.nan_to_num(shares), 0.0, 1.0))

    def range(self, path: Toolpath) -> str:
        """Return what the darkest and the lightest colour mean."""
        low, high = self.limits(path)
        return f"{low:.3g} (dark) to {high:.3g} {self.unit} (light)".replace("  ", " ")


def _per_layer(path: Toolpath) -> Floats:
    return np.asarray(path.layer_times[path.layers])


def _flow(path: Toolpath) -> Floats:
    times = path.times
    return np.asarray(np.where(times > 0.0, path.volumes / np.where(times > 0.0, times, 1.0), 0.0))


def _lean(path: Toolpath) -> Floats:
    return np.asarray(path.steps / path.plan.bead if path.plan.bead else path.steps)


MEASURES: Mapping[str, PathMeasure] = MappingProxyType(
    {
        "lean": PathMeasure("Lean, in beads", "", _lean),
        "layer": PathMeasure("Time of a layer", "s", _per_layer),
        "speed": PathMeasure("Speed", "mm/s", lambda path: path.speeds),
        "flow": PathMeasure("Flow", "mm³/s", _flow),
    }
)


def shades(palette: Palette) -> Pixels:
    """Return the colours from the least to the largest value, all seen on the canvas, (48, 3)."""
    low, high = (0.3, 1.0) if palette is DARK else (0.0, 0.88)
    found = table("viridis")
    picked = np.linspace(low, high, SHADES) * (len(found) - 1)
    return np.asarray(found[picked.astype(int)])


def shade_numbers(path: Toolpath, measure: str) -> np.ndarray:
    """Return which of the shades each move has, shape (k,)."""
    shares = MEASURES[measure].shares(path)
    return np.asarray(np.minimum((shares * SHADES).astype(np.intp), SHADES - 1))
