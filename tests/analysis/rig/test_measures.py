"""Measures of a cycle on loops made by hand, whose stiffness, strength and area are known."""

import math
from dataclasses import dataclass

import numpy as np
import pytest

from dcfp.analysis.rig.measures import (
    Cycle,
    cycles_of,
    zero_crossings,
)
from dcfp.analysis.rig.waveform import cycle_bounds

STIFFNESS, STRENGTH, AMPLITUDE, LOAD = 800.0, 3e5, 200.0, 7.5e6


@dataclass(frozen=True)
class Made:
    """A history made by hand."""

    time: np.ndarray
    displacement: np.ndarray
    force: np.ndarray
    load: np.ndarray
    cycle_times: np.ndarray

    @property
    def work(self) -> np.ndarray:
        steps = 0.5 * (self.force[1:] + self.force[:-1]) * np.diff(self.displacement)
        return np.concatenate(([0.0], np.cumsum(steps)))

    @property
    def temperature(self) -> np.ndarray:
        return 20.0 + self.time


def known_cycles(history: Made) -> tuple[Cycle, ...]:
    """Return the cycles of a history whose work and temperature are known."""
    return cycles_of(history, history.work, history.temperature)


def made(displacement: np.ndarray, friction: np.ndarray, cycle_times: np.ndarray | None = None) -> Made:
    """Return a history with a step of 1 s: a pendulum and a force of friction beside it."""
    time = np.arange(displacement.size, dtype=float)
    force = STIFFNESS * displacement + friction
    bounds = cycle_bounds(time, displacement) if cycle_times is None else cycle_times
    return Made(time, displacement, force, np.full(time.size, LOAD), bounds)


def parallelogram(turns: float, per_quarter: int = 20, start: float = 0.0) -> Made:
    """Return a loop of straight strokes; at each end there are two samples, before and after the force has turned.

    It begins `start` quarters after zero displacement on the way up.
    """
    quarters = start + np.arange(round(4 * turns * per_quarter) + 1) / per_quarter
    displacement = AMPLITUDE * 2.0 / math.pi * np.arcsin(np.sin(0.5 * math.pi * quarters))
    before = np.where(np.floor((quarters + 1.0 - 1e-9) / 2.0) % 2 == 0, 1.0, -1.0)
    after = np.where(np.floor((quarters + 1.0 + 1e-9) / 2.0) % 2 == 0, 1.0, -1.0)
    doubled = np.where(before == after, 1, 2)
    y = np.repeat(displacement, doubled)
    side = np.concatenate([[b] if n == 1 else [b, a] for b, a, n in zip(before, after, doubled, strict=True)])
    return made(y, STRENGTH * side)


def assert_known(cycle: Cycle) -> None:
    area = 4.0 * STRENGTH * AMPLITUDE
    stiffness = STIFFNESS + STRENGTH / AMPLITUDE
    assert cycle.largest == pytest.approx(AMPLITUDE)
    assert cycle.least == pytest.approx(-AMPLITUDE)
    assert cycle.effective_stiffness == pytest.approx(stiffness)
    assert cycle.energy == pytest.approx(area)
    assert cycle.effective_damping == pytest.approx(
        2.0 / math.pi * area / (stiffness * (2.0 * AMPLITUDE) ** 2)
    )
    assert cycle.strength == pytest.approx(STRENGTH)
    assert cycle.friction == pytest.approx(STRENGTH / LOAD)
    assert cycle.load == pytest.approx(LOAD)


def test_a_parallelogram_has_its_stiffness_strength_and_area() -> None:
    for cycles in (known_cycles(parallelogram(3.0)), cycles_of(parallelogram(3.0))):
        assert [cycle.number for cycle in cycles] == [1, 2, 3]
        for cycle in cycles:
            assert_known(cycle)


def test_zero_is_passed_at_the_start_of_each_cycle_but_the_first_and_in_the_middle() -> None:
    assert [len(cycle.crossings) for cycle in known_cycles(parallelogram(3.0))] == [1, 2, 2]
    assert zero_crossings(parallelogram(3.0)).shape == (6, 3)


def test_a_measured_history_has_no_temperature() -> None:
    assert math.isnan(cycles_of(parallelogram(1.0))[0].peak_temperature)
    assert known_cycles(parallelogram(1.0))[0].peak_temperature > 20.0


@pytest.mark.parametrize("turns", [2.25, 2.5, 2.75])
def test_a_last_cycle_that_does_not_close_does_not_count(turns: float) -> None:
    cycles = known_cycles(parallelogram(turns))
    assert len(cycles) == 2
    assert_known(cycles[1])


def test_a_motion_that_begins_elsewhere_has_its_cycles_from_zero_upwards() -> None:
    for start in (0.5, 1.5, 2.5, 3.5):
        history = parallelogram(3.0, start=start)
        cycles = known_cycles(history)
        assert 2 <= len(cycles) <= 3
        assert_known(cycles[1])


def test_cycles_between_the_samples_are_found_by_interpolation() -> None:
    """Samples that fall on neither the ends nor the zeros."""
    angle = 0.013 + 2.0 * math.pi * np.arange(0, 1000) / 321.7
    y = AMPLITUDE * np.sin(angle)
    side = np.sign(np.cos(angle))
    history = made(y, STRENGTH * side)
    for cycle in cycles_of(history)[1:]:
        assert cycle.friction == pytest.approx(STRENGTH / LOAD, rel=1e-6)
        assert cycle.energy == pytest.approx(4.0 * STRENGTH * AMPLITUDE, rel=1e-3)
        assert cycle.post_yield_stiffness == pytest.approx(STIFFNESS, rel=1e-6)
        assert cycle.effective_stiffness == pytest.approx(STIFFNESS + STRENGTH / AMPLITUDE, rel=1e-3)


def test_a_ramp_before_and_after_is_left_out() -> None:
    history = parallelogram(4.0)
    one = 4 * 20 + 2  # samples of a cycle, its two ends doubled
    shorter = Made(
        history.time,
        history.displacement,
        history.force,
        history.load,
        np.array([one, 2 * one, 3 * one], dtype=float),
    )
    cycles = known_cycles(shorter)
    assert len(cycles) == 2
    for cycle in cycles:
        assert_known(cycle)


def test_where_it_never_passes_zero_there_is_no_friction() -> None:
    y = 15.0 + 5.0 * np.sin(2.0 * math.pi * np.arange(201) / 100.0)
    (cycle,) = known_cycles(made(y, np.zeros(y.size)))
    assert cycle.crossings == ()
    assert math.isnan(cycle.friction)
    assert math.isnan(cycle.strength)


def test_strokes_of_few_samples_have_no_stiffness() -> None:
    y = AMPLITUDE * np.sin(2.0 * math.pi * np.arange(9) / 4.0)
    assert all(
        math.isnan(cycle.post_yield_stiffness)
        for cycle in known_cycles(made(y, np.zeros(9), np.array([0.0, 4.0, 8.0])))
    )


def test_noise_around_zero_makes_no_cycle() -> None:
    angle = 2.0 * math.pi * np.arange(1201) / 400.0
    noise = 0.02 * AMPLITUDE * np.random.default_rng(1).normal(size=angle.size)
    bounds = cycle_bounds(np.arange(1201.0), AMPLITUDE * np.sin(angle) + noise)
    assert bounds == pytest.approx([0.0, 400.0, 800.0, 1200.0], abs=8.0)


def test_a_sample_a_rounding_error_from_zero_is_at_zero() -> None:
    y = np.array([1.0, 1e-15, -1.0, -1e-15, 1.0])
    crossings = zero_crossings(made(y, np.ones(5), np.array([0.0, 4.0])))
    assert crossings[:, 0] == pytest.approx([1.0, 3.0])


def test_unequal_ends() -> None:
    nan = math.nan
    cycle = Cycle(1, 3.0, -1.0, 300.0, -100.0, 1.0, math.pi * 1600.0, (), nan, nan, nan)
    assert cycle.effective_stiffness == pytest.approx(100.0)
    assert cycle.effective_damping == pytest.approx(2.0)


def test_a_sample_repeated_at_the_turn_does_not_join_two_strokes() -> None:
    assert known_cycles(parallelogram(2.0))[1].post_yield_stiffness == pytest.approx(STIFFNESS)


def test_the_end_of_a_cycle_that_begins_at_the_peak_has_friction() -> None:
    y = AMPLITUDE * np.cos(2.0 * math.pi * np.arange(201) / 100.0)
    side = np.sign(np.diff(y, prepend=y[0]))
    first, second = known_cycles(made(y, STRENGTH * side, np.array([0.0, 100.0, 200.0])))
    assert first.force_at_largest == pytest.approx(second.force_at_largest)


@pytest.mark.parametrize("y", [np.zeros(30), np.repeat([0.0, 10.0, -10.0], 10)])
def test_motions_without_strokes_have_no_stiffness(y: np.ndarray) -> None:
    (cycle,) = known_cycles(made(y, np.zeros(y.size), np.array([0.0, y.size - 1.0])))
    assert np.isnan([cycle.effective_stiffness, cycle.effective_damping]).all() == (not y.any())
