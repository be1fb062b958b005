"""The View menu's means to look into a shape: comparison, influence, curvature."""

from __future__ import annotations

from functools import partial

from PySide6.QtWidgets import QWidget

from app.commands.command import Command
from app.state.overlays import Overlay
from app.state.presenter import Frame, Presenter
from app.state.view_state import Compare
from sgb_core.curves.segment import PARAMETERS, SYMBOLS, ParameterName

LONGER = 1.25
LEAST_COMB, MOST_COMB = 0.1, 10.0
# What colours the surface until a slider is used.
FIRST_FOLLOWED: ParameterName = "lambda2"

_COMPARED: tuple[tuple[Compare, str, str, str], ...] = (
    (
        "saved",
        "Last save",
        "Ctrl+Alt+B",
        "Lay the document as it was last saved over the present one",
    ),
    (
        "cubic",
        "Plain cubic (ω = 0)",
        "Ctrl+Alt+C",
        "Lay the cubic Bézier curves of the same control points over the present shape",
    ),
)


def analysis_commands(presenter: Presenter, plot: QWidget) -> list[Command]:
    """Return the commands that compare, colour and measure what is shown.

    ``plot`` is the dock of the curvature plot.
    """
    return [*_comparing(presenter), *_colouring(presenter), *_measuring(presenter, plot)]


def _comparing(presenter: Presenter) -> list[Command]:
    return [
        Command(
            f"compare_{name}",
            "View/Compare with",
            text,
            partial(_toggle_compare, presenter, name),
            keys,
            tip=tip,
            state=partial(_compares, name),
        )
        for name, text, keys, tip in _COMPARED
    ]


def _colouring(presenter: Presenter) -> list[Command]:
    fixed = [
        Command(
            f"influence_{name}",
            "View/Influence",
            f"Influence of {SYMBOLS[name]}",
            partial(_toggle_influence, presenter, name),
            f"Alt+Shift+{number}",
            tip=f"Colour the surface by how far each point moves per unit of {SYMBOLS[name]}:\n"
            "the exact derivative, without what a joint's rule moves besides.",
            state=partial(_colours, name),
        )
        for number, name in enumerate(PARAMETERS, start=1)
    ]
    following = Command(
        "influence_follows",
        "View/Influence",
        "Influence of the slider in use",
        lambda: _toggle_following(presenter),
        f"Alt+Shift+{len(PARAMETERS) + 1}",
        tip="Colour the surface by the influence of the slider that is pointed at or dragged",
        state=lambda frame: frame.view.influence_follows,
    )
    return [*fixed, following]


def _measuring(presenter: Presenter, plot: QWidget) -> list[Command]:
    return [
        Command(
            "curvature_plot",
            "View",
            "Curvature plot",
            lambda: _toggle_plot(presenter, plot),
            "Ctrl+Alt+K",
            "comb",
            "Plot the curvature over the length of the profile",
            state=lambda _frame: not plot.isHidden(),
        ),
        Command(
            "comb_longer",
            "View",
            "Longer curvature comb",
            lambda: _scale_comb(presenter, LONGER),
            "Ctrl+Alt+Up",
            enabled=_shows_comb,
        ),
        Command(
            "comb_shorter",
            "View",
            "Shorter curvature comb",
            lambda: _scale_comb(presenter, 1.0 / LONGER),
            "Ctrl+Alt+Down",
            enabled=_shows_comb,
        ),
    ]


def _compares(name: Compare, frame: Frame) -> bool:
    return frame.view.compare == name


def _colours(name: ParameterName, frame: Frame) -> bool:
    return _fixed_influence(frame) == name


def _shows_comb(frame: Frame) -> bool:
    return frame.view.shows(Overlay.COMB)


def _toggle_compare(presenter: Presenter, name: Compare) -> None:
    off = presenter.view.compare == name
    presenter.set_view(compare=None if off else name, ghost_state=None, before=None)
    if not off and name == "saved" and presenter.session.saved_document is None:
        presenter.notify("This document has not been saved yet: nothing to compare with.", "info")


def _toggle_influence(presenter: Presenter, name: ParameterName) -> None:
    off = _fixed_influence(presenter) == name
    presenter.set_view(influence=None if off else name, influence_follows=False)


def _fixed_influence(shown: Frame | Presenter) -> ParameterName | None:
    """Return the parameter that was chosen by name, None where it follows the sliders."""
    return None if shown.view.influence_follows else shown.view.influence


def _toggle_following(presenter: Presenter) -> None:
    view = presenter.view
    if view.influence_follows:
        presenter.set_view(influence=None, influence_follows=False)
    else:
        presenter.set_view(influence=view.influence or FIRST_FOLLOWED, influence_follows=True)


def _toggle_plot(presenter: Presenter, plot: QWidget) -> None:
    plot.setVisible(plot.isHidden())
    presenter.refresh_now()


def _scale_comb(presenter: Presenter, factor: float) -> None:
    length = presenter.view.comb_length * factor
    presenter.set_view(comb_length=min(max(length, LEAST_COMB), MOST_COMB))
