"""A quantity of a response as a user adds one, in a module of its own."""

from dcfp.analysis.response import PEAKS
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import M_PER_S, MM_PER_S


def _swing_speed(response) -> float:
    return 0.5 * response.peak_velocity


PEAKS.add(
    "toy_speed",
    Quantity("toy_speed_mm_s", "half of the largest relative velocity", MM_PER_S, M_PER_S, decimals=4, symbol="v_{toy}", name="toy_speed", get=_swing_speed),
)  # fmt: skip
