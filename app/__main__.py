"""The entry point of ``sgb-studio`` and ``python -m app``."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

# What shells report for a program ended by Ctrl+C.
INTERRUPTED = 130


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command, or the window, and return the exit status.

    0: done. 1: the input or a file is at fault. 2: wrong usage.
    """
    # The matrices are long and thin: a second thread gains nothing, and where the machine is busy
    # waiting for it costs many times the product.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    try:
        # Imported late, so that Ctrl+C while it loads is as quiet as any other.
        from app.cli import parser

        return parser.main(sys.argv[1:] if argv is None else argv)
    except KeyboardInterrupt:
        return INTERRUPTED


if __name__ == "__main__":
    sys.exit(main())
