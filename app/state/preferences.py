"""What the user prefers, kept between sessions: typed, checked, with one signal for a change."""

from __future__ import annotations

from dataclasses import asdict, replace
from functools import partial
from typing import Any, Literal, TypedDict, Unpack, get_args

from PySide6.QtCore import QObject, QSettings, Signal

from app.state.stored import flag, number, one_of, stored, text
from sgb_core.document.unit import Unit
from sgb_core.values import dataclass

NavigationStyle = Literal["studio", "blender", "rhino", "fusion"]
STYLES: tuple[NavigationStyle, ...] = get_args(NavigationStyle)
TEXT_PERCENT = (80, 200)
LARGEST_STEP = 1e6


@dataclass(frozen=True, slots=True)
class Preferences:
    """All preferences but the theme and the keys, which have stores of their own.

    ``snap_step`` is in the document's unit, 0 for the step of the grid that is seen.
    ``scale_legs`` lets a joint that is dragged keep its legs in proportion to the chords instead of
    carrying them; ``cross_axis`` lets points be dragged through the axis. ``printer`` is the name
    of the printer chosen last, ``print_layer`` its layer in mm.
    """

    navigation_style: NavigationStyle = "studio"
    animate_views: bool = True
    invert_wheel: bool = False
    snap_step: float = 0.0
    new_unit: Unit = Unit.MM
    text_percent: int = 100
    gallery_at_start: bool = False
    scale_legs: bool = False
    cross_axis: bool = False
    printer: str = ""
    print_layer: float = 0.0


class Notifier(QObject):
    """Tells, with the new preferences, that something was changed."""

    changed = Signal(object)


class _State:
    """Read once and kept; one per process, as QSettings is."""

    present: Preferences | None = None
    notifier: Notifier | None = None


def current() -> Preferences:
    """Return the preferences in force."""
    if _State.present is None:
        _State.present = _read()
    return _State.present


def notifier() -> Notifier:
    """Return the object whose ``changed`` signal follows every change."""
    if _State.notifier is None:
        _State.notifier = Notifier()
    return _State.notifier


class Changes(TypedDict, total=False):
    """What :func:`change` takes: the fields of Preferences."""

    navigation_style: NavigationStyle
    animate_views: bool
    invert_wheel: bool
    snap_step: float
    new_unit: Unit
    text_percent: int
    gallery_at_start: bool
    scale_legs: bool
    cross_axis: bool
    printer: str
    print_layer: float


def change(**fields: Unpack[Changes]) -> None:
    """Change preferences, remember them and tell everybody."""
    changed = replace(current(), **fields)
    if changed == current():
        return
    settings = QSettings()
    for name in fields:
        settings.setValue(name, str(getattr(changed, name)))
    _State.present = changed
    notifier().changed.emit(changed)


def reload() -> Preferences:
    """Read the stored preferences afresh, as at the start of the program."""
    _State.present = None
    return current()


def _read() -> Preferences:
    """Return what is stored; what is missing or makes no sense takes its default."""
    found: dict[str, Any] = {
        name: stored(name, fallback, partial(_taken, name, fallback))
        for name, fallback in asdict(Preferences()).items()
    }
    return Preferences(**found)


def _taken(name: str, fallback: object, value: object) -> object:
    if name == "navigation_style":
        return one_of(value, STYLES)
    if isinstance(fallback, Unit):
        return Unit(str(value))
    if isinstance(fallback, str):
        return text(value)
    if isinstance(fallback, bool):
        return flag(value)
    if isinstance(fallback, int):
        return int(number(value, *TEXT_PERCENT))
    return number(value, 0.0, LARGEST_STEP)
