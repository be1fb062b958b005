"""Two real programs and an outsider on one file: nobody's version goes without a question."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from sgb_core.document import edits
from sgb_core.document.file import project_file, recovery
from tests.app.helpers import tower

ROOT = Path(__file__).resolve().parents[3]
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="watches a pipe")


class Program:
    """One program, told what to do."""

    def __init__(self, home):
        places = {f"XDG_{n.upper()}_HOME": str(home / n) for n in ("config", "data", "state")}
        self.process = subprocess.Popen(
            [sys.executable, "-m", "tests.app.window.commanded_window"],
            cwd=ROOT,
            env={**os.environ, **places},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
        )

    def __call__(self, line):
        self.process.stdin.write(f"{line}\n".encode())
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def kill(self):
        self.process.kill()
        self.process.communicate()


def test_two_programs_and_an_outsider_on_one_file(tmp_path, qapp):
    pot, other = tmp_path / "pot.sgb", tmp_path / "other.sgb"
    project_file.save(edits.rename(tower(), "first"), pot)
    one, two = Program(tmp_path / "home"), Program(tmp_path / "home")
    try:
        assert one(f"open {pot}")["done"]
        assert "open in another window too" in two(f"open {pot}")["notice"]
        one("name of one")
        saved = one("save CANCEL")
        assert saved["done"]
        assert "asked" not in saved
        two("name of two")
        for answer, ghost in (("CANCEL", ""), ("COMPARE", "of one")):
            refused = two(f"save {answer}")
            assert not refused["done"]
            # Both are shown, with their times.
            assert refused["pictures"] == 2
            for words in ("changed on the disk", "is open in another window", "written", "opened"):
                assert words in refused["asked"]
            assert refused["ghost"] == ghost
        assert project_file.load(pot).name == "of one"
        assert two(f"save SAVE_AS {other}")["done"]
        assert (project_file.load(pot).name, project_file.load(other).name) == ("of one", "of two")
        # Somebody else writes, by other means.
        project_file.save(edits.rename(tower(), "outside"), pot)
        one("name one again")
        assert "changed on the disk" in one("save CANCEL")["asked"]
        assert project_file.load(pot).name == "outside"
        assert two(f"open {pot}")["done"]
        two("name two again")
    finally:
        one.kill()
        two.kill()
    left = recovery.recoverable(
        tmp_path / "home" / "data" / "SGB Studio" / "SGB Studio" / "recovery",
        tmp_path / "home" / "state" / "SGB Studio" / "SGB Studio" / "locks",
    )
    # Neither work has taken the place of the other.
    assert {(item.document.name, item.target) for item in left} == {
        ("one again", pot),
        ("two again", pot),
    }
