"""What the viewport's tests share: documents, pixels, and a presenter without a session."""

from dataclasses import replace

import numpy as np

from app.state.view_state import ViewState
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.evaluation import evaluate
from sgb_core.document.model import Document, Revolution
from sgb_core.document.session import Session
from sgb_core.surfaces.revolution import Axis

VASE = (
    ((22, 0), (46, 8), (52, 40), (40, 62)),
    ((40, 62), (28, 84), (14, 88), (16, 108)),
    ((16, 108), (17, 116), (22, 118), (26, 122)),
)
DRUM = (((0.2, 0.2), (0.9, 0.0), (0.9, 1.0), (0.2, 0.8)),)


SHAPE = ShapeParameters(2, 3, 1, 0.5)


def document(segments=VASE, shape=SHAPE, axis="z", sweep=360.0):
    """Return a document of these segments, all with the same shape."""
    profile = Profile.of([Segment(points, shape) for points in segments])
    return Document(profile, revolution=Revolution(Axis(axis), 0.0, sweep))


def reshaped(doc, omega):
    """Return the document with another ω in all segments."""
    segments = [s.with_shape(replace(s.shape, omega=omega)) for s in doc.profile.segments]
    return replace(doc, profile=doc.profile.with_segments(segments))


def near(image, colour, tolerance=40):
    """Return how many pixels of (h, w, 3 or 4) are close to #rrggbb."""
    wanted = np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)])
    return int((np.abs(image[..., :3].astype(int) - wanted).max(axis=-1) <= tolerance).sum())


class Frame:
    """The attributes of a frame that the viewport reads."""

    def __init__(self, doc, view, dragging, generation, compared=None):
        self.evaluation = evaluate(doc)
        self.document = doc
        self.view = view
        self.dragging = dragging
        self.generation = generation
        self.compared = compared
        self.body = self.printed = None


class FakePresenter:
    """Holds a document and a view state and refreshes one view at once."""

    def __init__(self, doc):
        self.document = doc
        self.view = ViewState()
        self.dragging = False
        self.generation = 0
        self.compared = None
        self.target = None

    @property
    def frame(self):
        return Frame(
            self.document, self.view, self.dragging, self.generation, compared=self.compared
        )

    @property
    def session(self):
        return Session(self.document)

    def set_view(self, **changes):
        self.view = replace(self.view, **changes)
        self.send()

    def toggle_overlay(self, overlay):
        self.set_view(show=self.view.show ^ {overlay})

    def toggle_projection(self):
        parallel = self.view.projection == "parallel"
        self.set_view(projection="perspective" if parallel else "parallel")

    def edit(self, doc, dragging=False):
        self.document, self.dragging = doc, dragging
        self.send()

    def send(self):
        if self.target is not None:
            self.target.refresh(self.frame)
