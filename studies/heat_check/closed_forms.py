r"""Closed forms: kernels of the half-space and of plates, and a sum of fading modes for them.

The rise of a surface point is :math:`\sqrt{D/\pi}/k\,\int q(t-\tau)\,G(\tau)\,d\tau`, with
:math:`G = 1/\sqrt\tau` for the half-space. In a plate the heat comes back from the back face: images at every
:math:`2L`, all of one sign if the back is insulated, of alternating sign if it is kept at ambient.
"""

import numpy as np
from numpy.typing import ArrayLike
from plate_fe import CONDUCTIVITY, DIFFUSIVITY, Array
from scipy.optimize import brentq, lsq_linear
from scipy.special import erfc

FACTOR = np.sqrt(DIFFUSIVITY / np.pi) / CONDUCTIVITY
IMAGES = np.arange(1, 400)
RATIO = 2.0**1.5  # of neighbouring rates


def plate_kernel(time: ArrayLike, thickness: float, cold_back: bool) -> Array:
    """Return G [s^-1/2] of a plate, by images for short times and by modes for long ones."""
    t = np.atleast_1d(np.asarray(time, dtype=np.float64))[:, None]
    sign = np.where(IMAGES % 2 == 1, -1.0, 1.0) if cold_back else np.ones(IMAGES.size)
    crossing = thickness**2 / DIFFUSIVITY  # time that heat takes to cross the plate, in order of size [s]
    images = (1.0 + 2.0 * (sign * np.exp(-(IMAGES**2) * crossing / t)).sum(axis=1)) / np.sqrt(t[:, 0])
    waves = IMAGES - 0.5 if cold_back else IMAGES
    modes = 2.0 * np.exp(-((np.pi * waves) ** 2) * t / crossing).sum(axis=1) + (0.0 if cold_back else 1.0)
    return np.where(t[:, 0] < crossing, images, np.sqrt(np.pi / crossing) * modes)


def constant_flux_rise(time: ArrayLike, thickness: float = np.inf, cold_back: bool = False) -> Array:
    """Return the rise of the surface under a unit flux from time zero on [degC mm s/N]."""
    t = np.atleast_1d(np.asarray(time, dtype=np.float64))[:, None]
    half_space = 2.0 * FACTOR * np.sqrt(t[:, 0])
    if np.isinf(thickness):
        return half_space
    sign = np.where(IMAGES % 2 == 1, -1.0, 1.0) if cold_back else np.ones(IMAGES.size)
    x = IMAGES * thickness / np.sqrt(DIFFUSIVITY * t)
    ierfc = np.exp(-(x**2)) / np.sqrt(np.pi) - x * erfc(x)
    return half_space * (1.0 + 2.0 * np.sqrt(np.pi) * (sign * ierfc).sum(axis=1))


def line_mean(time: Array, position: Array, flux: Array, half_side: float, points: int = 400) -> float:
    """Return the mean rise of the contact at the last time, over points of a half-space along the sliding.

    `position` [mm] at the `time`s, `flux` [N/(mm s)] in the intervals between them.
    """
    ago = np.sqrt(time[-1] - time)
    weighted = 2.0 * FACTOR * (ago[:-1] - ago[1:]) * flux
    inside = position[-1] + half_side * ((np.arange(points) + 0.5) / points * 2.0 - 1.0)
    middle = 0.5 * (position[1:] + position[:-1])
    covered = np.abs(inside[:, None] - middle) <= half_side
    return float((covered @ weighted).mean())


def sheet_kernel(time: ArrayLike, sheet: float, conducting: float, holding: float) -> Array:
    """Return G [s^-1/2] of a sheet on a deep body; arguments as for `plate_fe.depth`."""
    t = np.atleast_1d(np.asarray(time, dtype=np.float64))[:, None]
    effusivity = np.sqrt(conducting * holding)
    echo = ((1.0 - effusivity) / (1.0 + effusivity)) ** IMAGES
    images = 2.0 * (echo * np.exp(-((IMAGES * sheet) ** 2) / (DIFFUSIVITY * t))).sum(axis=1)
    return (1.0 + images) / np.sqrt(t[:, 0])


def onset(thickness: float, share: float, steady: bool) -> float:
    """Return the time [s] at which an insulated back adds `share` of the temperature.

    With `steady` under a constant flux, else long after a short heating, where the kernel itself tells.
    """
    crossing = thickness**2 / DIFFUSIVITY

    def excess(log_time: float) -> float:
        t = np.exp(log_time) * crossing
        if steady:
            ratio = constant_flux_rise(t, thickness) / constant_flux_rise(t)
        else:
            ratio = plate_kernel(t, thickness, False) * np.sqrt(t)
        return float(ratio[0]) - 1.0 - share

    return float(np.exp(brentq(excess, np.log(0.05), np.log(50.0)))) * crossing


def fading_modes(
    thickness: float, cold_back: bool, count: int = 16, fitted: int = 6
) -> tuple[Array, Array, float]:
    r"""Return a sum of exponentials for the kernel of a plate.

    With :math:`a = \pi^2 D/L^2` (insulated back) the rates are 0, a, and 1.5 a onwards in the ratio
    :math:`2^{1.5}`; with :math:`a = \pi^2 D/(4L^2)` (back at ambient) a, and 9 a onwards. The fast modes have
    the weights that the trapezoidal rule gives them for the half-space, the slowest ones are fitted. Weights
    over :math:`\sqrt a` are the same for every plate.

    Returns
    -------
    tuple
        Rates [1/s], weights [s^-1/2] and the largest relative error for lags from 4 ms to ten times L^2/D
        (twice for the cold back, where little is left after that).
    """
    crossing = thickness**2 / DIFFUSIVITY
    own = (0.5 * np.pi if cold_back else np.pi) ** 2 / crossing
    lead = [1.0] if cold_back else [0.0, 1.0]
    rates = own * np.concatenate((lead, (9.0 if cold_back else 1.5) * RATIO ** np.arange(count - len(lead))))
    weights = np.log(RATIO) / np.sqrt(np.pi) * np.sqrt(rates)
    lags = np.geomspace(4e-3, (2.0 if cold_back else 10.0) * crossing, 1500)
    target = plate_kernel(lags, thickness, cold_back)
    table = np.exp(-lags[:, None] * rates)
    missing = 1.0 - table[:, fitted:] @ weights[fitted:] / target
    weights[:fitted] = lsq_linear(
        table[:, :fitted] / target[:, None], missing, bounds=(0.0, np.inf), tol=1e-14
    ).x
    return rates, weights, float(np.abs(table @ weights / target - 1.0).max())
