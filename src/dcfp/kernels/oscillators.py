r"""Many damped oscillators under the same ground motion at once: exact for acceleration that is linear between samples.

.. math:: \ddot u + 2 h \omega \dot u + \omega^2 u = -a_g(t)

From sample to sample displacement and velocity are a linear function of themselves and of the two accelerations, with the same
eight coefficients throughout. The inner loop is over the oscillators, which a processor takes several at a time.
"""

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel

# rows of the coefficients: of u, v, the acceleration at the start and its change over the step, in the new u and the new v;
# then omega squared, 2 h omega
UU, UV, UA, UC, VU, VV, VA, VC, SQUARE, DAMPING, COEFFICIENTS = range(11)
# rows of the state and of what is compared on the way; energies are per unit mass
U, V, PEAK_U, PEAK_V, PEAK_A, INPUT, PEAK_INPUT, PEAK_ABSOLUTE, ROWS = range(9)


@kernel
def _stepped(
    coefficients: NDArray[np.float64], j: int, u: float, v: float, a: float, c: float
) -> tuple[float, float]:
    """Return displacement and velocity of oscillator j after a step, from those before it, the acceleration and its change."""
    return (
        coefficients[UU, j] * u + coefficients[UV, j] * v + coefficients[UA, j] * a + coefficients[UC, j] * c,
        coefficients[VU, j] * u + coefficients[VV, j] * v + coefficients[VA, j] * a + coefficients[VC, j] * c,
    )


@kernel
def _furthest(u: float, v: float, next_u: float, next_v: float, step: float) -> float:
    """Return the largest displacement of a step: at its end, or where the parabola of the two velocities turns."""
    turning = u + (0.5 * step * v * v / (v - next_v) if v * next_v < 0.0 else 0.0)
    return max(abs(next_u), abs(turning))


@kernel
def respond_all(
    coefficients: NDArray[np.float64],
    step: float,
    acceleration: NDArray[np.float64],
    state: NDArray[np.float64],
) -> None:
    """Take every oscillator through the samples of `acceleration` [mm/s2], `step` [s] apart; note its largest displacement."""
    for i in range(acceleration.size - 1):
        a = acceleration[i]
        c = acceleration[i + 1] - a
        for j in range(state.shape[1]):
            u, v = state[U, j], state[V, j]
            next_u, next_v = _stepped(coefficients, j, u, v, a, c)
            state[PEAK_U, j] = max(state[PEAK_U, j], _furthest(u, v, next_u, next_v, step))
            state[U, j], state[V, j] = next_u, next_v


@kernel
def respond_slowly(
    coefficients: NDArray[np.float64],
    step: float,
    acceleration: NDArray[np.float64],
    state: NDArray[np.float64],
) -> None:
    """Do the same for oscillators so slow that they turn at a sample, without the division that looks between samples."""
    for i in range(acceleration.size - 1):
        a = acceleration[i]
        c = acceleration[i + 1] - a
        for j in range(state.shape[1]):
            u, v = state[U, j], state[V, j]
            next_u, next_v = _stepped(coefficients, j, u, v, a, c)
            state[PEAK_U, j] = max(state[PEAK_U, j], abs(next_u))
            state[U, j], state[V, j] = next_u, next_v


@kernel
def respond_with_energy(
    coefficients: NDArray[np.float64],
    step: float,
    acceleration: NDArray[np.float64],
    ground: NDArray[np.float64],
    state: NDArray[np.float64],
) -> None:
    """Do the same, and note the largest velocity, absolute acceleration and input energies at the samples.

    `ground` is the velocity of the ground [mm/s]. The relative input energy is the integral of - a_g v, in closed form; the absolute one that
    of (a_u + a_g) v_g, which differs by v_g (v_g / 2 + v).
    """
    for i in range(acceleration.size - 1):
        a = acceleration[i]
        next_a = acceleration[i + 1]
        c = next_a - a
        g = ground[i + 1]
        for j in range(state.shape[1]):
            u, v = state[U, j], state[V, j]
            next_u, next_v = _stepped(coefficients, j, u, v, a, c)
            square, damping = coefficients[SQUARE, j], coefficients[DAMPING, j]
            # the equation of motion, integrated over the step, gives the area under u
            area = -(step * (a + 0.5 * c) + (next_v - v) + damping * (next_u - u)) / square
            energy = state[INPUT, j] - (next_a * next_u - a * u) + c / step * area
            absolute = energy + g * (0.5 * g + next_v)
            total = damping * next_v + square * next_u
            state[PEAK_U, j] = max(state[PEAK_U, j], _furthest(u, v, next_u, next_v, step))
            state[PEAK_V, j] = max(state[PEAK_V, j], abs(next_v))
            state[PEAK_A, j] = max(state[PEAK_A, j], abs(total))
            state[PEAK_INPUT, j] = max(state[PEAK_INPUT, j], energy)
            state[PEAK_ABSOLUTE, j] = max(state[PEAK_ABSOLUTE, j], absolute)
            state[INPUT, j] = energy
            state[U, j], state[V, j] = next_u, next_v
