"""The sections of a project file, read from parsed JSON and checked."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from enum import StrEnum
from itertools import pairwise
from math import radians
from typing import NoReturn

import numpy as np

from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.curves.profile import GAP, JointRule, Profile
from sgb_core.curves.segment import (
    LAMBDAS,
    NEUTRAL,
    PARAMETER_RANGES,
    ParameterName,
    Segment,
    ShapeParameters,
)
from sgb_core.document.errors import FileError
from sgb_core.document.file.fields import Fields, Node
from sgb_core.document.model import Revolution
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis
from sgb_core.surfaces.variation import Law, LawKind

MAX_COORDINATE = 1e9
# Far beyond any real project; what keeps reading a hostile one within seconds.
MAX_SEGMENTS = 2_000
MAX_LAWS = 500
MAX_KEYFRAMES = 500
MAX_FOLD = 1_000_000
# Keys nearer than this many degrees are at one angle: a curve between them would only jump.
CLOSEST_KEYS = 1e-9


class SegmentEnd(StrEnum):
    """The ends of a segment by their names in ``holds``."""

    START = "start"
    END = "end"


COORDINATE = "a number from -1e9 to 1e9"
FINITE = "a finite number"


def read_profile(node: Node) -> Profile:
    """Return the ``profile`` section; it is required."""
    if not node.is_given:
        node.fail('an object {"segments": [...]}')
    fields = node.object()
    closed = fields["closed"].boolean(False)
    allowed = f"a list of 1 to {MAX_SEGMENTS} segments"
    segments = [_segment(item) for item in fields["segments"].array(allowed, 1, MAX_SEGMENTS)]
    count = len(segments) if closed else len(segments) - 1
    joints = fields["joints"]
    rules = [JointRule.G0] * count
    if joints.is_given:
        many = f"a list of {count}: one rule for each joint of {len(segments)} segments"
        many += " in a ring" if closed else ""
        rules = [item.choice(JointRule) for item in joints.array(many, count, count)]
    profile = Profile(tuple(segments), tuple(rules), closed, fields.rest())
    _check_gaps(profile, joints.is_given)
    return profile


def _check_gaps(profile: Profile, given: bool) -> None:
    """Refuse ends that do not meet where a rule, or a ring, says that they do."""
    points, size = profile.control_points, profile.size
    steps = np.roll(points[:, 0], -1, axis=0) - points[:, 3]
    gaps = np.hypot(steps[:, 0], steps[:, 1])
    for joint in profile.joints:
        if gaps[joint] <= GAP * size:
            continue
        gap, rule = float(gaps[joint]), profile.rules[joint]
        if profile.closed and joint == len(profile) - 1:
            raise FileError(
                f"profile.closed is true, but the last point is {gap:.6g} from the first; "
                "allowed is true only where they meet"
            )
        if rule is not JointRule.FREE:
            default = "" if given else " (the default)"
            raise FileError(
                f'profile.joints[{joint}] is "{rule}"{default}, but segments {joint} and '
                f'{joint + 1} are {gap:.6g} apart; allowed is "free", or ends that meet'
            )


def _segment(node: Node) -> Segment:
    fields = node.object('an object {"points": [...]}')
    rows = fields["points"].array("a list of 4 points [r, h]", 4, 4)
    points = [
        [item.number(COORDINATE, -MAX_COORDINATE, MAX_COORDINATE) for item in pair]
        for pair in (row.array("a point [r, h]", 2, 2) for row in rows)
    ]
    values = dataclasses.asdict(NEUTRAL)
    if fields["lambda"].is_given:
        items = fields["lambda"].array("a list of 3 numbers [λ1, λ2, λ3]", 3, 3)
        for name, item in zip(LAMBDAS, items, strict=True):
            values[name] = _in_range(item, name)
    if fields["omega"].is_given:
        values["omega"] = _in_range(fields["omega"], "omega")
    holds: set[str] = set()
    if fields["holds"].is_given:
        items = fields["holds"].array('a list of "start" and "end"', 0, 2)
        holds = {item.choice(SegmentEnd).value for item in items}
    return Segment(
        np.array(points),
        ShapeParameters(**values),
        fields.rest(),
        holds_start="start" in holds,
        holds_end="end" in holds,
    )


def _in_range(node: Node, parameter: ParameterName) -> float:
    low, high = PARAMETER_RANGES[parameter]
    return node.number(f"a number from {low:g} to {high:g}", low, high)


def read_revolution(fields: Fields) -> Revolution:
    """Return the ``revolution`` section."""
    default = Revolution()
    axis = fields["axis"].choice(Axis, default.axis)
    start, sweep = default.start_deg, default.sweep_deg
    if fields["start_deg"].is_given:
        start = fields["start_deg"].number(FINITE)
    if fields["sweep_deg"].is_given:
        allowed = "a number above 0 and at most 360"
        sweep = fields["sweep_deg"].number(allowed, high=360.0, above=0.0)
        # The smallest doubles vanish in radians.
        if radians(sweep) == 0.0:
            fields["sweep_deg"].fail(allowed)
    return Revolution(axis, start, sweep, fields.rest())


def read_variation(node: Node, count: int) -> tuple[Law, ...]:
    """Return the ``variation`` section of a profile with ``count`` segments."""
    if not node.is_given:
        return ()
    items = node.array(f"a list of at most {MAX_LAWS} laws", 0, MAX_LAWS)
    return tuple(_law(item.object(), count) for item in items)


def _law(fields: Fields, count: int) -> Law:
    name = fields["parameter"]
    parameter = next((each for each in PARAMETER_RANGES if each == name.value), None)
    if parameter is None:
        name.fail(", ".join(f'"{each}"' for each in PARAMETER_RANGES))
    kind = fields["law"].choice(LawKind)
    start, end = 0.0, 1.0
    if fields["from"].is_given:
        start = _in_range(fields["from"], parameter)
    if fields["to"].is_given:
        end = _in_range(fields["to"], parameter)
    segments = fields["segments"]
    numbers: tuple[int, ...] | None = None
    if segments.is_given and segments.value != "all":
        allowed = f"a segment number from 0 to {count - 1}"
        items = segments.array('"all" or a list of segment numbers', 0, count)
        numbers = tuple(item.integer(allowed, 0, count - 1) for item in items)
    fold = 1
    if fields["n"].is_given:
        fold = fields["n"].integer(f"a whole number from 1 to {MAX_FOLD}", 1, MAX_FOLD)
    keys: tuple[tuple[float, float], ...] = ()
    if fields["keyframes"].is_given or kind is LawKind.KEYFRAMES:
        keys = _keyframes(fields["keyframes"], 1 if kind is LawKind.KEYFRAMES else 0)
    return Law(parameter, kind, start, end, numbers, fold, keys, fields.rest())


def _keyframes(node: Node, least: int) -> tuple[tuple[float, float], ...]:
    allowed = f"a list of {least} to {MAX_KEYFRAMES} pairs [degrees, f]"
    keys = []
    for item in node.array(allowed, least, MAX_KEYFRAMES):
        degrees, value = item.array("a pair [degrees, f]", 2, 2)
        keys.append((degrees.number(FINITE), value.number("a number from 0 to 1", 0.0, 1.0)))
    _check_angles(node, keys)
    return tuple(keys)


def _check_angles(node: Node, keys: Sequence[tuple[float, float]]) -> None:
    """Refuse two keys at one angle, 0 and 360 being one, unless they say the same."""
    values: dict[float, float] = {}
    for turn, fraction in keys:
        if values.setdefault(turn % 360.0, fraction) != fraction:
            _fail_at(node, turn)
    turns = sorted(values)
    for before, after in pairwise([*turns, turns[0] + 360.0] if len(turns) > 1 else []):
        if after - before < CLOSEST_KEYS:
            _fail_at(node, before)


def _fail_at(node: Node, turn: float) -> NoReturn:
    raise FileError(f"{node.path} has two keys at {turn:g} degrees; allowed is one for each angle")


def read_solid(fields: Fields) -> Solid:
    """Return the ``solid`` section."""
    default = Solid()

    def length(key: str, fallback: float, above: float = -1.0) -> float:
        if not fields[key].is_given:
            return fallback
        allowed = "a positive number" if above == 0.0 else "a number of at least 0"
        return fields[key].number(f"{allowed}, at most 1e9", 0.0, MAX_COORDINATE, above)

    return Solid(
        fields["kind"].choice(BodyKind, default.kind),
        length("wall", default.wall, above=0.0),
        fields["side"].choice(WallSide, default.side),
        length("base", default.base),
        fields["rim"].choice(Rim, default.rim),
        length("drain_hole", default.drain_hole),
        length("foot_ring", default.foot_ring),
        fields.rest(),
    )


def read_placement(fields: Fields) -> Placement:
    """Return the ``placement`` section."""

    def triple(key: str, allowed: str, limit: float) -> tuple[float, float, float]:
        if not fields[key].is_given:
            return (0.0, 0.0, 0.0)
        items = fields[key].array("a list of 3 numbers", 3, 3)
        x, y, z = (item.number(allowed, -limit, limit) for item in items)
        return (x, y, z)

    return Placement(
        triple("rotation_deg", FINITE, float("inf")),
        triple("translation", COORDINATE, MAX_COORDINATE),
        fields.rest(),
    )
