"""The plan against a program of very small steps that shares nothing with its kernels."""

import numpy as np
import pytest
from explicit_plan import PlanOutcome, integrate
from vertical import with_vertical

import dcfp
from dcfp import LI_2020, ConstantFriction, Li2020, NoHeating, SimplifiedHeating, Station, System
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


def check(plan: Plan, motion: Station, *, vertical: bool = False) -> PlanOutcome:
    """Compare the analysis with very small steps, and return the outcome of these."""
    found = respond_plan(plan, motion, vertical=vertical, tail=0.0)
    brute = integrate(plan, motion, vertical=vertical)
    static = plan.static_loads
    assert found.peak_displacement == pytest.approx(brute.displacement, rel=5e-4)
    assert found.peak_rotation == pytest.approx(brute.rotation, rel=3e-3, abs=1.5e-6)
    np.testing.assert_allclose(found.peak_temperature, brute.temperature, atol=0.1)
    np.testing.assert_allclose(found.least_load / static, brute.least / static, atol=1e-3)
    np.testing.assert_allclose(found.largest_load / static, brute.largest / static, atol=1e-3)
    np.testing.assert_allclose(found.uplift_time, brute.lifted, atol=0.005)
    np.testing.assert_allclose(found.peak_drift, brute.drift, rtol=1e-3)
    np.testing.assert_allclose(found.peak_floor_acceleration[1:], brute.acceleration[1:], rtol=1e-3)
    # that of the slab jumps with friction, and the more so with a load that changes fast
    slab = brute.acceleration[0]
    assert found.peak_floor_acceleration[0] == pytest.approx(slab, rel=3e-3 if vertical else 1e-3)
    return brute


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_the_plan_is_that_of_very_small_steps(case: str) -> None:
    brute = check(CASES[case], dcfp.load_station("P695-FF-2").scaled_to_pgv(500.0))
    assert (brute.lifted.max() > 0.1) == case.startswith("uplift")


@pytest.mark.slow
@pytest.mark.parametrize("case", ["rigid, heated", "storeys, heated"])
@pytest.mark.parametrize("peak", [0.5, 1.3])
def test_loads_that_follow_a_vertical_component_are_those_of_very_small_steps(case: str, peak: float) -> None:
    motion = with_vertical(dcfp.load_station("P695-FF-2").scaled_to_pgv(500.0), peak)
    brute = check(CASES[case], motion, vertical=True)
    assert (brute.lifted.min() > 0.0) == (peak > 1.0)
