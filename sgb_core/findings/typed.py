"""What is typed of a thing and says nothing of one."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class SaysNothing(Finding):
    """A word that is none of those ``allowed`` of a thing, such as a layer, as one types it."""

    word: str
    of: str
    allowed: tuple[str, ...]


@say.register
def _(finding: SaysNothing, reader: Reader = FILE) -> str:
    allowed = ", ".join(finding.allowed)
    return f"{finding.word!r} says nothing of a {finding.of}; allowed are {allowed}"
