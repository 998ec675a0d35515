"""The closed form of a step against a numerical integration of the equation it solves."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from dcfp.kernels.oscillator import advance_oscillator, work


def integrate(stiffness, step, velocity, acceleration, rate, curvature):
    """y - y0, v, and the first two integrals of y - y0, with the force taken from the acceleration at the start."""

    def slope(t, state):
        y, v, area, _ = state
        return [v, acceleration + rate * t + curvature * t**2 - stiffness * y, y, area]

    solved = solve_ivp(slope, (0.0, step), [0.0, velocity, 0.0, 0.0], method="DOP853", rtol=1e-12, atol=1e-14)
    return solved.y[:, -1]


@pytest.mark.parametrize("angle", [1e-6, 0.01, 0.3, 0.55, 1.0])
@pytest.mark.parametrize("start", [(300.0, 0.0), (-40.0, 2500.0)])
def test_a_step_solves_the_equation_of_motion(angle, start):
    step = 0.01
    stiffness = (angle / step) ** 2
    velocity, acceleration = start
    expected = integrate(stiffness, step, velocity, acceleration, -8e4, 3e6)
    moved = advance_oscillator(stiffness, step, velocity, acceleration, -8e4, 3e6)
    np.testing.assert_allclose(moved, expected, rtol=1e-11, atol=1e-13)


def test_free_oscillation_returns_after_one_period():
    steps, stiffness = 60, 2472.0
    step = 2.0 * np.pi / np.sqrt(stiffness) / steps
    y, v = 0.2, 0.0
    for _ in range(steps):
        moved = advance_oscillator(stiffness, step, v, -stiffness * y, 0.0, 0.0)
        y, v = y + moved.displacement, moved.velocity
    assert y == pytest.approx(0.2, rel=1e-12)
    assert v == pytest.approx(0.0, abs=1e-10)


@given(
    st.floats(1e-4, 0.02),
    st.floats(-1e3, 1e3),
    st.floats(-1e4, 1e4),
    st.floats(-1e5, 1e5),
    st.floats(-1e6, 1e6),
)
def test_work_of_the_force_is_the_change_of_energy(step, velocity, constant, rate, curvature):
    stiffness, y = 1.09, 37.0
    moved = advance_oscillator(stiffness, step, velocity, constant - stiffness * y, rate, curvature)
    done = work(constant, rate, curvature, step, moved)
    kinetic = 0.5 * (moved.velocity**2 - velocity**2)
    strain = 0.5 * stiffness * ((y + moved.displacement) ** 2 - y**2)
    assert done == pytest.approx(kinetic + strain, rel=1e-9, abs=1e-7)
