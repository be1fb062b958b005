"""Qt is loaded so that what is imported after it comes as quickly as before.

PySide6 puts an import of its own in the place of Python's. It reads the source of every module of
the process, looking for those that want Qt's functions under other names (``from __feature__``);
here there is none, and the 3-D part alone has nine hundred modules.
"""

from __future__ import annotations

import builtins
from collections.abc import Mapping, Sequence
from importlib import import_module
from types import ModuleType

# What PySide6's own import is needed for: its classes are made when they are asked for.
QT = {"PySide6", "shiboken6", "shibokensupport", "__feature__"}

Variables = Mapping[str, object] | None


def load_qt() -> None:
    """Import Qt; all that is no part of it is imported by Python itself from then on."""
    plain = builtins.__import__
    import_module("PySide6.QtWidgets")
    of_qt = builtins.__import__
    if of_qt is plain:
        return

    def chosen(
        name: str,
        globals: Variables = None,
        locals: Variables = None,
        fromlist: Sequence[str] | None = (),
        level: int = 0,
    ) -> ModuleType:
        usual = level > 0 or name.partition(".")[0] not in QT
        return (plain if usual else of_qt)(name, globals, locals, fromlist, level)

    builtins.__import__ = chosen
