"""The largest change between two successive peaks in any direction: by looking at every direction, and along a line."""

import numpy as np
import pytest

from dcfp.analysis.plane_response import largest_change

STEP = 0.01
TIME = np.arange(1201) * STEP


def in_one_direction(displacement: np.ndarray, velocity: np.ndarray) -> float:
    """Return the largest change of one component, whose peaks are where the velocity, linear over a step, is zero."""
    before, after = velocity[:-1], velocity[1:]
    turns = before * after < 0.0
    peaks = displacement[:-1] + 0.5 * STEP * before**2 / np.where(turns, before - after, 1.0)
    return float(np.abs(np.diff([displacement[0], *peaks[turns], displacement[-1]])).max())


@pytest.mark.parametrize("seed", range(5))
def test_of_a_wandering_path_it_is_the_largest_of_all_directions(seed: int) -> None:
    random = np.random.default_rng(seed)
    pace, phase, size = (
        random.uniform(0.5, 9.0, (6, 2)),
        random.uniform(0.0, 6.3, (6, 2)),
        random.normal(0.0, 80.0, (6, 2)),
    )
    angle = pace * TIME[:, None, None] + phase
    displacement, velocity = (size * np.sin(angle)).sum(axis=1), (size * pace * np.cos(angle)).sum(axis=1)
    expected = [
        in_one_direction(displacement @ direction, velocity @ direction)
        for direction in ((np.cos(one), np.sin(one)) for one in np.arange(180) * np.pi / 180)
    ]
    assert largest_change(displacement, velocity, STEP) == pytest.approx(max(expected), rel=1e-12)


def test_along_a_line_it_is_that_of_the_line() -> None:
    lean = np.array([np.cos(np.pi / 6.0), np.sin(np.pi / 6.0)])
    along, speed = 100.0 * np.sin(3.0 * TIME), 300.0 * np.cos(3.0 * TIME)
    found = largest_change(along[:, None] * lean, speed[:, None] * lean, STEP)
    assert found == pytest.approx(200.0, rel=1e-4)
