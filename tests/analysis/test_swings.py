"""The swings of a response from one peak of displacement to the next."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dcfp.analysis import Response, respond
from dcfp.analysis.swings import Swings, _zero_of_parabola, swings_of
from dcfp.constants import STANDARD_GRAVITY
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import load_motion
from dcfp.motion.named import all_keys, read_stored
from dcfp.system import LI_2020, ConstantFriction, NoHeating

NAMES = ["KNA", "NCC", "LPG", "IVD"]


@pytest.fixture(scope="module", params=NAMES)
def response(request: pytest.FixtureRequest) -> Response:
    return respond(load_motion(request.param).scaled_to_pgv(500.0))


# ----- closed forms -----


def test_an_elastic_oscillator_under_a_constant_acceleration() -> None:
    """y = - a / w2 (1 - cos w t): equal swings to and fro, and the ground takes back all that it gave."""
    acceleration, step = 100.0, 0.002
    motion = GroundMotion(np.full(151, acceleration), step)
    response = respond(motion, friction=ConstantFriction(0.5), heating=NoHeating(), tail=0.0)
    swings = swings_of(response)
    squared = (LI_2020.restoring_stiffness + LI_2020.elastic_stiffness) / LI_2020.mass
    change, half_period = 2.0 * acceleration / squared, math.pi / math.sqrt(squared)
    number = int(0.3 / half_period)
    assert len(swings) == number == 4
    np.testing.assert_allclose(swings.times, half_period * np.arange(number + 1), rtol=0.0, atol=1e-6)
    np.testing.assert_allclose(swings.changes, change * np.array([-1, 1, -1, 1]), rtol=1e-6)
    given = acceleration * change * LI_2020.mass
    np.testing.assert_allclose(swings.net_input, given * np.array([1, -1, 1, -1]), rtol=1e-6)
    np.testing.assert_allclose(
        swings.most_input, given * np.array([1, 0, 1, 0]), rtol=1e-6, atol=1e-6 * given
    )
    assert not swings.hysteretic.any()
    velocity = math.sqrt(2.0 * acceleration * change)
    assert swings[0].input_velocity == pytest.approx(velocity, rel=1e-6)
    assert swings.input_velocity == pytest.approx(velocity, rel=1e-6)
    assert swings[1].net_input_velocity == 0.0  # of what it took back there is no velocity
    assert (swings[1].start, swings[1].end) == (swings.times[1], swings.times[2])


def box(first: float, length: float, second: float, step: float = 1e-4) -> GroundMotion:
    """A ground acceleration of `first`, after `length` of `second`, up to 3 s; each change takes one step."""
    time = np.arange(round(3.0 / step) + 1) * step
    return GroundMotion(np.where(time < length, first, second), step)


def test_a_sliding_block() -> None:
    """Newmark's block on a ground that accelerates at A for T and then at -B: all of it in closed form.

    The analysis has a spring (b), stiff, and plates, flat; the acceleration takes a step of 1e-4 s to change. That leaves 5e-4.
    """
    a, b, length, friction = 1200.0, 300.0, 0.4, 0.05
    bearing = LI_2020.unchecked(radii=(5e9, 5e9), elastic_stiffness=1e5 * LI_2020.elastic_stiffness)
    response = respond(box(a, length, -b), bearing, ConstantFriction(friction), NoHeating(), tail=0.0)
    held = friction * STANDARD_GRAVITY
    fastest = (a - held) * length
    rising, falling = 0.5 * fastest * length, 0.5 * fastest**2 / (held + b)
    swing = swings_of(response).largest
    assert swing is not None
    assert swing.change == pytest.approx(-(rising + falling), rel=5e-4)
    assert swing.end == pytest.approx(length + fastest / (held + b), rel=5e-4)
    assert swing.input_velocity == pytest.approx(math.sqrt(2.0 * a * rising), rel=5e-4)
    assert swing.net_input_velocity == pytest.approx(math.sqrt(2.0 * (a * rising - b * falling)), rel=5e-4)
    assert swing.hysteretic_velocity == pytest.approx(math.sqrt(2.0 * held * (rising + falling)), rel=5e-4)


# ----- laws -----


def test_swings_go_to_and_fro(response: Response) -> None:
    swings = swings_of(response)
    assert len(swings) > 20
    assert (swings.changes[1:] * swings.changes[:-1] < 0.0).all()
    assert (np.diff(swings.times) > 0.0).all()
    assert (swings.most_input >= np.maximum(swings.net_input, 0.0)).all()


def test_swings_add_up_to_the_whole(response: Response) -> None:
    """Travel, input and dissipated energy between the start and the last turn, beside the histories themselves."""
    swings = swings_of(response)
    energy, mass = response.energy, response.bearing.mass
    last = swings.times[-1]
    whole = energy.input[-1]
    there = np.interp(last, response.time, energy.input)
    assert swings.net_input.sum() == pytest.approx(there, abs=1e-4 * whole)
    assert swings.hysteretic.sum() == pytest.approx(
        np.interp(last, response.time, energy.hysteretic), abs=1e-4 * whole
    )
    between_samples = np.abs(np.diff(response.displacement[response.time <= last])).sum()
    assert between_samples < np.abs(swings.changes).sum() < 1.01 * between_samples
    # Eq. (6) between two turns: what is put in and not dissipated is in the springs
    strain = np.interp(swings.times, response.time, energy.strain)
    left = swings.net_input - swings.hysteretic - np.diff(strain)
    assert np.abs(left).max() < 0.01 * whole
    assert swings.input_velocity >= math.sqrt(2.0 * swings.net_input.max() / mass)


def test_the_largest_swing_is_the_largest_change_of_the_analysis() -> None:
    """The analysis looks at every turn, these only at the samples.

    Swings that matter last many samples. Only where two turns fall between the same two samples, as the elastic oscillation of 0.126 s could
    at steps above 0.06 s, is a swing missed; no record is sampled like that. At 0.02 s the parabola leaves up to 5e-5.
    """
    for record in read_stored(all_keys()):
        for motion in (record.motion, record.motion.scaled_to_pgv(250.0)):
            response = respond(motion)
            largest = swings_of(response).largest
            assert largest is not None
            assert abs(largest.change) == pytest.approx(response.peak_change, rel=1e-4), motion.name


def test_a_mirrored_record_swings_the_other_way() -> None:
    motion = load_motion("NCC").scaled_to_pgv(500.0)
    there, back = swings_of(respond(motion)), swings_of(respond(motion.scaled(-1.0)))
    size = np.abs(there.displacements).max()
    np.testing.assert_allclose(back.times, there.times, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(back.displacements, -there.displacements, rtol=0.0, atol=1e-9 * size)
    np.testing.assert_allclose(back.most_input, there.most_input, atol=1e-9 * there.most_input.max())
    np.testing.assert_allclose(back.hysteretic, there.hysteretic, atol=1e-9 * there.hysteretic.max())


def test_finer_samples_show_the_same_swings(response: Response) -> None:
    finer = swings_of(respond(response.motion, step=0.25 * response.motion.time_step))
    swings = swings_of(response)
    one, other = swings.largest, finer.largest
    assert one is not None
    assert other is not None
    assert one.change == pytest.approx(other.change, rel=2e-3)
    assert one.end == pytest.approx(other.end, abs=1e-3)
    assert one.input_velocity == pytest.approx(other.input_velocity, rel=5e-3)
    assert one.hysteretic_velocity == pytest.approx(other.hysteretic_velocity, rel=2e-3)


# ----- what never turns -----


def nothing_in(swings: Swings) -> bool:
    return (
        len(swings) == 0
        and swings.largest is None
        and swings.input_velocity == swings.hysteretic_velocity == 0.0
    )


def test_a_response_that_never_moves_has_no_swing() -> None:
    assert nothing_in(swings_of(respond(GroundMotion(np.zeros(20), 0.01))))


def test_a_swing_still_going_on_is_not_one() -> None:
    response = respond(GroundMotion(np.full(20, 1000.0), 0.01), tail=0.0)
    assert response.displacement[-1] < -1.0
    assert nothing_in(swings_of(response))


@given(
    first=st.floats(0.01, 1.0),
    last=st.floats(0.01, 1.0),
    mean=st.floats(-1.0, 1.0),
    side=st.sampled_from([1.0, -1.0]),
)
def test_where_the_parabola_passes_zero(first: float, last: float, mean: float, side: float) -> None:
    ends = [np.array([side * value]) for value in (first, -last, mean)]
    share = _zero_of_parabola(*ends)[0]
    assert 0.0 <= share <= 1.0
    bulge = 6.0 * mean - 3.0 * (first - last)
    value = first * (1.0 - share) - last * share + bulge * share * (1.0 - share)
    assert abs(value) < 1e-9
