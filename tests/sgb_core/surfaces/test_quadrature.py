from __future__ import annotations

import numpy as np
import pytest

from sgb_core.curves import basis
from sgb_core.surfaces.quadrature import integrate, section_flux
from tests.sgb_core.surfaces.chains import TOWER, chain


def test_flux_is_that_of_the_polynomial() -> None:
    quartics = chain(TOWER, (4, 3, 4, 0.3)).quartics
    total = 0.0
    for quartic in quartics:
        # Interpolated once in the power form, integrated there.
        s = np.linspace(0, 1, 5)
        r, h = (np.poly1d(np.polyfit(s, v, 4)) for v in (basis.bernstein(4, s) @ quartic).T)
        primitive = (r * r * h.deriv()).integ()
        total += primitive(1.0) - primitive(0.0)
    assert section_flux(quartics) == pytest.approx(total, rel=1e-11)


def test_adaptive_bisection_integrates() -> None:
    edges = np.array([0.0, 1.0])
    assert integrate(lambda s: np.abs(s - 0.3), edges) == pytest.approx(0.29, rel=1e-13)
    assert integrate(np.sqrt, edges) == pytest.approx(2 / 3, rel=1e-12)
    sharp = integrate(lambda s: 1e-4 / ((s - 0.4) ** 2 + 1e-8), edges)
    assert sharp == pytest.approx(np.arctan(6000) + np.arctan(4000), rel=1e-11)


def test_rounding_ends_the_bisection() -> None:
    asked = 0

    def noisy(s: np.ndarray) -> np.ndarray:
        nonlocal asked
        asked += len(s)
        return np.cos(s) + 1e-9 * np.sin(1e9 * s * s)

    assert integrate(noisy, np.array([0.0, 1.0])) == pytest.approx(np.sin(1.0), rel=1e-8)
    assert asked < 50_000
    asked = 0
    # What is known to less is asked less often.
    integrate(noisy, np.array([0.0, 1.0]), least=1e-8)
    assert asked < 100
