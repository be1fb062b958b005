"""The small pictures beside the sliders: each shows the range of its own parameter."""

import pytest
from PySide6.QtGui import QImage

from app.panels.shape.parameter_picture import HEIGHT, WIDTH, ParameterPicture
from app.theme import theme
from sgb_core.curves.segment import Segment, ShapeParameters
from tests.app.waiting import let_turn, show

BELLY = Segment([(26, 0), (64, 22), (20, 66), (34, 100)], ShapeParameters(1, 3, 1, 1))


@pytest.fixture
def drawn(qtbot, qapp):
    theme.apply(qapp, "light")

    def draw(parameter, segment):
        picture = ParameterPicture(parameter, None)
        qtbot.addWidget(picture)
        show(qtbot, picture)
        picture.show_segment(segment)
        let_turn()
        return picture.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)

    return draw


def ink(image):
    """Where a picture differs from its corner."""
    ground = image.pixel(0, 0)
    return {(x, y) for x in range(WIDTH) for y in range(HEIGHT) if image.pixel(x, y) != ground}


def test_each_slider_has_a_picture_of_its_own(drawn):
    shown = [ink(drawn(name, BELLY)) for name in ("lambda1", "lambda2", "lambda3")]
    for k, one in enumerate(shown):
        assert one
        for other in shown[k + 1 :]:
            assert len(one ^ other) > 10


def test_it_lies_inside_and_is_the_same_at_any_size(drawn):
    plain = ink(drawn("lambda2", BELLY))
    assert all(0 < x < WIDTH - 1 and 0 < y < HEIGHT - 1 for x, y in plain)
    large = Segment(1e6 * BELLY.points, BELLY.shape)
    assert len(ink(drawn("lambda2", large)) ^ plain) <= 2


def test_a_segment_that_is_a_point_is_drawn_too(drawn):
    drawn("lambda2", Segment([(5, 5)] * 4))
