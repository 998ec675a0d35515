"""What a batch gives for each lane."""

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.batch.lanes import Lanes
from dcfp.analysis.status import FAILED, NUMBERS, Status
from dcfp.arrays import FloatArray
from dcfp.kernels import batch as k
from dcfp.kernels.march import AT_REST, DONE
from dcfp.system import Bearing


@dataclass(frozen=True, eq=False)
class Peaks:
    """Peaks and energies of each lane, shape (lanes,); what they are, `dcfp.Response` says.

    Attributes
    ----------
    peak_displacement, peak_change, residual_displacement
        [mm].
    peak_velocity, input_velocity, hysteretic_velocity
        [mm/s].
    peak_force
        [N].
    force_ratio
        Largest force over the weight [-].
    peak_temperature
        [degC].
    least_friction
        [-].
    status
        As `dcfp.analysis.status.NUMBERS` counts; where it is `FAILED` all else is not a number.
    """

    peak_displacement: FloatArray
    peak_change: FloatArray
    peak_velocity: FloatArray
    peak_force: FloatArray
    force_ratio: FloatArray
    peak_temperature: FloatArray
    least_friction: FloatArray
    residual_displacement: FloatArray
    input_velocity: FloatArray
    hysteretic_velocity: FloatArray
    status: NDArray[np.uint8]

    @classmethod
    def of(cls, outcome: FloatArray, lanes: Lanes) -> "Peaks":
        """Read the outcome of the kernel."""
        bearings = [model.bearing for model in lanes.models]
        mass, weight, elastic, restoring, capacity = _constants(bearings)[:, lanes.model]
        force = outcome[:, k.OUT_FORCE] * mass
        stuck = outcome[:, k.OUT_LAST_DISPLACEMENT] - outcome[:, k.OUT_LAST_ELONGATION]
        values = {
            "peak_displacement": outcome[:, k.OUT_DISPLACEMENT],
            "peak_change": outcome[:, k.OUT_CHANGE],
            "peak_velocity": outcome[:, k.OUT_VELOCITY],
            "peak_force": force,
            "force_ratio": force / weight,
            "peak_temperature": outcome[:, k.OUT_TEMPERATURE],
            "least_friction": outcome[:, k.OUT_FRICTION],
            "residual_displacement": stuck * elastic / (elastic + restoring),
            "input_velocity": _equivalent_velocity(outcome[:, k.OUT_INPUT], mass),
            "hysteretic_velocity": _equivalent_velocity(outcome[:, k.OUT_HYSTERETIC], mass),
        }
        finished = np.isin(outcome[:, k.OUT_ENDED], (DONE, AT_REST))
        failed = ~(finished & np.isfinite(outcome).all(axis=1))
        status = np.where(outcome[:, k.OUT_RESTS] > 0.0, NUMBERS[Status.OK], NUMBERS[Status.STILL_MOVING])
        status[outcome[:, k.OUT_DISPLACEMENT] > capacity] = NUMBERS[Status.BEYOND_CAPACITY]
        status[failed] = FAILED
        whole = {name: np.where(failed, np.nan, one) for name, one in values.items()}
        return cls(**whole, status=status.astype(np.uint8))

    def arrays(self) -> dict[str, NDArray[np.float64] | NDArray[np.uint8]]:
        """Return the arrays by name."""
        return {item.name: getattr(self, item.name) for item in fields(self)}


def _constants(bearings: Sequence[Bearing]) -> FloatArray:
    """Return mass [t], weight [N], both stiffnesses [N/mm] and the capacity [mm] of bearings, a column for each."""
    rows = [
        (
            one.mass,
            one.vertical_force,
            one.elastic_stiffness,
            one.restoring_stiffness,
            np.inf if one.displacement_capacity is None else one.displacement_capacity,
        )
        for one in bearings
    ]
    return np.array(rows, dtype=np.float64).T


def _equivalent_velocity(energy: FloatArray, mass: FloatArray) -> FloatArray:
    """Return V_E [mm/s] of energies per mass [mm2/s2]; the mass [t] is put in and taken out as `Response` does, so that the last digit is the same."""
    return np.sqrt(np.maximum(2.0 * (energy * mass) / mass, 0.0))
