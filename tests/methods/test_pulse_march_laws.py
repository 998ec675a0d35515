"""Laws of the march along straight legs, for every pulse, bearing, friction law and heating model."""

import math
from dataclasses import replace

import numba
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dcfp.constants import STANDARD_GRAVITY
from dcfp.kernels import march as k
from dcfp.methods import Pulses, march_through_pulses
from dcfp.methods.pulse_march import LONGEST_STEP, PARTS
from dcfp.system import (
    LI_2020,
    Bearing,
    ConstantFriction,
    FrictionLaw,
    Heating,
    Li2020,
    Lomiento2013,
    NoHeating,
    PreciseHeating,
    SimplifiedHeating,
    System,
    UserFriction,
)
from dcfp.system.plates import cold_plates, kernel_model

SEARCH = settings(max_examples=60, deadline=None, derandomize=True)
MODELS = [
    (ConstantFriction(), NoHeating()),
    (Li2020(), NoHeating()),
    (Li2020(), SimplifiedHeating()),
    (Li2020(), PreciseHeating()),
    (Lomiento2013(), NoHeating()),
]


@st.composite
def some_pulses(draw: st.DrawFn) -> Pulses:
    lengths = draw(st.lists(st.floats(0.05, 2.5), min_size=1, max_size=8))
    sizes = draw(st.lists(st.floats(20.0, 1000.0), min_size=len(lengths), max_size=len(lengths)))
    signs = draw(st.sampled_from([1.0, -1.0])) * (-1.0) ** np.arange(len(lengths))
    times = np.cumsum([draw(st.floats(0.0, 20.0)), *lengths])
    return Pulses(times, np.cumsum([0.0, *(signs * sizes)]))


bearings = st.builds(
    lambda radii, diameter, pressure: Bearing(radii, diameter, pressure, 1e6),
    st.one_of(
        st.tuples(st.floats(800.0, 9000.0)), st.tuples(st.floats(800.0, 9000.0), st.floats(800.0, 9000.0))
    ),
    st.floats(100.0, 600.0),
    st.floats(10.0, 100.0),
)
models = st.sampled_from(MODELS)


# ----- laws -----


def final_state(pulses: Pulses, bearing: Bearing, law: FrictionLaw, heating: Heating) -> k.MarchState:
    """State of the kernel at the end."""
    state = np.zeros(1, k.MARCH_STATE)
    system = System(bearing, law, heating)
    plates = cold_plates(system).with_room(2000)
    model = kernel_model(system, plates)
    path = np.empty((0, k.PATH_SIZE))
    _, fits = k.march_along_legs(model, pulses.times, pulses.velocities, PARTS, LONGEST_STEP, state, path)
    assert fits
    return k.MarchState(*state[0].item())


@SEARCH
@given(pulses=some_pulses(), bearing=bearings, model=models)
def test_what_is_put_in_is_dissipated_or_stays_in_spring_a(
    pulses: Pulses, bearing: Bearing, model: tuple[FrictionLaw, Heating]
) -> None:
    state = final_state(pulses, bearing, *model)
    # friction that falls as the speed does may let it creep for ever; by then it has nearly come to rest
    assert state.slip_sign == 0.0 or abs(state.velocity) < 0.01
    stiffness = STANDARD_GRAVITY / bearing.effective_radius
    left = 0.5 * stiffness * state.displacement**2 + 0.5 * state.velocity**2
    assert state.input == pytest.approx(state.hysteretic + left, rel=1e-9, abs=1e-9)
    # and the door gives the same
    march = march_through_pulses(pulses, bearing, *model)
    assert march.prediction.total_velocity == pytest.approx(math.sqrt(2.0 * max(state.input, 0.0)), rel=1e-12)
    assert march.residual_displacement == state.displacement
    assert march.prediction.hysteretic_velocity <= math.sqrt(2.0 * state.hysteretic) * (1.0 + 1e-12)


@SEARCH
@given(pulses=some_pulses(), bearing=bearings, model=models)
def test_mirrored_pulses_do_the_same_to_the_other_side(
    pulses: Pulses, bearing: Bearing, model: tuple[FrictionLaw, Heating]
) -> None:
    there = march_through_pulses(pulses, bearing, *model)
    back = march_through_pulses(pulses.scaled(-1.0), bearing, *model)
    # cells of the plates are swept from the other end, so sums round differently
    rel = 1e-9 if isinstance(model[1], PreciseHeating) else 1e-12
    assert there.prediction.displacement_change == pytest.approx(back.prediction.displacement_change, rel=rel)
    assert there.prediction.displacement == pytest.approx(back.prediction.displacement, rel=rel)
    assert there.prediction.total_velocity == pytest.approx(back.prediction.total_velocity, rel=rel)
    assert there.residual_displacement == pytest.approx(-back.residual_displacement, rel=rel, abs=1e-9)
    assert there.leg == back.leg


@SEARCH
@given(pulses=some_pulses(), bearing=bearings, model=models)
def test_the_path_is_that_of_the_peaks(
    pulses: Pulses, bearing: Bearing, model: tuple[FrictionLaw, Heating]
) -> None:
    march = march_through_pulses(pulses, bearing, *model, with_path=True)
    assert march.prediction == march_through_pulses(pulses, bearing, *model).prediction
    largest = np.abs(march.displacement).max()
    # a stop within a step may be followed by a start to the other side
    assert largest <= march.prediction.displacement <= largest * 1.02 + 1.0
    assert march.displacement[-1] == march.residual_displacement
    assert (np.diff(march.time) > 0.0).all()
    assert march.time[0] > pulses.times[0]
    assert march.prediction.displacement_change <= 2.0 * march.prediction.displacement * (1.0 + 1e-12)


@SEARCH
@given(pulses=some_pulses(), model=models)
def test_a_ground_that_never_exceeds_friction_moves_nothing(
    pulses: Pulses, model: tuple[FrictionLaw, Heating]
) -> None:
    """Friction at rest under cold plates is what there is to exceed: of Li's law it is 0.45 of that at speed."""
    law, heating = model
    held = float(law.coefficient(LI_2020.pressure, 0.0, heating.ambient)) * STANDARD_GRAVITY
    legs = np.abs(np.diff(pulses.velocities)) / np.diff(pulses.times)
    quiet = pulses.scaled(0.999 * held / legs.max())
    march = march_through_pulses(quiet, LI_2020, law, heating)
    found = march.prediction
    assert (found.displacement_change, found.displacement, found.input_velocity) == (0.0, 0.0, 0.0)
    assert (found.hysteretic_velocity, found.total_velocity, march.residual_displacement) == (0.0, 0.0, 0.0)
    assert march.leg is None
    assert march.peak_temperature == heating.ambient


def test_no_pulses_move_nothing() -> None:
    for times in ([], [1.0], [0.0, 1.0]):
        pulses = Pulses(np.array(times), 100.0 * np.arange(len(times)))
        march = march_through_pulses(pulses, with_path=True)
        assert march.prediction.displacement_change == march.prediction.total_velocity == 0.0
        assert march.leg is None


# ----- other bearings and laws -----


def test_unequal_plates_move_as_equal_ones_of_the_same_sum(six_legs: Pulses) -> None:
    """With one coefficient for both plates only the sum of the radii matters; with heat each plate has its own."""
    unequal = replace(LI_2020, radii=(3000.0, 6000.0))
    one, other = (
        march_through_pulses(six_legs, of, ConstantFriction(), NoHeating()) for of in (unequal, LI_2020)
    )
    assert one.prediction.displacement_change == pytest.approx(
        other.prediction.displacement_change, rel=1e-12
    )
    heated, equal = (march_through_pulses(six_legs, of) for of in (unequal, LI_2020))
    assert heated.peak_temperature > equal.peak_temperature + 5.0
    change = heated.prediction.displacement_change
    assert change == pytest.approx(equal.prediction.displacement_change, rel=0.05)


@numba.njit
def constant_law(pressure, speed, temperature):
    return 0.043


@pytest.mark.slow
def test_a_law_of_the_users_own(six_legs: Pulses) -> None:
    own = march_through_pulses(six_legs, LI_2020, UserFriction(constant_law), SimplifiedHeating())
    built_in = march_through_pulses(six_legs, LI_2020, ConstantFriction(0.043), SimplifiedHeating())
    assert own.prediction == built_in.prediction
    assert own.peak_temperature == built_in.peak_temperature > 50.0


def test_a_slide_beyond_the_first_cells_finds_more(six_legs: Pulses) -> None:
    march = march_through_pulses(six_legs.scaled(4.0), LI_2020, heating=PreciseHeating(cells=16))
    assert march.prediction.displacement > 900.0
    roomy = march_through_pulses(six_legs.scaled(4.0), LI_2020, heating=PreciseHeating(cells=17))
    assert march.peak_temperature == pytest.approx(roomy.peak_temperature, rel=0.02)
