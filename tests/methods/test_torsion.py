"""Torsion formulas of codes for a plan, by hand and under rotation."""

import math

import numpy as np
import pytest

from dcfp.methods.torsion import code_torsion, period_ratio
from dcfp.system.plan import Plan, grid

PLACES = grid(np.arange(6) * 6000.0, np.arange(4) * 6000.0)


def test_the_plan_of_30_by_18_metres() -> None:
    plan = Plan(PLACES, eccentricity=(0.05, 0.05))
    asce, ntc = code_torsion(plan, 200.0)
    # P_T^2 = 150 / 102: sums of squares of the places over 24, and (30^2 + 18^2) / 12, in m2
    assert period_ratio(plan.places - np.array(plan.middle), plan.lengths) == pytest.approx(
        math.sqrt(150 / 102)
    )
    assert asce.along_y == pytest.approx(1.0 + 15.0 / (150 / 102) * 12.0 * 1.5 / (30.0**2 + 18.0**2))
    assert asce.along_x == 1.15  # by the formula 1.09
    # equal bearings: e y n / sum(x^2 + y^2)
    assert ntc.along_x == pytest.approx(1.0 + 0.9 * 9.0 / 150.0)
    assert ntc.along_y == pytest.approx(1.0 + 1.5 * 15.0 / 150.0)


def test_a_turned_plan_has_the_same_factors() -> None:
    plan = Plan(PLACES, centre=(16000.0, 8000.0))
    for one, other in zip(code_torsion(plan, 300.0), code_torsion(plan.turned(25.0), 300.0), strict=True):
        assert (one.along_x, one.along_y) == pytest.approx((other.along_x, other.along_y))


def test_loads_that_follow_the_mass_leave_only_the_accident() -> None:
    own = code_torsion(Plan(PLACES, centre=(16000.0, 9000.0)), 200.0)[1]
    uniform = code_torsion(Plan(PLACES, centre=(16000.0, 9000.0), loads=np.full(24, 7.5e6), mass=24 * 7.5e6 / 9806.65), 200.0)[1]  # fmt: skip
    # by the loads' own moments the stiffness sits on the mass; with uniform loads the metre is an eccentricity
    assert own.along_y < uniform.along_y
    assert uniform.along_y == pytest.approx(1.0 + 2.5 * 15.0 / 150.0)
