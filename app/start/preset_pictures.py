"""Draws the gallery's pictures of the presets: ``python -m app.start.preset_pictures``.

One PNG per preset beside its project file, the surface alone on a transparent ground, so that it
stands on both themes. To be run again after a preset is made or changed.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO

import resources
from app.scene.offscreen import render_png
from app.state.overlays import Overlay
from sgb_core.document.file import project_file
from sgb_core.document.file.atomic import write_whole

# Twice the size at which a tile shows it, for high-resolution screens, and small as a file.
SIDE = 208
LARGEST_FILE = 45_000


def picture(preset: resources.Preset) -> bytes:
    """Return a preset's picture as PNG; raises ValueError where it would be too large to ship."""
    document = project_file.loads(preset.file.read_bytes())
    png = render_png(document, (SIDE, SIDE), show=frozenset({Overlay.SURFACE}), transparent=True)
    if len(png) > LARGEST_FILE:
        raise ValueError(f"the picture of {preset.name} has {len(png)} bytes")
    return png


def _writer(data: bytes) -> Callable[[BinaryIO], object]:
    return lambda stream: stream.write(data)


def main(folder: Path | None = None) -> int:
    """Draw the pictures of all presets into ``folder``, by default where the gallery looks."""
    for preset in resources.presets():
        png = picture(preset)
        path = preset.picture if folder is None else folder / preset.picture.name
        write_whole(path, _writer(png))
        sys.stdout.write(f"{path.name}: {len(png)} bytes\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
