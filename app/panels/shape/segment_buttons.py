"""The row of buttons below the cards: what can be done with the segments."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QToolButton, QWidget

from app.commands.command import Command
from app.commands.segment import segment_commands
from app.state.presenter import Presenter
from app.theme import icons

_BUTTONS = (
    "append_segment",
    "insert_segment",
    "split_segment",
    "reverse_segment",
    "remove_segment",
)


def segment_buttons(
    parent: QWidget, presenter: Presenter, run: Callable[[Command, bool], None]
) -> tuple[QHBoxLayout, dict[str, QToolButton], list[tuple[QToolButton, Command]]]:
    """Return the row, its buttons by their commands' names, and those that are not always on.

    A click calls ``run`` with the command and what the button says of itself.
    """
    commands = {command.name: command for command in segment_commands(presenter)}
    buttons: dict[str, QToolButton] = {}
    conditions: list[tuple[QToolButton, Command]] = []
    row = QHBoxLayout()
    row.setContentsMargins(8, 6, 8, 8)
    row.setSpacing(0)
    for name in _BUTTONS:
        command = commands[name]
        button = QToolButton(parent)
        icons.bind(button, command.icon)
        button.setIconSize(QSize(20, 20))
        button.setToolTip(command.tip or command.text)
        button.setAccessibleName(command.text)
        place = {_BUTTONS[0]: "first", _BUTTONS[-1]: "last"}.get(name, "middle")
        button.setProperty("segment", place)
        button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        button.clicked.connect(partial(run, command))
        if command.enabled is not None:
            conditions.append((button, command))
        buttons[name] = button
        row.addWidget(button, 1)
    return row, buttons, conditions
