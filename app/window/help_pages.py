"""The sheet of all keys and the about box, made from what the window really offers."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from importlib.metadata import PackageNotFoundError, version

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QTextBrowser, QVBoxLayout, QWidget

from app.commands.command import CommandSet
from app.scene.standard_views import KEYED_VIEWS, STANDARD_VIEWS
from app.viewport.navigation import LETTERS

PROFILE_KEYS = (
    ("Drag", "move a point, a joint or a quartic point Q"),
    ("Arrows, Shift+arrows", "nudge, ten times as far"),
    ("Ctrl while dragging", "do not snap"),
    ("Shift while dragging", "keep to horizontal, vertical or along the leg"),
    ("Alt while dragging", "break the joint's rule for this drag"),
    ("Tab, Shift+Tab", "walk through the points"),
    ("Double-click on the curve", "split there"),
    ("Del", "remove the segment"),
    ("Drag the blue line", "the fill line of a vessel"),
    ("Space+drag or middle drag, wheel, F", "pan, zoom, fit"),
    ("Esc", "cancel the drag"),
    ("Ctrl+C, Ctrl+X, Ctrl+V, Ctrl+D", "copy, cut, paste, duplicate segments or points"),
    ("Drag the frame of several points", "move, scale; Shift in proportion, Alt about the centre"),
    ("Ctrl+T", "scale the selected points by numbers"),
)
VIEW_WORDS = ", ".join(view.words.lower() for view in STANDARD_VIEWS.values() if view.key)
VIEWPORT_KEYS = (
    ("Drag a point or a quartic point Q", "move it in the profile's plane, keys as in the editor"),
    ("Drag the dot over the top", "the axis, towards x, y or z"),
    ("Drag a dot beside the foot", "the turn's start or end; steps of 15°, with Ctrl any angle"),
    ("Left drag elsewhere", "orbit"),
    ("Shift+drag or middle drag", "pan"),
    ("Wheel", "zoom at the cursor"),
    ("Double-click", "orbit about that point"),
    (KEYED_VIEWS, f"{VIEW_WORDS}; with Ctrl from the other side"),
    ("Arrows, Shift+arrows, +, −", "orbit, pan, zoom"),
    ("Click or drag the cube", "look from a face, an edge or a corner; orbit"),
    (", ".join(LETTERS), ", ".join(words for _, words in LETTERS.values())),
)
WINDOW_KEYS = (
    ("Arrows, Enter, Esc in the gallery", "walk, open, leave everything as it is"),
    ("Right, Left, Esc in the guided tour", "next, back, stop"),
    ("Enter, F2, Del in the list of states", "show, rename, delete"),
    ("Esc with one view alone", "bring all views back"),
)
LOOK_KEYS = (
    ("Drag a mark of a gradient", "move it; Left and Right do the same"),
    ("Double-click on a mark, Enter", "choose its colour"),
    ("Double-click beside a mark", "add one"),
    ("Up, Down, Del", "choose the next mark, remove it"),
)
SLIDER_KEYS = (
    ("Arrows or wheel", "step; Shift finer, Ctrl coarser"),
    ("Double-click on the label", "reset"),
    ("Right click", "reset, copy, paste, apply to all, animate"),
    ("12.5/2, 3cm, 1/2 in", "numbers take sums and units"),
)


def shortcuts(parent: QWidget, commands: CommandSet) -> None:
    """Show every shortcut of the window."""
    menus: dict[str, list[tuple[str, str]]] = {}
    for name, command in commands.commands.items():
        keys = commands[name].shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        if keys:
            menus.setdefault(command.menu.partition("/")[0], []).append((keys, command.text))
    tables = [
        ("Profile editor", PROFILE_KEYS),
        ("Viewport", VIEWPORT_KEYS),
        ("Sliders and numbers", SLIDER_KEYS),
        ("Gradients of the Look panel", LOOK_KEYS),
        ("Window", WINDOW_KEYS),
        *menus.items(),
    ]
    _page(parent, "Shortcuts", "".join(_table(title, rows) for title, rows in tables))


def about(parent: QWidget) -> None:
    """Say what the program is and which version."""
    try:
        number = version("sgb-studio")
    except PackageNotFoundError:
        number = "from source"
    _page(
        parent,
        "About SGB Studio",
        f"<h2>SGB Studio</h2><p>Version {escape(number)}</p>"
        "<p>Sculpt rotation surfaces from shape-adjustable generalized Bézier profiles: "
        "λ<sub>1</sub>, λ<sub>2</sub>, λ<sub>3</sub> and ω reshape the curve without moving "
        "its control points.</p>",
    )


def _table(title: str, rows: Iterable[tuple[str, str]]) -> str:
    cells = "".join(
        f"<tr><td width='48%' style='padding:2px 18px 2px 0'><b>{escape(keys)}</b></td>"
        f"<td style='padding:2px 0'>{escape(text)}</td></tr>"
        for keys, text in rows
    )
    return f"<h3>{escape(title)}</h3><table width='100%'>{cells}</table>"


def _page(parent: QWidget, title: str, html: str) -> None:
    dialog = QDialog(parent)
    dialog.setWindowTitle(title)
    browser = QTextBrowser(dialog)
    browser.setHtml(html)
    browser.setAccessibleName(title)
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
    buttons.rejected.connect(dialog.reject)
    layout = QVBoxLayout(dialog)
    layout.addWidget(browser)
    layout.addWidget(buttons)
    dialog.resize(560, 620)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    # The window goes on working beside it.
    dialog.show()
