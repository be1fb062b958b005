"""What is typed of a layer of paint and says nothing of one."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class NoLayerWord(Finding):
    """A word of a layer, as one types it, that is none of those ``allowed``."""

    word: str
    allowed: tuple[str, ...]


@say.register
def _(finding: NoLayerWord, reader: Reader = FILE) -> str:
    return f"{finding.word!r} says nothing of a layer; allowed are {', '.join(finding.allowed)}"
