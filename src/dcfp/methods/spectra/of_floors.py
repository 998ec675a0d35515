"""Response spectra of slab and floors of a building, and broadened, for what stands on them."""

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.methods.spectra.of_record import DAMPING, PERIODS, checked, response_spectrum
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.parameters import Parameter
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import FRACTION, M_PER_S2, METRE, MM_PER_S2, NONE, SECOND

if TYPE_CHECKING:
    from dcfp.analysis.plan import PlanResponse

#: By which part frequencies are uncertain to either side: 15 % is that of US NRC Regulatory Guide 1.122 (1978).
BROADENING = Parameter("part by which frequencies are broadened to either side", FRACTION, 0.0, 0.5, key="broadening", default=0.15)  # fmt: skip


@dataclass(frozen=True, eq=False)
class FloorSpectra:
    """Pseudo-acceleration of elastic oscillators on slab and floors, at the centre of mass of the building."""

    periods: FloatArray = field(metadata={"unit": SECOND})  #: [s], shape (n,)
    damping: float  #: ratio of critical damping [-]
    broadening: float  #: part by which frequencies are broadened to either side [-]
    heights: FloatArray  #: of the levels above the slab [mm], shape (levels,)
    acceleration: FloatArray = field(
        metadata={"unit": MM_PER_S2}
    )  #: in x and in y [mm/s2], shape (levels, 2, n)
    name: str = "building"

    @property
    def envelope(self) -> FloatArray:
        """The larger of both directions [mm/s2], shape (levels, n)."""
        return self.acceleration.max(axis=1)

    @property
    def broadened(self) -> FloatArray:
        """Largest ordinate of the envelope at any frequency within the broadening [mm/s2], shape (levels, n)."""
        return freeze(np.array([broadened(self.periods, row, self.broadening) for row in self.envelope]))


def broadened(periods: FloatArray, values: FloatArray, part: float) -> FloatArray:
    """Return for every period [s] the largest value of a spectrum between the frequencies (1 - part) f and (1 + part) f; between periods it is a straight line over the logarithm."""
    logs = np.log(periods)
    first, last = logs - math.log1p(part), logs - math.log1p(-part)
    ends = np.maximum(np.interp(first, logs, values), np.interp(last, logs, values))
    inside = (logs >= first[:, np.newaxis]) & (logs <= last[:, np.newaxis])
    return np.maximum(ends, np.where(inside, values, -np.inf).max(axis=1))


def floor_spectra(
    response: "PlanResponse",
    periods: FloatArray = PERIODS,
    damping: float = DAMPING,
    broadening: float = BROADENING.default,
) -> FloorSpectra:
    """Return the response spectra of slab and floors.

    Parameters
    ----------
    response
        Of the building.
    periods, damping
        As of `response_spectrum`.
    broadening
        Part by which frequencies are uncertain to either side [-].

    Raises
    ------
    InputError
        If a value is out of range.
    """
    periods = checked(periods, damping)
    part = BROADENING.checked(broadening, "broadening")
    step, floors = float(response.time[1]), response.floor_acceleration
    found = np.array(
        [
            [
                response_spectrum(GroundMotion(np.ascontiguousarray(floors[:, level, axis]), step), periods, damping).pseudo_acceleration
                for axis in range(2)
            ]
            for level in range(floors.shape[1])
        ]
    )  # fmt: skip
    heights = np.concatenate(([0.0], response.plan.structure.heights))
    return FloorSpectra(freeze(periods), damping, part, freeze(heights), freeze(found), response.title)


class FloorOrdinates(NamedTuple):
    """The spectra of a level at one period, in the units of the package."""

    record: str
    level: int
    height: float
    period: float
    along_x: float
    along_y: float
    broadened: float


def floor_ordinates(response: "PlanResponse", spectra: FloorSpectra) -> list[FloorOrdinates]:
    """Return the spectra of every level at every period."""
    wide = spectra.broadened
    return [
        FloorOrdinates(response.name, level, float(height), *row)
        for level, height in enumerate(spectra.heights)
        for row in np.column_stack((spectra.periods, *spectra.acceleration[level], wide[level])).tolist()
    ]


#: What is told of them.
FLOOR_ORDINATES = (
    Quantity("record", "name of the ground motion", head="Record", get="record"),
    Quantity("level", "level: 0 is the slab", NONE, decimals=0, head="Level", get="level"),
    Quantity("height_m", "height above the slab", METRE, decimals=2, head="Height", get="height"),
    Quantity("period_s", "period", SECOND, digits=3, head="T", get="period"),
    Quantity("S_a_x_m_s2", "pseudo-acceleration in x", M_PER_S2, decimals=3, head="S_a,x", get="along_x"),
    Quantity("S_a_y_m_s2", "pseudo-acceleration in y", M_PER_S2, decimals=3, head="S_a,y", get="along_y"),
    Quantity("S_a_broadened_m_s2", "larger one, broadened", M_PER_S2, decimals=3, head="broadened", get="broadened"),
)  # fmt: skip
