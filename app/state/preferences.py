"""What the user prefers, kept between sessions: typed, checked, with one signal for a change."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from typing import Any, Literal, get_args

from PySide6.QtCore import QObject, QSettings, Signal

from sgb_core.document.model import Unit

NavigationStyle = Literal["studio", "blender", "rhino", "fusion"]
STYLES: tuple[NavigationStyle, ...] = get_args(NavigationStyle)
TEXT_PERCENT = (80, 200)
AUTOSAVE_SECONDS = (0, 600)


@dataclass(frozen=True, slots=True)
class Preferences:
    """All preferences but the theme and the keys, which have stores of their own.

    ``snap_step`` is in the document's unit, 0 for the step of the grid that is seen;
    ``autosave_seconds`` is how often unsaved work is set aside, 0 for never.
    """

    navigation_style: NavigationStyle = "studio"
    animate_views: bool = True
    invert_wheel: bool = False
    snap_step: float = 0.0
    new_unit: Unit = Unit.MM
    autosave_seconds: int = 5
    text_percent: int = 100
    gallery_at_start: bool = False


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


def change(**fields: Any) -> None:
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


def stored_words(key: str) -> list[str]:
    """Return the texts kept under a key of the settings, which give a single one back bare."""
    stored = QSettings().value(key, [])
    if isinstance(stored, str):
        return [stored]
    return [str(each) for each in stored] if isinstance(stored, list) else []


def stored_number(key: str, usual: float) -> float:
    """Return the number kept under a key of the settings, ``usual`` where there is none."""
    stored = QSettings().value(key, usual, float)
    return stored if isinstance(stored, float) else usual


def _read() -> Preferences:
    """Return what is stored; what is missing or makes no sense takes its default."""
    settings, default = QSettings(), Preferences()
    found: dict[str, Any] = {}
    for name, fallback in asdict(default).items():
        text = str(settings.value(name, fallback))
        try:
            found[name] = _parsed(name, text, fallback)
        except ValueError:
            found[name] = fallback
    return Preferences(**found)


def _parsed(name: str, text: str, fallback: object) -> object:
    if name == "navigation_style":
        if text not in STYLES:
            raise ValueError(text)
        return text
    if isinstance(fallback, Unit):
        return Unit(text)
    if isinstance(fallback, bool):
        return text.lower() in ("true", "1")
    if isinstance(fallback, int):
        low, high = TEXT_PERCENT if name == "text_percent" else AUTOSAVE_SECONDS
        return min(high, max(low, int(text)))
    number = float(text)
    if not 0.0 <= number < 1e9:
        raise ValueError(text)
    return number
