"""What is said where an assumption is left, and measures that would mislead."""

import math

import numpy as np
import pytest

from dcfp.analysis.rig import Program, RigTest, Sine, VerticalLoad, run_program
from dcfp.errors import InputError
from dcfp.system import ConstantFriction, FittedFriction, NoHeating, SimplifiedHeating


def run(wave: Sine, load: VerticalLoad, friction=None, heating=None):
    return run_program(Program("a", (RigTest("a", wave, load),)), friction=friction, heating=heating)[0]


def test_a_short_dip_of_the_load_is_felt():
    """It lasts less than a piece of the slow motion."""
    dip = VerticalLoad((7.54e6, 7.54e6, 0.377e6, 7.54e6), (0.0, 20.0, 20.06, 20.12), is_pressure=False)
    loops = run(Sine(200.0, 20.0, 1), dip, ConstantFriction(), NoHeating())
    assert loops.load.min() == pytest.approx(0.377e6)
    steady = run(
        Sine(200.0, 20.0, 1), VerticalLoad((7.54e6,), is_pressure=False), ConstantFriction(), NoHeating()
    )
    assert np.interp(19.9, loops.time, loops.force) == pytest.approx(
        np.interp(19.9, steady.time, steady.force), rel=1e-6
    )
    stored = 0.5 * loops.bearing.elastic_stiffness * loops.elongation**2
    friction_work = np.concatenate(([0.0], np.cumsum(np.diff(loops.hysteretic_energy + stored))))
    assert friction_work[-1] < steady.hysteretic_energy[-1]


@pytest.mark.parametrize(
    "times", [[], [0.0], [1e-12], [0.3, 0.3 + 1e-12], np.linspace(0.0, 20.0, 57).tolist()]
)
def test_a_path_cut_is_the_same_path(times):
    travel = Sine(100.0, 50.0, 1.5).travel()
    cut = travel.cut_at(np.array(times))
    assert cut.lengths.sum() == pytest.approx(travel.lengths.sum(), rel=1e-12)
    assert (cut.lengths > 0.0).all()
    sine = 100.0 * np.sin(0.5 * cut.time[:-1])
    assert cut.pieces[:, 0] == pytest.approx(sine, abs=1e-6)
    assert cut.pieces[:, 1] == pytest.approx(50.0 * np.cos(0.5 * cut.time[:-1]), abs=1e-4)


def test_a_load_that_changes_leaves_no_friction_of_the_loop():
    time = np.linspace(0.0, 4.0 * math.pi, 400)
    load = VerticalLoad(tuple(7.54e6 * (1.0 + 0.3 * np.sin(2.0 * time))), tuple(time), is_pressure=False)
    cycle = run(Sine(100.0, 100.0, 2), load, ConstantFriction(), NoHeating()).cycles[1]
    assert not cycle.steady_load
    assert math.isnan(cycle.loop_friction)
    assert math.isnan(cycle.post_yield_stiffness)
    assert cycle.friction == pytest.approx(0.043, rel=1e-6)


def test_a_test_that_never_slides_says_so():
    loops = run(Sine(0.1, 1.0, 2), VerticalLoad((60.0,)))
    assert not loops.sliding.any()
    assert any("never slides" in remark for remark in loops.remarks)


@pytest.mark.parametrize(("ambient", "said"), [(20.0, False), (10.0, False), (-20.0, True), (40.0, True)])
def test_plates_far_from_the_temperature_of_the_tests(ambient, said):
    loops = run(Sine(100.0, 100.0, 1), VerticalLoad((60.0,)), heating=SimplifiedHeating(ambient=ambient))
    assert any("at the start, not 20" in remark for remark in loops.remarks) is said


def test_a_fitted_law_knows_its_tests():
    law = FittedFriction(tested_pressure=(40.0, 80.0), tested_speed=(5.0, 400.0), tested_ambient=20.0)
    assert run(Sine(200.0, 390.0, 1), VerticalLoad((60.0,)), law).remarks == ()
    remarks = " ".join(run(Sine(300.0, 600.0, 1), VerticalLoad((90.0,)), law).remarks)
    assert "above 80 N/mm2" in remarks
    assert "faster than 400 mm/s" in remarks
    assert FittedFriction(tested_pressure=[40, 80]).tested_pressure == (40.0, 80.0)
    for wrong in ((80.0, 40.0), (1.0,), "x", (1.0, "x")):
        with pytest.raises(InputError):
            FittedFriction(tested_pressure=wrong)
