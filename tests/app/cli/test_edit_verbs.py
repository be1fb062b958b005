"""The names that the verbs copy, so that help answers at once, are those of the core."""

from __future__ import annotations

from app.cli.edit_verbs import VERBS
from sgb_core.curves.profile import JointRule
from sgb_core.curves.segment import PARAMETERS
from sgb_core.surfaces.twist import Ease


def choices(verb: str) -> dict[str, tuple[str, ...] | None]:
    return {argument.name: argument.choices for argument in VERBS[verb].arguments}


def test_the_parameters_are_the_cores() -> None:
    assert choices("set")["parameter"] == PARAMETERS


def test_the_ways_of_twisting_are_the_cores() -> None:
    assert choices("set-twist")["--ease"] == tuple(Ease)


def test_the_rules_are_the_cores() -> None:
    assert choices("rule")["rule"] == tuple(JointRule)
