"""Dependency tests whose law is known: 4 speeds and 3 pressures, without noise and with it."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from dcfp.analysis.rig import Measurement, Program, RigTest, Sine, VerticalLoad, run_program
from dcfp.arrays import freeze
from dcfp.system import LI_2020, FittedFriction, SimplifiedHeating

AMPLITUDE, CYCLES = 200.0, 4.0
SPEEDS, PRESSURES = (20.0, 50.0, 150.0, 400.0), (40.0, 80.0)

Noisy = Callable[[Measurement, np.random.Generator], Measurement]


def measured(program: Program, law=None, heating=None, bearing=LI_2020) -> tuple[Measurement, ...]:
    """Return what a perfect instrument would have measured in a program."""
    loops = run_program(program, bearing, law or FittedFriction(), heating or SimplifiedHeating())
    return tuple(
        Measurement(
            test.test.name,
            freeze(test.time),
            freeze(test.displacement),
            freeze(test.force),
            freeze(test.load),
            None,
            "",
        )
        for test in loops
    )


def sine_test(name: str, speed: float, pressure: float, amplitude: float = AMPLITUDE) -> RigTest:
    return RigTest(name, Sine(amplitude, speed, CYCLES), VerticalLoad((pressure,)))


@pytest.fixture(scope="session")
def measure() -> Callable[..., tuple[Measurement, ...]]:
    """Measure single tests, each (name, speed, pressure), without noise."""

    def call(
        *tests: tuple[str, float, float], amplitude: float = AMPLITUDE, **models
    ) -> tuple[Measurement, ...]:
        program = Program("tests", tuple(sine_test(*test, amplitude) for test in tests))
        return measured(program, **models)

    return call


@pytest.fixture(scope="session")
def dependency(measure) -> dict[str, Measurement]:
    """The dependency tests by name: V20, V50, V150, V400 at 60 N/mm2, and P40, P80 at 20 mm/s."""
    tests = [(f"V{speed:.0f}", speed, 60.0) for speed in SPEEDS]
    tests += [(f"P{pressure:.0f}", 20.0, pressure) for pressure in PRESSURES]
    return {test.name: test for test in measure(*tests)}


@pytest.fixture(scope="session")
def noisy() -> Noisy:
    """Add white noise: 2 % of the peak force, 2 % of the mean load, 0.05 % of the amplitude."""

    def call(test: Measurement, random: np.random.Generator) -> Measurement:
        def noise(size: float) -> np.ndarray:
            return size * random.standard_normal(test.time.size)

        return replace(
            test,
            displacement=freeze(test.displacement + noise(5e-4 * np.abs(test.displacement).max())),
            optional_force=freeze(test.force + noise(0.02 * np.abs(test.force).max())),
            optional_load=freeze(test.load + noise(0.02 * test.load.mean())),
        )

    return call
