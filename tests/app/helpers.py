"""Documents and gestures that several window tests share."""

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import NEUTRAL, Segment
from sgb_core.document.model import Document

TOWER = (
    ((5, 13), (6, 12), (3, 10), (2, 8)),
    ((2, 8), (1, 6), (2, 3), (5, -1)),
    ((5, -1), (8, -5), (5, -9), (8, -10)),
)


def tower(shape=NEUTRAL, rule="G1"):
    """Return the three-segment tower of the paper's figure 7."""
    segments = [Segment(points, shape) for points in TOWER]
    return Document(Profile.of(segments, [rule, rule]), name="Tower")
