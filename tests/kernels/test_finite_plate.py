"""The modes of a plate of finite thickness, against its kernel and against the half-space."""

import numpy as np
import pytest

from dcfp.analysis.rig import Program, RigTest, Sine, VerticalLoad, run_program
from dcfp.errors import InputError
from dcfp.kernels.sum_of_exponentials import finite_plate_modes, half_space_modes
from dcfp.system import PreciseHeating, SimplifiedHeating, System
from dcfp.system.plates import cold_plates

DIFFUSIVITY = 4.07


def finite_plate_kernel(lag, diffusivity, thickness, *, insulated):
    """Return the kernel G [s^-1/2] itself at lags [s], by its images."""
    sign = 1.0 if insulated else -1.0
    n = np.arange(1.0, 200.0)
    images = sign**n * np.exp(-np.outer(1.0 / (diffusivity * lag), (n * thickness) ** 2))
    return (1.0 + 2.0 * images.sum(axis=1)) / np.sqrt(lag)


@pytest.mark.parametrize("thickness", [10.0, 30.0, 50.0, 100.0, 200.0])
@pytest.mark.parametrize(("insulated", "reach", "allowed"), [(True, 10.0, 4e-4), (False, 2.0, 1.4e-3)])
def test_modes_are_within_what_they_state_of_the_kernel(thickness, insulated, reach, allowed):
    rates, weights, _ = finite_plate_modes(DIFFUSIVITY, thickness, insulated=insulated)
    lag = np.geomspace(4e-3, reach * thickness**2 / DIFFUSIVITY, 3000)
    kernel = finite_plate_kernel(lag, DIFFUSIVITY, thickness, insulated=insulated)
    total = (weights * np.exp(-np.outer(lag, rates))).sum(axis=1)
    assert np.abs(total / kernel - 1.0).max() < allowed


def test_both_series_of_the_kernel_agree():
    thickness = 40.0
    slow = np.pi**2 * DIFFUSIVITY / thickness**2
    lag = np.geomspace(50.0, 2000.0, 50)
    n = np.arange(1.0, 40.0)
    root = np.sqrt(np.pi * DIFFUSIVITY) / thickness
    insulated = root * (1.0 + 2.0 * np.exp(-np.outer(lag, n**2) * slow).sum(axis=1))
    cold = 2.0 * root * np.exp(-np.outer(lag, (n - 0.5) ** 2) * slow).sum(axis=1)
    assert finite_plate_kernel(lag, DIFFUSIVITY, thickness, insulated=True) == pytest.approx(
        insulated, rel=1e-12
    )
    # the images of a cold back cancel, so that relative to their own size rounding remains
    assert finite_plate_kernel(lag, DIFFUSIVITY, thickness, insulated=False) == pytest.approx(
        cold, rel=1e-9, abs=1e-12
    )


def test_a_thick_plate_is_a_half_space():
    rates, weights, instant = finite_plate_modes(DIFFUSIVITY, 200.0, insulated=True)
    other_rates, other_weights, other_instant = half_space_modes()
    lag = np.geomspace(4e-3, 100.0, 500)
    ours = (weights * np.exp(-np.outer(lag, rates))).sum(axis=1)
    other = (other_weights * np.exp(-np.outer(lag, other_rates))).sum(axis=1)
    assert ours == pytest.approx(other, rel=7e-4)
    assert instant == pytest.approx(other_instant, rel=0.2)


@pytest.mark.parametrize("model", [SimplifiedHeating, PreciseHeating])
def test_the_back_shows_after_the_test_and_on_the_right_side(model):
    wave = Sine(200.0, 400.0, 4)
    load = VerticalLoad((60.0,))
    program = Program("two", (RigTest("a", wave, load), RigTest("b", wave, load, pause=600.0)))

    def begins_at(**plates):
        first, second = run_program(program, heating=model(**plates))
        return first.temperature[-1], second.temperature[0]

    hot, later = begins_at()
    hot_insulated, insulated = begins_at(thickness=50.0)
    hot_cold, cold = begins_at(thickness=50.0, back="ambient")
    assert hot_insulated == pytest.approx(hot, abs=0.02)
    assert hot_cold == pytest.approx(hot, abs=0.05)
    assert cold < later - 3.0
    assert insulated > later + 5.0


def test_an_insulated_plate_keeps_its_heat():
    """What friction gave ends up spread over the plate: a uniform rise of E / (2 rho c L A)."""
    thickness = 20.0
    still = RigTest("b", Sine(0.6, 1.0, 1), VerticalLoad((60.0,)), pause=3600.0)
    program = Program("two", (RigTest("a", Sine(100.0, 200.0, 3), VerticalLoad((60.0,))), still))
    heating = SimplifiedHeating(thickness=thickness)
    first, second = run_program(program, heating=heating)
    heat_capacity = heating.conductivity / heating.diffusivity  # per volume [N/(mm2 degC)]
    heat = first.hysteretic_energy[-1] / first.bearing.slider_area / 2.0
    # the point at the centre is always covered: amplitude / 2 is less than half of the contact
    assert second.temperature[0] - heating.ambient == pytest.approx(
        heat / (heat_capacity * thickness), rel=3e-3
    )


@pytest.mark.parametrize(
    ("plates", "words"),
    [
        ({"thickness": 5.0}, "a number of mm from 10 to 200"),
        ({"thickness": 500.0}, "a number of mm from 10 to 200"),
        ({"thickness": -1.0}, "a number of mm from 10 to 200"),
        ({"thickness": 50.0, "back": "wet"}, "must be one of insulated, ambient"),
        ({"back": "ambient"}, "needs the thickness"),
    ],
)
def test_impossible_plates_are_refused(plates, words):
    with pytest.raises(InputError, match=words):
        SimplifiedHeating(**plates)


def test_modes_of_plates_are_in_their_rows():
    plates = cold_plates(System(heating=SimplifiedHeating(thickness=50.0)))
    rates, _, instant = finite_plate_modes(DIFFUSIVITY, 50.0, insulated=True)
    assert plates.modes[0] == pytest.approx(rates)
    assert plates.instant == instant
