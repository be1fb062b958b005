"""The segment of a slider, shown large over the editor while the slider is pointed at."""

import numpy as np
import pytest
from PySide6.QtCore import QPointF
from PySide6.QtGui import QImage

import resources
import sgb_core
from app.hand.coordinates import Area, ScreenPoint
from app.profile_editor.inset import inset_area
from app.state.view_state import Hover
from tests.app.mouse import hover
from tests.app.profile_editor.bench import Bench, vase

AREA = Area(40.0, 0.0, 340.0, 560.0)


@pytest.mark.parametrize("corner", [(60, 20), (320, 20), (60, 540), (320, 540)])
def test_it_lies_inside_and_clear_of_its_segment(corner):
    places = np.array(corner) + np.array([(-15.0, -15.0), (15.0, 15.0)])
    found = inset_area(AREA, places)
    assert AREA.left <= found.left < found.right <= AREA.right
    assert AREA.top <= found.top < found.bottom <= AREA.bottom
    apart = (places[:, 0].max() < found.left or places[:, 0].min() > found.right) or (
        places[:, 1].max() < found.top or places[:, 1].min() > found.bottom
    )
    assert apart


def test_a_large_segment_and_a_small_picture_have_none():
    large = np.array([(60.0, 20.0), (320.0, 500.0)])
    assert inset_area(AREA, large) is None
    small = np.array([(60.0, 20.0), (70.0, 30.0)])
    assert inset_area(Area(0.0, 0.0, 150.0, 150.0), small) is None


def grabbed(bench):
    bench.settle()
    return bench.view.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)


def test_it_shows_while_a_slider_is_pointed_at_and_gives_way_to_the_hand(qtbot):
    bench = Bench(qtbot, vase())
    for _ in range(3):
        bench.view.zoom(0.6, _at(bench))
    plain = grabbed(bench)
    bench.presenter.set_view(hover=Hover("lambda2", 0))
    lit = grabbed(bench)
    places = bench.view.transform.map(bench.document.profile[0].points)
    area = inset_area(bench.view.area, places)
    assert area is not None
    middle = QPointF((area.left + area.right) / 2.0, (area.top + area.bottom) / 2.0)
    changed = _changed(plain, lit, area)
    assert changed > 0.02
    # The pointer in the editor takes hold of things: nothing may cover them.
    hover(bench.view, middle)
    bench.presenter.set_view(hover=Hover("lambda2", 0))
    assert _changed(lit, grabbed(bench), area) > 0.02
    bench.presenter.set_view(hover=None)


def _at(bench):
    area = bench.view.area
    return ScreenPoint((area.left + area.right) / 2.0, (area.top + area.bottom) / 2.0)


def _changed(first, second, area):
    """The share of an area's points, every third, that differ between two pictures."""
    count = total = 0
    for x in range(round(area.left) + 2, round(area.right) - 2, 3):
        for y in range(round(area.top) + 2, round(area.bottom) - 2, 3):
            total += 1
            count += first.pixel(x, y) != second.pixel(x, y)
    return count / total


def test_in_the_smallest_window_a_shoulder_is_shown_large(qtbot):
    bench = Bench(qtbot, sgb_core.load(resources.presets()[0].file))
    bench.view.resize(380, 370)
    bench.view.fit()
    plain = grabbed(bench)
    bench.presenter.set_view(hover=Hover("lambda2", 2))
    lit = grabbed(bench)
    places = bench.view.transform.map(bench.document.profile[2].points)
    area = inset_area(bench.view.area, places)
    assert area is not None
    assert _changed(plain, lit, area) > 0.1
