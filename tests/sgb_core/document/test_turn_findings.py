"""Laws that carry a section beyond the axis are told, with the angle and how far."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.edits import set_variation
from sgb_core.document.file import project_file
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


def test_a_strength_along_the_height_is_kept_and_said_not_to_be_drawn() -> None:
    lobes = Law("radius", "lobes", 1.0, 0.9, count=8)
    faded = replace(lobes, extra={"along": [[0.0, 0.0], [1.0, 1.0]]})
    straight = Document(Profile.of([line((20.0, 0.0), (20.0, 60.0))]))
    assert warnings(set_variation(straight, [lobes])) == []
    document = project_file.loads(project_file.dumps(set_variation(straight, [lobes, faded])))
    assert document.variation[1].extra["along"]
    (told,) = warnings(document)
    assert told.startswith("variation: the strength along the height of law 1 is kept")
