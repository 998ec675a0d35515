"""The coefficient and the temperature of a loop against those of the virtual machine that made it."""

from dataclasses import replace

import numpy as np
import pytest

from dcfp.analysis.rig import (
    Measurement,
    Program,
    Recorded,
    RigTest,
    Sine,
    Triangle,
    VerticalLoad,
    run_program,
)
from dcfp.arrays import freeze
from dcfp.errors import InputError
from dcfp.inference.identification import friction_history
from dcfp.inference.identification.friction_history import Smoothed, contact_temperature
from dcfp.system import (
    LI_2020,
    Bearing,
    FittedFriction,
    NoHeating,
    PreciseHeating,
    SimplifiedHeating,
    System,
)

TWO = Bearing((2000.0, 3000.0), 300.0, 60.0, 1.0e6)


def machine(waveform, bearing=LI_2020, heating=None, law=None, pressure=60.0):
    test = RigTest("test", waveform, VerticalLoad((pressure,)))
    (loops,) = run_program(
        Program("one", (test,)), bearing, law or FittedFriction(), heating or SimplifiedHeating()
    )
    return loops, Measurement(
        "test",
        freeze(loops.time),
        freeze(loops.displacement),
        freeze(loops.force),
        freeze(loops.load),
        None,
        "",
    )


@pytest.mark.parametrize("heating", [SimplifiedHeating(), PreciseHeating(), NoHeating()])
@pytest.mark.parametrize(
    "waveform", [Sine(200.0, 400.0, 3), Sine(440.0, 300.0, 2), Triangle(150.0, 200.0, 2)]
)
def test_it_finds_what_the_machine_knew(waveform, heating) -> None:
    loops, measurement = machine(waveform, heating=heating)
    history = friction_history(measurement, LI_2020, heating)
    used = history.used
    assert used.mean() > 0.85
    np.testing.assert_allclose(history.coefficient[used], loops.friction[used], rtol=1e-8)
    # of a triangle the machine gives the speed before a corner, which is not used
    np.testing.assert_allclose(history.speed[used], np.abs(loops.velocity[used]), rtol=1e-4)
    # the fall of the coefficient within the first steps is steeper than a line
    rise = max(float(np.ptp(loops.temperature)), 1e-9)
    error = np.abs(history.temperature - loops.temperature)[used] / rise
    assert error.max() <= 0.01
    # at the corner of a triangle spring (b) takes a fifth of a step, and there the heat is a fifth too much
    late = history.time[used] > 0.1 * history.time[-1]
    assert error[late].max() <= (0.006 if waveform.kind == "triangle" else 0.002)


def test_two_different_plates_of_one_coefficient() -> None:
    law = FittedFriction(temperature_rate=0.0)  # then both plates have the coefficient of the bearing
    loops, measurement = machine(Sine(200.0, 300.0, 2), TWO, law=law)
    history = friction_history(measurement, TWO, SimplifiedHeating())
    late = history.used & (history.time > 0.1 * history.time[-1])
    np.testing.assert_allclose(history.temperature[late], loops.temperature[late], rtol=5e-3)


def test_samples_near_reversals_are_left_out_by_the_reach_of_spring_b() -> None:
    soft = replace(LI_2020, elastic_stiffness=1e5)
    _, measurement = machine(Sine(50.0, 50.0, 2), soft)
    few = friction_history(measurement, soft, SimplifiedHeating()).used
    many = friction_history(measurement, LI_2020, SimplifiedHeating()).used
    assert few.sum() < many.sum()


# while the spring is loaded the machine goes less than one sample, four, or forty
@pytest.mark.parametrize("samples", [2000, 20_000])
@pytest.mark.parametrize("stiffness", [2e5, LI_2020.elastic_stiffness])
def test_what_loads_the_spring_at_the_start_neither_slides_nor_heats(samples, stiffness) -> None:
    bearing = replace(LI_2020, elastic_stiffness=stiffness)
    time = np.linspace(0.0, 2.0 * np.pi, samples)
    loops, measurement = machine(Recorded(time, 200.0 * np.sin(time)), bearing)
    history = friction_history(measurement, bearing, SimplifiedHeating())
    np.testing.assert_allclose(history.coefficient[history.used], loops.friction[history.used], rtol=1e-8)
    early = history.used & (history.time < 0.2)
    rise = loops.temperature[early] - 20.0
    np.testing.assert_allclose(history.temperature[early] - 20.0, rise, rtol=0.025)


@pytest.mark.parametrize("heating", [SimplifiedHeating(), PreciseHeating()])
@pytest.mark.parametrize("bearing", [LI_2020, TWO])
def test_a_sample_is_not_heated_by_its_own_noise(bearing, heating) -> None:
    time = np.linspace(0.0, 3.0, 301)
    displacement, velocity = 100.0 * np.sin(2.0 * time), 200.0 * np.cos(2.0 * time)
    force = 1e5 * np.sign(velocity)
    motion = Smoothed(displacement, velocity, 0)
    kick = np.where(np.arange(301) == 60, 1e4, 0.0)

    def temperature(values, used):
        return contact_temperature(time, motion, values, used, System(bearing, heating=heating))

    none, all_used = np.zeros(301, bool), np.ones(301, bool)
    felt = temperature(force + kick, none) - temperature(force, none)
    kept = temperature(force + kick, all_used) - temperature(force, all_used)
    assert felt[60] > 0.02
    assert abs(kept[60]) < 2e-3 * felt[60]
    assert kept[63:] == pytest.approx(felt[63:], abs=1e-9)


def test_a_stroke_within_the_elastic_deformation_is_refused() -> None:
    soft = LI_2020.unchecked(elastic_stiffness=1e4)
    _, measurement = machine(Sine(20.0, 20.0, 2))
    with pytest.raises(InputError, match="steady sliding"):
        friction_history(measurement, soft, SimplifiedHeating())


def test_force_and_load_are_needed() -> None:
    _, measurement = machine(Sine(20.0, 20.0, 1))
    for missing in ("force", "load"):
        with pytest.raises(InputError, match=f"no column '{missing}"):
            friction_history(
                replace(measurement, **{f"optional_{missing}": None}), LI_2020, SimplifiedHeating()
            )
