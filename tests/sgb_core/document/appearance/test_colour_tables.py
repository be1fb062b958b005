"""The colour tables: their ends, their order, and what they do with numbers that are none."""

import numpy as np

import resources.library  # noqa: F401
from sgb_core.document.appearance.colour_tables import colours, table


def _lightness(rgb):
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    return np.cbrt(linear @ [0.2126, 0.7152, 0.0722])


def test_ends_and_outside():
    found = colours("viridis", np.array([[0.0, 1.0], [-3.0, np.nan]]))
    assert found.shape == (2, 2, 3)
    assert found.dtype == np.uint8
    shades = table("viridis")
    low, high = (tuple(int(part) for part in end) for end in (shades[0], shades[-1]))
    assert tuple(found[0, 0]) == tuple(found[1, 0]) == tuple(found[1, 1]) == low
    assert tuple(found[0, 1]) == high


def test_equal_steps_look_equal():
    light = _lightness(colours("viridis", np.linspace(0.0, 1.0, 65)) / 255.0)
    steps = np.diff(light)
    assert steps.min() > 0.0
    assert np.ptp(np.convolve(steps, np.ones(8) / 8, "valid")) < 0.35 * steps.mean()
