"""Tests that were held out are predicted within what was measured."""

import numpy as np
import pytest

from dcfp.inference.identification import bearing_file, identify
from dcfp.system import (
    LI_2020,
    Bearing,
    FittedFriction,
    PreciseHeating,
    SimplifiedHeating,
    System,
    read_bearing,
)


def test_without_noise_the_prediction_is_the_test(dependency) -> None:
    tests = dict(dependency)
    held = [tests.pop("V150"), tests.pop("P80")]
    found = identify(list(tests.values()), held_out=held)
    assert [one.name for one in found.predictions] == ["V150", "P80"]
    for one in found.predictions:
        assert one.force_error < 1e-3
        for row in one.rows():
            # the force at a turn is fitted to the samples before it, where it falls steeply, and the path between samples is not quite the same
            assert row["keff_kN_mm_ratio"] == pytest.approx(1.0, abs=1.2e-2)
            assert row["energy_kN_m_ratio"] == pytest.approx(1.0, abs=1e-3)
            assert row["friction_at_zero_ratio"] == pytest.approx(1.0, abs=1e-3)


def test_with_noise_it_is_within_the_noise(dependency, noisy) -> None:
    random = np.random.default_rng(7)
    tests = {name: noisy(test, random) for name, test in dependency.items()}
    (one,) = identify(
        [test for name, test in tests.items() if name != "V150"], held_out=[tests["V150"]]
    ).predictions
    # the force has 2 % of noise, and the load that drives the prediction has its own
    assert one.force_error < 0.025
    exact, used = dependency["V150"].force, one.history.used
    assert np.sqrt(np.mean((one.force - exact)[used] ** 2)) < 0.003 * np.abs(exact).max()
    for row in one.rows():
        # energy is a sum over 400 samples; friction at zero is from two forces and stiffness from two at the reversals, where the force of
        # spring (b) turns round within 0.3 mm of a displacement that has 0.1 mm of noise
        assert row["energy_kN_m_ratio"] == pytest.approx(1.0, abs=0.01)
        assert row["friction_at_zero_ratio"] == pytest.approx(1.0, abs=0.1)
        assert row["keff_kN_mm_ratio"] == pytest.approx(1.0, abs=0.12)


def test_a_law_of_other_tests_is_seen_to_fail(dependency, measure) -> None:
    (stranger,) = measure(("stranger", 150.0, 60.0), law=FittedFriction(mu_0=0.09))
    (one,) = identify(list(dependency.values()), held_out=[stranger]).predictions
    assert one.rows()[0]["energy_kN_m_ratio"] < 0.9
    assert one.force_error > 0.05


@pytest.mark.parametrize(
    "heating",
    [
        SimplifiedHeating(ambient=-5.0),
        PreciseHeating(conductivity=21.3, cells=32),
        SimplifiedHeating(thickness=40.0, back="ambient"),
    ],
)
@pytest.mark.parametrize(
    "bearing",
    [LI_2020, Bearing((1000.0, 2500.0), 300.0, 45.0, 8.123e5, name='a "quoted" \\ name, Übung 試験\t')],
)
def test_a_bearing_file_reads_back_to_the_same_numbers(tmp_path, bearing, heating) -> None:
    law = FittedFriction(mu_0=0.1 / 3.0, temperature_rate=0.0)
    path = tmp_path / "bearing.toml"
    path.write_text(
        bearing_file(System(bearing, law, heating), ("from tests", "line\nbreak")), encoding="utf-8"
    )
    found = read_bearing(path)
    assert found.friction == law
    assert found.heating == heating
    assert found.bearing.name == bearing.name
    assert found.bearing.radii == bearing.radii
    assert found.bearing.displacement_capacity == bearing.displacement_capacity
    assert found.bearing.elastic_stiffness == pytest.approx(bearing.elastic_stiffness, rel=1e-15)
