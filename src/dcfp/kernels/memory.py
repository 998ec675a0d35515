r"""The half-space's memory of past heat as a short sum of fading modes.

The kernel of Eq. (11) is an integral of exponentials, and the trapezoidal rule in :math:`\ln x` turns it into a sum:

.. math:: \frac1{\sqrt\tau} = \frac2{\sqrt\pi} \int_0^\infty e^{-x^2\tau}\,dx
          \approx \sum_j w_j e^{-s_j \tau} + w_\infty \delta(\tau)

with rates in geometric ratio. Beylkin and Monzon (2005) give the idea. The endless rule with ratio :math:`r = s_{j+1}/s_j` is off by at most
:math:`2\sqrt2\,e^{-\pi^2/\ln r}` of the kernel. Modes faster than anything that happens in a step act at once
(:math:`w_\infty`); slower modes are lumped into the two slowest.
Each mode is a first-order recursion, so a step costs the same whatever came before it, and neither a restart nor the way
in which time is cut can alter what a given flux does.
"""

import math
from functools import cache

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.exponential import fading

#: Ratio of neighbouring rates; 2 sqrt(2) exp(-pi2/ln r) = 2.1e-4 of the kernel, a tenth of it in a temperature.
RATE_RATIO = 2.0**1.5
#: Number of modes; fixed and a multiple of four, the lanes of a processor, so that every loop over them is laid out flat.
MODES = 16
#: What a fading mode keeps [degC]: a processor takes fifty times as long to reckon with the smallest numbers there are.
_TRACE = 1e-100
#: Time within which the slowest mode hardly fades, unless another is asked for [s].
HORIZON = 100.0


@cache
def fading_modes(horizon: float = HORIZON) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
    """Return rates [1/s] (slowest first), weights [s^-1/2] and the instant weight [s^1/2] for 1/sqrt(tau).

    The slowest mode hardly fades within the `horizon` [s]. For the default one the fastest lives 0.8 milliseconds, and the
    sum is within 2.7e-4 of the kernel for lags from 4 milliseconds to 100 s, within 1e-3 up to 300 s.
    """
    rates = 0.02 / horizon * RATE_RATIO ** np.arange(MODES)
    weights = trapezoidal_weights(rates)
    shrink = 1.0 / math.sqrt(RATE_RATIO)
    # the slower modes are not there: the two slowest take over their weight and their first fading
    slower = weights[0] * shrink / (1.0 - shrink)
    faded = weights[0] * rates[0] * shrink**3 / (1.0 - shrink**3)
    moved = (faded - slower * rates[0]) / (rates[1] - rates[0])
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


@kernel
def fill_fade(bank: NDArray[np.float64], rates: int, step: float, fade: int) -> None:
    """Write exp(-rate step) of every mode into row `fade`, from the fourth mode on by repeated squaring.

    Every second rate is RATE_RATIO squared = 8 times as fast; the slowest modes of a plate have rates of their own.
    """
    for j in range(4):
        bank[fade, j] = fading(bank[rates, j] * step)
    for j in range(4, MODES):
        f = bank[fade, j - 2]
        f *= f
        f *= f
        f *= f
        bank[fade, j] = f


@kernel
def fill_weights(bank: NDArray[np.float64], rates: int, weights: int, step: float, fade: int) -> None:
    """Write what a linear flux does over a step into the two rows after `fade`.

    A step in which the flux goes from q0 to q1 turns c into fade c + opening q0 + closing q1.
    """
    for j in range(MODES):
        x = bank[rates, j] * step
        e = bank[fade, j]
        scale = bank[weights, j] * step
        # the exact form cancels for small x; there the series is good to 1e-9
        near_opening = 0.5 - x * (1.0 / 3.0 - x * (0.125 - x * (1.0 / 30.0 - x * (1.0 / 144.0))))
        near_closing = 0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x * (1.0 / 120.0 - x * (1.0 / 720.0))))
        over = 1.0 / (x * x)
        small = x < 0.05
        bank[fade + 1, j] = scale * (near_opening if small else (1.0 - e - x * e) * over)
        bank[fade + 2, j] = scale * (near_closing if small else (x - 1.0 + e) * over)


@kernel
def total(bank: NDArray[np.float64], row: int) -> float:
    """Sum of a row, in four parts: in one, each addition would wait for the one before."""
    s0, s1, s2, s3 = 0.0, 0.0, 0.0, 0.0
    for j in range(0, MODES, 4):
        s0 += bank[row, j]
        s1 += bank[row, j + 1]
        s2 += bank[row, j + 2]
        s3 += bank[row, j + 3]
    return (s0 + s1) + (s2 + s3)


@kernel
def faded_total(bank: NDArray[np.float64], fade: int, row: int) -> float:
    """Sum of a row after a fade."""
    s0, s1, s2, s3 = 0.0, 0.0, 0.0, 0.0
    for j in range(0, MODES, 4):
        s0 += bank[fade, j] * bank[row, j]
        s1 += bank[fade, j + 1] * bank[row, j + 1]
        s2 += bank[fade, j + 2] * bank[row, j + 2]
        s3 += bank[fade, j + 3] * bank[row, j + 3]
    return (s0 + s1) + (s2 + s3)


@kernel
def feed(bank: NDArray[np.float64], fade: int, row: int, flux_start: float, flux_end: float) -> float:
    """Advance a row of modes over a step in which the flux is linear; return their new sum."""
    for j in range(MODES):
        heated = bank[fade + 1, j] * flux_start + bank[fade + 2, j] * flux_end
        bank[row, j] = bank[fade, j] * bank[row, j] + heated
    return total(bank, row)


@kernel
def let_fade(bank: NDArray[np.float64], fade: int, row: int) -> float:
    """Advance a row of modes over a step without flux; return their new sum."""
    for j in range(MODES):
        bank[row, j] = bank[fade, j] * bank[row, j] + _TRACE
    return total(bank, row)
