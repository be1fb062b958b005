"""Files to read, written where a test asks, and what was read from them."""

from __future__ import annotations

from pathlib import Path

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.design.tracing.result import distances
from sgb_core.document.model import Unit
from sgb_core.sources import Options, Taken, take

SVG = (
    '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" {}>{}</svg>'
)
MM = 'width="100mm" height="100mm" viewBox="0 0 100 100"'


def taken(folder: Path, name: str, text: str | bytes, options: Options | None = None) -> Taken:
    """Return what is taken from a file of this name and text."""
    path = folder / name
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return take(path, options or Options())


def svg(folder: Path, body: str, options: Options | None = None, root: str = MM) -> Taken:
    """Return what is taken from an SVG file of this body."""
    return taken(folder, "drawing.svg", SVG.format(root, body), options)


def apart(profile: Profile, points: Floats) -> float:
    """Return the largest distance of points from a profile, in parts of its size."""
    return float(distances(profile, points).max()) / profile.size


MILLIMETRES = Options(unit=Unit.MM)
