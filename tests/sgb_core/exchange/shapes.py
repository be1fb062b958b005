"""Documents and strategies that the export tests share."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import strategies as st

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.model import Document, Revolution
from sgb_core.surfaces.revolution import Axis


def chain(points: list[tuple[float, float]], shapes: list[ShapeParameters]) -> Profile:
    """Return a chain through 3n + 1 control points, neighbours sharing an end."""
    segments = [
        Segment(np.array(points[3 * k : 3 * k + 4]), shape) for k, shape in enumerate(shapes)
    ]
    return Profile(tuple(segments))


def spindle(**changes: Any) -> Document:
    """Return a body closed at both poles, of two segments, height 60."""
    profile = chain(
        [(0, 0), (15, 0), (30, 10), (25, 30), (20, 45), (10, 60), (0, 60)],
        [ShapeParameters(0.5, 4.0, 2.0, 0.7), ShapeParameters(2.0, 3.5, 0.2, 1.0)],
    )
    return Document(profile, **changes)


def tube(**changes: Any) -> Document:
    """Return an open surface: a straight wall of radius 20, height 60."""
    return Document(chain([(20, 0), (20, 20), (20, 40), (20, 60)], [ShapeParameters()]), **changes)


def ring(**changes: Any) -> Document:
    """Return a closed generatrix off the axis: a torus-like body."""
    points = [(40, 0), (60, 0), (60, 30), (40, 30), (20, 30), (20, 0), (40, 0)]
    open_chain = chain(points, [ShapeParameters(), ShapeParameters(0.5, 3.0, 0.5, 1.0)])
    return Document(Profile(open_chain.segments, closed=True), **changes)


def shape_parameters() -> st.SearchStrategy[ShapeParameters]:
    """Draw from the whole range, its limits included."""
    return st.builds(
        ShapeParameters, st.floats(0, 4), st.floats(0, 6), st.floats(0, 4), st.floats(0, 1)
    )


@st.composite
def closed_documents(draw: st.DrawFn) -> Document:
    """Draw bodies from pole to pole, upward or downward, about any axis and in any size."""
    count = draw(st.integers(1, 3))
    radius = st.floats(0.05, 1.0)
    inner = [draw(radius) for _ in range(3 * count - 1)]
    scale = draw(st.sampled_from([1e-3, 1.0, 50.0, 1e5]))
    heights = np.linspace(0.0, 2.0, 3 * count + 1)[:: draw(st.sampled_from([1, -1]))]
    points = [(scale * r, scale * h) for r, h in zip([0.0, *inner, 0.0], heights, strict=True)]
    profile = chain(points, [draw(shape_parameters()) for _ in range(count)])
    return Document(profile, revolution=Revolution(draw(st.sampled_from(list(Axis)))))
