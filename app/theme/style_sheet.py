"""The style sheet of the window, built from a palette.

Property selectors used by the views: ``role="primary"`` (the button that does the main thing),
``role="flat"`` (a tool button without a frame), ``role="muted"``, ``role="heading"``,
``role="error"``, ``role="warning"`` and ``role="good"`` (labels), ``segment="first|middle|last|
only"`` (buttons that form one control), ``invalid="true"`` (a field whose text is refused),
``role="card"`` with ``selected``, ``role="chip"`` with ``state="good|bad|plain"``.
"""

from __future__ import annotations

from dataclasses import asdict
from string import Template

import resources
from app.theme.palette import Palette

_SHEET = Template("""
QToolTip { background: $panel; color: $text; border: 1px solid $border; padding: 4px 6px; }
QMainWindow, QDialog { background: $window; }
QMainWindow::separator { background: $window; width: 5px; height: 5px; }
QMainWindow::separator:hover { background: $accent; }
QSplitter::handle { background: $window; }
QSplitter::handle:hover { background: $accent; }

QMenuBar { background: $window; color: $text; padding: 1px 4px; }
QMenuBar::item { background: transparent; padding: 4px 9px; border-radius: 4px; }
QMenuBar::item:selected { background: $hover; }
QMenuBar::item:pressed { background: $pressed; }
QMenu { background: $panel; color: $text; border: 1px solid $border; padding: 4px; }
QMenu::item { padding: 5px 26px 5px 24px; border-radius: 4px; }
QMenu::item:selected { background: $accent; color: $accent_text; }
QMenu::item:disabled { color: $text_disabled; background: transparent; }
QMenu::separator { height: 1px; background: $border; margin: 4px 8px; }
QMenu::icon { padding-left: 5px; }
QToolBar { background: $window; border: none; padding: 2px 4px; spacing: 2px; }
QToolBar::separator { background: $border; width: 1px; margin: 5px 4px; }
QStatusBar { background: $window; color: $text_muted; border-top: 1px solid $border; }
QStatusBar::item { border: none; }

QDockWidget { color: $text_muted; font-weight: 600;
  titlebar-close-icon: url($dock_close); titlebar-normal-icon: url($dock_float); }
QDockWidget::title { background: $window; padding: 5px 8px; text-align: left; }
QTabBar { qproperty-elideMode: ElideNone; }
QTabBar::tab { background: transparent; color: $text_muted; padding: 5px 10px;
  border-bottom: 2px solid transparent; }
QTabBar::tab:right { padding: 10px 5px; border-bottom: none; border-left: 2px solid transparent; }
QTabBar::tab:right:selected { border-left-color: $accent; }
QTabBar::tab:selected { color: $text; border-bottom-color: $accent; }
QTabBar::tab:hover { color: $text; background: $hover; }
QTabBar::tab:focus { color: $text; background: $hover; }
QTabWidget::pane { border: none; border-top: 1px solid $border; }

QToolButton { background: transparent; color: $text; border: 1px solid transparent;
  border-radius: 5px; padding: 3px; }
QToolButton:hover { background: $hover; }
QToolButton:pressed { background: $pressed; }
QToolButton:checked { background: $selected; border-color: $accent; }
QToolButton:focus { border-color: $accent; }
QToolButton:disabled { color: $text_disabled; }
QToolButton[popupMode="1"] { padding-right: 15px; }
QToolButton::menu-indicator { image: none; }
QToolButton[segment] { background: $field; border-color: $border; border-radius: 0px;
  padding: 4px 6px; }
QToolButton[segment="first"] { border-top-left-radius: 5px; border-bottom-left-radius: 5px;
  border-right-width: 0px; }
QToolButton[segment="middle"] { border-right-width: 0px; }
QToolButton[segment="last"] { border-top-right-radius: 5px; border-bottom-right-radius: 5px; }
QToolButton[segment="only"] { border-radius: 5px; }
QToolButton[segment]:hover { background: $hover; }
QToolButton[segment]:checked { background: $accent; color: $accent_text; border-color: $accent; }
QToolButton[segment]:focus { border: 1px solid $text; }

QPushButton { background: $field; color: $text; border: 1px solid $border; border-radius: 5px;
  padding: 4px 12px; }
QPushButton:hover { background: $hover; }
QPushButton:pressed { background: $pressed; }
QPushButton:focus { border-color: $accent; }
QPushButton:default, QPushButton[role="primary"] { background: $accent; color: $accent_text;
  border-color: $accent; }
QPushButton:default:focus, QPushButton[role="primary"]:focus { border: 2px solid $text;
  padding: 3px 11px; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QPushButton:disabled { color: $text_disabled; background: $window; border-color: $groove; }

QLineEdit, QTextEdit, QPlainTextEdit { background: $field; color: $text;
  border: 1px solid $border; border-radius: 4px; padding: 2px 4px;
  selection-background-color: $accent; selection-color: $accent_text; }
QLineEdit:hover { border-color: $axis; }
QLineEdit:focus, QTextEdit:focus, QPlainTextEdit:focus { border-color: $accent; }
QLineEdit:disabled { color: $text_disabled; background: $window; }
QLineEdit:read-only { background: $panel; }
QLineEdit[invalid="true"] { color: $error; border-color: $error; }
QAbstractSpinBox { background: $field; color: $text; border: 1px solid $border;
  border-radius: 4px; padding: 2px 4px; }
QAbstractSpinBox:focus { border-color: $accent; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { width: 0px; border: none; }

QComboBox { background: $field; color: $text; border: 1px solid $border; border-radius: 4px;
  padding: 2px 4px 2px 7px; }
QComboBox:hover { background: $hover; }
QComboBox:focus, QComboBox:on { border-color: $accent; }
QComboBox:disabled { color: $text_disabled; background: $window; }
QComboBox::drop-down { border: none; width: 17px; }
QComboBox::down-arrow { image: url($arrow_down); width: 11px; height: 11px; }
QComboBox QAbstractItemView { background: $panel; color: $text; border: 1px solid $border;
  outline: none; selection-background-color: $accent; selection-color: $accent_text; }

QCheckBox, QRadioButton { color: $text; spacing: 7px; padding: 2px; border-radius: 4px; }
QCheckBox:disabled, QRadioButton:disabled { color: $text_disabled; }
QCheckBox::indicator { width: 14px; height: 14px; border: 1px solid $axis; border-radius: 4px;
  background: $field; }
QCheckBox::indicator:hover { border-color: $accent; }
QCheckBox::indicator:focus { border: 2px solid $accent; }
QCheckBox::indicator:checked { background: $accent; border-color: $accent;
  image: url($tick); }
QCheckBox::indicator:checked:focus { border: 1px solid $text; }
QRadioButton::indicator { width: 14px; height: 14px; border: 1px solid $axis; border-radius: 8px;
  background: $field; }
QRadioButton::indicator:hover { border-color: $accent; }
QRadioButton::indicator:focus { width: 12px; height: 12px; border: 2px solid $accent; }
QRadioButton::indicator:checked { width: 6px; height: 6px; border: 5px solid $accent; }
QRadioButton::indicator:checked:focus { width: 8px; height: 8px; border: 4px solid $accent; }
QRadioButton::indicator:disabled { border-color: $groove; background: $window; }
QCheckBox::indicator:disabled { border-color: $groove; background: $window; }

QScrollArea { background: $panel; border: none; }
QScrollArea > QWidget > QWidget { background: $panel; }
QScrollBar:vertical { background: transparent; width: 11px; margin: 0; }
QScrollBar::handle:vertical { background: $groove; border-radius: 4px; min-height: 28px;
  margin: 2px 2px 2px 2px; }
QScrollBar:horizontal { background: transparent; height: 11px; margin: 0; }
QScrollBar::handle:horizontal { background: $groove; border-radius: 4px; min-width: 28px;
  margin: 2px 2px 2px 2px; }
QScrollBar::handle:hover { background: $axis; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }

QTableView, QTreeView, QListView { background: $field; alternate-background-color: $panel;
  color: $text; border: 1px solid $border; gridline-color: $grid_major; outline: none;
  selection-background-color: $selected; selection-color: $text; }
QTableView:focus, QTreeView:focus, QListView:focus { border-color: $accent; }
QTableView::item:focus { border: 1px solid $accent; }
QHeaderView { background: $panel; }
QHeaderView::section { background: $panel; color: $text_muted; border: none;
  border-bottom: 1px solid $border; padding: 3px 6px; }
QTableCornerButton::section { background: $panel; border: none; }

QProgressBar { background: $groove; color: $text; border: none; border-radius: 4px;
  text-align: center; min-height: 8px; }
QProgressBar::chunk { background: $selected; border-bottom: 4px solid $accent; }
QGroupBox { color: $text_muted; border: 1px solid $border; border-radius: 6px;
  margin-top: 10px; padding-top: 6px; }
QGroupBox::title { subcontrol-origin: margin; left: 9px; padding: 0 4px; }

QLabel[role="muted"] { color: $text_muted; }
QLabel[role="heading"] { color: $text_muted; font-weight: 600; }
QLabel[role="error"] { color: $error; }
QLabel[role="warning"] { color: $warning; }
QLabel[role="good"] { color: $good; }
QFrame[role="rule"] { background: $border; border: none; }

QFrame[role="card"] { background: $field; border: 1px solid $border; border-radius: 7px; }
QFrame[role="card"][selected="true"] { border-color: $accent; border-left: 3px solid $accent; }
QPushButton[role="title"] { background: transparent; border: 1px solid transparent;
  font-weight: 600; text-align: left; padding: 2px 4px; }
QPushButton[role="title"]:hover { background: $hover; }
QPushButton[role="title"]:focus { border-color: $accent; }
QFrame[role="card"] QLineEdit { background: $panel; }
QFrame[role="card"] QLineEdit:focus { background: $field; }
QFrame[role="card"] QComboBox { background: $panel; }
QFrame[role="overlay"] { background: $panel; border: 1px solid $border; border-radius: 10px; }
QWidget#noticeBar { background: $panel; border: 1px solid $border; border-radius: 7px; }
QWidget#noticeBar[level="warning"] { border: 2px solid $warning; }
QWidget#noticeBar[level="error"] { border: 2px solid $error; }
QDialog[role="overlay"] { background: $panel; border: 1px solid $border; }
QFrame[role="overlay"] QListView { background: transparent; border: 1px solid transparent; }
QFrame[role="overlay"] QListView:focus { border-color: $border; border-radius: 6px; }
QLabel[role="chip"] { color: $text_muted; border: 1px solid $border; border-radius: 7px;
  padding: 0px 5px; margin: 2px 0px; }
QLabel[role="chip"][state="good"] { color: $good; border-color: $good; }
QLabel[role="chip"][state="bad"] { color: $warning; border-color: $warning; }
""")


def style_sheet(palette: Palette) -> str:
    """Return the application's style sheet in the colours of ``palette``."""
    icons = resources.path("icons")
    drawn = {
        place: (icons / f"style-{icon}-{palette.name}.svg").as_posix()
        for place, icon in (
            ("arrow_down", "arrow"),
            ("tick", "tick"),
            ("dock_close", "close"),
            ("dock_float", "float"),
        )
    }
    return _SHEET.substitute(asdict(palette), **drawn)
