"""Known constants come back: exactly without noise, within their intervals with it, whatever the order, the unit or the sampling."""

from dataclasses import replace

import numpy as np
import pytest

from dcfp.analysis.rig import read_measurement
from dcfp.arrays import freeze
from dcfp.inference.identification import DEFAULT, friction_history, identify
from dcfp.inference.identification.fit import LawAtSamples, Samples, fit_law, jackknife, value_of
from dcfp.system import LI_2020, FittedFriction, PreciseHeating, SimplifiedHeating, System

OTHER = FittedFriction(
    mu_0=0.11, pressure_exponent=0.35, speed_drop=0.4, speed_rate=0.03, temperature_rate=0.004
)
TESTS = [("V20", 20.0, 60.0), ("V60", 60.0, 60.0), ("V300", 300.0, 60.0), ("P30", 20.0, 30.0)]


def values(law, names=DEFAULT):
    return [getattr(law, name) for name in names]


@pytest.mark.parametrize("heating", [SimplifiedHeating(), PreciseHeating()])
@pytest.mark.parametrize("law", [FittedFriction(), OTHER])
def test_constants_come_back_without_noise(measure, law, heating) -> None:
    found = identify(measure(*TESTS, law=law, heating=heating), LI_2020, heating)
    assert [one.name for one in found.estimates] == list(DEFAULT)
    assert values(found.law) == pytest.approx(values(law), rel=1e-3)
    assert max(one.relative_scatter for one in found.residuals) < 1e-3


def test_conductivity_comes_back_where_the_rate_is_known(measure) -> None:
    steel = SimplifiedHeating(conductivity=24.0)
    tests = measure(*TESTS, heating=steel)
    found = identify(tests, LI_2020, SimplifiedHeating(), fit=["mu_0", "conductivity"])
    assert found.system.heating.conductivity == pytest.approx(24.0, rel=2e-3)
    assert found.law.temperature_rate == 0.007
    # rises are those with the conductivity that was found
    hottest = max(float(one.max()) for one in found.temperatures)
    assert hottest == pytest.approx(
        max(float(friction_history(t, LI_2020, steel).temperature.max()) for t in tests), rel=2e-3
    )


def test_derivatives_are_those_of_the_law(dependency) -> None:
    system = System(friction=OTHER)
    history = friction_history(dependency["V400"], system)
    law = LawAtSamples(Samples.of([history], 20.0), system)
    names = (*DEFAULT, "pressure_floor", "conductivity")
    at = {name: value_of(system, name) for name in names}
    coefficient, slopes = law.derivatives(at, names)
    exact = OTHER.coefficient(history.pressure, history.speed, history.temperature)[history.used]
    assert coefficient == pytest.approx(exact, rel=1e-12)
    for name, slope in zip(names, slopes.T, strict=True):
        step = 1e-5 * at[name]
        change = law({**at, name: at[name] + step}) - law({**at, name: at[name] - step})
        assert slope == pytest.approx(change / (2.0 * step), rel=1e-4, abs=1e-10)


def test_the_order_of_the_tests_does_not_matter(dependency, noisy) -> None:
    random = np.random.default_rng(1)
    tests = [noisy(test, random) for test in dependency.values()]
    one, other = identify(tests), identify(tests[::-1])
    for a, b in zip(one.estimates, other.estimates, strict=True):
        assert (a.value, a.lower, a.upper) == pytest.approx((b.value, b.lower, b.upper), rel=1e-6)


@pytest.mark.parametrize("kept", ["every second", "four of five"])
def test_the_sampling_does_not_matter(dependency, kept) -> None:
    def thinned(test):
        number = np.arange(test.time.size)
        part = number % 2 == 0 if kept == "every second" else number % 5 != 1
        cut = {
            name: freeze(getattr(test, name)[part])
            for name in ("time", "displacement", "optional_force", "optional_load")
        }
        return replace(test, **cut)

    whole = identify(list(dependency.values()))
    found = identify([thinned(test) for test in dependency.values()])
    assert values(found.law) == pytest.approx(values(whole.law), rel=2e-3)


def test_the_units_of_the_file_do_not_matter(dependency, tmp_path) -> None:
    units = {"plain": ("s", "mm", "kN", "kN", 1.0, 1e-3), "other": ("ms", "in", "MN", "kip", 1e3, 1e-6)}
    found = []
    for name, (time, length, force, load, times, forces) in units.items():
        tests = []
        for test in dependency.values():
            path = tmp_path / f"{test.name}_{name}.csv"
            columns = (
                test.time * times,
                test.displacement / (25.4 if length == "in" else 1.0),
                test.force * forces,
                test.load / (4448.2216152605 if load == "kip" else 1e3),
            )
            head = f"time [{time}],displacement [{length}],force [{force}],load [{load}]"
            np.savetxt(path, np.column_stack(columns), "%.12g", ",", header=head, comments="")
            tests.append(read_measurement(path))
        found.append(values(identify(tests).law))
    assert found[0] == pytest.approx(found[1], rel=1e-6)


def test_a_mirrored_test_gives_the_same_law(dependency) -> None:
    mirrored = [
        replace(test, displacement=freeze(-test.displacement), optional_force=freeze(-test.force))
        for test in dependency.values()
    ]
    one, other = identify(list(dependency.values())), identify(mirrored)
    assert values(one.law) == pytest.approx(values(other.law), rel=1e-9)


def test_a_drift_of_the_zero_of_the_force_does_not_matter(dependency) -> None:
    shifted = [
        replace(test, optional_force=freeze(test.force + 0.03 * np.abs(test.force).max()))
        for test in dependency.values()
    ]
    found = identify(shifted)
    for one in found.estimates:  # an offset raises one stroke and lowers the next
        assert one.lower < getattr(FittedFriction(), one.name) < one.upper
        assert one.value == pytest.approx(getattr(FittedFriction(), one.name), rel=0.03)


def test_the_jackknife_is_leaving_blocks_out() -> None:
    random = np.random.default_rng(5)
    block = np.repeat(np.arange(12), 25)
    slopes = random.standard_normal((300, 2)) + np.array([1.0, 0.0])
    measured = slopes @ [2.0, -1.0] + 0.1 * random.standard_normal(300)

    def solve(part):
        return np.linalg.lstsq(slopes[part], measured[part], rcond=None)[0]

    whole = solve(block >= 0)
    changes = np.array([whole - solve(block != g) for g in range(12)])
    found = jackknife(slopes, measured - slopes @ whole, block)
    assert found.covariance == pytest.approx(11.0 / 12.0 * changes.T @ changes, rel=1e-9)
    assert (found.freedom <= 12.0).all()


def test_fit_law_alone_is_what_identify_uses(dependency) -> None:
    system = System(friction=FittedFriction())
    histories = [friction_history(t, system) for t in dependency.values()]
    found = fit_law(Samples.of(histories, 20.0), system, DEFAULT)
    assert values(identify(list(dependency.values())).law) == pytest.approx(
        [found.values[name] for name in DEFAULT], rel=1e-12
    )
