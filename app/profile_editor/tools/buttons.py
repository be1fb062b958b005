"""The tools as small buttons in the profile editor's corner."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QFrame, QToolButton, QVBoxLayout, QWidget

from app.profile_editor.tools.table import TOOLS
from app.theme import icons


class ToolButtons(QFrame):
    """A bar with one button for each tool, the one in use pressed, and switches below them."""

    def __init__(self, take: Callable[[str], object], parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("viewport-buttons")
        self.setAutoFillBackground(True)
        self.setAccessibleName("Tools")
        self.setCursor(Qt.CursorShape.ArrowCursor)
        column = QVBoxLayout(self)
        column.setContentsMargins(2, 2, 2, 2)
        column.setSpacing(0)
        self.buttons: dict[str, QToolButton] = {}
        self.switches: dict[str, QToolButton] = {}
        for kind in TOOLS:
            button = QToolButton(self)
            icons.bind(button, kind.icon)
            button.setIconSize(QSize(16, 16))
            button.setToolTip(f"{kind.tip} ({chr(kind.key)})")
            button.setAccessibleName(f"{kind.words} tool")
            button.setAutoRaise(True)
            button.setCheckable(True)
            # Walked to from elsewhere by F6 and its own key; Tab walks through the points.
            button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            button.clicked.connect(lambda _checked=False, name=kind.name: take(name))
            column.addWidget(button)
            self.buttons[kind.name] = button

    def add_switch(self, action: QAction) -> None:
        """Add a button that switches what an action switches."""
        button = QToolButton(self)
        button.setDefaultAction(action)
        button.setIconSize(QSize(16, 16))
        button.setAccessibleName(action.text())
        button.setAutoRaise(True)
        button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        column = self.layout()
        if column is not None:
            column.addWidget(button)
        self.switches[action.objectName()] = button
        self.adjustSize()

    def show_taken(self, name: str) -> None:
        """Let the button of the tool in use look pressed."""
        for each, button in self.buttons.items():
            if button.isChecked() != (each == name):
                button.setChecked(each == name)
