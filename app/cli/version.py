"""Which version of the program this is."""

from __future__ import annotations

PROGRAM = "SGB Studio"


def version() -> str:
    """Return the installed version, or that there is none."""
    from importlib import metadata

    try:
        return metadata.version("sgb-studio")
    except metadata.PackageNotFoundError:
        return "(not installed)"
