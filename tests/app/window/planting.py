"""Plants an exception at the beginning of any function of the program, however it is held."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import CodeType, FrameType, FunctionType

APP = str(Path(__file__).resolve().parents[3] / "app")


def _failing(free: tuple[str, ...]) -> CodeType:
    """Return code that raises ZeroDivisionError, for a function that closes over names."""
    lines = ["def make():", *(f" {name} = None" for name in free), " def fail(*_, **__):"]
    lines += [f"  {name}" for name in free]
    space: dict[str, Callable[[], FunctionType]] = {}
    exec("\n".join([*lines, "  raise ZeroDivisionError('planted')", " return fail"]), space)
    return space["make"]().__code__


@contextmanager
def planted(function: FunctionType) -> Iterator[None]:
    """Let ``function`` fail at once wherever it is called, connected slots included."""
    code = function.__code__
    function.__code__ = _failing(code.co_freevars).replace(
        co_filename=code.co_filename, co_name=code.co_name, co_firstlineno=code.co_firstlineno
    )
    try:
        yield
    finally:
        function.__code__ = code


def function_of(code: CodeType, frame: FrameType) -> FunctionType | None:
    """Return the function that runs in a frame; None for one that is held by no class or module."""
    owner = frame.f_locals.get("self")
    for each in type(owner).__mro__:
        found = vars(each).get(code.co_name)
        if isinstance(found, FunctionType) and found.__code__ is code:
            return found
    found = frame.f_globals.get(code.co_name)
    return found if isinstance(found, FunctionType) and found.__code__ is code else None


@contextmanager
def noted(called: Callable[[FrameType], object]) -> Iterator[None]:
    """Call ``called`` with the frame of each function of the program that begins to run."""

    def note(frame: FrameType, event: str, _argument: object) -> None:
        if event == "call" and frame.f_code.co_filename.startswith(APP):
            called(frame)

    sys.setprofile(note)
    try:
        yield
    finally:
        sys.setprofile(None)
