"""The plane engine against what is known in closed form: the steady circle, one oscillator, a friction that turns."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from dcfp.kernels.plane_step import END, elongation_after, oscillator_rows
from dcfp.verify.plane import CIRCLES


@pytest.mark.parametrize(
    ("place", "rigid_plastic", "printed"),
    [(0, 163.9534, 164.0034), (1, 188.0843, 188.4856), (2, 11.1185, 11.2859), (3, 172.2856, 172.4228)],
)
def test_the_steady_circle_of_an_acceleration_that_turns(place, rigid_plastic, printed) -> None:
    """The closed form that `dcfp verify` shows: the friction is not that of two directions each for itself."""
    exact = list(CIRCLES.values())[place]
    assert exact.rigid_plastic_radius == pytest.approx(rigid_plastic, abs=5e-5)
    assert exact.radius == pytest.approx(printed, abs=1e-4)
    response = exact.response()
    last = response.displacement[-1000:]
    # straight between its samples, a turning acceleration is smaller by (w dt)2 / 12
    assert last == pytest.approx(exact.radius, rel=2e-5)
    turned_by = np.diff(response.energy.hysteretic[[-1001, -1]])[0]
    assert turned_by == pytest.approx(exact.energy, rel=3e-5)


def test_the_elongation_follows_a_velocity_that_turns_uniformly() -> None:
    radius, path, angle = 2.0, 3.0, 0.5

    def slope(part: float, direction: np.ndarray) -> list[float]:
        return [path / radius * math.sin(angle * part - direction[0])]

    for start in (-0.9, 0.0, 0.3, 1.2):
        exact = solve_ivp(slope, (0.0, 1.0), [start], rtol=1e-12, atol=1e-12).y[0, -1]
        chord = path * np.exp(0.5j * angle) * math.sin(0.5 * angle) / (0.5 * angle)
        end, slides = elongation_after(
            complex(radius * np.exp(1j * start)),
            radius,
            radius,
            complex(chord),
            1.0 + 0j,
            complex(np.exp(1j * angle)),
        )
        assert slides
        assert end / radius == pytest.approx(np.exp(1j * exact), abs=1e-5)


def test_what_turns_back_is_elastic_until_the_yield_surface_is_met_again() -> None:
    assert elongation_after(2.0 + 0j, 2.0, 2.0, -3.0 + 0j, -1.0 + 0j, -1.0 + 0j) == (-1.0 + 0j, False)
    end, slides = elongation_after(2.0 + 0j, 2.0, 2.0, -5.0 + 0j, -1.0 + 0j, -1.0 + 0j)
    assert slides
    assert end == pytest.approx(-2.0)
    # a surface that grows faster than the elongation is left behind
    assert elongation_after(2.0 + 0j, 2.0, 2.5, 0.2 + 0j, 1.0 + 0j, 1.0 + 0j) == (2.2 + 0j, False)


@pytest.mark.parametrize("stiffness", [0.5, 2471.0, 1e5])
def test_coefficients_of_the_oscillator(stiffness: float) -> None:
    """h^k phi_k by the series, and where it cancels by cosine and sine: both against the solution under a force 1, t, t2."""
    length = 0.013
    (row,) = oscillator_rows(stiffness, np.array([length]))
    for power in range(3):

        def rates(t: float, state: np.ndarray, power: int = power) -> list[float]:
            return [state[1], t**power - stiffness * state[0], state[0]]

        found = solve_ivp(rates, (0.0, length), [0.0, 0.0, 0.0], rtol=1e-11, atol=1e-25).y[:, -1]
        factor = math.factorial(power)
        assert found == pytest.approx(factor * row[END + power + 2 : END + power + 5][[0, 0, 1]] * [1, 0, 1] + factor * np.array([0.0, row[END + power + 1], 0.0]), rel=1e-7)  # fmt: skip
