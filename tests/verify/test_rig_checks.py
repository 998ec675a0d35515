"""The brute-force integration of a test of the virtual machine by itself."""

import numpy as np
import pytest

from dcfp.analysis.rig import Sine
from dcfp.system import LI_2020, PreciseHeating, SimplifiedHeating
from dcfp.verify.rig import FinerSine, refined
from dcfp.verify.rig_explicit import Path, integrate, sine, twice

CONSTANT = np.array([0.043, 0.0, 0.0, 0.0, 0.0, 1.0])


def test_a_finer_sine_is_the_same_sine() -> None:
    coarse = Sine(200.0, 400.0, 2).travel()
    fine = FinerSine(200.0, 400.0, 2, parts=3).travel()
    assert fine.pieces[::3] == pytest.approx(coarse.pieces, abs=1e-9)
    exact = 200.0 * np.sin(2.0 * fine.time[:-1])
    assert np.abs(fine.pieces[:, 0] - exact).max() < 2e-10 * 200.0
    assert refined(coarse, 1).pieces == pytest.approx(coarse.pieces)


def test_brute_force_is_a_coulomb_loop_under_constant_friction() -> None:
    outcome = integrate(sine(200.0, 400.0, 2, 4000), LI_2020, CONSTANT, SimplifiedHeating())
    slip = 0.043 * LI_2020.vertical_force
    assert np.abs(outcome.force[[2000, 4000, 6000]]) == pytest.approx(slip, rel=1e-12)
    area = 4.0 * slip * (200.0 - slip / LI_2020.elastic_stiffness)
    assert outcome.work[8000] - outcome.work[4000] == pytest.approx(area, rel=1e-5)


def steady_slide(distance: float, steps: int, time: float) -> Path:
    velocity = distance / time
    return Path(time / steps, np.linspace(0.0, distance, steps + 1), np.full(steps + 1, velocity))


def test_brute_force_heats_as_a_constant_flux_does() -> None:
    """2 q sqrt(D t / pi) / k, Carslaw and Jaeger (1959), section 2.9, where the slider stays over the point."""
    stiff = LI_2020.unchecked(elastic_stiffness=1e15)
    heating = SimplifiedHeating()
    outcome = integrate(steady_slide(100.0, 1000, 1.0), stiff, CONSTANT, heating)
    flux = 0.5 * 0.043 * 60.0 * 100.0
    rise = 2.0 * flux * np.sqrt(heating.diffusivity * 1.0 / np.pi) / heating.conductivity
    assert outcome.temperature[-1] - 20.0 == pytest.approx(rise, rel=1e-12)


def test_the_overlap_is_the_mean_of_many_points() -> None:
    """The precise model at once against points one by one."""
    heating = PreciseHeating()
    path = sine(400.0, 600.0, 1, 400)
    outcome = integrate(path, LI_2020.unchecked(elastic_stiffness=1e15), CONSTANT, heating)
    middle = 0.25 * (path.displacement[1:] + path.displacement[:-1])
    flux = 0.5 * 0.043 * 60.0 * np.abs(np.diff(path.displacement)) / path.step
    last = 250
    half = LI_2020.contact_half_side
    points = 0.5 * path.displacement[last] + half * (2.0 * (np.arange(4000) + 0.5) / 4000 - 1.0)
    covered = np.abs(points[:, np.newaxis] - middle[np.newaxis, :last]) <= half
    ago = np.sqrt(path.step * (last - np.arange(last + 1)))
    rises = heating.rise_factor * (covered @ (2.0 * (ago[:-1] - ago[1:]) * flux[:last]))
    assert outcome.temperature[last] - 20.0 == pytest.approx(rises.mean(), rel=1e-4)


def test_a_rest_is_left_out_only_where_nothing_is_asked() -> None:
    path = sine(50.0, 100.0, 1, 200)
    doubled = twice(path, 100)
    outcome = integrate(doubled, LI_2020, CONSTANT, SimplifiedHeating())
    assert doubled.displacement.size == 2 * 200 + 100 + 1
    assert outcome.temperature[300] < outcome.temperature[200]
    assert outcome.work[300] == outcome.work[200]
