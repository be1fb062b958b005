"""What holds for all ticks of a gesture: from where, by what, under which equations."""

from __future__ import annotations

import numpy as np

from sgb_core.curves.continuity import JointClass, measure_joints
from sgb_core.curves.profile import SMOOTH_RULES, JointRule, Profile
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.joints import JointEquation, equations_of
from sgb_core.design.locks.columns import Columns
from sgb_core.design.locks.dimension import DimensionKind
from sgb_core.design.locks.equation import LockEquation
from sgb_core.design.locks.gauge import Gauge
from sgb_core.design.locks.hold import Lock, lock_of
from sgb_core.design.locks.readings import MODELLED, Setting, read
from sgb_core.document.dimensions import STORED, dimension_value, setting_of
from sgb_core.document.model import Document
from sgb_core.values import dataclass

_K = DimensionKind


@dataclass(frozen=True, slots=True)
class LockPlan:
    """What a gesture's ticks share; ``key`` tells it from the plan of another gesture."""

    key: tuple[object, ...]
    start: Chain
    columns: Columns
    joints: tuple[JointEquation, ...]
    locked_joints: frozenset[int]
    locks: tuple[Lock, ...]
    setting: Setting


def modelled(document: Document) -> frozenset[DimensionKind]:
    """Return the kinds whose model is not the measure itself."""
    return MODELLED | {_K.VOLUME} if document.variation else MODELLED


def plan_of(key: tuple[object, ...], base: Document, edited: Document) -> LockPlan:
    """Return the plan of edits that lead from ``base`` to documents like ``edited``."""
    ruled = base if base.profile.rules == edited.profile.rules else edited
    rules = _rules(ruled.profile)
    locked_joints = {}
    fixed = locked_points(edited, base.profile)
    for dimension in edited.dimensions:
        if dimension.locked and dimension.joint is not None and dimension.rule is not None:
            locked_joints[dimension.joint] = dimension.rule
    rules.update(locked_joints)
    start = Chain.of(base.profile)
    count = len(base.profile)
    governed = {k for law in edited.variation for k in range(count) if law.applies_to(k)}
    joints = tuple(equations_of(rules, count, points_move=True))
    setting = setting_of(edited)
    return LockPlan(
        key,
        start,
        Columns.of(base.profile, fixed, governed),
        joints,
        frozenset(locked_joints),
        tuple(_locks(base, edited, start)),
        setting,
    )


def lock_equations(document: Document) -> list[LockEquation]:
    """Return the locks of numbers as equations for a search that begins with a document."""
    start = Chain.of(document.profile)
    locks = _locks(document, document, start)
    return [LockEquation(lock, setting_of(document)) for lock in locks]


def _locks(base: Document, edited: Document, start: Chain) -> list[Lock]:
    """Return the locks that can be measured, their models set right at the gesture's start."""
    gauge, setting = Gauge(start), setting_of(base)
    rough = modelled(edited)
    found = []
    for number, dimension in enumerate(edited.dimensions):
        if dimension.value is None or dimension.kind in STORED:
            continue
        reading = read(gauge, dimension, setting)
        if reading is None:
            reading = read(gauge, dimension, setting_of(edited))
        if reading is None:
            continue
        target = dimension.value
        if dimension.kind in rough:
            exact = dimension_value(base, dimension)
            target += 0.0 if exact is None else reading.value - exact
        found.append(lock_of(number, dimension, start.size, target))
    return found


def _rules(profile: Profile) -> dict[int, JointRule]:
    """Return what goes on holding: rules that hold now, of others G1 where the joint is smooth."""
    kept = {}
    for report in measure_joints(profile):
        if report.rule not in SMOOTH_RULES or report.measured in (JointClass.GAP, JointClass.G0):
            continue
        kept[report.joint] = report.rule if report.holds else JointRule.G1
    return kept


def locked_points(document: Document, profile: Profile | None = None) -> list[tuple[int, int]]:
    """Return all points (segment, point) that a document's locks hold in their places.

    Which ends meet at a joint is told by ``profile``, the document's own by default.
    """
    found = []
    for dimension in document.dimensions:
        if dimension.locked and dimension.kind is _K.POINT:
            found += at_one_place(profile or document.profile, dimension.points[0])
    return found


def at_one_place(profile: Profile, point: tuple[int, int]) -> list[tuple[int, int]]:
    """Return all points at the place of one: itself, and the other end at its joint."""
    points = profile.control_points
    if point[1] in (1, 2):
        return [point]
    ends = [(k, i) for k in range(len(profile)) for i in (0, 3)]
    neighbours = {point[0], (point[0] + 1) % len(profile), (point[0] - 1) % len(profile)}
    return [
        end for end in ends if end[0] in neighbours and np.array_equal(points[end], points[point])
    ]
