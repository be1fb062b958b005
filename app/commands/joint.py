"""Choosing the rule of a joint, wherever it is chosen in the window."""

from __future__ import annotations

from app.state.presenter import Presenter
from app.state.window_reader import sentence, told
from sgb_core.curves.continuity import measure_joint, unmet_rule
from sgb_core.curves.profile import JointRule
from sgb_core.curves.unmet import hindrance_at
from sgb_core.document import edits


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
