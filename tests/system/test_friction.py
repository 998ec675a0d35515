"""Friction laws: printed values, switches, and agreement of the compiled and the array forms."""

import numba
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dcfp.errors import InputError
from dcfp.kernels.friction import coefficient
from dcfp.schema.citations import bibliography
from dcfp.system import (
    FRICTION_LAWS,
    ConstantFriction,
    Constantinou1990,
    Kumar2015,
    Li2020,
    UserFriction,
    friction_law,
)
from dcfp.system.friction import li_2020


def test_li_2020_factors_at_the_printed_points():
    assert li_2020.pressure_factor(60.0) == pytest.approx(1.000, abs=5e-4)
    assert li_2020.velocity_factor(400.0) == pytest.approx(0.9997, abs=5e-5)
    assert li_2020.temperature_factor(17.5) == pytest.approx(1.0, abs=5e-4)
    assert Li2020().coefficient(60.0, 400.0, 17.5) == pytest.approx(0.075, rel=1e-3)


def test_kumar_2015_factors_are_one_at_their_references():
    law = Kumar2015(reference_pressure=50.0)
    assert law.pressure_factor(50.0) == 1.0
    assert law.velocity_factor(1e4) == pytest.approx(1.0, abs=1e-12)
    assert law.velocity_factor(0.0) == 0.5


@pytest.mark.parametrize(
    ("name", "left"), [("kumar2015", 0.5), ("kim2023-third", 1 / 3), ("kim2023-two-thirds", 2 / 3)]
)
def test_temperature_laws_leave_what_their_name_says_at_200_degrees(name, left):
    law = friction_law(name)
    assert law.name == name
    assert law.temperature_factor(20.0) == pytest.approx(1.0, abs=0.01)
    assert law.temperature_factor(200.0) == pytest.approx(left, abs=0.02)


def test_constantinou_1990_goes_from_slow_to_fast():
    law = Constantinou1990(fast=0.12, slow=0.05, rate=0.03)
    assert law.coefficient(60.0, 0.0, 20.0) == pytest.approx(0.05)
    assert law.coefficient(60.0, 1e4, 20.0) == pytest.approx(0.12)
    assert law.coefficient(60.0, 40.0, 20.0) == pytest.approx(0.12 - 0.07 * np.exp(-1.2))


@pytest.mark.parametrize("name", tuple(FRICTION_LAWS))
@given(pressure=st.floats(5.0, 120.0), speed=st.floats(0.0, 2e3), temperature=st.floats(-20.0, 400.0))
def test_compiled_and_array_forms_agree(name, pressure, speed, temperature):
    law = friction_law(name)
    compiled = coefficient(law.at_pressure(pressure), pressure, speed, temperature, 0.0)
    assert compiled == pytest.approx(float(law.coefficient(pressure, speed, temperature)), rel=1e-12)


@pytest.mark.parametrize("factor", ["pressure", "velocity", "temperature"])
@pytest.mark.parametrize("law", [Li2020, Kumar2015])
def test_each_factor_can_be_switched_off(law, factor):
    off = law(**{f"{factor}_dependent": False})
    values = {"pressure": 35.0, "velocity": 7.0, "temperature": 150.0}
    arguments = (35.0, 7.0, 150.0)
    removed = getattr(law(), f"{factor}_factor")(values[factor])
    assert float(off.coefficient(*arguments)) * float(removed) == pytest.approx(
        float(law().coefficient(*arguments))
    )
    assert coefficient(off.at_pressure(35.0), *arguments, 0.0) == pytest.approx(
        float(off.coefficient(*arguments))
    )


def test_coefficients_broadcast():
    values = Li2020().coefficient(60.0, np.array([[1.0], [100.0]]), np.array([20.0, 60.0, 100.0]))
    assert values.shape == (2, 3)
    assert (np.diff(values, axis=1) < 0.0).all()
    assert (np.diff(values, axis=0) > 0.0).all()


@pytest.mark.slow
def test_a_user_law_may_be_plain_or_compiled():
    def plain(pressure, speed, temperature):
        return 0.04 + 1e-5 * speed + 1e-6 * pressure - 1e-5 * temperature

    for function in (plain, numba.njit(plain)):
        law = UserFriction(function)
        assert float(law.coefficient(60.0, 100.0, 20.0)) == pytest.approx(0.04086)


@pytest.mark.slow
def test_a_user_law_that_cannot_be_compiled_is_refused():
    with pytest.raises(InputError, match="cannot be compiled"):
        UserFriction(lambda pressure, speed, temperature: str(pressure).no_such_method())


def test_a_user_law_that_is_negative_is_refused():
    with pytest.raises(InputError, match="positive"):
        UserFriction(lambda pressure, speed, temperature: -0.1)


@pytest.mark.parametrize(
    ("name", "parameters", "words"),
    [
        ("li2021", {}, "did you mean 'li2020'"),
        ("li2020", {"mu": 0.05}, "no parameter of the friction law li2020 'mu'"),
        ("constant", {"mu": -0.1}, "above 0 and up to"),
        ("constant", {"mu": "a"}, "above 0 and up to"),
        ("kumar2015", {"temperature_law": "half"}, "no parameter of"),
        ("constantinou1990", {"fast": 0.05, "slow": 0.06}, "must not exceed"),
    ],
)
def test_bad_laws_get_a_sentence(name, parameters, words):
    with pytest.raises(InputError, match=words):
        friction_law(name, parameters)


def test_the_laws_of_kim_and_constantinou_are_variants_of_kumar():
    third = friction_law("kim2023-third", {"mu_reference": 0.06})
    assert isinstance(third, Kumar2015)
    assert third.velocity_factor(10.0) == Kumar2015().velocity_factor(10.0)
    assert third.citation in bibliography()
    assert isinstance(friction_law("constant"), ConstantFriction)


def test_the_fitted_law_restates_li_2020():
    pressure, speed, temperature = np.meshgrid([20.0, 60.0, 120.0], [0.0, 20.0, 600.0], [-20.0, 20.0, 300.0])
    fitted = friction_law("fitted").coefficient(pressure, speed, temperature)
    assert fitted == pytest.approx(Li2020().coefficient(pressure, speed, temperature), rel=6e-4)
    assert friction_law("fitted").pressure_factor(60.0) == 1.0


@pytest.mark.parametrize(
    ("parameters", "words"),
    [
        ({"mu_0": 1.0}, "above 0 and up to"),
        ({"pressure_exponent": -0.1}, "pressure_exponent: .* from 0 to 5"),
        ({"pressure_floor": 1.1}, "pressure_floor"),
        ({"reference_pressure": 0.0}, "a number of N/mm2"),
        ({"speed_drop": 1.0}, "speed_drop"),
        ({"speed_rate": 0.0}, "a number of s/mm"),
        ({"speed_rate": 19.0}, "speed_rate"),
        ({"temperature_rate": 0.7}, "temperature_rate"),
        ({"reference_temperature": float("nan")}, "number of degC"),
    ],
)
def test_constants_of_the_fitted_law_are_checked(parameters, words):
    with pytest.raises(InputError, match=words):
        friction_law("fitted", parameters)
