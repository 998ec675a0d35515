r"""Temperature of the contact by brute force: the integral of Eq. (11) summed over the whole past, at many points.

Nothing here is shared with the kernels. The flux is taken constant over each interval, and its weight is exact:

.. math:: \int_{t_a}^{t_b} \frac{d\tau}{\sqrt{t-\tau}} = 2 \left(\sqrt{t-t_a} - \sqrt{t-t_b}\right)
"""

import math
from dataclasses import dataclass

import numpy as np

from dcfp.analysis import Response
from dcfp.arrays import FloatArray


@dataclass(frozen=True)
class SlidingHistory:
    """A slider on one of two equal plates.

    Attributes
    ----------
    time
        [s], shape (n + 1,).
    position
        Of the slider on the plate in the middle of each interval [mm], shape (n,).
    flux
        Heat into the plate per area in each interval [N/(mm s)], shape (n,).
    """

    time: FloatArray
    position: FloatArray
    flux: FloatArray


def history_of(response: Response) -> SlidingHistory:
    """Return the history of a response on two equal plates: y/2 and mu p |v| / 2, Li et al. (2020), Eq. (12)."""
    speed = np.where(response.sliding != 0.0, np.abs(response.velocity), 0.0)
    flux = 0.5 * response.friction * response.bearing.pressure * speed
    position = 0.5 * response.displacement
    return SlidingHistory(
        time=response.time,
        position=0.5 * (position[1:] + position[:-1]),
        flux=0.5 * (flux[1:] + flux[:-1]),
    )


def rises_at(
    history: SlidingHistory,
    sample: int,
    points: FloatArray,
    half_contact: float,
    conductivity: float,
    diffusivity: float,
) -> FloatArray:
    """Temperature rise of points on the plate [degC] at a sample: Li et al. (2020), Eqs (11) and (12).

    `points` and `half_contact` [mm], `conductivity` [N/(s degC)], `diffusivity` [mm2/s].
    """
    ago = np.sqrt(history.time[sample] - history.time[: sample + 1])
    weighted = 2.0 * (ago[:-1] - ago[1:]) * history.flux[:sample]
    factor = math.sqrt(diffusivity / math.pi) / conductivity
    covered = np.abs(points[:, np.newaxis] - history.position[np.newaxis, :sample]) <= half_contact
    return np.asarray(factor * (covered @ weighted))


def centre_temperature(response: Response, sample: int) -> float:
    """Temperature of the centre of the plate [degC] at a sample: the simplified model."""
    return _mean_temperature(response, sample, np.zeros(1))


def contact_temperature(response: Response, sample: int, spacing: float) -> float:
    """Mean temperature of the contact [degC] at a sample, of points `spacing` [mm] apart: the precise model."""
    half = response.bearing.contact_half_side
    count = max(2, math.ceil(2.0 * half / spacing))
    inside = (np.arange(count) + 0.5) / count * 2.0 * half - half
    return _mean_temperature(response, sample, 0.5 * response.displacement[sample] + inside)


def _mean_temperature(response: Response, sample: int, points: FloatArray) -> float:
    heating = response.heating
    rises = rises_at(
        history_of(response),
        sample,
        points,
        response.bearing.contact_half_side,
        heating.conductivity,
        heating.diffusivity,
    )
    return heating.ambient + float(rises.mean())
