"""What a trace says of itself, in the window's words."""

from __future__ import annotations

from collections import Counter

from app.panels.measures.lines import LIQUIDS, LITRES_FROM
from sgb_core.sources import Taken
from sgb_core.sources.uncertainty import Holding


def told_holding(found: Holding, taken: Taken) -> str:
    """Return what a traced vessel holds, and how sure that is, in one line."""
    names = (("scale", found.scale), ("curve", found.curve), ("sides", found.sides))
    millilitres = found.volume * taken.unit.millilitres
    liquid = "l" if millilitres >= LITRES_FROM else "ml"
    times = taken.unit.millilitres / LIQUIDS[liquid]
    parts = [f"{name} {_digits(part * times, 2)}" for name, part in names if part > 0.0]
    why = f" ({', '.join(parts)})" if parts else ""
    volume, doubt = _digits(found.volume * times, 4), _digits(found.total * times, 2)
    return f"Holds {volume} {liquid} ± {doubt}{why}"


def _digits(value: float, count: int) -> str:
    """Return a number in so many digits, without an exponent where it is no tiny one."""
    return f"{float(f'{value:.{count}g}'):.12g}"


def told_trace(taken: Taken) -> list[str]:
    """Return lines on a trace: segments, deviations and joints; the sides where there are two."""
    found, unit = taken.trace, taken.unit.value
    count = len(found.profile)
    r, h = found.farthest_point
    exact = ", exact" if found.exact else ""
    lines = [
        f"{count} segment{'s' if count > 1 else ''} from {found.points} points{exact}",
        f"Largest deviation {found.largest_deviation:.3g} {unit}, at r = {r:.4g}, h = {h:.4g}; "
        f"rms {found.rms_deviation:.3g} {unit}",
    ]
    joints = Counter(joint.measured.value for joint in found.joints)
    if joints:
        said = ", ".join(f"{number} {kind}" for kind, number in sorted(joints.items()))
        lines.append(f"Joints: {said}")
    if taken.left_right is not None:
        lines.append(f"Left and right differ by {taken.left_right:.3g} {unit} rms")
    if found.outliers:
        lines.append(f"{len(found.outliers)} outliers left out")
    return lines
