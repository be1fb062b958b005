"""Frozen dataclasses that are made in a twelfth of the time: half of a short command was that.

The standard decorator writes and compiles the methods of each class while its module is imported;
most of a run's classes never need most of theirs. Here each is made when it is first asked for.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import MISSING, FrozenInstanceError, fields
from operator import attrgetter
from reprlib import recursive_repr
from typing import TYPE_CHECKING, Any, NoReturn

if TYPE_CHECKING:
    # To a type checker it is the standard one.
    from dataclasses import dataclass as dataclass
else:

    def dataclass(*, frozen=False, slots=False, eq=True):
        """Return the decorator :func:`dataclasses.dataclass` for these options.

        Values that are frozen and have slots are made here; all else is left to the standard one.
        What its functions ``fields``, ``replace`` and ``asdict`` say of both is the same.
        """
        if not (frozen and slots):
            return dataclasses.dataclass(frozen=frozen, slots=slots, eq=eq)
        return lambda cls: _value(cls, eq)


def _value(cls: type, eq: bool) -> type:
    # What the class has itself stays; Python puts None for the hash of one with an == of its own.
    own = {name for name, method in cls.__dict__.items() if method is not None}
    if not cls.__doc__:
        # Else the standard one spells out the signature.
        cls.__doc__ = cls.__name__
    made: Any = dataclasses.dataclass(init=False, repr=False, eq=False, slots=True)(cls)
    for name, method in _SHARED.items():
        if name not in own:
            setattr(made, name, method)
    for name, make in (_LATE if eq else _LATE_ALONE).items():
        if name not in own:
            setattr(made, name, _Late(made, name, make))
    return made  # type: ignore[no-any-return]


class _Factory:
    """What a signature shows where a field makes its own default."""

    def __repr__(self) -> str:
        return "<factory>"


_FACTORY = _Factory()


class _Late:
    """A method that is made when it is first looked up, and then stands in this one's place."""

    __slots__ = ("cls", "make", "name")

    def __init__(self, cls: type, name: str, make: Callable[[type], Any]) -> None:
        self.cls, self.name, self.make = cls, name, make

    def __get__(self, instance: object, owner: type) -> Any:
        method = self.make(self.cls)
        method.__name__ = self.name
        method.__qualname__ = f"{self.cls.__qualname__}.{self.name}"
        method.__module__ = self.cls.__module__
        setattr(self.cls, self.name, method)
        return method if instance is None else method.__get__(instance, owner)


def _init(cls: Any) -> Any:
    """Return the constructor, compiled: each time it is called nothing else is as fast."""
    known: dict[str, object] = {"FACTORY_": _FACTORY}
    positional: list[str] = []
    named: list[str] = []
    lines: list[str] = []
    for k, each in enumerate(fields(cls)):
        makes, has_default = each.default_factory is not MISSING, each.default is not MISSING
        known |= {f"set_{k}_": getattr(cls, each.name).__set__, f"default_{k}_": each.default}
        known[f"make_{k}_"] = each.default_factory
        value = each.name
        if each.init:
            default = "=FACTORY_" if makes else f"=default_{k}_" if has_default else ""
            (named if each.kw_only else positional).append(f"{each.name}{default}")
            if makes:
                value = f"make_{k}_() if {each.name} is FACTORY_ else {each.name}"
        elif makes or has_default:
            value = f"make_{k}_()" if makes else f"default_{k}_"
        else:
            # The class sets it after the others.
            continue
        lines.append(f"    set_{k}_(self, {value})")
    if hasattr(cls, "__post_init__"):
        lines.append("    self.__post_init__()")
    head = ", ".join(["self", *positional, *(["*", *named] if named else [])])
    exec("\n".join([f"def made({head}):", *lines, "    return None"]), known)
    made: Any = known["made"]
    made.__annotations__ = {each.name: each.type for each in fields(cls) if each.init}
    made.__annotations__["return"] = None
    return made


def _repr(cls: Any) -> Any:
    shown = [each.name for each in fields(cls) if each.repr]

    @recursive_repr()
    def made(self: object) -> str:
        values = ", ".join(f"{name}={getattr(self, name)!r}" for name in shown)
        return f"{type(self).__qualname__}({values})"

    return made


def _eq(cls: Any) -> Any:
    compared = _getter([each.name for each in fields(cls) if each.compare])

    def made(self: object, other: object) -> bool:
        return compared(self) == compared(other) if type(other) is type(self) else NotImplemented

    return made


def _hash(cls: Any) -> Any:
    hashed = _getter(
        [each.name for each in fields(cls) if (each.compare if each.hash is None else each.hash)]
    )

    def made(self: object) -> int:
        return hash(hashed(self))

    return made


def _getter(names: list[str]) -> Callable[[object], tuple[object, ...]]:
    """Return what gets these attributes of an object, as a tuple however many there are."""
    if len(names) > 1:
        return attrgetter(*names)
    return lambda value: tuple(getattr(value, name) for name in names)


def _refuse_set(self: object, name: str, value: object) -> NoReturn:
    raise FrozenInstanceError(f"cannot assign to field {name!r}")


def _refuse_delete(self: object, name: str) -> NoReturn:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


def _state(self: Any) -> list[object]:
    return [getattr(self, each.name) for each in fields(self)]


def _set_state(self: Any, state: list[object]) -> None:
    for each, value in zip(fields(self), state, strict=True):
        object.__setattr__(self, each.name, value)


_SHARED = {
    "__setattr__": _refuse_set,
    "__delattr__": _refuse_delete,
    # What copies and pickles a value, without setting its fields one by one.
    "__getstate__": _state,
    "__setstate__": _set_state,
}
_LATE_ALONE = {"__init__": _init, "__repr__": _repr}
_LATE = {**_LATE_ALONE, "__eq__": _eq, "__hash__": _hash}
