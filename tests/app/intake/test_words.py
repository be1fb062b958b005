"""What the sheet says of a trace."""

from __future__ import annotations

import numpy as np
import pytest

from app.intake.words import told_holding
from sgb_core.design.tracing import trace
from sgb_core.document.model import Unit
from sgb_core.sources import Taken
from sgb_core.sources.uncertainty import Holding

LINE = np.array([[20.0, 0.0], [22.0, 30.0], [20.0, 60.0]])


@pytest.mark.parametrize(
    ("unit", "found", "said"),
    [
        (Unit.MM, Holding(350e3, 4.2e3, 1e3, 0.0), "Holds 350 ml ± 4.3 (scale 4.2, curve 1)"),
        (
            Unit.MM,
            Holding(2.521e7, 3e4, 3.2e5, 0.0),
            "Holds 25.21 l ± 0.32 (scale 0.03, curve 0.32)",
        ),
        (Unit.CM, Holding(987654.0, 1e3, 0.0, 0.0), "Holds 987.7 l ± 1 (scale 1)"),
    ],
)
def test_what_it_holds_is_read_in_litres_where_it_is_much(
    unit: Unit, found: Holding, said: str
) -> None:
    taken = Taken(trace(LINE, 0.1), unit, "jar.png", "picture", (0.0,), LINE)
    assert told_holding(found, taken) == said
