"""No file and no command line ends in a traceback, or in more than a gigabyte.

A few in the test command; SGB_MUTANTS=100000 in the environment names how many, SGB_SEED others,
and then each file must be loaded and checked within 3 s of the processor.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
NAMED = os.environ.get("SGB_MUTANTS")
SEED = os.environ.get("SGB_SEED", "7")
SECONDS = 3.0


@pytest.mark.parametrize(("what", "few"), [("files", 60), ("lines", 60), ("grammar", 40)])
def test_mutants_are_taken_or_refused_in_a_line(tmp_path, what, few):
    count = few if NAMED is None else min(int(NAMED), 1000 if what == "grammar" else 10**9)
    done = subprocess.run(
        [sys.executable, "-m", "tests.app.cli.mutants", what, str(count), SEED, str(tmp_path)],
        # Odd command lines write files of odd names where they are run.
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    counts = json.loads(done.stdout)
    print(f"{count} {what}: {counts}")
    assert counts["faults"] == []
    assert all(counts[key] > 0 for key in counts if key not in ("faults", "slowest"))
    if NAMED and what == "files":
        assert counts["slowest"] < SECONDS
