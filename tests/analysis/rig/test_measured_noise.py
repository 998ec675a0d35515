"""Measures of noisy measurements: close to those of the test behind them."""

from dataclasses import replace

import numpy as np
import pytest

from dcfp.analysis.rig import Measurement, Program, RigTest, Sine, VerticalLoad, load_program, run_program
from dcfp.analysis.rig.program import measured_test
from dcfp.analysis.rig.waveform import STARTS, cycle_bounds
from dcfp.arrays import freeze
from dcfp.errors import InputError
from dcfp.system import PreciseHeating


def noisy(loops, displacement: float, force: float, seed: int = 3) -> Measurement:
    """Return what instruments with white noise [mm, N] would have measured."""
    random = np.random.default_rng(seed)
    size = loops.time.size
    return Measurement(
        loops.test.name,
        freeze(loops.time),
        freeze(loops.displacement + displacement * random.standard_normal(size)),
        freeze(loops.force + force * random.standard_normal(size)),
        freeze(loops.load),
        None,
        "",
    )


@pytest.fixture(scope="module")
def fast():
    return run_program(load_program("dependency").only(["T01"]), heating=PreciseHeating())[0]


@pytest.mark.parametrize("displacement", [0.0, 0.01, 0.03, 0.1])
@pytest.mark.parametrize("seed", range(4))
def test_noise_changes_the_measures_little(fast, displacement, seed):
    measured = noisy(fast, displacement, 2e3, seed).cycles
    assert len(measured) == len(fast.cycles)
    for found, true in zip(measured, fast.cycles, strict=True):
        assert found.effective_stiffness == pytest.approx(true.effective_stiffness, rel=0.03)
        assert found.effective_damping == pytest.approx(true.effective_damping, rel=0.03)
        assert found.energy == pytest.approx(true.energy, rel=0.01)
        assert len(found.crossings) == len(true.crossings)
        assert found.friction == pytest.approx(true.friction, rel=0.03)


@pytest.mark.parametrize("start", [s for s in STARTS if s != "peak"])
def test_a_file_has_the_cycles_of_the_test_behind_it(start):
    loops = run_program(Program("a", (RigTest("a", Sine(150.0, 300.0, 3, start), VerticalLoad((60.0,))),)))[0]
    bounds = cycle_bounds(loops.time, loops.displacement)
    assert bounds == pytest.approx(loops.cycle_times, abs=1e-3 * loops.test.waveform.period)


def test_a_motion_too_noisy_to_be_driven_is_refused(fast):
    time = np.linspace(0.0, fast.time[-1], 50_000)
    shaken = np.interp(time, fast.time, fast.displacement) + 0.05 * np.random.default_rng(1).standard_normal(
        time.size
    )
    measured = Measurement("huge", freeze(time), freeze(shaken), None, None, None, "")
    with pytest.raises(InputError, match="too noisy to be driven"):
        measured_test(measured)
    assert measured_test(noisy(fast, 0.01, 0.0)).waveform.peak_velocity == pytest.approx(400.0, rel=0.03)


def test_later_tests_of_a_story_bring_those_before_them():
    program = load_program("asce").only(["T12b"])
    assert [test.name for test in program.tests] == ["T12a", "T12b"]
    alone = run_program(program)[1]
    whole = {test.test.name: test for test in run_program(load_program("asce").only(["T12c"]))}["T12b"]
    assert alone.peak_temperature == pytest.approx(whole.peak_temperature, abs=0.1)
    assert replace(program, code="").sequences == program.sequences
