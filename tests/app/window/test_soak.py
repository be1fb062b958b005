"""A window used for long holds no more than at its beginning.

A little in the test command; SGB_SOAK=1 in the environment asks for 20 000 ticks of a slider, 500
files opened and 100 windows opened and closed.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
LONG = "SGB_SOAK" in os.environ
MUCH = (20_000, 500, 100) if LONG else (200, 8, 1)
# What allocators keep, and the history of 400 gestures.
MEGABYTES = 150 if LONG else 60

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")


def test_what_is_used_for_long_grows_no_more(tmp_path, qapp, capsys):
    done = subprocess.run(
        [sys.executable, "-m", "tests.app.window.soak", *map(str, MUCH), str(tmp_path)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    found = json.loads(done.stdout.splitlines()[-1])
    with capsys.disabled():
        print(f"\n{MUCH[0]} ticks, {MUCH[1]} opens, {MUCH[2]} windows: {found}")
    warm = found.pop("warm")
    for after in found.values():
        assert after["megabytes"] - warm["megabytes"] < MEGABYTES
        for kind in ("widgets", "qt", "vtk", "threads"):
            # A timer or a notice may be on its way.
            assert after[kind] <= warm[kind] + 5, kind
