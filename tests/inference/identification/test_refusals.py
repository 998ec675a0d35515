"""What the data cannot determine is refused with its reason and the ways out, or held where it was not asked for."""

from dataclasses import replace

import numpy as np
import pytest

from dcfp.arrays import freeze
from dcfp.errors import InputError
from dcfp.inference.identification import identify
from dcfp.system import LI_2020, FittedFriction, NoHeating, SimplifiedHeating


@pytest.fixture(scope="module")
def tests(dependency, noisy):
    random = np.random.default_rng(3)
    return {name: noisy(test, random) for name, test in dependency.items()}


CASES = {
    "one pressure": (
        ("V20", "V400"), {"fit": ["mu_0", "pressure_exponent"]},
        "cannot determine pressure_exponent: every test has a pressure of (59|60)",
    ),
    "no two ways out": (("V20",), {"fit": ["pressure_exponent"]}, "add a test at another pressure, or fix it .fix pressure_exponent=VALUE"),
    "floor of two pressures": (("V20", "P40"), {"fit": ["mu_0", "pressure_floor"]}, "cannot determine pressure_floor: the pressures of the tests are 2"),
    "floor and exponent": (("V20", "P40", "P80"), {"fit": ["mu_0", "pressure_exponent", "pressure_floor"]}, "goes with pressure_exponent .correlation"),
    "slow only": (("V20",), {"fit": ["mu_0", "speed_drop", "speed_rate"]}, "cannot determine mu_0: .* goes with speed_drop"),
    "rate and conductivity": (("V20", "V400"), {"fit": ["mu_0", "temperature_rate", "conductivity"]}, "only through its ratio to temperature_rate"),
    "conductivity without effect": (("V20",), {"fit": ["mu_0", "conductivity"], "fixed": {"temperature_rate": 0.0}}, "nothing depends on it"),
    "no heating": (("V20",), {"fit": ["temperature_rate"], "heating": NoHeating()}, "without a heating model"),
    "diffusivity": (("V20",), {"fit": ["diffusivity"]}, "only sqrt.diffusivity. / conductivity acts"),
    "reference": (("V20",), {"fit": ["reference_pressure"]}, "where mu_0 stands"),
    "unknown": (("V20",), {"fit": ["mu0"]}, "did you mean 'mu_0'"),
    "unknown fixed": (("V20",), {"fixed": {"speed": 1.0}}, "no parameter 'speed'"),
    "out of range": (("V20",), {"fixed": {"mu_0": 2.0}}, "above 0 and up to 0.9999, not 2"),
    "fixed and fitted": (("V20",), {"fit": ["mu_0"], "fixed": {"mu_0": 0.07}}, "both to be fitted and fixed"),
    "nothing": (("V20",), {"fit": []}, "at least one parameter"),
    "all fixed": (
        ("V20",), {"fixed": {"mu_0": 0.07, "temperature_rate": 0.007, "speed_drop": 0.5, "speed_rate": 0.02}},
        "leave at least one",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_a_refusal_is_one_sentence_with_the_reason(tests, case) -> None:
    names, options, words = CASES[case]
    options = {"heating": SimplifiedHeating(), **options}
    with pytest.raises(InputError, match=words) as refused:
        identify([tests[name] for name in names], LI_2020, **options)
    assert str(refused.value).endswith((".", "?"))
    assert ". " not in str(refused.value)


def test_no_tests_and_twins_are_refused(tests) -> None:
    with pytest.raises(InputError, match="at least one test"):
        identify([])
    with pytest.raises(InputError, match="Two tests have the name 'V20'"):
        identify([tests["V20"]], held_out=[tests["V20"]])


def test_a_constant_speed_does_not_tell_of_speed(measure) -> None:
    from dcfp.analysis.rig import Measurement, Program, RigTest, Triangle, VerticalLoad, run_program

    test = RigTest("triangle", Triangle(150.0, 100.0, 3), VerticalLoad((60.0,)))
    (loops,) = run_program(Program("one", (test,)))
    found = Measurement("triangle", loops.time, loops.displacement, loops.force, loops.load, None, "")
    with pytest.raises(
        InputError, match="cannot determine speed_drop: the speeds of the tests span 100 to 100 mm/s"
    ):
        identify([found], fit=["mu_0", "speed_drop"])
    assert {one.name for one in identify([found]).estimates} == {"mu_0", "temperature_rate"}


@pytest.mark.parametrize(
    ("names", "fitted"),
    [
        (("V20", "V50", "V150", "V400", "P40"), {"mu_0", "pressure_exponent", "speed_drop", "speed_rate", "temperature_rate"}),
        (("V20", "V50", "V150", "V400"), {"mu_0", "speed_drop", "speed_rate", "temperature_rate"}),
        (("V20",), {"mu_0", "speed_rate", "temperature_rate"}),
    ],
)  # fmt: skip
def test_what_was_not_asked_for_is_held_with_its_reason(tests, names, fitted) -> None:
    found = identify([tests[name] for name in names])
    assert {one.name for one in found.estimates} == fitted
    held = {one.name: one for one in found.held}
    for name in {"pressure_exponent", "speed_drop"} - fitted:
        assert held[name].value == getattr(FittedFriction(), name)
        assert held[name].reason not in ("", "not asked for")
        assert f"fix {name}=VALUE" in held[name].reason
    for one in found.estimates:
        assert abs(one.value - getattr(FittedFriction(), one.name)) < 4.0 * one.standard_error


def test_fixed_values_stay(tests) -> None:
    found = identify(list(tests.values()), fixed={"pressure_exponent": 0.25, "reference_pressure": 50.0})
    assert (found.law.pressure_exponent, found.law.reference_pressure) == (0.25, 50.0)
    reasons = {one.name: one.reason for one in found.held}
    assert reasons["pressure_exponent"] == reasons["reference_pressure"] == "fixed as asked for"


def test_a_wrong_model_is_remarked_on(tests) -> None:
    found = identify(list(tests.values()), LI_2020, NoHeating())
    assert any("stay alike" in remark for remark in found.remarks)
    assert len(identify(list(tests.values())).remarks) == 1  # what the intervals take for granted


def test_a_test_that_does_not_belong_is_remarked_on(tests, measure) -> None:
    (stranger,) = measure(("stranger", 50.0, 60.0), law=FittedFriction(mu_0=0.1))
    found = identify([*tests.values(), stranger])
    assert any(remark.startswith("stranger: the law misses") for remark in found.remarks)


def with_force(test, factor: float, noise: float = 0.0):
    """Multiply the force, and add noise of a size relative to its peak."""
    random = np.random.default_rng(3)
    scatter = noise * np.abs(test.force).max() * random.standard_normal(test.time.size)
    return replace(test, optional_force=freeze(factor * (test.force + scatter)))


@pytest.mark.parametrize(
    ("factor", "noise", "words"),
    [
        (-1.0, 0.0, "helps the sliding instead of opposing it"),
        (1e-3, 0.0, "is 3.*e-05, and from 0.001 to 1 is possible; look at the units"),
        (1e3, 0.0, "look at its stiffness before sliding and at the unit of the force"),
        (10.0, 0.0, "cannot determine mu_0, the only parameter that is left to fit"),
        (0.1, 0.0, "cannot determine mu_0, the only parameter that is left to fit"),
        (1.0, 5.0, "look at the sign and the unit of the force and at its noise"),
    ],
)
def test_a_force_of_the_wrong_sign_or_unit_or_of_noise_alone_is_refused(
    dependency, factor, noise, words
) -> None:
    wrong = [with_force(dependency[name], factor, noise) for name in ("V20", "V400")]
    with pytest.raises(InputError, match=words) as refused:
        identify(wrong)
    assert ". " not in str(refused.value)


def test_poor_data_beside_a_fixed_coefficient_are_refused(dependency) -> None:
    with pytest.raises(InputError, match="determine none of the parameters that are left to fit") as refused:
        identify([with_force(dependency["V20"], 1.0, 10.0)], fixed={"mu_0": 0.075})
    assert ". " not in str(refused.value)
