import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from app.hand.canvas import clipped, joined, most_pieces, visible_runs
from app.hand.coordinates import Area
from sgb_core.curves import basis

AREA = Area(0.0, 0.0, 300.0, 200.0)
places = st.tuples(st.floats(-5e3, 5e3), st.floats(-5e3, 5e3))
S = np.linspace(0.0, 1.0, 4001)


def distance_to(polyline, point):
    start, step = polyline[:-1], np.diff(polyline, axis=0)
    squared = np.maximum((step**2).sum(axis=1), 1e-300)
    along = np.clip(((point - start) * step).sum(axis=1) / squared, 0.0, 1.0)
    return np.hypot(*(start + along[:, None] * step - point).T).min()


@given(st.lists(places, min_size=5, max_size=5), st.sampled_from([0.05, 1.0, 40.0]))
def test_what_is_on_the_screen_is_drawn_to_a_fraction_of_a_pixel(control, zoom):
    quartic = zoom * np.array(control)
    curve = basis.bernstein(4, S) @ quartic
    inside = curve[
        (curve[:, 0] >= 0) & (curve[:, 0] <= 300) & (curve[:, 1] >= 0) & (curve[:, 1] <= 200)
    ]
    runs = list(visible_runs(quartic, AREA))
    assert sum(len(run) for run in runs) < 4000
    for point in inside[:: max(1, len(inside) // 12)]:
        assert min(distance_to(run, point) for run in runs) < 0.6


@given(places, places)
def test_a_clipped_line_lies_in_the_rectangle_and_on_the_line(a, b):
    ends = clipped(np.array(a), np.array(b), AREA)
    if ends is None:
        inside = np.array(a) + np.linspace(0, 1, 999)[:, None] * (np.array(b) - a)
        within = (inside > (0.5, 0.5)).all(axis=1) & (inside < (299.5, 199.5)).all(axis=1)
        assert not within.any()
        return
    for end in ends:
        assert -1e-6 <= end[0] <= 300 + 1e-6
        assert -1e-6 <= end[1] <= 200 + 1e-6
        assert distance_to(np.array([a, b]), np.array(end)) < 1e-6


@given(
    st.lists(st.lists(places, min_size=4, max_size=4), min_size=2, max_size=6),
    st.sampled_from([1e-3, 0.05, 1.0]),
    st.integers(0, 5),
)
def test_a_chain_is_drawn_as_its_curves_are_each_alone(legs, zoom, gap):
    quartics, last = [], np.array(legs[0][0])
    for number, leg in enumerate(legs):
        start = last + (300.0 if number == gap else 0.0)
        quartics.append([start, *np.array(leg)])
        last = np.array(leg[-1])
    quartics = zoom * np.array(quartics)
    pieces = most_pieces(quartics)
    parts = basis.bernstein(4, np.linspace(0.0, 1.0, pieces + 1)) @ quartics
    lines = list(joined(parts))
    assert len(lines) == 1 + (1 <= gap < len(legs) and zoom * 300.0 > 0.05)
    for quartic in quartics:
        curve = basis.bernstein(4, S[::400]) @ quartic
        for point in curve:
            assert min(distance_to(line, point) for line in lines) < 0.3


def test_what_is_not_seen_is_no_part_of_a_line():
    parts = np.array([[[k, 0.0], [k + 1.0, 0.0]] for k in range(5)])
    seen = np.array([True, True, False, True, False])
    assert [line[:, 0].tolist() for line in joined(parts, seen)] == [[0, 1, 2], [3, 4]]
