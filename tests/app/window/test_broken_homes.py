"""The real program starts whatever lies in its user's places, and says what it set aside once.

A few in the test command; SGB_SETTINGS=300 in the environment names how many.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.app.window.broken_home import broken_home, keys

ROOT = Path(__file__).resolve().parents[3]
HOMES = int(os.environ.get("SGB_SETTINGS", "1"))
PATIENCE_SECONDS = 180

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="makes pipes and links")


def started(home):
    places = {f"XDG_{name.upper()}_HOME": str(home / name) for name in ("config", "data", "state")}
    done = subprocess.run(
        [sys.executable, "-m", "tests.app.window.real_start"],
        cwd=ROOT,
        env={**os.environ, **places},
        capture_output=True,
        text=True,
        check=False,
        timeout=PATIENCE_SECONDS,
    )
    assert done.returncode == 0, done.stderr[-3000:]
    assert "Traceback" not in done.stderr, done.stderr[-3000:]
    return json.loads(done.stdout.splitlines()[-1])


def test_the_keys_are_found():
    found = keys()
    assert len(found) > 20
    assert {"theme", "hints_seen", "measures/overhang", "text_percent", "printer"} <= set(found)


def test_every_home_starts(tmp_path, qapp, capsys):
    aside = offered = 0
    for number in range(HOMES):
        home = tmp_path / str(number)
        home.mkdir()
        how = broken_home(home, 1000 * HOMES + number)
        first = started(home)
        assert first["visible"], how
        assert not any("Something failed" in each for each in first["said"]), (how, first)
        told = [each for each in first["said"] if "set aside" in each or "cannot be read" in each]
        # One thing after the other is said in one notice, or the last would hide the first.
        assert all(each in first["last"] for each in told), (how, first)
        again = started(home)
        assert again["visible"], how
        settings = home / "config" / "SGB Studio" / "SGB Studio.conf"
        if settings.is_file():
            assert not any("set aside" in each for each in again["said"]), (how, again)
        aside += bool(told)
        offered += first["offered"]
    with capsys.disabled():
        print(f"\n{HOMES} broken homes started twice, {aside} had something set aside, "
              f"{offered} offered work")  # fmt: skip
