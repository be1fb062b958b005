"""A command that the window runs in a process of its own: ``python -m app.cli.aside``.

Standard output is for the window alone: each line is JSON, a number for the percentage done, a
string for why the command failed, in the window's words.
"""

from __future__ import annotations

import json
import sys

from app.cli.parser import FAULT, fault_words, run
from app.state.window_reader import WINDOW


def main(argv: list[str]) -> int:
    """Run one command and return the exit status."""
    try:
        return run(argv)
    except (OSError, MemoryError, ValueError) as error:
        print(json.dumps(fault_words(error, WINDOW)), flush=True)
        return FAULT


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
