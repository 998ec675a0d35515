"""The plan against a program of very small steps that shares nothing with its kernels."""

import numpy as np
import pytest
from explicit_plan import integrate

import dcfp
from dcfp import LI_2020, ConstantFriction, Li2020, NoHeating, SimplifiedHeating, System
from dcfp.analysis.plan import respond_plan
from dcfp.system.plan import Plan, grid
from dcfp.system.storeys import MODAL, Storey

CONSTANT = System(LI_2020, ConstantFriction(0.043), NoHeating())
HEATED = System(LI_2020, Li2020(), SimplifiedHeating())
NINE = grid([0.0, 5000.0, 10000.0], [0.0, 5000.0, 10000.0])
ANGLE = np.array([(0.0, 0.0), (6000.0, 0.0), (12000.0, 0.0), (0.0, 6000.0), (0.0, 12000.0)])
FLOOR = 9 * LI_2020.mass / 4
STOREYS = tuple(Storey(FLOOR, (1.5e6, 1.2e6), 4000.0) for _ in range(3))
TALL = tuple(Storey(FLOOR, (1.5e6, 1.2e6), 12000.0) for _ in range(3))
CASES = {
    "rigid, heated": Plan(NINE, HEATED, eccentricity=(0.05, 0.05)),
    "rigid and high, heated": Plan(NINE, HEATED, eccentricity=(0.1, -0.05), height=12000.0),
    "an angle, constant": Plan(ANGLE, CONSTANT, centre=(3800.0, 3400.0), height=6000.0),
    "storeys, heated": Plan(NINE, HEATED, eccentricity=(0.05, 0.05), storeys=STOREYS),
    "storeys, modal, constant": Plan(NINE, CONSTANT, eccentricity=(0.1, 0.0), storeys=STOREYS, damping_kind=MODAL),
    "uplift, heated": Plan(NINE, HEATED, eccentricity=(0.1, 0.1), storeys=TALL),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_the_plan_is_that_of_very_small_steps(case: str) -> None:
    plan, motion = CASES[case], dcfp.load_station("P695-FF-2").scaled_to_pgv(500.0)
    found = respond_plan(plan, motion, tail=0.0)
    brute = integrate(plan, motion)
    static = plan.static_loads
    assert found.peak_displacement == pytest.approx(brute.displacement, rel=5e-4)
    assert found.peak_rotation == pytest.approx(brute.rotation, rel=3e-3, abs=1.5e-6)
    np.testing.assert_allclose(found.peak_temperature, brute.temperature, atol=0.1)
    np.testing.assert_allclose(found.least_load / static, brute.least / static, atol=4e-3)
    np.testing.assert_allclose(found.largest_load / static, brute.largest / static, atol=4e-3)
    np.testing.assert_allclose(found.uplift_time, brute.lifted, atol=0.02)
    np.testing.assert_allclose(found.peak_drift, brute.drift, rtol=2e-3)
    np.testing.assert_allclose(found.peak_floor_acceleration[1:], brute.acceleration[1:], rtol=3e-3)
