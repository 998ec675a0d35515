"""Response history analysis: restarts, steps, tails, plates, laws of a user's own."""

import dataclasses
import itertools
import json
import math
import os
import subprocess
import sys

import numpy as np
import pytest

import dcfp
from dcfp import (
    LI_2020,
    Bearing,
    ConstantFriction,
    GroundMotion,
    InputError,
    Kumar2015,
    Li2020,
    NoHeating,
    PreciseHeating,
    SimplifiedHeating,
    UserFriction,
    respond,
)
from dcfp.analysis import Status
from dcfp.analysis.integration import Keep

HEATINGS = [NoHeating(), SimplifiedHeating(), PreciseHeating(cells=24)]


@pytest.fixture(scope="module")
def motion():
    return dcfp.load_motion("NCC").scaled_to_pgv(750.0)


def cut(motion, first, last):
    return dataclasses.replace(motion, acceleration=motion.acceleration[first : last + 1])


@pytest.mark.parametrize("heating", HEATINGS, ids=lambda h: h.name)
def test_restarts_from_a_saved_state_leave_the_answer_unchanged(motion, heating):
    whole = respond(motion, heating=heating, tail=0.0)
    pieces = [0, 3, 517, 518, 1200, motion.acceleration.size - 1]
    state, displacement, structure_velocity = None, [0.0], [0.0]
    for first, last in itertools.pairwise(pieces):
        part = respond(cut(motion, first, last), heating=heating, tail=0.0, start=state)
        state = part.final_state
        displacement.extend(part.displacement[1:])
        structure_velocity.extend(part.structure_velocity[1:])
    np.testing.assert_allclose(displacement, whole.displacement, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(structure_velocity, whole.structure_velocity, rtol=0.0, atol=1e-8)
    assert part.peak_displacement == pytest.approx(whole.peak_displacement, rel=1e-12)
    assert part.peak_temperature == pytest.approx(whole.peak_temperature, rel=1e-12)
    assert part.energy.input[-1] == pytest.approx(whole.energy.input[-1], rel=1e-11)
    assert part.energy.absolute_input[-1] == pytest.approx(whole.energy.absolute_input[-1], rel=1e-9)


def test_a_state_begun_afresh_keeps_motion_and_heat_but_no_peaks(motion):
    first = respond(motion)
    second = respond(motion.scaled(1e-3), start=first.final_state.afresh())
    assert second.displacement[0] == first.displacement[-1]
    assert second.temperature[0] == pytest.approx(first.temperature[-1])
    assert second.peak_displacement < 1.01 * abs(first.displacement[-1])
    assert second.peak_change < 1.0
    assert second.energy.input[0] == 0.0


@pytest.mark.parametrize("other", [PreciseHeating(cells=32), SimplifiedHeating(18.0), NoHeating()])
def test_a_state_of_another_model_is_refused(motion, other):
    state = respond(motion).final_state
    with pytest.raises(InputError, match="another bearing, friction law or heating model"):
        respond(motion, heating=other, start=state)


def test_a_restart_may_need_more_of_the_plate_than_there_was(motion):
    heating = PreciseHeating(cells=16)
    state = respond(motion, heating=heating).final_state
    response = respond(dcfp.load_motion("IVD").scaled_to_pgv(1500.0), heating=heating, start=state.afresh())
    assert response.peak_displacement > 700.0
    assert response.final_state.plates.cells.shape[1] > state.plates.cells.shape[1]


def test_the_smallest_friction_is_that_of_the_turn(motion):
    response = respond(motion)
    fine = respond(motion, step=0.001)
    assert response.least_friction == pytest.approx(fine.least_friction, rel=2e-3)


def test_a_state_is_not_changed_by_starting_from_it(motion):
    state = respond(cut(motion, 0, 900), tail=0.0).final_state
    rest = cut(motion, 900, motion.acceleration.size - 1)
    once = respond(rest, start=state)
    again = respond(rest, start=state)
    np.testing.assert_array_equal(once.displacement, again.displacement)


@pytest.mark.parametrize("heating", HEATINGS, ids=lambda h: h.name)
def test_shorter_steps_change_little(motion, heating):
    default = respond(motion, heating=heating)
    fine = respond(motion, heating=heating, step=motion.time_step / 7.5, tolerance=1e-4)
    assert fine.time[1] == pytest.approx(motion.time_step / 8.0)
    assert default.peak_displacement == pytest.approx(fine.peak_displacement, rel=1e-3)
    assert default.peak_temperature == pytest.approx(fine.peak_temperature, abs=0.2)


def test_a_step_longer_than_the_records_changes_nothing(motion):
    np.testing.assert_array_equal(respond(motion, step=1.0).displacement, respond(motion).displacement)


@pytest.mark.parametrize("heating", HEATINGS, ids=lambda h: h.name)
def test_energy_closes(motion, heating):
    response = respond(motion, heating=heating)
    assert response.energy.relative_residual < 1e-12
    assert (np.diff(response.energy.hysteretic) > -1e-9 * response.energy.hysteretic[-1]).all()


def test_absolute_input_energy_is_the_work_on_the_moving_ground(motion):
    response = respond(motion, step=motion.time_step / 20.0, tail=0.0)
    power = response.structure_acceleration * response.bearing.mass * response.ground_velocity
    middle = 0.5 * (power[1:] + power[:-1]) * response.time[1]
    work = np.concatenate(([0.0], np.cumsum(middle)))
    np.testing.assert_allclose(response.energy.absolute_input, work, atol=2e-4 * np.abs(work).max())
    absolute_kinetic = 0.5 * response.bearing.mass * response.structure_velocity**2
    balance = (
        response.energy.absolute_input
        - absolute_kinetic
        - response.energy.strain
        - response.energy.hysteretic
    )
    np.testing.assert_allclose(balance, 0.0, atol=1e-9 * np.abs(work).max())


def test_without_a_tail_given_it_goes_on_until_rest(motion):
    response = respond(motion)
    assert response.status is Status.OK
    assert response.time[-1] >= motion.duration
    longer = respond(motion, tail=40.0)
    assert longer.residual_displacement == pytest.approx(response.residual_displacement, abs=1e-9)
    late = longer.displacement[-200:]
    assert late.mean() == pytest.approx(response.residual_displacement, abs=0.05)


def test_an_analysis_cut_short_says_that_it_still_moves(motion):
    moving = int(np.argmax(np.abs(respond(motion).velocity)))
    short = respond(cut(motion, 0, moving), tail=0.0)
    assert short.status is Status.STILL_MOVING
    assert any("still moves" in remark for remark in short.remarks)


def test_a_moment_of_sticking_at_the_end_is_not_rest():
    motion = dcfp.load_motion("KNA").scaled_to_pgv(500.0)
    short = respond(cut(motion, 0, 1408), tail=0.0)
    assert short.status is (Status.OK if short.rests else Status.STILL_MOVING)
    assert respond(cut(motion, 0, 1408)).status is Status.OK


def test_the_way_to_rest_does_not_depend_on_the_step(motion):
    short = cut(motion, 0, 1200)  # ends while the ground accelerates
    plain, fine = respond(short), respond(short, step=motion.time_step / 5.0)
    assert plain.ground_velocity[-1] == pytest.approx(fine.ground_velocity[-1], rel=1e-12)
    assert plain.residual_displacement == pytest.approx(fine.residual_displacement, abs=0.05)


def test_assumptions_that_are_left_are_said(motion):
    soft = dataclasses.replace(LI_2020, elastic_stiffness=3e4)
    assert any("spring (b) is soft" in remark for remark in respond(motion, soft).remarks)
    unequal = dataclasses.replace(LI_2020, radii=(6000.0, 3000.0))
    assert any("two plates differ" in remark for remark in respond(motion, unequal).remarks)
    assert respond(motion.scaled(0.5)).remarks == ()


def test_exceeding_the_capacity_is_reported(motion):
    tight = dataclasses.replace(LI_2020, displacement_capacity=50.0, capacity_note="a test")
    response = respond(motion, tight)
    assert response.status is Status.BEYOND_CAPACITY
    assert any("50 mm (a test)" in remark for remark in response.remarks)
    unknown = dataclasses.replace(LI_2020, displacement_capacity=None)
    assert respond(motion, unknown).status is Status.OK


def test_a_motion_of_zeros_moves_nothing():
    response = respond(GroundMotion(np.zeros(50), 0.01))
    assert response.peak_displacement == 0.0
    assert response.energy.relative_residual == 0.0
    assert response.peak_temperature == 20.0


def test_velocity_of_structure_and_ground(motion):
    response = respond(motion)
    n = motion.velocity.size
    np.testing.assert_allclose(response.ground_velocity[:n], motion.velocity, atol=1e-9)
    np.testing.assert_allclose(
        response.structure_velocity - response.ground_velocity, response.velocity, atol=1e-9
    )


def test_force_stays_within_the_yield_surface(motion):
    response = respond(motion)
    friction_force = response.force - LI_2020.restoring_stiffness * response.displacement
    available = response.friction * LI_2020.vertical_force
    assert (np.abs(friction_force) <= available * (1.0 + 1e-6)).all()


@pytest.mark.parametrize("heating", HEATINGS, ids=lambda h: h.name)
def test_two_plates_that_hardly_differ_are_as_two_equal_ones(motion, heating):
    equal = respond(motion, heating=heating)
    nearly = dataclasses.replace(LI_2020, radii=(4500.001, 4499.999))
    response = respond(motion, nearly, heating=heating)
    assert response.lines.shape[1] == equal.lines.shape[1] + 1
    assert response.peak_displacement == pytest.approx(equal.peak_displacement, rel=1e-4)
    assert response.peak_temperature == pytest.approx(equal.peak_temperature, abs=0.02)


def test_the_plate_with_the_larger_radius_gets_hotter(motion):
    response = respond(motion, dataclasses.replace(LI_2020, radii=(6000.0, 3000.0)))
    lower, upper = response.lines[:, -2:].max(axis=0)
    assert lower > upper > 20.0
    assert response.energy.relative_residual < 1e-12


def test_a_single_plate_takes_all_the_travel(motion):
    single = dataclasses.replace(LI_2020, radii=(9000.0,))
    friction = ConstantFriction()
    one, two = respond(motion, single, friction), respond(motion, LI_2020, friction)
    np.testing.assert_allclose(one.displacement, two.displacement, atol=1e-9)
    # the same friction work on one plate instead of two
    contact = np.abs(two.displacement) < single.contact_half_side
    assert contact.all()
    np.testing.assert_allclose(one.temperature - 20.0, 2.0 * (two.temperature - 20.0), atol=1e-6)


@pytest.mark.slow
def test_a_user_law_equal_to_a_built_in_one_gives_its_answer(motion):
    def law(pressure, speed, temperature):
        gamma = 2.03 * pressure**-0.19 + 0.068
        alpha = 1.0 - 0.55 * math.exp(-0.019 * speed)
        return 0.075 * gamma * alpha * 1.13 * math.exp(-0.007 * temperature)

    own = respond(motion, friction=UserFriction(law))
    built_in = respond(motion, friction=Li2020())
    np.testing.assert_allclose(own.displacement, built_in.displacement, atol=1e-9)


def test_the_temperature_field_of_the_precise_model(motion):
    response = respond(motion, heating=PreciseHeating(cells=32), keep=Keep(every=50))
    profiles = response.profiles
    assert profiles is not None
    assert profiles.temperature.shape == (profiles.time.size, 1, profiles.position.size)
    late = profiles.temperature[-1, 0]
    assert abs(profiles.position[np.argmax(late)]) < LI_2020.contact_half_side
    assert late.max() > 40.0
    assert late[0] == pytest.approx(20.0, abs=0.01)
    # the mean over the contact is the temperature that the friction law saw
    for k in (5, 20, -1):
        place = round(profiles.time[k] / motion.time_step)
        centre = 0.5 * response.displacement[place]
        half = LI_2020.contact_half_side
        fine = np.linspace(centre - half, centre + half, 20_001)
        width = profiles.position[1] - profiles.position[0]
        cell = np.clip(
            np.round((fine - profiles.position[0]) / width).astype(int), 0, profiles.position.size - 1
        )
        mean = profiles.temperature[k, 0][cell].mean()
        assert mean == pytest.approx(response.temperature[place], abs=0.3)


def test_the_field_does_not_change_the_answer(motion):
    plain = respond(motion, heating=PreciseHeating())
    kept = respond(motion, heating=PreciseHeating(), keep=Keep(every=37))
    np.testing.assert_allclose(kept.displacement, plain.displacement, atol=1e-9)


def test_travel_beyond_the_first_line_of_cells():
    motion = dcfp.load_motion("IVD").scaled_to_pgv(1400.0)
    response = respond(motion, heating=PreciseHeating(cells=16))
    assert response.peak_displacement > 650.0
    assert response.energy.relative_residual < 1e-12


#: Peaks and steps under two laws and two models of the heating.
AGREEING = """
import json, dcfp, numpy as np
time = np.arange(0, 4, 0.02)
motion = dcfp.GroundMotion(3000.0 * np.sin(2.0 * np.pi * time) * np.exp(-((time - 2.0) ** 2)), 0.02)
responses = [
    dcfp.respond(motion, friction=law, heating=heating, tail=0.0)
    for law in (dcfp.Li2020(), dcfp.Kumar2015())
    for heating in (dcfp.SimplifiedHeating(), dcfp.PreciseHeating(cells=8))
]
print(json.dumps([[one.peak_displacement, one.peak_temperature, one.steps] for one in responses]))
"""


@pytest.mark.slow
def test_compiled_and_interpreted_kernels_agree(tmp_path, capsys):
    exec(AGREEING, {})
    here = json.loads(capsys.readouterr().out)
    other = "1" if os.environ.get("NUMBA_DISABLE_JIT", "0") == "0" else "0"
    done = subprocess.run(
        [sys.executable, "-c", AGREEING],
        env={**os.environ, "NUMBA_DISABLE_JIT": other},
        capture_output=True,
        text=True,
        check=True,
        cwd=tmp_path,
    )
    np.testing.assert_allclose(here, json.loads(done.stdout), rtol=1e-9)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"tail": -1.0}, "tail"),
        ({"tail": math.nan}, "tail"),
        ({"tolerance": 0.0}, "tolerance"),
        ({"tolerance": 1.0}, "tolerance"),
        ({"step": 0.0}, "step"),
        ({"step": -0.01}, "step"),
        ({"keep": Keep(every=10)}, "precise heating"),
    ],
)
def test_bad_settings_get_a_sentence(motion, arguments, words):
    with pytest.raises(InputError, match=words):
        respond(motion, **arguments)


@pytest.mark.slow
def test_unequal_bearing_with_speed_of_the_surface():
    """A law of the surface's speed on a double bearing sees half of the relative speed."""
    motion = dcfp.load_motion("KNA").scaled_to_pgv(400.0)
    double = respond(motion, LI_2020, Kumar2015(temperature_dependent=False), NoHeating())

    def half_speed(pressure, speed, temperature):
        return 0.075 * (1.0 - 0.5 * math.exp(-0.1 * 0.5 * speed))

    own = respond(motion, LI_2020, UserFriction(half_speed), NoHeating())
    np.testing.assert_allclose(own.displacement, double.displacement, atol=1e-8)


def test_bearing_scales_with_its_slider(motion):
    """The same pressure on a larger slider: all forces grow, the motion stays (spring (b) scaled alike)."""
    large = Bearing((4500.0, 4500.0), 800.0, 60.0, 4 * 1.9e6)
    small, big = respond(motion, LI_2020, heating=NoHeating()), respond(motion, large, heating=NoHeating())
    np.testing.assert_allclose(big.displacement, small.displacement, atol=1e-9)
    np.testing.assert_allclose(big.force, 4.0 * small.force, rtol=1e-9, atol=1e-3)


FIRST_TIMES = """
import time
time.perf_counter = time.thread_time  # whatever else the machine does
import dcfp
motion = dcfp.load_motion("NCC")
print(*(dcfp.respond(motion).elapsed for _ in range(8)))
"""


@pytest.mark.slow
def test_the_time_of_the_first_analysis_is_its_own():
    """Neither loading the kernels nor finding their arguments' types, of ten times the length, counts as analysis."""
    done = subprocess.run(
        [sys.executable, "-c", FIRST_TIMES], capture_output=True, text=True, check=True, timeout=300
    )
    first, *others = map(float, done.stdout.split())
    assert 0.0 < first < 4.0 * sorted(others)[len(others) // 2]
