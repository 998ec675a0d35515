"""The simplified and the design method, Eqs (26)-(33)."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dcfp.errors import InputError
from dcfp.methods import Prediction, Pulses, find_pulses
from dcfp.methods.li_2020 import (
    LI_2020,
    Constants,
    predict_from_pgv,
    predict_from_pulses,
    predict_simplified,
)
from dcfp.methods.li_2020 import simplified_method as simplified
from dcfp.motion.ground_motion import GroundMotion

SEARCH = settings(max_examples=100, deadline=None, derandomize=True)


def values(prediction: Prediction) -> list[float]:
    return [prediction.displacement_change, prediction.input_velocity, prediction.hysteretic_velocity]


# ----- table -----


@pytest.mark.parametrize(
    ("pgv", "change", "put_in", "dissipated"),
    [(250.0, 73.4, 277.2, 248.8), (1000.0, 568.4, 1108.8, 692.5)],
)
def test_check_values(pgv: float, change: float, put_in: float, dissipated: float) -> None:
    """Eqs (29)-(33) with the constants of the paper, worked out by hand; half of the last digit."""
    found = predict_from_pgv(pgv)
    assert found.displacement_change == pytest.approx(change, abs=0.05)
    assert found.input_velocity == pytest.approx(put_in, abs=0.05)
    assert found.hysteretic_velocity == pytest.approx(dissipated, abs=0.05)
    assert LI_2020.friction_deceleration == pytest.approx(421.8, abs=0.05)


# ----- one method beside the other -----


@SEARCH
@given(
    change=st.floats(20.0, 2000.0),
    sign=st.sampled_from([1.0, -1.0]),
    ratio=st.floats(0.02, 0.799),
    eps=st.floats(0.05, 5.0),
)
def test_the_simplified_is_the_pulse_method_for_a_pulse_of_average_shape(
    one_pulse, change: float, sign: float, ratio: float, eps: float
) -> None:
    """Where the ground falls by Eq. (26) and rises as the average does, nothing was simplified away."""
    slope = LI_2020.friction_deceleration / ratio
    constants = replace(LI_2020, average_slope=slope, fall_ratio=eps)
    pulses = one_pulse(sign * change, slope, eps * slope)
    whole = predict_from_pulses(pulses, constants).largest
    assert values(predict_simplified(pulses, constants).largest) == pytest.approx(values(whole), rel=1e-9)


@SEARCH
@given(pgv=st.floats(20.0, 3000.0), zeta=st.floats(0.3, 3.0), eps=st.floats(0.05, 5.0))
def test_the_design_is_the_simplified_method_for_the_pulse_of_its_pgv(
    one_pulse, pgv: float, zeta: float, eps: float
) -> None:
    """With Eqs (29) and (30); below a PGV of 113 mm/s that pulse is slower than friction, and both absorb all."""
    constants = replace(LI_2020, change_ratio=zeta, fall_ratio=eps)
    pulses = one_pulse(zeta * pgv, 930.0 * pgv / 250.0, 500.0)
    expected = predict_simplified(pulses, constants).largest
    assert values(predict_from_pgv(pgv, constants)) == pytest.approx(values(expected), rel=1e-9)


# ----- limits and trends -----


def test_all_that_is_put_in_is_absorbed_where_the_ground_is_slower_than_friction() -> None:
    """Eq. (27) comes to 1 at ku/kg = 1 without a jump and stays there."""
    ratio = np.array([1.0 - 1e-9, 1.0, 1.0 + 1e-9, 5.0])
    np.testing.assert_allclose(simplified.absorbed_velocity_ratio(ratio, 0.25), 1.0, rtol=1e-8)
    assert (simplified.absorbed_velocity_ratio(np.linspace(0.01, 0.99, 50), 0.25) < 1.0).all()
    weak = predict_from_pgv(100.0)
    assert weak.hysteretic_velocity == weak.input_velocity


@SEARCH
@given(ratio=st.floats(0.01, 0.99), eps=st.floats(0.01, 5.0))
def test_the_absorbed_part_is_that_of_the_pulse_method(ratio: float, eps: float) -> None:
    """Eq. (27) is Eq. (24) with Eq. (26): ku (kg - kg') / (kg (ku - kg')), squared."""
    slope, friction = 1.0, ratio
    after = -eps * slope
    part = friction * (slope - after) / (slope * (friction - after))
    assert simplified.absorbed_velocity_ratio(np.array([ratio]), eps)[0] ** 2 == pytest.approx(part)


@SEARCH
@given(pgv=st.floats(20.0, 3000.0), one=st.floats(0.1, 3.0), other=st.floats(0.1, 3.0))
def test_larger_zeta_and_smaller_eps_are_more_conservative(pgv: float, one: float, other: float) -> None:
    """Section 6.3; where ku/kg exceeds one, eps has no say."""
    less, more = sorted((one, other))
    if more - less < 1e-6:
        return
    by_zeta = [predict_from_pgv(pgv, replace(LI_2020, change_ratio=zeta)) for zeta in (less, more)]
    assert all(np.less(values(by_zeta[0]), values(by_zeta[1])))
    by_eps = [predict_from_pgv(pgv, replace(LI_2020, fall_ratio=eps)) for eps in (less, more)]
    assert by_eps[0].input_velocity == by_eps[1].input_velocity
    if LI_2020.friction_deceleration < 930.0 * pgv / 250.0 * (1.0 - 1e-6):
        assert by_eps[0].hysteretic_velocity > by_eps[1].hysteretic_velocity
        assert by_eps[0].displacement_change > by_eps[1].displacement_change
    else:
        assert by_eps[0] == by_eps[1]


def test_a_silent_record_gives_zero() -> None:
    silent = find_pulses(GroundMotion(np.zeros(10), 0.01))
    assert values(predict_simplified(silent).largest) == [0.0, 0.0, 0.0]


# ----- refusals -----


@pytest.mark.parametrize("friction", [930.0 / 9810.0 * (1.0 + 1e-9), 0.2])
def test_friction_above_the_average_slope_is_refused(six_legs: Pulses, friction: float) -> None:
    constants = Constants(nominal_friction=friction)
    words = r"^The simplified and the design method need mu_n g, .* below 0\.0948\.$"
    with pytest.raises(InputError, match=words):
        predict_simplified(six_legs, constants)
    with pytest.raises(InputError, match=words):
        predict_from_pgv(250.0, constants)
    # the pulse method needs no average
    assert predict_from_pulses(six_legs.scaled(3.0), constants).largest.input_velocity > 0.0


@pytest.mark.parametrize("pgv", [0.0, -250.0, np.nan, np.inf])
def test_a_pgv_that_is_none_is_refused(pgv: float) -> None:
    with pytest.raises(InputError, match=r"^The PGV \[mm/s\] must be a number above 0, not .*\.$"):
        predict_from_pgv(pgv)


@pytest.mark.parametrize(
    "name", ["nominal_friction", "gravity", "amplification", "fall_ratio", "average_slope"]
)
@pytest.mark.parametrize("value", [0.0, -1.0, np.nan, np.inf])
def test_constants_that_are_not_positive_are_refused(name: str, value: float) -> None:
    with pytest.raises(InputError, match=rf"^Constants: .* \({name}\) must be a number .*, not {value:g}\.$"):
        Constants(**{name: value})


def test_a_coefficient_of_one_is_refused() -> None:
    with pytest.raises(
        InputError, match=r"\(nominal_friction\) must be a number above 0 and up to 0\.9999, not 1 "
    ):
        Constants(nominal_friction=1.0)
