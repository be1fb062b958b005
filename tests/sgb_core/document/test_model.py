import pytest

from sgb_core.document.model import Unit


def test_units_are_parts_of_the_inch_and_the_litre() -> None:
    assert Unit.CM.millilitres == 1.0
    assert Unit.IN.millilitres == pytest.approx(16.387064, rel=1e-14)
    assert Unit.CM.factor_to(Unit.MM) == 10.0
    assert Unit.IN.factor_to(Unit.CM) == pytest.approx(2.54, rel=1e-15)
    for unit in Unit:
        assert unit.factor_to(unit) == 1.0
