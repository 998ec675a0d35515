"""The pulse method, Eqs (17)-(25), against the picture that it was derived from: three straight lines."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy import integrate, optimize

from dcfp.methods import Prediction, Pulses
from dcfp.methods.li_2020 import Constants, predict_from_pulses
from dcfp.methods.li_2020 import pulse_method as method

#: mu_n g of 400 mm/s2 exactly, so that ratios ku/kg can be met on the dot.
ROUND = Constants(nominal_friction=0.04, gravity=10_000.0)
K_U = 400.0

SEARCH = settings(max_examples=100, deadline=None, derandomize=True)
pulse_shapes = given(change=st.floats(20.0, 2000.0), ratio=st.floats(0.01, 0.999), fall=st.floats(0.02, 20.0))


def straight_lines(change: float, slope: float, next_slope: float, friction: float) -> Prediction:
    """Integrate the picture numerically: the ground goes up and down, the structure up alone until they meet.

    All arguments are amounts; the energies are per unit mass, as equivalent velocities.
    """
    peak = change / slope

    def ground(time: float) -> float:
        return slope * time if time <= peak else change - next_slope * (time - peak)

    def behind(time: float) -> float:
        return friction * time - ground(time)

    far = peak
    while behind(far) < 0.0:
        far += peak + change / next_slope
    met = optimize.brentq(behind, peak, far, xtol=1e-13, rtol=1e-14)
    pieces = ((0.0, peak), (peak, met))
    travel = sum(integrate.quad(behind, *piece)[0] for piece in pieces)
    put_in = integrate.quad(lambda time: -slope * behind(time), 0.0, peak)[0]
    dissipated = integrate.quad(lambda time: friction * abs(behind(time)), 0.0, peak)[0]
    dissipated += integrate.quad(lambda time: friction * abs(behind(time)), peak, met)[0]
    return Prediction(abs(travel), np.sqrt(2.0 * put_in), np.sqrt(2.0 * dissipated))


def by_formula(change: float, slope: float, next_slope: float, friction: float) -> Prediction:
    """Eqs (20), (23) and (24), with the signs in which they are written."""
    dv, kg, after, ku = (np.array([value]) for value in (change, slope, -next_slope, friction))
    return Prediction(
        float(method.displacement_change(dv, kg, after, ku)[0]),
        float(method.input_velocity(dv, kg, ku)[0]),
        float(method.hysteretic_velocity(dv, kg, after, ku)[0]),
    )


def agree(one: Prediction, other: Prediction, rel: float) -> None:
    assert one.displacement_change == pytest.approx(other.displacement_change, rel=rel)
    assert one.input_velocity == pytest.approx(other.input_velocity, rel=rel)
    assert one.hysteretic_velocity == pytest.approx(other.hysteretic_velocity, rel=rel)


@SEARCH
@pulse_shapes
def test_the_formulas_are_the_area_and_the_work_between_the_lines(
    change: float, ratio: float, fall: float
) -> None:
    slope = K_U / ratio
    agree(
        by_formula(change, slope, fall * slope, K_U),
        straight_lines(change, slope, fall * slope, K_U),
        rel=1e-8,
    )


@SEARCH
@pulse_shapes
def test_the_energies_agree_with_each_other(change: float, ratio: float, fall: float) -> None:
    slope, mass = np.array([K_U / ratio]), 768.8
    dv, after, ku = np.array([change]), -fall * slope, np.array([K_U])
    put_in = 0.5 * mass * (1.0 - ku / slope) * dv**2  # Eq. (22)
    assert method.input_velocity(dv, slope, ku) == pytest.approx(np.sqrt(2.0 * put_in / mass))
    dy = method.displacement_change(dv, slope, after, ku)
    dissipated = mass * ku * dy  # Eqs (21), (25)
    velocity = method.hysteretic_velocity(dv, slope, after, ku)
    assert velocity == pytest.approx(np.sqrt(2.0 * dissipated / mass), rel=1e-9)
    assert velocity == pytest.approx(np.sqrt(2.0 * K_U * dy), rel=1e-9)
    # after its peak the ground takes energy back
    assert (dissipated < put_in).all()


def test_a_structure_without_friction_stays_where_it_was() -> None:
    """It is left behind by as much as the ground moves: the triangle under its velocity."""
    change, slope, after = 300.0, 900.0, 200.0
    triangle = 0.5 * change * (change / slope + change / after)
    found = by_formula(change, slope, after, 1e-9)
    assert found.displacement_change == pytest.approx(triangle, rel=1e-9)
    assert found.input_velocity == pytest.approx(change)
    assert found.hysteretic_velocity < 1e-3


def test_a_structure_that_keeps_up_does_not_move() -> None:
    found = by_formula(300.0, 900.0, 200.0, 900.0)
    assert (found.displacement_change, found.input_velocity, found.hysteretic_velocity) == (0.0, 0.0, 0.0)
    near = by_formula(300.0, 900.0, 200.0, 900.0 * (1.0 - 1e-8))
    assert 0.0 < near.displacement_change < 1e-5


# ----- of a record's pulses -----


@pytest.mark.parametrize("start", [0.0, 150.0])
@pytest.mark.parametrize("sign", [1.0, -1.0])
@SEARCH
@pulse_shapes
def test_a_pulse_to_either_side_gives_the_same(
    one_pulse, start: float, sign: float, change: float, ratio: float, fall: float
) -> None:
    assume(ratio < 0.8 - 1e-9)
    slope = K_U / ratio
    predicted = predict_from_pulses(one_pulse(sign * change, slope, fall * slope, start), ROUND)
    agree(predicted.largest, by_formula(change, slope, fall * slope, K_U), rel=1e-9)
    assert predicted.governing == 0


@pytest.mark.parametrize("length", [1.0, 0.9, 0.8])
def test_pulses_near_the_friction_are_taken_half_as_large_again(length: float) -> None:
    """Figure 17: dv and both slopes times 1.5 where 0.8 <= ku/kg <= 1, the limits included; friction is not."""
    pulses = Pulses(np.array([0.0, length, length + 2.0]), np.array([0.0, 400.0, -100.0]))
    found = predict_from_pulses(pulses, ROUND).largest
    agree(found, straight_lines(600.0, 600.0 / length, 375.0, K_U), rel=1e-8)


def test_outside_of_those_limits_they_are_not() -> None:
    def of(length: float) -> Prediction:
        return predict_from_pulses(
            Pulses(np.array([0.0, length, 4.0]), np.array([0.0, 400.0, 0.0])), ROUND
        ).largest

    agree(of(0.799), straight_lines(400.0, 400.0 / 0.799, 400.0 / 3.201, K_U), rel=1e-8)
    assert of(0.801).displacement_change > 3.0 * of(0.799).displacement_change


def test_a_ground_slower_than_friction_moves_nothing(one_pulse) -> None:
    pulses = one_pulse(400.0, K_U * (1.0 - 1e-9), 100.0)
    predicted = predict_from_pulses(pulses, ROUND)
    largest = predicted.largest
    assert (largest.displacement_change, largest.input_velocity, largest.hysteretic_velocity) == (
        0.0,
        0.0,
        0.0,
    )
    assert predicted.governing is None


def test_every_pulse_is_taken_by_itself(six_legs: Pulses) -> None:
    predicted = predict_from_pulses(six_legs, ROUND)
    assert predicted.displacement_change.shape == (5,)
    for i in range(5):
        alone = Pulses(six_legs.times[i : i + 3], six_legs.velocities[i : i + 3])
        assert predict_from_pulses(alone, ROUND).largest == predicted.of(i)
    assert predicted.governing == int(np.argmax(predicted.displacement_change))
    assert predicted.largest.displacement_change == predicted.of(predicted.governing).displacement_change
    assert predicted.largest.displacement is None
    assert predicted.largest.bound == predicted.largest.displacement_change


def test_of_no_pulse_nothing_is_said(six_legs: Pulses) -> None:
    said = predict_from_pulses(six_legs, ROUND).of(None)
    assert np.isnan([said.displacement_change, said.input_velocity, said.hysteretic_velocity]).all()
