"""Whatever ``check`` accepts is measured, shown and exported under limits of the system.

``python -m tests.app.cli.accepted COUNT SEED FOLDER`` makes so many random projects and prints
its counts as JSON; COUNT may also be a folder of project files.
"""

from __future__ import annotations

import json
import random
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

from tests.sgb_core.document.random_documents import random_project

GIGABYTE = 1 << 30
CHECK_SECONDS, CHECK_BYTES = 3.0, 500e6
SECONDS = 20.0
# Of the processor, and not of a busy machine's clock; far more means that it would never end.
PATIENCE = 90
CHILD = """
import re, resource, sys
resource.setrlimit(resource.RLIMIT_CPU, (PATIENCE, PATIENCE))
from app.__main__ import main
status = main(sys.argv[1:])
peak = re.search(r'VmHWM:\\s+(\\d+)', open('/proc/self/status').read())
used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
print(int(peak[1]) * 1024, sum(each.ru_utime + each.ru_stime for each in used), file=sys.stderr)
sys.exit(status)
""".replace("PATIENCE", str(PATIENCE))


def run(words: list[str]) -> dict[str, Any]:
    """Run a command of the program; return its status, what it said, its bytes and seconds."""
    done = subprocess.run(
        [sys.executable, "-c", CHILD, *words], capture_output=True, text=True, check=False
    )
    lines = done.stderr.splitlines()
    last = re.fullmatch(r"(\d+) ([\d.]+)", lines[-1]) if lines else None
    if last is None:
        return {"status": done.returncode, "said": lines[-3:], "bytes": 0, "seconds": PATIENCE}
    return {
        "status": done.returncode,
        "said": lines[:-1],
        "out": done.stdout,
        "bytes": int(last[1]),
        "seconds": float(last[2]),
    }


def tried(path: Path, folder: Path) -> dict[str, Any]:
    """Check a file, then do with it what is promised; return what is at fault, and the worst."""
    found: dict[str, Any] = {"faults": [], "accepted": False, "seconds": 0.0, "bytes": 0}
    checked = run(["check", str(path)])
    if checked["seconds"] > CHECK_SECONDS or checked["bytes"] > CHECK_BYTES:
        found["faults"].append((path.name, "check", checked))
    if checked["status"] == 1:
        if len(checked["said"]) != 1:
            found["faults"].append((path.name, "check", checked))
        return found
    found["accepted"] = True
    for words in (
        ["measure", str(path), "--json"],
        ["render", str(path), str(folder / "out.png"), "--size", "320x240"],
        ["export", str(path), str(folder / "out.stl")],
    ):
        done = run(words)
        found["seconds"] = max(found["seconds"], done["seconds"])
        found["bytes"] = max(found["bytes"], done["bytes"])
        # What cannot be is said in one line; a traceback is many.
        refused = done["status"] == 1 and len(done["said"]) == 1
        if (
            not (done["status"] == 0 or refused)
            or done["seconds"] > SECONDS
            or done["bytes"] > GIGABYTE
        ):
            found["faults"].append((path.name, words[0], {**done, "out": ""}))
        elif refused and not told_before(done["said"][0], checked["out"]):
            found["faults"].append((path.name, f"{words[0]}: check has not said", done["said"]))
    return found


def told_before(refusal: str, checked: str) -> bool:
    """Whether ``check`` has warned of what a command refuses."""
    return f"warning: {refusal.removeprefix('sgb-studio: ')}" in checked


def main(count: str, seed: int, folder: Path) -> dict[str, Any]:
    """Try so many random projects, or all in a folder; return the counts."""
    counts: dict[str, Any] = {"accepted": 0, "refused": 0, "faults": [], "seconds": 0.0, "bytes": 0}
    if count.isdecimal():
        paths = []
        drawn = random.Random(seed)
        for number in drawn.sample(range(10_000_000), int(count)):
            paths.append(folder / f"random-{number}.sgb")
            paths[-1].write_text(json.dumps(random_project(number)), encoding="utf-8")
    else:
        paths = sorted(Path(count).glob("*.sgb"))
    for path in paths:
        found = tried(path, folder)
        counts["accepted" if found["accepted"] else "refused"] += 1
        counts["faults"] += found["faults"]
        for key in ("seconds", "bytes"):
            counts[key] = max(counts[key], found[key])
    return counts


if __name__ == "__main__":
    print(json.dumps(main(sys.argv[1], int(sys.argv[2]), Path(sys.argv[3]))))
