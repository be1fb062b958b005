"""The ``fair`` command: what is asked for, and what is said of the result."""

from __future__ import annotations

import argparse
import json
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sgb_core.design.fairing.findings import Faired, Keep, KeptRule
    from sgb_core.document.model import Document

ENERGIES = ("bending", "variation", "surface")
FREEDOMS = ("shape", "points")
KEEPS = (
    "capacity",
    "volume",
    "height",
    "max_diameter",
    "rim_diameter",
    "foot_diameter",
    "ends",
    "tangents",
)


def add_fair(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of ``fair``, the input file excepted."""
    parser.add_argument("out", metavar="OUT.sgb")
    parser.add_argument(
        "--energy", choices=ENERGIES, default="bending", help=f"least of {', '.join(ENERGIES)}"
    )
    parser.add_argument(
        "--free", choices=FREEDOMS, default="shape", help="what may move (shape parameters alone)"
    )
    parser.add_argument(
        "--segments", metavar="LIST", type=_numbers, help="only these, with commas, from 0"
    )
    parser.add_argument(
        "--keep", metavar="LIST", type=keeps, default=(), help=f"of {', '.join(KEEPS)}"
    )
    parser.add_argument("--json", action="store_true", help="one object, full precision")


def faired(document: Document, options: argparse.Namespace) -> tuple[Document, str]:
    """Return the fair document and the lines to print.

    Raises LocksExcludeError, which names the lock in the way, where locks exclude each other.
    """
    from sgb_core.design.fairing.energy import Energy
    from sgb_core.design.fairing.findings import Freedom, Keep
    from sgb_core.document.edits.fair import fair_profile

    result, found = fair_profile(
        document,
        Energy(options.energy),
        Freedom(options.free),
        segments=options.segments,
        keep=[Keep(name) for name in options.keep],
    )
    if options.json:
        return result, json.dumps(_tree(found), ensure_ascii=False, allow_nan=False, indent=2)
    return result, _told(found, options.energy)


def _tree(found: Faired) -> dict[str, Any]:
    return {
        "energy": found.energy.value,
        "before": found.before,
        "after": found.after,
        "moved": [[m.segment, m.parameter, m.before, m.after] for m in found.moved],
        "kept": [_name(lock) for lock in found.kept],
        "unmet": [_name(lock) for lock in found.unmet],
        "status": found.status.value,
    }


def _told(found: Faired, energy: str) -> str:
    lines = [f"energy ({energy}): {_number(found.before)} -> {_number(found.after)}"]
    lines += [
        f"segment {m.segment}: {m.parameter} {m.before:.6g} -> {m.after:.6g}" for m in found.moved
    ]
    lines += [f"not kept, as nothing free restores it: {_name(lock)}" for lock in found.unmet]
    lines += [f"segment {k}: its energy is infinite whatever is done" for k in found.endless]
    return "\n".join(lines)


def _number(value: float | None) -> str:
    return "infinite" if value is None else f"{value:.8g}"


def _name(lock: KeptRule | Keep) -> str:
    from sgb_core.design.fairing.findings import Keep

    return lock.value if isinstance(lock, Keep) else f"joint {lock.joint} {lock.rule.value}"


def _numbers(text: str) -> tuple[int, ...]:
    try:
        return tuple(int(part) for part in text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not allowed; allowed are segments' numbers with commas, such as 0,2"
        ) from None


def keeps(text: str) -> tuple[str, ...]:
    """Return the names of what is kept, as they are typed with commas."""
    names = tuple(name.strip() for name in text.split(",") if name.strip())
    for name in names:
        if name not in KEEPS:
            raise argparse.ArgumentTypeError(
                f"{name!r} is not allowed; allowed are {', '.join(KEEPS)}"
            )
    return names
