from __future__ import annotations

import numpy as np
import pytest

from sgb_core.curves import basis
from sgb_core.surfaces.quadrature import integrate, integrate_each, section_flux
from sgb_core.surfaces.sections import Sections
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
    sections = Sections(quartics, np.zeros_like(quartics))
    assert section_flux(sections) == pytest.approx(total, rel=1e-11)


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


def test_each_of_many_integrals_has_its_own_panels_and_its_own_scale() -> None:
    rates = np.geomspace(1e-6, 1e6, 600)
    low, high = np.zeros(2 * len(rates)), np.ones(2 * len(rates))
    low[1::2] = high[::2] = 0.5
    which = np.repeat(np.arange(len(rates)), 2)
    given_out_of_order = np.random.default_rng(4).permutation(len(low))
    panels = tuple(part[given_out_of_order] for part in (low, high, which))

    def spike(s: np.ndarray, k: np.ndarray) -> np.ndarray:
        return rates[k] / ((s - 0.4) ** 2 + 1e-8)

    found = integrate_each(spike, panels, len(rates))
    wanted = 1e4 * (np.arctan(6000) + np.arctan(4000)) * rates
    np.testing.assert_allclose(found, wanted, rtol=1e-11)


def test_what_is_known_no_better_holds_up_none_of_the_others() -> None:
    def noisy_or_not(s: np.ndarray, k: np.ndarray) -> np.ndarray:
        return np.where(k == 1, np.cos(s) + 1e-9 * np.sin(1e9 * s * s), np.abs(s - 0.3))

    ends = np.zeros(3), np.ones(3), np.arange(3)
    found = integrate_each(noisy_or_not, ends, 3)
    np.testing.assert_allclose(found[[0, 2]], 0.29, rtol=1e-13)
    assert found[1] == pytest.approx(np.sin(1.0), rel=1e-8)


def test_an_integral_without_panels_is_nothing() -> None:
    none = np.zeros(0), np.zeros(0), np.zeros(0, dtype=np.int64)
    np.testing.assert_array_equal(integrate_each(lambda s, _: s, none, 2), [0.0, 0.0])
