"""The ``trace`` command: which source is meant, and what is said of the result."""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sgb_core.document.file import project_file
from sgb_core.document.model import Unit
from sgb_core.findings.words import say
from sgb_core.sources import Options, ScaleBar, Side, Taken, take

_JSON: dict[str, Any] = {"ensure_ascii": False, "allow_nan": False, "indent": 2}


def trace(options: argparse.Namespace) -> bool:
    """Take the profile of each source, write the projects and print what is to be said.

    Several sources go into a folder, each as a project of its name; what is wrong with one of
    them is told and does not keep the others. Returns whether all went well.
    """
    how, sources, out = _options(options), options.sources, Path(options.out)
    if len(sources) == 1 and not out.is_dir():
        found = _traced(sources[0], out, how)
        print(json.dumps(_said(found), **_JSON) if options.json else _as_text(found))
        return True
    out.mkdir(exist_ok=True)
    said: list[object] = []
    faults = 0
    for source, name in zip(sources, _names(sources), strict=True):
        try:
            found = _traced(source, out / name, how)
        except (OSError, ValueError) as error:
            faults += 1
            said.append({"source": source, "error": _fault(error)})
            text = f"error: {_fault(error)}"
        else:
            said.append({"source": source, "out": str(out / name), **_said(found)})
            text = _as_text(found)
        if not options.json:
            print(f"{source}\n  " + text.replace("\n", "\n  "))
    if options.json:
        print(json.dumps(said, **_JSON))
    return not faults


def _traced(source: str, out: Path, how: Options) -> Taken:
    taken = take(source, how)
    project_file.save(taken.document(), out)
    return taken


def _names(sources: Sequence[str]) -> list[str]:
    """Return the names of the projects, with the sources' suffixes where it needs them."""
    stems = [Path(source).stem for source in sources]
    return [
        f"{stem if stems.count(stem) == 1 else Path(source).name}.sgb"
        for source, stem in zip(sources, stems, strict=True)
    ]


def _fault(error: OSError | ValueError) -> str:
    return (error.strerror or str(error)) if isinstance(error, OSError) else str(error)


def _options(options: argparse.Namespace) -> Options:
    bar = options.scale_bar
    return Options(
        unit=Unit(options.unit),
        tolerance=options.tolerance,
        height=options.height,
        scale=options.scale,
        scale_bar=None if bar is None else ScaleBar(bar[0:2], bar[2:4], bar[4]),
        axis=options.axis,
        side=Side(options.side),
        clicks=options.clicks,
        merge=options.merge,
    )


def _said(taken: Taken) -> dict[str, object]:
    """Return what is said of a trace, as plain values."""
    found = taken.trace
    axis = taken.axis
    return {
        "segments": len(found.profile),
        "points": found.points,
        "tolerance": found.tolerance,
        "largest_deviation": found.largest_deviation,
        "rms_deviation": found.rms_deviation,
        "farthest": list(found.farthest_point),
        "exact": found.exact,
        "axis": axis[0] if len(axis) == 1 else list(axis),
        "left_right": taken.left_right,
        "joints": [
            {
                "rule": joint.rule.value,
                "measured": joint.measured.value,
                "kink_deg": joint.kink_deg,
            }
            for joint in found.joints
        ],
        "outliers": list(found.outliers),
        "warnings": [say(note) for note in taken.notes],
    }


def _as_text(taken: Taken) -> str:
    """Return the same for a person, a few lines."""
    found, unit = taken.trace, taken.unit.value
    r, h = found.farthest_point
    count = len(found.profile)
    joints = [joint.measured.value for joint in found.joints]
    lines = [
        f"{count} segment{'s' if count > 1 else ''} from {found.points} points"
        + (", exact" if found.exact else ""),
        f"largest deviation: {found.largest_deviation:.6g} {unit} "
        f"(r = {r:.6g}, h = {h:.6g}); rms {found.rms_deviation:.6g} {unit}; "
        f"tolerance {found.tolerance:.6g} {unit}",
    ]
    if joints:
        lines.append(f"joints: {' '.join(joints)}")
    if taken.left_right is not None:
        lines.append(f"left and right differ by {taken.left_right:.6g} {unit} rms")
    if found.outliers:
        lines.append(f"left out as outliers: {' '.join(map(str, found.outliers))}")
    lines += [f"note: {say(note)}" for note in taken.notes]
    return "\n".join(lines)
