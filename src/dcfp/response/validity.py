"""What the model assumes, and whether an analysis stayed within it."""

from typing import TYPE_CHECKING

import numpy as np

from dcfp.kernels.march import TEMPERATURE

if TYPE_CHECKING:
    from dcfp.response.response import Response

#: Elongation of spring (b) before sliding above which heat and motion depend on how the two are split [mm].
LARGEST_YIELD_RADIUS = 1.0
#: Ratio of two plates' coefficients up to which they share the travel as their radii.
LARGEST_RATIO = 1.1
#: Time for which the heat in the plates is remembered within 1 % of the temperature [s].
LONGEST_MEMORY = 600.0


def validity_remarks(response: "Response") -> list[str]:
    """Return a sentence for each assumption that the analysis left."""
    name = response.motion.name
    remarks: list[str] = []
    radius = (
        float(response.friction.max()) * response.bearing.vertical_force / response.bearing.elastic_stiffness
    )
    heats = response.heating.name != "none" and bool(response.sliding.any())
    if radius > LARGEST_YIELD_RADIUS and heats:
        remarks.append(
            f"{name}: spring (b) is soft, it stretches {radius:.1f} mm before sliding; the heat of friction is taken"
            " from the whole relative velocity, so temperatures are uncertain."
        )
    ratio = _largest_ratio(response)
    if ratio > LARGEST_RATIO:
        remarks.append(
            f"{name}: the coefficients of the two plates differ by up to {100.0 * (ratio - 1.0):.0f} %, but the travel"
            " is shared as with equal ones."
        )
    if response.time[-1] > LONGEST_MEMORY and heats:
        remarks.append(
            f"{name}: the motion is longer than {LONGEST_MEMORY:.0f} s; heat from longer ago fades too fast in the model."
        )
    return remarks


def _largest_ratio(response: "Response") -> float:
    temperatures = response.histories.lines[:, TEMPERATURE:]
    if temperatures.shape[1] == 1:
        return 1.0
    law, pressure = response.friction_law, response.bearing.pressure
    speed = np.abs(response.velocity)
    first, second = (
        law.coefficient(pressure, speed * (share if law.speed_is_of_surface else 1.0), temperatures[:, i])
        for i, share in enumerate(response.bearing.shares)
    )
    ratio = first / second
    return float(max(ratio.max(), (1.0 / ratio).max()))
