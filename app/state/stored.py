"""Settings as they are stored: what makes no sense gives way to the default and is set aside."""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import QLockFile, QSettings

from app.theme import theme

T = TypeVar("T")
# Under this group of the settings lies what made no sense, for whoever wants to look.
ASIDE = "set_aside"
# In milliseconds; nobody takes longer to write settings.
_LONGEST_WRITE = 1000
_LONGEST_NAME = 200


class _Faults:
    """What was set aside and not yet said; one list per process, as QSettings is one store."""

    said: list[str] = []  # noqa: RUF012 - shared on purpose


def faults() -> list[str]:
    """Return, once, a line for each setting or store that was set aside since the last call."""
    found, _Faults.said = _Faults.said, []
    return found


def stored(key: str, usual: T, take: Callable[[object], T]) -> T:
    """Return what is kept under a key of the settings, ``usual`` where there is nothing.

    ``take`` gives the value, or raises ValueError or TypeError for what cannot be one: that is
    moved to the group ASIDE, and ``usual`` holds.
    """
    settings = QSettings()
    if not settings.contains(key):
        return usual
    value = settings.value(key)
    try:
        return take(value)
    except (ValueError, TypeError, OverflowError):
        settings.setValue(f"{ASIDE}/{key}", value)
        settings.remove(key)
        _Faults.said.append(key)
        return usual


def stored_words(key: str) -> list[str]:
    """Return the texts kept under a key of the settings, which give a single one back bare."""
    return stored(key, [], _words)


def stored_number(key: str, usual: float, low: float, high: float) -> float:
    """Return the number from ``low`` to ``high`` that is kept under a key of the settings."""
    return stored(key, usual, lambda value: number(value, low, high))


def stored_theme() -> theme.Choice:
    """Return the theme that was asked for when the program ran last, else the system's."""
    usual: theme.Choice = "system"
    return stored("theme", usual, lambda value: one_of(value, tuple(theme.CHOICES)))


def number(value: object, low: float, high: float) -> float:
    """Return a number that is stored as a text or a number; raises ValueError out of its range."""
    found = float(str(value))
    if not low <= found <= high:
        raise ValueError(value)
    return found


def one_of(value: object, choices: tuple[T, ...]) -> T:
    """Return the choice that is stored; raises ValueError where it is none of them."""
    return choices[choices.index(value)]


def text(value: object) -> str:
    """Return a stored name; raises ValueError for what is no text or too long for one."""
    if not isinstance(value, str) or len(value) > _LONGEST_NAME:
        raise ValueError(value)
    return value


def flag(value: object) -> bool:
    """Return a stored yes or no; raises ValueError where it is neither."""
    return {"true": True, "1": True, "false": False, "0": False}[_known(str(value).lower())]


def _known(text: str) -> str:
    if text not in ("true", "1", "false", "0"):
        raise ValueError(text)
    return text


def _words(value: object) -> list[str]:
    if value is None:
        # What the settings make of an empty list.
        return []
    if isinstance(value, str):
        return [value]
    if not isinstance(value, list) or not all(isinstance(each, str) for each in value):
        raise TypeError(value)
    return value


def clean_store(place: Path) -> None:
    """Remove what a program that was killed in writing the settings at a place has left there.

    Without that the next to write them would wait for a lock that nobody holds, half a minute long.
    """
    held = Path(f"{place}.lock")
    try:
        begun = held.stat().st_mtime_ns
    except OSError:
        return
    lock = QLockFile(str(held))
    lock.setStaleLockTime(_LONGEST_WRITE)
    if lock.tryLock(2 * _LONGEST_WRITE):
        # Who writes holds the lock: what was made since the dead one took it is left over.
        for left in place.parent.glob(f"{place.name}.??????"):
            with suppress(OSError):
                if left.suffix[1:].isalpha() and left.stat().st_mtime_ns >= begun:
                    left.unlink()
        lock.unlock()


def unkept() -> str:
    """Return the file of the settings where what was just set cannot be written, "" where it is."""
    settings = QSettings()
    settings.sync()
    return settings.fileName() if settings.status() is QSettings.Status.AccessError else ""


def check_store() -> None:
    """See whether the settings can be read at all; a file that is no settings is set aside."""
    settings = QSettings()
    clean_store(Path(settings.fileName()))
    settings.sync()
    place = Path(settings.fileName())
    if settings.status() is QSettings.Status.AccessError and place.exists():
        _Faults.said.append(f"the file {place}")
    elif settings.status() is QSettings.Status.FormatError:
        with suppress(OSError):
            os.replace(place, place.with_name(f"{place.name}.{ASIDE}"))
        _Faults.said.append(f"the file {place}")
