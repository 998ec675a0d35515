"""The brute-force integration in the plane by itself, as plain Python where a few steps are enough."""

import math
from dataclasses import replace

import numpy as np
import pytest

from dcfp import LI_2020, ConstantFriction, GroundMotion, PreciseHeating, SimplifiedHeating, Station, respond
from dcfp.system import NoHeating
from dcfp.verify import plane_explicit
from dcfp.verify.plane import CIRCLES
from dcfp.verify.plane_explicit import Outcome, integrate, on_a_grid, overlaps

CONSTANT = np.array([0.043, 0.0, 0.0, 0.0, 0.0, 1.0])


@pytest.fixture
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("march", "summed", "heat_points", "hottest_near"):
        monkeypatch.setattr(plane_explicit, f"_{name}", getattr(plane_explicit, f"_{name}_plainly"))
    monkeypatch.setattr(plane_explicit, "STEP", 2e-4)


def turning(seconds: float, turn: float = 1.0) -> Station:
    time = 0.01 * np.arange(round(seconds / 0.01))
    x, y = (GroundMotion(3000.0 * np.minimum(1.0, 4.0 * time) * wave(2.0 * math.pi * turn * time), 0.01) for wave in (np.cos, np.sin))  # fmt: skip
    return Station(x, y)


@pytest.mark.usefixtures("plain")
@pytest.mark.parametrize(
    "heating", [NoHeating(), SimplifiedHeating(), PreciseHeating()], ids=lambda one: one.name
)
def test_plain_python_and_the_analysis_agree_in_a_second(heating) -> None:
    motion = turning(1.0)
    outcome = integrate(motion, LI_2020, plane_explicit.li_2020_constants(60.0), heating)
    response = respond(motion, LI_2020, "li2020", heating, tail=0.0)
    assert response.peak_displacement > 50.0
    assert outcome.peak == pytest.approx(response.peak_displacement, rel=2e-3)
    assert outcome.temperature.max() == pytest.approx(response.peak_temperature, abs=0.3)


@pytest.mark.usefixtures("plain")
def test_two_directions_are_turned_and_not_each_for_itself() -> None:
    motion = turning(0.6)
    turned = integrate(motion.rotated(30.0), LI_2020, CONSTANT, NoHeating())
    straight = integrate(motion, LI_2020, CONSTANT, NoHeating())
    assert turned.peak == pytest.approx(straight.peak, rel=1e-9)
    still = replace(motion.y, acceleration=np.zeros(motion.y.acceleration.size))
    alone = integrate(Station(motion.x, still), LI_2020, CONSTANT, NoHeating())
    assert np.all(alone.displacement[:, 1] == 0.0)
    line = respond(motion.x, LI_2020, ConstantFriction(0.043), "none", tail=0.0)
    assert alone.peak == pytest.approx(line.peak_displacement, rel=2e-3)


@pytest.mark.slow
def test_brute_force_follows_the_steady_circle() -> None:
    exact = CIRCLES["A 1500 mm/s2, T 2 s, mu 0.043"]
    outcome = integrate(exact.response().motion, LI_2020, CONSTANT, NoHeating())
    turn = round(exact.period / outcome.step)
    assert np.hypot(*outcome.displacement[-turn:].T) == pytest.approx(exact.radius, rel=1e-4)


def test_the_overlap_of_discs_is_that_of_many_points() -> None:
    axis = np.linspace(-1.0, 1.0, 801)
    x, y = np.meshgrid(axis, axis)
    inside = np.hypot(x, y) <= 1.0
    table = overlaps()
    for distance in (0.0, 0.1, 0.7, 1.5, 1.99):
        both = inside & (np.hypot(x - distance, y) <= 1.0)
        found = np.interp(0.5 * distance, np.linspace(0.0, 1.0, table.size - 1), table[:-1])
        assert found == pytest.approx(both.sum() / inside.sum(), abs=2e-3)


@pytest.mark.usefixtures("plain")
def test_a_grid_heats_as_a_constant_flux_does() -> None:
    """2 q sqrt(D t / pi) / k, Carslaw and Jaeger (1959), section 2.9, and what is left of a flux that has ended."""
    heating, step, flux = PreciseHeating(), 0.025, 500.0
    factor = math.sqrt(heating.diffusivity / math.pi) / heating.conductivity
    places = np.zeros((40, 2))
    hottest, mean = on_a_grid(
        Outcome(0.0, places, np.full(40, flux), places[:, 0], step), LI_2020, heating, 80.0
    )
    assert hottest == pytest.approx(20.0 + 2.0 * flux * factor * math.sqrt(1.0), rel=1e-3)
    assert mean == pytest.approx(hottest, rel=1e-3)
    # the slider jumps away when it is half over: the other place begins cold
    places[20:, 0] = 2000.0
    hottest, mean = on_a_grid(
        Outcome(0.0, places, np.full(40, flux), places[:, 0], step), LI_2020, heating, 200.0
    )
    assert hottest == pytest.approx(20.0 + 2.0 * flux * factor * math.sqrt(0.5), rel=1e-3)
    assert mean == pytest.approx(hottest, rel=1e-3)
