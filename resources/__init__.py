"""Everything the program ships beside its code, reached through this one accessor.

It works from a checkout and from an installed wheel alike. The presets are ordinary project
files in ``presets/``; ``presets/index.json`` lists them in the order of the gallery, each with
its name (a slug, the file's stem), title, description and group. Beside each lies its picture,
which ``python -m app.start.preset_pictures`` draws.
"""

from __future__ import annotations

import json
from contextlib import suppress
from functools import cache
from importlib.resources import as_file, files
from pathlib import Path

from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class Preset:
    """A shape to start from.

    ``name`` is the word typed on the command line, ``title`` what a person reads, ``file`` the
    project file and ``group`` either "paper" (an example of the theory's paper) or "studio".
    """

    name: str
    title: str
    description: str
    file: Path
    group: str = "studio"

    @property
    def picture(self) -> Path:
        """Where the preset's picture lies, a small PNG with a transparent ground."""
        return self.file.with_suffix(".png")


def path(name: str) -> Path:
    """Return where a resource lies, e.g. ``path("presets/vase.sgb")``.

    Raises FileNotFoundError where there is none of that name.
    """
    with as_file(files(__name__).joinpath(name)) as found:
        # The package is always installed as plain files, so the path outlives the context.
        if not found.exists():
            raise FileNotFoundError(f"no resource {name!r}")
        return found


def read(name: str) -> bytes:
    """Return the bytes of a resource; raises FileNotFoundError as :func:`path` does."""
    return path(name).read_bytes()


def texture(name: str) -> bytes:
    """Return the file of one of the program's textures, a PNG or JPEG picture.

    Raises FileNotFoundError where there is none of that name.
    """
    for suffix in ("png", "jpg"):
        with suppress(FileNotFoundError):
            return read(f"textures/{name}.{suffix}")
    raise FileNotFoundError(f"no texture {name!r}")


def colour_table(name: str) -> bytes:
    """Return a table of colours, one #rrggbb a line from low to high.

    Raises FileNotFoundError where there is none of that name.
    """
    return read(f"colour_maps/{name}.txt")


@cache
def presets() -> tuple[Preset, ...]:
    """Return all presets in the order of the gallery; the first is the opening shape."""
    return tuple(
        Preset(
            name=entry["name"],
            title=entry["title"],
            description=entry["description"],
            file=path(f"presets/{entry['name']}.sgb"),
            group=entry["group"],
        )
        for entry in json.loads(read("presets/index.json"))
    )


@cache
def printers() -> tuple[Path, ...]:
    """Return the data files of the printers that are known, the usual one first."""
    names = json.loads(read("printers/index.json"))
    return tuple(path(f"printers/{name}.json") for name in names)


@dataclass(frozen=True, slots=True)
class Look:
    """A ready-made look: the word typed on the command line, a title, and what it sets."""

    name: str
    title: str
    appearance: dict[str, object]


@cache
def looks() -> tuple[Look, ...]:
    """Return the ready-made looks; each holds an ``appearance`` section of a project file."""
    return tuple(Look(**entry) for entry in json.loads(read("looks/index.json")))


def load_preset(name: str) -> bytes:
    """Return a preset's project file as bytes, for ``document.file_format.loads``.

    Raises ValueError, in one line that names the choices, where no preset has that name.
    """
    known = {preset.name: preset.file for preset in presets()}
    if name not in known:
        from sgb_core.fields.kinds import Choice
        from sgb_core.findings.errors import FindingError
        from sgb_core.findings.refusal import Unknown

        raise FindingError(Unknown("preset", name, Choice(known)))
    return known[name].read_bytes()
