"""The curvature plot: what is plotted where, pointed at and chosen."""

import numpy as np
import pytest
from PySide6.QtCore import QPointF

from app.panels import curvature_plot
from app.panels.curvature_plot import CurvaturePlot
from app.state.presenter import Presenter
from sgb_core.curves.comb import typical_curvature
from sgb_core.curves.primitives import arc, line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.model import Document
from sgb_core.document.session import Session
from tests.app.mouse import hover, press, release
from tests.app.waiting import let_turn, show

# Up a straight wall, then round a shoulder of radius 10.
WALL = Document(
    Profile.of([line((20, 0), (20, 30)), arc((10, 30), 10.0, 0.0, np.pi / 2)[0]], ["G1"])
)


@pytest.fixture
def plot(qtbot):
    presenter = Presenter(Session(WALL))
    widget = CurvaturePlot(presenter)
    presenter.add_view(widget)
    show(qtbot, widget, 400, 160)
    widget.presenter = presenter
    return widget


def test_a_circle_is_a_level_line_above_and_a_wall_lies_on_the_axis(plot):
    level = {round(plot.place(1, k).y(), 1) for k in range(5, 92, 6)}
    assert max(level) - min(level) < 1.5
    straight = plot.place(0, 40).y()
    assert straight > max(level) + 10
    assert plot.scale == pytest.approx(1.6 * 0.1, rel=0.01)
    assert plot.place(1, 0).x() == pytest.approx(plot.place(0, 96).x())


def test_it_follows_a_slider_while_it_is_dragged(plot):
    before = plot.place(1, 48)
    plot.presenter.begin("λ2")
    plot.presenter.apply(
        lambda d: edits.set_shape_parameter(
            edits.set_shape_parameter(d, 1, "omega", 1.0), 1, "lambda2", 1.0
        )
    )
    let_turn()
    assert plot.place(1, 48) != before
    plot.presenter.cancel()


def test_hovering_points_at_the_place_in_the_editor(plot):
    hover(plot, QPointF(plot.place(1, 48).x(), 60.0))
    segment, s = plot.presenter.view.mark
    assert segment == 1
    assert s == pytest.approx(0.5, abs=0.03)
    press(plot, QPointF(plot.place(1, 48).x(), 60.0))
    assert plot.presenter.view.segment == 1
    release(plot, QPointF(plot.place(1, 48).x(), 60.0))
    hover(plot, QPointF(2.0, 2.0))
    assert plot.presenter.view.mark is None


def test_it_paints_with_vanishing_derivatives(plot):
    plot.presenter.do(
        "cusp",
        lambda d: edits.set_shape_parameter(
            edits.set_shape_parameter(d, 1, "omega", 1.0), 1, "lambda1", 4.0
        ),
    )
    let_turn()
    hover(plot, QPointF(plot.place(0, 96).x() + 0.5, 60.0))
    assert not plot.grab().isNull()


def test_of_forty_segments_the_scale_is_looked_for_once_a_change_not_a_repaint(plot, monkeypatch):
    measured = []

    def counted(found):
        measured.append(found)
        return typical_curvature(found)

    monkeypatch.setattr(curvature_plot, "typical_curvature", counted)
    walls = [line((20 + k % 2, 5 * k), (21 - k % 2, 5 * k + 5)) for k in range(40)]
    plot.presenter.replace_document(Document(Profile.of(walls, ["G0"] * 39)))
    let_turn()
    for x in range(60, 380, 40):
        hover(plot, QPointF(float(x), 60.0))
        plot.grab()
    assert len(measured) == 1
    plot.presenter.do("Wider", lambda d: edits.scale(d, 2.0))
    let_turn()
    plot.grab()
    plot.grab()
    assert len(measured) == 2
