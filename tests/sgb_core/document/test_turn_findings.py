"""Laws that carry a section beyond the axis are told, with the angle and how far."""

from __future__ import annotations

import numpy as np
import pytest

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.edits import set_variation
from sgb_core.document.file.project_file import warnings
from sgb_core.document.model import Document
from sgb_core.surfaces.variation import Law

# With λ = (4, 3, 4) the curve stays off the axis at ω = 1 and crosses it at ω = 0.
WAIST = np.array([(1.0, 0.0), (-0.6, 1.0), (-0.6, 2.0), (1.0, 3.0)])
LAW = [Law("omega", "raised-cosine", 1.0, 0.0)]


def varying(points: np.ndarray) -> Document:
    document = Document(Profile.of([Segment(points, ShapeParameters(4, 3, 4, 1))]))
    return set_variation(document, LAW)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_section_that_crosses_the_axis_on_its_way_around_is_told(side: float) -> None:
    (line,) = warnings(varying(WAIST * (side, 1.0)))
    assert line.startswith("variation: segment 0 goes beyond the axis")
    # The plain cubic at θ = 180° reaches r = −0.2 at s = 1/2.
    assert "farthest by 0.2 at θ = 180°" in line


def test_laws_whose_sections_stay_on_their_side_are_not_doubted() -> None:
    # One control point beyond the axis, but no section; and a polygon that rules it out.
    assert warnings(varying(WAIST + np.array([0.25, 0.0]))) == []
    assert warnings(varying(np.abs(WAIST))) == []
