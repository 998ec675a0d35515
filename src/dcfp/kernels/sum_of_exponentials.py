r"""The heat equation's kernels as short sums of exponentials.

For a half-space the kernel of Eq. (11) is an integral of exponentials, and the trapezoidal rule in :math:`\ln x` turns it into a sum:

.. math:: \frac1{\sqrt\tau} = \frac2{\sqrt\pi} \int_0^\infty e^{-x^2\tau}\,dx
          \approx \sum_j w_j e^{-s_j \tau} + w_\infty \delta(\tau)

with rates in geometric ratio (Beylkin and Monzon 2005). Modes faster than anything that happens in a step act at once
(:math:`w_\infty`); slower modes are lumped into the two slowest. Each mode is a first-order recursion, so a step costs the same whatever came before it,
and neither a restart nor the way in which time is cut can alter what a given flux does. Of a plate of finite thickness, whose kernel is a sum of exponentials
for long times (``docs/heat_model.md``), the slowest modes are kept, and a few that follow were fitted to the kernel; from there on they are the half-space's.

The exponential function is evaluated in line: a call of the mathematical library saves and restores the registers around it, and in the
integration, where each step depends on a coefficient of friction, that is a twentieth of the time.
"""

import math
from functools import cache

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel

#: Ratio of neighbouring rates; 2 sqrt(2) exp(-pi2/ln r) = 2.1e-4 of the kernel, a tenth of it in a temperature.
RATE_RATIO = 2.0**1.5
#: Number of modes; fixed and a multiple of four, the width of the processor's vectors, so that every loop over them is unrolled.
MODES = 16
#: What a decaying mode keeps [degC]: denormal numbers would make a step fifty times as slow.
_NORMAL = 1e-100
#: Time within which the slowest mode hardly decays, unless another is asked for [s].
HORIZON = 100.0

#: Rates over a, and weights over its root, of the modes that are not those of the half-space; fitted for lags from L2/(2500 D) to 10 L2/D.
_INSULATED = (
    (0.0, 1.0, 1.5, 1.5 * RATE_RATIO, 1.5 * RATE_RATIO**2, 1.5 * RATE_RATIO**3),
    (0.56421, 1.12054, 0.02301, 1.28960, 2.00845, 3.42518),
)
#: The same over a / 4, for lags up to 2 L2/D.
_COLD = (
    (1.0, 9.0, 9.0 * RATE_RATIO, 9.0 * RATE_RATIO**2, 9.0 * RATE_RATIO**3, 9.0 * RATE_RATIO**4),
    (2.25723, 2.23047, 2.71518, 5.15038, 8.24771, 14.13561),
)

_PARTS = 128  # of one; a power of two
_LARGEST = 700.0
_WHOLE = np.exp(-np.arange(_LARGEST + 1.0))
_PART = np.exp(-np.arange(_PARTS) / _PARTS)
#: A number so large that what is added to it loses its fraction.
_NO_FRACTION = 1.5 * 2.0**52


@cache
def half_space_modes(horizon: float = HORIZON) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
    """Return rates [1/s] (slowest first), weights [s^-1/2] and the instant weight [s^1/2] for 1/sqrt(tau).

    The slowest mode hardly decays within the `horizon` [s]. For the default one the fastest lives 0.8 milliseconds, and the
    sum is within 2.7e-4 of the kernel for lags from 4 milliseconds to 100 s, within 1e-3 up to 300 s.
    """
    rates = 0.02 / horizon * RATE_RATIO ** np.arange(MODES)
    weights = trapezoidal_weights(rates)
    shrink = 1.0 / math.sqrt(RATE_RATIO)
    # the slower modes are not there: the two slowest take over their weight and the first term of their decay
    slower = weights[0] * shrink / (1.0 - shrink)
    decayed = weights[0] * rates[0] * shrink**3 / (1.0 - shrink**3)
    moved = (decayed - slower * rates[0]) / (rates[1] - rates[0])
    weights[0] += slower - moved
    weights[1] += moved
    rates.flags.writeable = weights.flags.writeable = False
    return rates, weights, instant_weight(rates[-1])


def trapezoidal_weights(rates: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the weights [s^-1/2] of the rule for modes in the ratio `RATE_RATIO`, of rates [1/s]."""
    spacing = 0.5 * math.log(RATE_RATIO)  # of ln x, x = sqrt(s)
    return 2.0 / math.sqrt(math.pi) * spacing * np.sqrt(rates)


def instant_weight(fastest: float) -> float:
    """Return the weight [s^1/2] of all modes faster than one of a rate [1/s], which act at once."""
    shrink = 1.0 / math.sqrt(RATE_RATIO)
    weight = float(trapezoidal_weights(np.array([fastest]))[0])
    return weight / fastest * shrink / (1.0 - shrink)


def finite_plate_modes(
    diffusivity: float, thickness: float, *, insulated: bool
) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
    """Return rates [1/s], weights [s^-1/2] and the instant weight [s^1/2] for the kernel of a plate.

    `diffusivity` [mm2/s], `thickness` [mm]. Within 0.04 % of the kernel for an insulated back and 0.13 % for a cold one, from lags
    of 4 milliseconds on, up to 10 and 2 times L2/D.
    """
    slowest = math.pi**2 * diffusivity / thickness**2 * (1.0 if insulated else 0.25)
    own_rates, own_weights = (np.array(values) for values in (_INSULATED if insulated else _COLD))
    rates = slowest * own_rates[-1] * RATE_RATIO ** np.arange(1 - own_rates.size, MODES - own_rates.size + 1)
    rates[: own_rates.size] = slowest * own_rates
    weights = trapezoidal_weights(rates)
    weights[: own_weights.size] = math.sqrt(slowest) * own_weights
    return rates, weights, instant_weight(rates[-1])


@kernel
def exp_neg(x: float) -> float:
    """Return exp(-x), within three units of the last place; quick for x from 0 to 700."""
    if not 0.0 <= x < _LARGEST:
        return math.exp(-x)
    nearest = (_PARTS * x + _NO_FRACTION) - _NO_FRACTION
    n = int(nearest)
    r = nearest * (1.0 / _PARTS) - x
    square = r * r
    near = (1.0 + r) + square * ((0.5 + r * (1.0 / 6.0)) + square * (1.0 / 24.0 + r * (1.0 / 120.0)))
    return (_WHOLE[n // _PARTS] * _PART[n % _PARTS]) * near


@kernel
def fill_decay(modes: NDArray[np.float64], rates: int, step: float, factors: int) -> None:
    """Write exp(-rate step) of every mode into row `factors`, from the fourth mode on by repeated squaring.

    Every second rate is RATE_RATIO squared = 8 times as fast; the slowest modes of a plate have rates of their own.
    """
    for j in range(4):
        modes[factors, j] = exp_neg(modes[rates, j] * step)
    for j in range(4, MODES):
        f = modes[factors, j - 2]
        f *= f
        f *= f
        f *= f
        modes[factors, j] = f


@kernel
def fill_weights(modes: NDArray[np.float64], rates: int, weights: int, step: float, factors: int) -> None:
    """Write what a linear flux does over a step into the two rows after `factors`.

    A step in which the flux goes from q0 to q1 turns c into factor c + opening q0 + closing q1.
    """
    for j in range(MODES):
        x = modes[rates, j] * step
        e = modes[factors, j]
        scale = modes[weights, j] * step
        # the exact form cancels for small x; there the series is good to 1e-9
        near_opening = 0.5 - x * (1.0 / 3.0 - x * (0.125 - x * (1.0 / 30.0 - x * (1.0 / 144.0))))
        near_closing = 0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x * (1.0 / 120.0 - x * (1.0 / 720.0))))
        over = 1.0 / (x * x)
        small = x < 0.05
        modes[factors + 1, j] = scale * (near_opening if small else (1.0 - e - x * e) * over)
        modes[factors + 2, j] = scale * (near_closing if small else (x - 1.0 + e) * over)


@kernel
def total(modes: NDArray[np.float64], row: int) -> float:
    """Sum of a row, in four parts: in one, each addition would depend on the one before."""
    s0, s1, s2, s3 = 0.0, 0.0, 0.0, 0.0
    for j in range(0, MODES, 4):
        s0 += modes[row, j]
        s1 += modes[row, j + 1]
        s2 += modes[row, j + 2]
        s3 += modes[row, j + 3]
    return (s0 + s1) + (s2 + s3)


@kernel
def decayed_total(modes: NDArray[np.float64], factors: int, row: int) -> float:
    """Sum of a row after it has decayed."""
    s0, s1, s2, s3 = 0.0, 0.0, 0.0, 0.0
    for j in range(0, MODES, 4):
        s0 += modes[factors, j] * modes[row, j]
        s1 += modes[factors, j + 1] * modes[row, j + 1]
        s2 += modes[factors, j + 2] * modes[row, j + 2]
        s3 += modes[factors, j + 3] * modes[row, j + 3]
    return (s0 + s1) + (s2 + s3)


@kernel
def accumulate(
    modes: NDArray[np.float64], factors: int, row: int, flux_start: float, flux_end: float
) -> float:
    """Advance a row of modes over a step in which the flux is linear; return their new sum."""
    for j in range(MODES):
        heated = modes[factors + 1, j] * flux_start + modes[factors + 2, j] * flux_end
        modes[row, j] = modes[factors, j] * modes[row, j] + heated
    return total(modes, row)


@kernel
def decay(modes: NDArray[np.float64], factors: int, row: int) -> float:
    """Advance a row of modes over a step without flux; return their new sum."""
    for j in range(MODES):
        modes[row, j] = modes[factors, j] * modes[row, j] + _NORMAL
    return total(modes, row)
