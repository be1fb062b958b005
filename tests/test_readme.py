"""What the README says is tried out."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from sgb_core import exchange
from sgb_core.document.file import project_file

ROOT = Path(__file__).resolve().parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")


def _blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", README, re.MULTILINE | re.DOTALL)


def _block(language: str) -> str:
    (block,) = _blocks(language)
    return block


def _python(*arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *arguments],
        cwd=cwd,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
    )


def test_the_python_example_runs(tmp_path: Path) -> None:
    done = _python("-W", "error", "-c", _block("python"), cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert re.search(r"\d+\.\d mm³ inside", done.stdout)
    assert "the joint is G1" in done.stdout
    assert re.search(r"holds \d+ ml", done.stdout)
    assert (tmp_path / "cup.stl").stat().st_size > 84
    # The project file shown is the very one that the example writes.
    shown = project_file.loads(_block("json").encode())
    assert project_file.load(tmp_path / "cup.sgb") == shown


def test_the_command_line_examples_run(tmp_path: Path) -> None:
    for line in "".join(_blocks("sh")).splitlines():
        program, *arguments = shlex.split(line)
        assert program == "sgb-studio"
        done = _python("-m", "app", *arguments, cwd=tmp_path)
        assert done.returncode == 0, f"{line}: {done.stderr}"
        if "--json" in arguments:
            assert json.loads(done.stdout)["volume"] > 0.0
    written = {path.name for path in tmp_path.iterdir()}
    made = {"jar.sgb", "fuller.sgb", "fuller.csv", "fuller.stl", "fuller.png"}
    made |= {"held.sgb", "taller.sgb", "jar.pdf", "board.pdf"}
    assert written == made | {"ball.sgb", "round.sgb", "fairest.sgb", "six-litres.sgb", "jar.gcode"}


@pytest.mark.parametrize("suffix", exchange.suffixes())
def test_each_format_is_named(suffix: str) -> None:
    assert re.search(rf"\b{suffix[1:].upper()}\b", README)


def test_the_system_packages_named_are_those_the_test_command_installs() -> None:
    (named,) = re.findall(r"sudo apt install (.*)", README)
    script = (ROOT / "tests" / "run").read_text(encoding="utf-8")
    (installed,) = re.findall(r"^packages=\((.*?)\)", script, re.MULTILINE | re.DOTALL)
    only_for_tests = {"xvfb", "fonts-dejavu-core", "admesh"}
    assert set(named.split()) == set(installed.split()) - only_for_tests


@pytest.mark.parametrize("target", re.findall(r"\]\(([^)#]+)\)", README))
def test_links_and_pictures_exist(target: str) -> None:
    assert (ROOT / target).is_file()
    if target.endswith(".png"):
        assert (ROOT / target).stat().st_size < 200_000


def test_paths_in_the_text_exist() -> None:
    named = re.findall(r"(?:`|^    )((?:app|sgb_core|resources|tests)/[\w./-]*)", README, re.M)
    assert len(named) >= 10
    assert [name for name in named if not (ROOT / name).exists()] == []
