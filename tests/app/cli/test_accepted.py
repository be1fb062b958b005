"""What ``check`` accepts is measured, shown and exported within a gigabyte and 20 s.

One project in the test command; SGB_ACCEPTED=100 in the environment names how many random ones, or
a folder of project files.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="limits of the system, /proc")


def test_what_is_accepted_can_be_used_or_is_warned_of(tmp_path, capsys):
    count = os.environ.get("SGB_ACCEPTED", "1")
    done = subprocess.run(
        [sys.executable, "-m", "tests.app.cli.accepted", count, "7", str(tmp_path)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    counts = json.loads(done.stdout)
    with capsys.disabled():
        print(f"\n{counts['accepted']} projects used within {counts['bytes'] / 1e6:.0f} MB and "
              f"{counts['seconds']:.1f} s, {counts['refused']} refused")  # fmt: skip
    assert counts["faults"] == []
    assert counts["accepted"] > 0
