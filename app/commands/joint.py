"""Choosing the rule of a joint, wherever it is chosen in the window."""

from __future__ import annotations

from functools import partial

from app.commands.command import Command
from app.state.presenter import Presenter
from app.state.window_reader import sentence, told
from sgb_core.curves.continuity import measure_joint, unmet_rule
from sgb_core.curves.moved import moved
from sgb_core.curves.profile import JointRule
from sgb_core.curves.unmet import hindrance_at
from sgb_core.document import edits
from sgb_core.document.model import Document


def choose_rule(presenter: Presenter, joint: int, rule: JointRule) -> bool:
    """Set a rule and say what it moved, or why it cannot be kept; returns whether it was allowed.

    The step in the history has the same words.
    """
    before = presenter.document
    try:
        ruled = edits.set_rule(before, joint, rule)
        moves = edits.rule_moves(before, ruled, joint)
    except edits.EditError:
        # Said by the presenter, as of any edit.
        return presenter.do(f"Rule {rule}", lambda document: edits.set_rule(document, joint, rule))
    if not presenter.do(told(moves), lambda document: edits.set_rule(document, joint, rule)):
        return False
    profile = presenter.document.profile
    report = measure_joint(profile, joint)
    if not report.holds:
        hindrance = hindrance_at(profile, joint, report)
        presenter.notify(sentence(unmet_rule(profile, report, hindrance)), "warning")
    elif moves.moved:
        presenter.notify(sentence(moves), "info", "Undo", presenter.undo)
    return True


def joint_commands(presenter: Presenter) -> list[Command]:
    """Return what makes all joints smooth at once."""
    return [
        Command(
            f"joints_{rule.value.casefold()}",
            "Segment",
            f"Make all joints smooth ({rule.value})",
            partial(smooth_all, presenter, rule),
            tip=tip,
            enabled=lambda frame: bool(frame.document.profile.joints),
            separator=rule is JointRule.G1,
        )
        for rule, tip in (
            (JointRule.G1, "Give every joint one tangent, and say what moved"),
            (JointRule.G2, "Give every joint one tangent and one curvature, and say what moved"),
        )
    ]


def smooth_all(presenter: Presenter, rule: JointRule) -> None:
    """Make all joints smooth as one step; say what moved and where the rule cannot be kept."""
    before = presenter.document
    smoothed, left = edits.smooth_joints(before, rule)
    where = ", ".join(_joint_name(before, joint) for joint in left)
    cannot = f" It cannot be kept at {where}." if left else ""
    if smoothed is before:
        presenter.notify(f"No joint could be made {rule}.{cannot}" if left else _ALL_SMOOTH)
        return
    found = moved(before.profile, smoothed.profile)
    points = sum(each.what.startswith("P") for each in found)
    shapes = len(found) - points
    parts = [_count(points, "point"), _count(shapes, "shape parameter")]
    said = " and ".join(part for part in parts if part) or "nothing"
    if presenter.do(f"All joints {rule}", lambda d: edits.smooth_joints(d, rule)[0]):
        presenter.notify(
            f"{rule} at the joints moved {said}.{cannot}", "info", "Undo", presenter.undo
        )


_ALL_SMOOTH = "All joints are so smooth already."


def _joint_name(document: Document, joint: int) -> str:
    before, after = document.profile.neighbours(joint)
    return f"joint {before + 1}–{after + 1}"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'s' * (number != 1)}" if number else ""
