"""The colour map: its ends, its order, and what it does with numbers that are none."""

import numpy as np

from app.theme.colour_scale import colours, table


def _lightness(rgb):
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    return np.cbrt(linear @ [0.2126, 0.7152, 0.0722])


def test_ends_and_outside():
    found = colours(np.array([[0.0, 1.0], [-3.0, np.nan]]))
    assert found.shape == (2, 2, 3)
    assert found.dtype == np.uint8
    low, high = (tuple(int(part) for part in end) for end in (table()[0], table()[-1]))
    assert tuple(found[0, 0]) == tuple(found[1, 0]) == tuple(found[1, 1]) == low
    assert tuple(found[0, 1]) == high


def test_equal_steps_look_equal():
    light = _lightness(colours(np.linspace(0.0, 1.0, 65)) / 255.0)
    steps = np.diff(light)
    assert steps.min() > 0.0
    assert np.ptp(np.convolve(steps, np.ones(8) / 8, "valid")) < 0.35 * steps.mean()
