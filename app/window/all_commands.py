"""Every command of a window, gathered in the order of the menus."""

from __future__ import annotations

from app.commands.analysis import analysis_commands
from app.commands.body import body_commands
from app.commands.clipboard import clipboard_commands
from app.commands.command import Command
from app.commands.edit import edit_commands
from app.commands.fair import fair_commands
from app.commands.focus_walk import walk_commands
from app.commands.guides import guide_commands
from app.commands.joint import joint_commands
from app.commands.scale_dialog import selection_commands
from app.commands.segment import segment_commands
from app.commands.segment_kinds import more_segment_commands
from app.commands.view import view_commands
from app.drawings.commands import drawing_commands
from app.figures.commands import figure_commands, fit_commands
from app.intake.commands import import_commands, picture_commands
from app.profile_editor.tools.commands import tool_commands
from app.window.commands import (
    Window,
    export_commands,
    file_commands,
    gallery_commands,
    help_commands,
    layout_commands,
    look_commands,
    preference_commands,
    state_commands,
    theme_commands,
    welcome_commands,
)


def all_commands(window: Window) -> list[Command]:
    """Return every command of a window whose views and panels stand."""
    presenter, jobs, viewport = window.presenter, window.jobs, window.surface_view
    dialogs, ask_path = window.window(), window.exporting.ask_path
    return [
        *gallery_commands(window),
        *file_commands(window),
        *import_commands(window.importer),
        *edit_commands(presenter),
        *clipboard_commands(presenter, window.importer.paste),
        *selection_commands(presenter, dialogs),
        *body_commands(presenter),
        *tool_commands(window.profile_view),
        *guide_commands(presenter),
        *state_commands(presenter, window.panels),
        *fit_commands(presenter, jobs, dialogs),
        *fair_commands(presenter, jobs, dialogs),
        *preference_commands(window),
        *segment_commands(presenter),
        *more_segment_commands(presenter),
        *joint_commands(presenter),
        *view_commands(presenter, viewport, window.profile_view),
        *picture_commands(window.importer),
        *look_commands(window),
        *theme_commands(window),
        *layout_commands(window),
        *walk_commands(window.walked),
        *analysis_commands(presenter, window.panels.docks["curvature"]),
        *export_commands(window),
        *drawing_commands(window.exporting, presenter, dialogs),
        *figure_commands(presenter, jobs, viewport, ask_path, dialogs),
        *welcome_commands(window),
        *help_commands(window),
    ]
