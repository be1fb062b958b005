"""What the shape itself is asked for: to be fair, at once or as chosen, and to reach targets."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QDialog, QWidget

from app.commands.command import Command
from app.state.jobs import Jobs
from app.state.presenter import Presenter

if TYPE_CHECKING:
    from app.commands.fairing import Fairing

LIVE_TIP = (
    "While a point is dragged or nudged the sliders of the segments beside it move by themselves "
    "to the fairest curvature; locks and joints' rules hold, no other point moves"
)


def fair_commands(presenter: Presenter, jobs: Jobs, window: QWidget) -> list[Command]:
    """Return what makes the profile fair or reach targets; dialogs stand beside ``window``."""

    @cache
    def fairing() -> Fairing:
        # Imported when it is wanted: the window starts without.
        from app.commands.fairing import Fairing

        return Fairing(presenter, jobs)

    def ask() -> None:
        from app.commands.fair_dialog import FairDialog

        _open(window.findChild(FairDialog) or FairDialog(presenter, fairing(), window))

    def reach() -> None:
        from app.commands.targets_dialog import TargetsDialog

        _open(window.findChild(TargetsDialog) or TargetsDialog(presenter, jobs, window))

    def vary() -> None:
        from app.commands.variants_dialog import VariantsDialog

        _open(window.findChild(VariantsDialog) or VariantsDialog(presenter, jobs, window))

    return [
        Command(
            "make_fair",
            "Edit",
            "Make fair (smooth)",
            lambda: fairing().start(),
            "Ctrl+L",
            tip="Give the selected points' segments, or the whole profile, the fairest curvature "
            "by shape parameters alone, or as last chosen",
            separator=True,
        ),
        Command(
            "make_fair_by",
            "Edit",
            "Make fair (smooth) by…",
            ask,
            "Ctrl+Shift+L",
            tip="Choose what a fair curve has least of, what may move and what is kept",
        ),
        _live(fairing),
        _reach(reach),
        _variants(vary),
    ]


def _open(dialog: QDialog) -> None:
    dialog.show()
    dialog.raise_()


def _live(fairing: Callable[[], Fairing]) -> Command:
    return Command(
        "live_fair",
        "Edit",
        "Live fair",
        lambda: fairing().toggle_live(),
        "Ctrl+Alt+L",
        icon="live-fair",
        tip=LIVE_TIP,
        state=lambda frame: frame.view.live_fair is not None,
    )


def _reach(run: Callable[[], object]) -> Command:
    return Command(
        "reach_targets",
        "Edit",
        "Reach targets…",
        run,
        "Ctrl+Shift+T",
        tip="Capacity, volume, material, mass, height and diameters together, by the mildest "
        "change, the size or one slider; seen while the values are typed",
    )


def _variants(run: Callable[[], object]) -> Command:
    return Command(
        "variants",
        "Edit",
        "Variants…",
        run,
        "Ctrl+Alt+V",
        tip="A sheet of small pictures of the same object, each with all locks and joints' rules "
        "kept, the fairest first; a click takes one",
    )
