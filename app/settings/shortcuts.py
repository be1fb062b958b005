"""The keys of the actions: which were given by the user, and which two actions share one."""

from __future__ import annotations

from PySide6.QtCore import QSettings
from PySide6.QtGui import QKeySequence

from app.commands.command import CommandSet
from app.state.stored import stored

_GROUP = "keys"


class Keys:
    """The shortcuts of one window's actions, the user's own in place of the given ones."""

    def __init__(self, commands: CommandSet) -> None:
        self._commands = commands
        self._given = {name: action.shortcuts() for name, action in commands.actions.items()}
        self.load()

    def load(self) -> None:
        """Take over what is stored, as after a change in another window."""
        for name, action in self._commands.actions.items():
            wanted = stored(f"{_GROUP}/{name}", self._given[name], _sequences)
            if action.shortcuts() != wanted:
                action.setShortcuts(wanted)
                self._commands.retip(name)

    def text(self, name: str) -> str:
        """Return the key of an action as it is written on this system, "" for none."""
        return self._commands[name].shortcut().toString(QKeySequence.SequenceFormat.NativeText)

    def is_own(self, name: str) -> bool:
        """Whether the user has given this action another key than it came with."""
        return QSettings().contains(f"{_GROUP}/{name}")

    def give(self, name: str, key: QKeySequence) -> None:
        """Give an action a key of the user's own; an empty one takes its key away."""
        given = self._given[name]
        if key == (given[0] if given else QKeySequence()):
            QSettings().remove(f"{_GROUP}/{name}")
        else:
            text = key.toString(QKeySequence.SequenceFormat.PortableText)
            QSettings().setValue(f"{_GROUP}/{name}", text)
        self.load()

    def reset(self, name: str | None = None) -> None:
        """Give one action, or all, the keys they came with."""
        QSettings().remove(_GROUP if name is None else f"{_GROUP}/{name}")
        self.load()

    def sharing(self, name: str) -> list[str]:
        """Return the names of the other actions that answer to a key of this one."""
        keys = {key.toString() for key in self._commands[name].shortcuts()} - {""}
        return [
            other
            for other, action in self._commands.actions.items()
            if other != name and keys & {key.toString() for key in action.shortcuts()}
        ]


def _sequences(value: object) -> list[QKeySequence]:
    """Return the key that is stored, none for "": then the action's own was taken away."""
    if not isinstance(value, str):
        raise TypeError(value)
    sequence = QKeySequence(value)
    # Names that Qt does not know are read as an unknown key, or as none at all.
    if value and (sequence.isEmpty() or not sequence.toString()):
        raise ValueError(value)
    return [sequence] if value else []
