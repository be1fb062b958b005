"""What the system lacks for what is asked."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class NoScreen(Plain):
    """There is nothing to open a window on."""

    NO_DISPLAY = (
        "there is no screen to open a window on (DISPLAY and WAYLAND_DISPLAY are not set); "
        "commands such as render and export work without one"
    )


@dataclass(frozen=True, slots=True)
class MissingPackages(Finding):
    """System packages, by their Debian names, that a purpose, such as "drawing", needs."""

    purpose: str
    packages: tuple[str, ...]


@say.register
def _(finding: MissingPackages, reader: Reader = FILE) -> str:
    return (
        f"{finding.purpose} needs system libraries that are missing; on Debian or Ubuntu: "
        f"sudo apt install {' '.join(finding.packages)}"
    )
