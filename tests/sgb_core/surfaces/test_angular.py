"""Few angles that stand for all, against dense quadrature."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from sgb_core.curves.nodes import panels
from sgb_core.surfaces.angular import angle_edges, representative_angles
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import Law
from tests.sgb_core.surfaces.chains import TOWER, chain

KEYS = tuple(zip(range(0, 360, 3), (0.5 + 0.5 * np.sin(np.arange(120.0) ** 2)), strict=True))
LAWS = {
    "one of many keys": (Law("omega", "keyframes", 0.0, 1.0, keyframes=KEYS),),
    "waves over keys": (
        Law("omega", "keyframes", 0.0, 1.0, keyframes=KEYS),
        Law("lambda2", "cosine", 1.0, 6.0, count=45),
    ),
    "three of different shapes": (
        Law("omega", "paper", 0.0, 1.0),
        Law("lambda1", "cosine", 4.0, 0.5, count=16),
        Law("lambda2", "cosine", 1.0, 6.0, count=45),
    ),
}


@pytest.mark.parametrize("sweep", [2.0 * pi, 1.9])
@pytest.mark.parametrize("name", LAWS)
def test_few_angles_integrate_what_depends_smoothly_on_the_laws(name, sweep) -> None:
    surface = RevolutionSurface(chain(TOWER), sweep=sweep, laws=LAWS[name])
    theta, weights = representative_angles(surface, 12)
    assert len(theta) <= 60
    assert (weights > 0.0).all()
    assert weights.sum() == pytest.approx(sweep, rel=1e-12)

    def smooth(angles: np.ndarray) -> np.ndarray:
        shares = [law.fraction(angles) for law in surface.laws]
        return np.exp(0.7 * shares[0]) / (3.0 + sum(shares[1:], np.zeros(len(angles))))

    dense, fine = panels(angle_edges(surface, bare=True), 20)
    # One f is integrated to rounding, three to the degree that so few angles reach.
    close = {1: 1e-12, 2: 1e-9, 3: 1e-6}[len(surface.laws)]
    assert weights @ smooth(theta) == pytest.approx(fine @ smooth(dense), rel=close)


def test_what_is_simple_already_keeps_its_own_angles() -> None:
    still = RevolutionSurface(chain(TOWER), laws=(Law("omega", "paper", 0.4, 0.4),))
    theta, weights = representative_angles(still, 12)
    assert len(theta) == 1
    assert weights == pytest.approx([2.0 * pi])
    wave = RevolutionSurface(chain(TOWER), laws=(Law("omega", "cosine", 0.0, 1.0, count=500),))
    theta, weights = representative_angles(wave, 12)
    # Those of half a wave.
    assert len(theta) == 12
    assert weights.sum() == pytest.approx(2.0 * pi)
