"""Makes the colour tables: ``python -m resources.colour_maps.make`` writes them anew.

viridis, cividis and inferno are matplotlib's (CC0), 65 of their 256 colours. The diverging scale
is our own: straight lines in CIELAB from blue and from orange to a light grey, evenly in
lightness, told apart by people who confuse red and green.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

COUNT = 65
# L*, a*, b* of the ends and of the middle.
BLUE, GREY, ORANGE = (32.0, 8.0, -50.0), (94.0, 0.0, 0.0), (38.0, 38.0, 48.0)


def diverging() -> NDArray[np.float64]:
    """Return the colours from blue over grey to orange, 0 to 1, shape (COUNT, 3)."""
    part = np.linspace(0.0, 1.0, COUNT // 2 + 1)[:, None]
    lower = np.array(BLUE) * (1.0 - part) + np.array(GREY) * part
    upper = np.array(GREY) * (1.0 - part) + np.array(ORANGE) * part
    lab = np.concatenate([lower, upper[1:]])
    f_y = (lab[:, 0] + 16.0) / 116.0
    f = np.stack([f_y + lab[:, 1] / 500.0, f_y, f_y - lab[:, 2] / 200.0], axis=-1)
    xyz = np.where(f > 6 / 29, f**3, 3 * (6 / 29) ** 2 * (f - 4 / 29))
    xyz = xyz * np.array([0.95047, 1.0, 1.08883])
    to_rgb = np.array(
        [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]]
    )
    linear = np.clip(xyz @ to_rgb.T, 0.0, 1.0)
    gamma = np.where(linear > 0.0031308, 1.055 * linear ** (1 / 2.4) - 0.055, 12.92 * linear)
    return np.asarray(gamma)


def write_all(folder: Path) -> None:
    """Write every table, a colour a line."""
    import matplotlib

    tables = {"diverging": diverging()}
    for name in ("viridis", "cividis", "inferno"):
        tables[name] = matplotlib.colormaps[name](np.linspace(0.0, 1.0, COUNT))[:, :3]
    for name, colours in tables.items():
        rows = np.rint(colours * 255).astype(int)
        text = "".join("#{:02x}{:02x}{:02x}\n".format(*row) for row in rows)
        (folder / f"{name}.txt").write_text(text, encoding="ascii")


if __name__ == "__main__":
    write_all(Path(__file__).parent)
