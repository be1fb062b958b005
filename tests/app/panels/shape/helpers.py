"""A shape panel on a real session, for the tests that move it."""

from app.panels.shape.panel import ShapePanel
from app.state.presenter import Presenter
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.model import Document
from sgb_core.document.session import Session
from tests.app.waiting import show

SHAPE = ShapeParameters(1.5, 2.5, 1.5, 0.5)


def chain(count):
    """Return a zigzag of so many segments, all joined."""
    segments = []
    for k in range(count):
        points = [(5 + k % 2, k), (7, k + 0.3), (7, k + 0.6), (5 + (k + 1) % 2, k + 1)]
        segments.append(Segment(points, SHAPE))
    return Document(Profile.of(segments))


def open_panel(qtbot, document, size=(300, 800)):
    presenter = Presenter(Session(document))
    panel = ShapePanel(presenter)
    presenter.add_view(panel)
    show(qtbot, panel, *size)
    return panel


def shape(session, segment):
    return session.document.profile.segments[segment].shape


def row(panel, segment, parameter):
    return panel.cards[segment].rows[parameter]
