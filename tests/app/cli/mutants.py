"""Loads and checks mutated project files and odd command lines under limits of the system.

``python -m tests.app.cli.mutants files|lines|grammar COUNT SEED FOLDER`` prints its counts as
JSON; the slowest is told in seconds of the processor, and kept in FOLDER where it is a file.
"""

from __future__ import annotations

import contextlib
import copy
import io
import json
import random
import resource
import signal
import sys
import time
import traceback
from pathlib import Path
from typing import Any

import resources
from app.cli import parser
from app.cli.measures_table import contents
from sgb_core.document.errors import FileError
from sgb_core.document.evaluation import evaluate
from sgb_core.document.file import project_file
from tests.app.cli.odd_lines import odd_line

GIGABYTE = 1 << 30
# Seconds of the processor after which a command line counts as endless.
PATIENCE = 60
ODD = (None, True, -1, 0, 1, 0.5, 1e-300, 1e9, 1.5e9, 1e308, -1e308, 10**30, "", "x", "all", [])
ODD_WORDS = (
    "",
    "-1",
    "1e999",
    "nan",
    "é",
    "--",
    "-",
    "..",
    "\n",
    "x" * 5000,
    "/",
    "-o",
    "1,2",
    "%s",
)
WIDER: dict[str, Any] = {
    "solid": {"kind": "vessel", "wall": 2, "side": "outside", "base": 3, "rim": "round"},
    "twist": {"turns": 0.5, "ease": "smooth"},
    "placement": {"rotation_deg": [10, 20, 30], "translation": [1, 2, 3]},
    "variation": [{"segments": "all", "parameter": "omega", "law": "cosine", "n": 3}],
    "revolution": {"axis": "x", "start_deg": 30, "sweep_deg": 200},
}


def seeds() -> list[dict[str, Any]]:
    """Return the trees of the presets, some with further sections."""
    found = []
    for number, preset in enumerate(resources.presets()):
        tree = json.loads(resources.load_preset(preset.name))
        found.append(tree)
        name = list(WIDER)[number % len(WIDER)]
        found.append({**tree, name: WIDER[name], "solid": WIDER["solid"]})
    return found


def places(tree: Any) -> list[tuple[Any, Any]]:
    """Return every container of a tree with each of its keys."""
    found: list[tuple[Any, Any]] = []
    waiting = [tree]
    while waiting:
        here = waiting.pop()
        if isinstance(here, dict | list):
            keys = list(here) if isinstance(here, dict) else list(range(len(here)))
            found += [(here, key) for key in keys]
            waiting += [here[key] for key in keys]
    return found


def mutated(tree: dict[str, Any], drawn: random.Random) -> bytes:
    """Return the bytes of a file that differs from a good one in a few places."""
    tree = copy.deepcopy(tree)
    for _ in range(drawn.choice((1, 1, 2, 3, 8))):
        spots = places(tree)
        if not spots:
            break
        here, key = drawn.choice(spots)
        value = here[key]
        way = drawn.randrange(7)
        if way == 0:
            here[key] = copy.deepcopy(drawn.choice(ODD))
        elif way == 1:
            del here[key]
        elif way == 2 and isinstance(here, list):
            here[key:key] = [copy.deepcopy(value)] * drawn.choice((1, 2, 50))
        elif way == 3 and isinstance(value, int | float) and not isinstance(value, bool):
            here[key] = value * drawn.choice((-1, 0, 1e-9, 0.5, 1.0000001, 3, 1e3, 1e6))
        elif way == 4:
            here[key] = [value]
        elif way == 5:
            other, place = drawn.choice(spots)
            here[key] = copy.deepcopy(other[place]) if place in other_keys(other) else value
        elif isinstance(here, dict):
            here["x" * drawn.choice((1, 200))] = copy.deepcopy(value)
    data = json.dumps(tree).encode()
    if drawn.random() < 0.1:
        at = drawn.randrange(len(data))
        data = (
            data[:at] + drawn.choice((b"", b"\0", b"[" * 500, b"\xff", b"1e999")) + data[at + 1 :]
        )
    return data


def other_keys(container: Any) -> Any:
    """Return the keys that a container still has."""
    return container if isinstance(container, dict) else range(len(container))


def files(count: int, drawn: random.Random, folder: Path) -> dict[str, Any]:
    """Load and check so many mutants; whatever is accepted must be given back exactly."""
    counts: dict[str, Any] = {"accepted": 0, "refused": 0, "faults": [], "slowest": 0.0}
    good = seeds()
    for _ in range(count):
        data = mutated(drawn.choice(good), drawn)
        begun = time.process_time()
        try:
            document = project_file.loads(data)
            contents(evaluate(document))
            assert project_file.loads(project_file.dumps(document)) == document
            counts["accepted"] += 1
        except FileError as error:
            if len(str(error).splitlines()) != 1:
                counts["faults"].append(kept(folder, data))
            counts["refused"] += 1
        except Exception:
            counts["faults"].append(kept(folder, data))
        taken = time.process_time() - begun
        if taken > counts["slowest"]:
            counts["slowest"] = taken
            (folder / "slowest.sgb").write_bytes(data)
    return counts


def kept(folder: Path, data: bytes) -> str:
    """Keep what failed, and return where and how."""
    place = folder / f"{abs(hash(data)):x}.sgb"
    place.write_bytes(data)
    return f"{place}: {traceback.format_exc(limit=-3)}"


class EndlessError(BaseException):
    """A command line that takes more than PATIENCE seconds of the processor."""


def stop(*_: object) -> None:
    """End what takes too long; called by the system."""
    raise EndlessError


def grammar(count: int, drawn: random.Random, folder: Path) -> dict[str, Any]:
    """Run so many lines that the parser itself proposes, most of them in order."""
    good, out = folder / "small.sgb", folder / "out"
    good.write_bytes(resources.load_preset("goblet"))
    counts: dict[str, Any] = {"0": 0, "1": 0, "2": 0, "faults": [], "slowest": 0.0}
    for _ in range(count):
        run_line(odd_line(drawn, good, out), counts)
    return counts


def run_line(line: list[str], counts: dict[str, Any]) -> None:
    """Run a line; count how it ended, and note what is at fault."""
    begun = time.process_time()
    said, told = io.StringIO(), io.StringIO()
    signal.setitimer(signal.ITIMER_PROF, PATIENCE)
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(told):
            try:
                status = parser.main(line)
            except SystemExit as end:
                status = int(end.code or 0)
        assert status in (0, 1, 2)
        # Several sources are each reported on.
        several = line[:1] == ["trace"] and "  error: " in said.getvalue() + told.getvalue()
        assert status != 1 or several or len(told.getvalue().strip().splitlines()) == 1
        counts[str(status)] += 1
    except (Exception, EndlessError):
        counts["faults"].append(f"{line}: {traceback.format_exc(limit=-3)}")
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
    counts["slowest"] = max(counts["slowest"], time.process_time() - begun)


def lines(count: int, drawn: random.Random, folder: Path) -> dict[str, Any]:
    """Run so many odd command lines; each must end with 0, 1 or 2, and one line if with 1."""
    good = folder / "good.sgb"
    good.write_bytes(resources.load_preset("vase"))
    out = str(folder / "out")
    plain = [
        ["check", str(good)],
        ["measure", str(good), "--json"],
        ["sample", str(good), "--per-segment", "9"],
        ["export", str(good), f"{out}.stl", "--samples", "3", "6"],
        ["export", str(good), f"{out}.obj", "--tolerance", "5"],
        ["edit", str(good), f"{out}.sgb", "set", "0", "lambda2", "2"],
        ["edit", str(good), f"{out}.sgb", "split", "0", "0.5"],
        ["edit", str(good), f"{out}.sgb", "rule", "0", "G1"],
        ["new", "vase", f"{out}.sgb"],
        ["presets"],
        ["solve", str(good), f"{out}.sgb", "height=10cm", "--by", "height"],
    ]
    counts: dict[str, Any] = {"0": 0, "1": 0, "2": 0, "faults": [], "slowest": 0.0}
    for _ in range(count):
        line = list(drawn.choice(plain))
        for _ in range(drawn.choice((1, 1, 2))):
            at = drawn.randrange(len(line) + 1)
            way = drawn.randrange(3)
            if way == 0 and at < len(line):
                line[at] = drawn.choice(ODD_WORDS)
            elif way == 1 and len(line) > 1:
                del line[min(at, len(line) - 1)]
            else:
                line.insert(max(1, at), drawn.choice((*ODD_WORDS, *drawn.choice(plain))))
        if not line or line[0] not in {each[0] for each in plain}:
            continue
        run_line(line, counts)
    return counts


if __name__ == "__main__":
    resource.setrlimit(resource.RLIMIT_AS, (GIGABYTE, GIGABYTE))
    what, number, seed, where = sys.argv[1:]
    signal.signal(signal.SIGPROF, stop)
    run = {"files": files, "lines": lines, "grammar": grammar}[what]
    print(json.dumps(run(int(number), random.Random(int(seed)), Path(where))))
