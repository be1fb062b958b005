"""The menus and the toolbar of a window, beyond what the table of commands makes by itself."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QDockWidget, QMainWindow, QMenu, QToolBar, QToolButton, QWidget

import resources
from app.commands.command import CommandSet
from app.files.files import Files
from app.theme import icons
from app.widgets.menu_button import open_menu

# Names of commands; None stands for a line between them.
_TOOLS_LEFT = ("open", "save", None, "undo", "redo", None)
_TOOLS_MIDDLE = ("append_segment", "split_segment", "remove_segment", None, "fit")
_TOOLS_RIGHT = ("export_mesh", "screenshot")


class WindowMenus:
    """Presets, recent files and panels as menus, and what is in the toolbar; of one window."""

    def __init__(
        self,
        window: QMainWindow,
        commands: CommandSet,
        files: Files,
        docks: Mapping[str, QDockWidget],
        toolbar: QToolBar,
    ) -> None:
        self._window = window
        self._commands = commands
        self._files = files
        commands["redo"].setShortcuts([QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")])
        self._presets = self._preset_menu()
        self._recent = QMenu("Open recent", window)
        self._recent.aboutToShow.connect(self._fill_recent)
        file_menu = commands.menu("File")
        file_menu.insertMenu(commands["open"], self._presets)
        file_menu.insertMenu(commands["save"], self._recent)
        panels = QMenu("Panels", window)
        for name, dock in docks.items():
            action = dock.toggleViewAction()
            action.setToolTip(f"Show or hide the panel {action.text()}")
            commands.adopt(f"panel_{name}", panels, action, f"Panel: {action.text()}")
        commands.menu("View").insertMenu(commands["reset_layout"], panels)
        self._fill_toolbar(toolbar)

    def _preset_menu(self) -> QMenu:
        menu = QMenu("New from preset", self._window)
        files = self._files
        for preset in resources.presets():
            action = QAction(preset.title, self._window)
            action.setToolTip(preset.description)
            words = f"New: {preset.title}"
            self._commands.adopt(f"preset_{preset.name}", menu, action, words)
            action.triggered.connect(
                lambda _checked=False, name=preset.name: files.new_from_preset(name)
            )
        menu.setToolTipsVisible(True)
        return menu

    def _fill_recent(self) -> None:
        self._recent.clear()
        files = self._files
        paths = files.recent.paths()
        for path in paths:
            action = self._recent.addAction(path.name)
            action.setToolTip(str(path))
            action.triggered.connect(lambda _checked=False, path=path: files.open_path(path))
        if not paths:
            self._recent.addAction("No recent files").setEnabled(False)
            return
        self._recent.addSeparator()
        self._recent.addAction("Clear list").triggered.connect(files.recent.clear)

    def _fill_toolbar(self, bar: QToolBar) -> None:
        bar.clear()
        self._add(bar, _TOOLS_LEFT)
        button = QToolButton(bar)
        button.setText("Presets")
        icons.bind(button, "presets")
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        open_menu(button, self._presets)
        button.setToolTip("Start from a ready-made shape")
        bar.addWidget(button)
        bar.addSeparator()
        self._add(bar, _TOOLS_MIDDLE)
        spring = QWidget(bar)
        spring.setSizePolicy(
            spring.sizePolicy().Policy.Expanding, spring.sizePolicy().Policy.Minimum
        )
        bar.addWidget(spring)
        self._add(bar, _TOOLS_RIGHT)
        for name in _TOOLS_RIGHT:
            tool = bar.widgetForAction(self._commands[name])
            assert isinstance(tool, QToolButton)
            tool.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)

    def _add(self, bar: QToolBar, names: tuple[str | None, ...]) -> None:
        for name in names:
            bar.addAction(self._commands[name]) if name else bar.addSeparator()
