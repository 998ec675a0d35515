"""Identification with plates of finite thickness, and what the law then knows of its tests."""

import pytest

from dcfp.errors import InputError
from dcfp.inference.identification import bearing_file, identify
from dcfp.system import (
    FittedFriction,
    NoHeating,
    PreciseHeating,
    SimplifiedHeating,
    System,
    UserFriction,
    read_bearing,
)


@pytest.mark.parametrize("back", ["insulated", "ambient"])
@pytest.mark.parametrize("model", [SimplifiedHeating, PreciseHeating])
def test_the_law_comes_back_from_plates_of_finite_thickness(measure, model, back) -> None:
    heating = model(thickness=30.0, back=back)
    tests = measure(("a", 20.0, 60.0), ("b", 400.0, 60.0), ("c", 20.0, 80.0), heating=heating)
    found = identify(list(tests), heating=heating)
    truth = FittedFriction()
    for one in found.estimates:
        assert one.value == pytest.approx(getattr(truth, one.name), rel=3e-3), one.name


def test_without_heating_nothing_leaks(measure) -> None:
    tests = measure(("a", 20.0, 60.0), ("b", 400.0, 60.0), heating=NoHeating())
    found = identify(list(tests), heating=NoHeating(thickness=30.0), fit=["mu_0", "speed_drop", "speed_rate"])
    assert found.estimate("speed_drop").value == pytest.approx(0.55, rel=1e-2)


def test_the_law_knows_its_tests(dependency, tmp_path) -> None:
    found = identify(list(dependency.values()))
    tests = found.law.tests()
    assert tests is not None
    assert tests.pressure == pytest.approx((40.0, 80.0), rel=1e-3)
    assert tests.speed[1] == pytest.approx(400.0, rel=1e-2)
    assert tests.ambient == 20.0
    path = tmp_path / "b.toml"
    path.write_text(bearing_file(found.system))
    assert read_bearing(path).friction == found.law


def test_the_intervals_say_what_they_take_for_granted(dependency) -> None:
    assert "take the simplified heating model" in identify(list(dependency.values())).remarks[0]


def test_nothing_left_to_fit_is_said_in_one_sentence(dependency) -> None:
    fixed = {"mu_0": 0.075, "temperature_rate": 0.007, "speed_rate": 0.019, "speed_drop": 0.55}
    with pytest.raises(InputError):
        identify([dependency["V20"]], fixed=fixed)


def test_a_law_that_is_a_function_does_not_go_into_a_file() -> None:
    law = UserFriction(lambda pressure, speed, temperature: 0.05, "flat")
    with pytest.raises(InputError, match="'flat' is a function"):
        bearing_file(System(friction=law))
