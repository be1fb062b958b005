"""A quartic point under the pointer lights up its parameter's range in both views."""

from __future__ import annotations

from app.hand.hit_test import Handle, Target
from app.state.presenter import Presenter
from app.state.view_state import Hover
from sgb_core.curves.segment import LAMBDAS


class QuarticLight:
    """Shows the range of a quartic point that is pointed at, as its slider would."""

    def __init__(self, presenter: Presenter) -> None:
        self._presenter = presenter
        self._lit: Hover | None = None

    def show(self, held: object) -> None:
        """Light up the range of ``held`` where it is a quartic point, else put out what is lit."""
        hover = None
        if isinstance(held, Handle) and held.target is Target.QUARTIC:
            hover = Hover(LAMBDAS[held.index], held.segment)
        # Who leaves a slider may have put this light out meanwhile.
        gone = hover is not None and self._presenter.view.hover != hover
        if hover != self._lit or gone:
            self._lit = hover
            self._presenter.set_view(hover=hover)

    def forget(self) -> None:
        """Leave the light to the drag that begins or has ended."""
        self._lit = None
