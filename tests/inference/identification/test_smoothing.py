"""Strokes and smoothing: polynomials come back, SciPy agrees, corners stay corners."""

import numpy as np
import pytest
from scipy.signal import savgol_filter

from dcfp.inference.identification.friction_history import find_strokes, smooth


@pytest.mark.parametrize("order", [2, 4])
def test_it_is_the_filter_of_savitzky_and_golay(order) -> None:
    random = np.random.default_rng(1)
    values = np.cumsum(random.standard_normal(400))
    time = 0.01 * np.arange(400)
    found = smooth(values, time, [slice(0, 400)], order)
    assert found.values == pytest.approx(savgol_filter(values, found.window, order), abs=1e-9)
    slope = savgol_filter(values, found.window, order, deriv=1, delta=0.01)
    assert found.slope == pytest.approx(slope, abs=1e-7)


def test_the_window_follows_the_noise_and_the_sampling() -> None:
    random = np.random.default_rng(2)

    def window(samples: int, noise: float) -> int:
        time = np.linspace(0.0, 1.0, samples)
        values = np.sin(2.0 * np.pi * time) + noise * random.standard_normal(samples)
        return smooth(values, time, [slice(0, samples)], 4).window

    assert window(400, 1e-6) < window(400, 1e-2) < window(4000, 1e-2)


def test_uneven_samples_give_the_same_slope() -> None:
    random = np.random.default_rng(3)
    time = (np.arange(300) + 0.3 * random.uniform(-1.0, 1.0, 300)) / 300.0
    found = smooth(np.sin(3.0 * time), time, [slice(0, 300)], 4)
    assert found.slope[5:-5] == pytest.approx(3.0 * np.cos(3.0 * time[5:-5]), abs=1e-3)


def test_strokes_end_at_the_turns_and_small_ones_are_left_out() -> None:
    time = np.linspace(0.0, 3.0, 601)
    motion = 100.0 * np.sin(2.0 * np.pi * time)
    strokes = find_strokes(motion, 2.0)
    assert [stroke.start for stroke in strokes] == [0, 51, 151, 251, 351, 451, 551]
    assert strokes[-1].stop == 601
    ripple = motion + 0.5 * np.sin(60.0 * time)
    assert len(find_strokes(ripple, 2.0)) == len(strokes)
    assert find_strokes(np.zeros(50), 1.0) == []


def test_a_corner_stays_a_corner() -> None:
    time = np.arange(201) * 0.01
    motion = 50.0 * (1.0 - np.abs(time - 1.0))
    random = np.random.default_rng(4)
    found = smooth(motion + 0.01 * random.standard_normal(201), time, find_strokes(motion, 1.0), 4)
    assert found.slope[5:95] == pytest.approx(50.0, abs=0.8)
    assert found.slope[106:196] == pytest.approx(-50.0, abs=0.8)
