"""Whether an analysis stayed within what the model assumes."""

from typing import TYPE_CHECKING

import numpy as np

from dcfp.kernels.march import TEMPERATURE
from dcfp.system.validity import History, assumption_remarks

if TYPE_CHECKING:
    from dcfp.analysis.response import Response

#: Time for which the heat in the plates is remembered within 1 % of the temperature [s].
LONGEST_MEMORY = 600.0


def validity_remarks(response: "Response") -> list[str]:
    """Return a sentence for each assumption that the analysis left."""
    return assumption_remarks(
        History(
            name=response.motion.name,
            bearing=response.bearing,
            friction_law=response.friction_law,
            heating=response.heating,
            velocity=response.velocity,
            friction=response.friction,
            temperatures=response.histories.lines[:, TEMPERATURE:],
            slides=bool(response.sliding.any()),
            load=np.array([response.bearing.vertical_force]),
            duration=float(response.time[-1]),
            memory=LONGEST_MEMORY,
        )
    )
