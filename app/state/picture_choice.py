"""Which pictures can be chosen: the program's textures, and files of the user's."""

from __future__ import annotations

from pathlib import Path

from app.state.presenter import Presenter

TEXTURES = (
    ("Blue-and-white bands", "blue-white-bands"),
    ("Lotus", "lotus"),
    ("Geometric", "geometric"),
    ("Wood", "wood"),
    ("Brick", "brick"),
    ("Rammed earth", "rammed-earth"),
    ("Earthen wall", "earthen-wall"),
    ("Roof tile", "roof-tile"),
    ("Celadon crackle", "celadon-crackle"),
    ("Raku crackle", "raku-crackle"),
    ("Speckle", "speckle"),
)
PICTURE_FILES = "Pictures (*.png *.jpg *.jpeg)"


def picture_bytes(presenter: Presenter, path: Path) -> bytes | None:
    """Return what is in a picture's file; None, and a notice, where it cannot be read."""
    try:
        return path.read_bytes()
    except OSError as error:
        presenter.notify(f"Cannot read {path.name}: {error.strerror}", "error")
        return None
