"""The geometry of SGB Studio, usable without the window: ``import sgb_core as sgb``.

The names here are what a script needs; everything else is reached by its module. All values are
frozen: each function of ``edits`` returns a new document. What is asked of a thing is a property
or a method of it; the examples in docstrings take ``import math`` and the import above as done.

>>> tube = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
>>> cup = sgb.edits.set_solid(tube, kind="vessel", wall=3, base=4)
>>> f"{cup.body().capacity / 1000:.1f} ml in a cup {cup.height:.0f} mm high"
'50.8 ml in a cup 60 mm high'
"""

from __future__ import annotations

import ast
from functools import cache
from importlib import import_module
from pathlib import Path


@cache
def _homes() -> dict[str, tuple[str, str]]:
    """Return of each public name the module it stands in and what it is called there.

    The stub beside this file lists them, once for type checkers and for the program.
    """
    stub = ast.parse(Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8"))
    imported: dict[str, tuple[str, str]] = {}
    homes: dict[str, tuple[str, str]] = {}
    for line in stub.body:
        if isinstance(line, ast.ImportFrom):
            for alias in line.names:
                imported[alias.name] = (line.module or "", alias.name)
                if alias.asname is not None:
                    homes[alias.asname] = imported[alias.name]
        elif isinstance(line, ast.Assign):
            (target,) = line.targets
            homes[ast.unparse(target)] = imported[ast.unparse(line.value)]
    return homes


def __getattr__(name: str) -> object:
    # Python asks for these of every package, and must not make it read its names.
    if name.startswith("__") and name != "__all__":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    homes = _homes()
    found: object
    if name == "__all__":
        # A star import needs no rooms, and would hide the standard module trace.
        rooms = {known for known, (home, _) in homes.items() if home == __name__}
        found = sorted(homes.keys() - rooms - {"trace"})
    elif name not in homes:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    else:
        home, known = homes[name]
        found = None if home == __name__ else getattr(import_module(home), known, None)
        if found is None:
            found = import_module(f"{home}.{known}")
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted({*globals(), *_homes()})
