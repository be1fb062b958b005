"""Fits of documents: targets from the profile, smooth poles, rules that stay true."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import differential_evolution

from sgb_core.curves.continuity import measure_joints
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.design.fitting import Freedom
from sgb_core.design.target_curves import SuperellipseArc
from sgb_core.document.edits import close_profile, reverse_profile, set_variation
from sgb_core.document.edits.fit import arc_for, fit_choices, fit_profile, take_fit
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.surfaces.variation import Law

PAPER = ((0.0, 0.0), (1.2, 0.0), (1.2, 2.0), (0.0, 2.0))
CIRCLE = SuperellipseArc(1.0, 1.0, 1.0)


def published() -> Document:
    return Document(Profile.of([Segment(PAPER, ShapeParameters(0, 3, 0, 0.671))]))


def chain() -> Document:
    lower = Segment(((0, 0), (0.7, 0), (1, 0.3), (1, 1)))
    upper = Segment(((1, 1), (1, 1.7), (0.7, 2), (0, 2)))
    return Document(Profile.of([lower, upper], ["C1"]))


def test_the_target_is_read_off_the_profile() -> None:
    arc = arc_for(published())
    assert (arc.a, arc.centre) == (1.0, 1.0)
    assert arc.b == pytest.approx(published().profile.bounds()[1][0])
    assert arc_for(published(), circle=True).b == 1.0
    assert arc_for(published(), circle=True, b=3.0).a == 3.0
    with pytest.raises(EditError, match="one radius"):
        arc_for(published(), circle=True, a=1.0, b=2.0)
    with pytest.raises(EditError, match="exponent"):
        arc_for(published(), exponent=0.5)


def test_each_freedom_says_how_near_it_comes_and_where() -> None:
    heard: list[float] = []
    choices = fit_choices(published(), CIRCLE, report=heard.append)
    assert choices.present.largest == pytest.approx(0.0334, abs=1e-4)
    largest = [found.deviation.largest for found in choices.fits]
    assert [found.freedom for found in choices.fits] == list(Freedom)
    assert largest == sorted(largest, reverse=True)
    assert largest[2] < 2e-4
    assert heard == sorted(heard)
    assert heard[-1] == 1.0
    for found in choices.fits:
        place = found.deviation
        point = found.profile.segments[place.segment].point(place.s)
        assert np.hypot(point[0], point[1] - 1.0) - 1.0 == pytest.approx(
            np.copysign(place.largest, np.hypot(point[0], point[1] - 1.0) - 1.0), abs=1e-12
        )


def test_a_search_can_be_stopped_at_every_step_of_it() -> None:
    class StoppedError(Exception):
        pass

    heard: list[float] = []

    def report(part: float) -> None:
        heard.append(part)
        if len(heard) == 3:
            raise StoppedError

    with pytest.raises(StoppedError):
        fit_profile(published(), CIRCLE, Freedom.POLYGON, report=report)
    # Still in the first of its searches.
    assert heard == [0.0, 0.0, 0.0]


def test_the_best_omega_is_that_of_a_scan() -> None:
    found = fit_profile(published(), CIRCLE, Freedom.OMEGA)[1]
    s = np.linspace(0.0, 1.0, 4001)

    def off(omega: float) -> float:
        points = Segment(PAPER, ShapeParameters(0, 3, 0, omega)).point(s)
        return float(np.abs(np.hypot(points[:, 0], points[:, 1] - 1.0) - 1.0).max())

    assert found.deviation.largest <= min(map(off, np.linspace(0, 1, 2001))) * (1 + 1e-6)


def test_a_fitted_sphere_stays_smooth_at_its_poles_and_is_the_best_of_its_kind() -> None:
    fitted, found = fit_profile(published(), CIRCLE, Freedom.POLYGON, keep_ends=True)
    points = fitted.profile.control_points[0]
    assert points[1, 1] == points[0, 1] == 0.0
    assert points[2, 1] == points[3, 1] == 2.0
    assert found.deviation.largest < 2e-4
    s = np.linspace(0.0, 1.0, 201)

    def off(x: np.ndarray) -> float:
        corners = ((0, 0), (x[0], 0), (x[1], 2), (0, 2))
        shape = ShapeParameters.from_leg_fractions(*np.clip(x[2:], 0, 1))
        curve = Segment(corners, shape).point(s)
        return float(np.abs(np.hypot(curve[:, 0], curve[:, 1] - 1.0) - 1.0).max())

    ranges = [(0.8, 2.0), (0.8, 2.0), (0.3, 1.0), (0.3, 0.7), (0.3, 1.0)]
    other = differential_evolution(off, ranges, seed=3, maxiter=150, tol=1e-10)
    assert found.deviation.largest <= other.fun * 1.01


def test_a_profile_that_runs_down_is_fitted_downwards() -> None:
    down = reverse_profile(published())
    fitted, found = fit_profile(down, CIRCLE, Freedom.POLYGON)
    assert found.deviation.largest < 2e-4
    assert fitted.profile.control_points[0, 0].tolist() == [0.0, 2.0]


def test_rules_say_no_more_than_what_is_left() -> None:
    target = SuperellipseArc(0.8, 1.0, 1.0)
    for freedom in (Freedom.OMEGA, Freedom.SHAPE):
        fitted, found = fit_profile(chain(), target, freedom)
        assert all(report.holds for report in measure_joints(fitted.profile))
        assert take_fit(chain(), found) == fitted


def test_what_cannot_be_fitted_says_why() -> None:
    ring = close_profile(Document(Profile.of([Segment(((2, 0), (3, 0), (3, 2), (2, 2)))])))
    law = [Law("omega", "raised-cosine", 0.0, 1.0)]
    gap = replace(chain(), profile=Profile.of([Segment(PAPER), Segment(PAPER)], ["free"]))
    many = Document(
        Profile.of(
            [Segment(((1, k), (1, k + 0.3), (1, k + 0.6), (1, k + 1))) for k in range(11)],
            ["G0"] * 10,
        )
    )
    for document, words in (
        (ring, "closed"),
        (set_variation(published(), law), "laws"),
        (gap, "gaps"),
        (many, "at most 10 segments, not 11"),
    ):
        with pytest.raises(EditError, match=words):
            fit_profile(document, CIRCLE, Freedom.POLYGON)
