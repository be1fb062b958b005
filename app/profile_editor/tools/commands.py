"""The tools of the profile editor as commands, so that menus and palette offer them."""

from __future__ import annotations

from functools import partial
from typing import Protocol

from app.commands.command import Command
from app.profile_editor.tools.table import TOOLS
from app.state.presenter import Frame


class Editor(Protocol):
    """The profile editor as these commands know it."""

    def take(self, tool: str) -> None:
        """Take a tool by its name, with the focus."""


def tool_commands(editor: Editor) -> list[Command]:
    """Return one command for each tool; its key works in the editor only, and stands in its tip."""
    return [
        Command(
            f"tool_{kind.name}",
            "Edit/Tools",
            f"{kind.words} tool",
            partial(editor.take, kind.name),
            icon=kind.icon,
            tip=f"{kind.tip} ({chr(kind.key)} in the profile editor)",
            state=partial(_taken, kind.name),
        )
        for kind in TOOLS
    ]


def _taken(name: str, frame: Frame) -> bool:
    return frame.view.tool == name
