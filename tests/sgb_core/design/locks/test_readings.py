"""What dimensions measure, against closed forms, the body's measures and finite differences."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

import sgb_core as sgb
from sgb_core.design.demands.chain import Chain
from sgb_core.design.locks.gauge import Gauge
from sgb_core.design.locks.readings import MODELLED, Setting, read
from sgb_core.document.dimensions import dimension_value, setting_of
from tests.sgb_core.design.locks.samples import pot, wavy

OF_ALL = (
    sgb.Dimension("height"),
    sgb.Dimension("max_diameter"),
    sgb.Dimension("max_diameter_height"),
    sgb.Dimension("rim_diameter"),
    sgb.Dimension("foot_diameter"),
    sgb.Dimension("neck_diameter"),
    sgb.Dimension("neck_height"),
    sgb.Dimension("diameter_at", height=70.0),
    sgb.Dimension("distance", points=((0, 0), (3, 2))),
    sgb.Dimension("angle", points=((1, 0), (1, 1))),
    sgb.Dimension("radius", segment=2, s=0.3),
    sgb.Dimension("capacity"),
    sgb.Dimension("filled"),
    sgb.Dimension("volume"),
    sgb.Dimension("material"),
    sgb.Dimension("mass"),
)


def value(document: sgb.Document, kind: str, **fields: object) -> float:
    found = dimension_value(document, sgb.Dimension(kind, **fields))  # type: ignore[arg-type]
    assert found is not None
    return found


def test_a_straight_cup_has_the_dimensions_of_its_cone() -> None:
    # The contract's worked example, and a cone.
    cylinder = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
    cup = sgb.edits.set_solid(cylinder, kind="vessel", wall=3, base=4)
    assert value(cup, "capacity") == pytest.approx(pi * 17**2 * 56, rel=1e-12)
    assert value(cup, "material") == pytest.approx(pi * (400 * 60 - 289 * 56), rel=1e-12)
    assert value(cup, "mass") == pytest.approx(pi * (400 * 60 - 289 * 56) * 1.9e-3, rel=1e-12)
    assert value(sgb.edits.set_fill(cup, 30.0), "filled") == pytest.approx(pi * 289 * 26, rel=1e-12)
    cone = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (40, 60))]))
    assert value(cone, "height") == 60.0
    assert (value(cone, "rim_diameter"), value(cone, "foot_diameter")) == (80.0, 40.0)
    assert value(cone, "diameter_at", height=30.0) == pytest.approx(60.0, rel=1e-14)
    assert value(cone, "distance", points=((0, 0), (0, 3))) == pytest.approx(np.hypot(20, 60))
    angle = value(cone, "angle", points=((0, 0), (0, 3)))
    assert angle == pytest.approx(np.degrees(np.arctan2(60, 20)), rel=1e-14)
    assert dimension_value(cone, sgb.Dimension("neck_diameter")) is None
    assert dimension_value(cone, sgb.Dimension("capacity")) is None
    assert dimension_value(cone, sgb.Dimension("radius", segment=0, s=0.5)) is None


def test_a_radius_of_curvature_is_that_of_the_circle() -> None:
    quarter = sgb.Document(sgb.Profile.of([sgb.arc((0, 0), 30.0, -pi / 2, 0.0)[0]]))
    found = value(quarter, "radius", segment=0, s=0.5)
    assert found == pytest.approx(30.0, rel=2e-3)


def test_extremes_are_those_of_dense_samples() -> None:
    document = sgb.Document(wavy(7))
    points = np.concatenate(
        [segment.point(np.linspace(0, 1, 4001)) for segment in document.profile]
    )
    r = points[:, 0]
    widest = int(r.argmax())
    assert value(document, "max_diameter") == pytest.approx(2.0 * r[widest], rel=1e-7)
    assert value(document, "max_diameter_height") == pytest.approx(points[widest, 1], abs=0.02)
    inner = np.flatnonzero((r[1:-1] < r[:-2]) & (r[1:-1] < r[2:])) + 1
    assert value(document, "neck_diameter") == pytest.approx(2.0 * r[inner].min(), rel=1e-7)


@pytest.mark.parametrize("side", ["inside", "outside"])
def test_models_of_bodies_are_their_measures_where_nothing_folds(side: str) -> None:
    document = sgb.edits.set_fill(sgb.edits.set_solid(pot(4), side=side), 100.0)
    gauge, setting = Gauge(Chain.of(document.profile)), setting_of(document)
    # Outside, the floor below the foot is no part of the model of the material.
    kinds = sorted(MODELLED) if side == "inside" else ["capacity", "filled"]
    for kind in kinds:
        dimension = sgb.Dimension(kind)
        exact, model = dimension_value(document, dimension), read(gauge, dimension, setting)
        assert exact is not None
        assert model is not None
        assert model.value == pytest.approx(exact, rel=1e-6), kind


@pytest.mark.parametrize("turned", [False, True], ids=["upwards", "downwards"])
@pytest.mark.parametrize("dimension", OF_ALL, ids=lambda each: str(each.kind))
def test_slopes_are_those_of_differences(dimension: sgb.Dimension, turned: bool) -> None:
    document = sgb.edits.set_solid(sgb.Document(wavy(6, 1.1)), kind="vessel", wall=3, base=4)
    if turned:
        document = sgb.edits.reverse_profile(document)
    chain = Chain.of(document.profile)
    setting = Setting(document.solid, 100.0, 4.0, 0.0019)
    way = np.random.default_rng(5).normal(size=chain.blocks.shape)

    def at(step: float) -> float:
        found = read(Gauge(chain.with_blocks(chain.blocks + step * way)), dimension, setting)
        assert found is not None
        return found.value

    found = read(Gauge(chain), dimension, setting)
    assert found is not None
    # Richardson's extrapolation of central differences, to the fourth order.
    step = 2e-5
    wide, narrow = (at(h) - at(-h) for h in (2.0 * step, step))
    expected = (8.0 * narrow - wide) / (12.0 * step)
    assert float(found.slope @ way.ravel()) == pytest.approx(expected, rel=1e-5)
