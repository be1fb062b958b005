"""The checks beside the tests: the same before a commit as in the test command, on everything."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def test_a_commit_is_checked_as_by_the_test_command() -> None:
    command = (ROOT / "tests" / "run").read_text(encoding="utf-8")
    hooks = (ROOT / ".pre-commit-config.yaml").read_text(encoding="utf-8")
    checks = re.findall(r"^ *(\.venv/bin/(?:ruff|mypy)\b.*)$", command, re.MULTILINE)
    assert len(checks) == 3
    assert re.findall(r"^ *entry: (.*)$", hooks, re.MULTILINE) == checks


def test_the_types_of_all_packages_are_checked_strictly() -> None:
    tools = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]
    packages = tools["hatch"]["build"]["targets"]["wheel"]["packages"]
    assert sorted(tools["mypy"]["packages"]) == sorted(packages)
    assert tools["mypy"]["strict"]
    # What is got from others may be untyped; nothing of ours is let off.
    eased = [name for entry in tools["mypy"]["overrides"] for name in entry["module"]]
    assert {name.split(".")[0] for name in eased}.isdisjoint(packages)
