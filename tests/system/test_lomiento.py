"""The law that wears off with the dose of rubbing."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import dcfp
from dcfp.analysis.rig import Program, RigTest, Sine, Triangle, VerticalLoad, load_program, run_program
from dcfp.errors import InputError
from dcfp.kernels.friction import coefficient, with_reference
from dcfp.system import LI_2020, Li2020, Lomiento2013, NoHeating, PreciseHeating


def test_factors_at_their_references():
    law = Lomiento2013(
        reference_pressure=300.0, velocity_ratio=2.0, reference_speed=25.0, reference_dose=1e7, dose_power=0.3
    )
    assert law.pressure_factor(0.0) == 1.0
    assert law.pressure_factor(300.0) == pytest.approx(np.exp(-1.0))
    assert law.velocity_factor(0.0) == 1.0
    assert law.velocity_factor(1e6) == pytest.approx(2.0)
    assert law.dose_factor(0.0) == 1.0
    assert law.dose_factor(1e7) == pytest.approx(np.exp(-1.0))


@given(
    pressure=st.floats(5.0, 120.0),
    speed=st.floats(0.0, 2e3),
    dose=st.floats(0.0, 1e9),
    ratio=st.floats(0.5, 5.0),
    power=st.floats(0.1, 3.0),
)
def test_compiled_and_array_forms_agree(pressure, speed, dose, ratio, power):
    law = Lomiento2013(velocity_ratio=ratio, dose_power=power)
    compiled = coefficient(law.at_pressure(pressure), pressure, speed, 20.0, dose)
    assert compiled == pytest.approx(float(law.coefficient(pressure, speed, 20.0, dose)), rel=1e-11)


def test_the_reference_alone_carries_the_pressure():
    law = Lomiento2013()
    moved = with_reference(law.at_pressure(60.0), law.at_pressure(40.0).reference)
    assert moved == law.at_pressure(40.0)


def test_defaults_restate_the_law_of_li():
    """What the docstring says of them: pressure within 1.1 % from 40 to 80 N/mm2, velocity exactly, and the fit to test T01 within 0.9 %."""
    law, paper = Lomiento2013(), Li2020()
    pressure = np.linspace(40.0, 80.0, 9)
    ours = law.pressure_factor(pressure) / law.pressure_factor(60.0)
    assert ours == pytest.approx(paper.pressure_factor(pressure) / paper.pressure_factor(60.0), rel=1.1e-2)
    speed = np.array([0.0, 10.0, 100.0, 400.0])
    ours = law.velocity_factor(0.5 * speed) / law.velocity_ratio
    assert ours == pytest.approx(paper.velocity_factor(speed))
    fast = load_program("dependency").only(["T01"])
    heated = run_program(fast, heating=PreciseHeating())[0]
    worn = run_program(fast, friction=law, heating=NoHeating())[0]
    assert np.abs(worn.crossings[:, 1]) == pytest.approx(np.abs(heated.crossings[:, 1]), rel=9e-3)


@pytest.mark.parametrize(
    ("wave", "mean_square"),
    [(Triangle(100.0, 200.0, 2), 200.0**2), (Sine(100.0, 200.0, 2), 0.5 * 200.0**2)],
)
def test_the_dose_is_the_integral_of_pressure_and_squared_speed(wave, mean_square):
    law = Lomiento2013(reference_dose=1e6, dose_power=0.7)
    loops = run_program(
        Program("a", (RigTest("a", wave, VerticalLoad((45.0,))),)), friction=law, heating=NoHeating()
    )[0]
    # on each plate half of the speed; the little that it sticks adds nothing
    dose = 45.0 * 0.25 * mean_square * loops.time[-1]
    expected = float(law.coefficient(45.0, 0.5 * 200.0, 20.0, dose))
    assert loops.friction[-1] == pytest.approx(expected, rel=2e-3)


def test_what_has_worn_off_does_not_recover():
    wave, load = Sine(100.0, 200.0, 2), VerticalLoad((60.0,))
    tests = (RigTest("a", wave, load), RigTest("b", wave, load, pause=3600.0))
    first, second = run_program(Program("two", tests), friction=Lomiento2013(), heating=NoHeating())
    assert second.cycles[0].friction < first.cycles[-1].friction


def test_earthquakes_and_their_energy():
    motion = dcfp.load_motion("NCC").scaled_to_pgv(500.0)
    response = dcfp.respond(motion, friction=Lomiento2013())
    fine = dcfp.respond(motion, friction=Lomiento2013(), tolerance=1e-4, step=0.002)
    assert response.energy.relative_residual < 1e-12
    assert response.peak_displacement == pytest.approx(fine.peak_displacement, rel=1e-3)
    assert any("unconfirmed" in remark for remark in response.remarks)
    single = dcfp.respond(motion, dcfp.Bearing((9000.0,), 400.0, 60.0, 1.9e6), Lomiento2013())
    assert single.least_friction < response.least_friction  # the whole speed on one plate wears it off sooner


def test_it_says_where_it_has_no_tests():
    program = Program("a", (RigTest("a", Sine(400.0, 600.0, 1), VerticalLoad((90.0,))),))
    remarks = " ".join(run_program(program, LI_2020, Lomiento2013())[0].remarks)
    assert "above 80 N/mm2" in remarks
    assert "faster than 400 mm/s" in remarks


@pytest.mark.parametrize(
    "change",
    [
        {"mu_0": 0.0},
        {"velocity_ratio": -1.0},
        {"reference_dose": 0.0},
        {"dose_power": 5.0},
        {"reference_speed": float("nan")},
    ],
)
def test_impossible_constants_are_refused(change):
    with pytest.raises(InputError):
        Lomiento2013(**change)
