"""Half cycles of responses as a table: what was put in and dissipated from one peak of displacement to the next, Eqs (15), (16) of Li et al. (2020)."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dcfp.analysis.response import PEAKS, Response
from dcfp.analysis.swings import Swing, swings_of
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.parameters import Parameter
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import KN_M, M_PER_S, MM, MM_PER_S, N_MM, SECOND

#: Which half cycles are told.
LEAST_CHANGE = Parameter(
    "tell the half cycles whose displacement changes by at least this, with their energies, Eqs (15), (16)", MM, 0.0, key="half_cycles",
)  # fmt: skip


@dataclass(frozen=True)
class HalfCycle:
    """One half cycle of a response.

    Attributes
    ----------
    motion
        Ground motion of the response.
    from_displacement, to_displacement
        y_(i-1) and y_i, at its two peaks [mm].
    most_input, net_input, hysteretic, strain
        dE_i, the largest input energy since the start; over the whole half cycle dEr_i, dEhr_i and dEsr_i [N mm]: by Eq. (15) dEr = dEhr + dEsr, by Eq. (16) without the springs dEr = dEhr.
    swing
        Its times, its change, and the energies as equivalent velocities.
    """

    motion: GroundMotion
    from_displacement: float
    to_displacement: float
    most_input: float
    net_input: float
    hysteretic: float
    strain: float
    swing: Swing


#: What is told of a half cycle.
HALF_CYCLE = (
    PEAKS["record"],
    PEAKS["peak_ground_velocity"],
    Quantity("start_s", "time of the peak at its start", SECOND, name="start", head="from", decimals=2, get="swing.start"),
    Quantity("end_s", "time of the peak at its end", SECOND, name="end", head="to", decimals=2, get="swing.end"),
    Quantity("y_start_mm", "displacement at its start", MM, name="y_start", head="y_i-1", decimals=1, get="from_displacement"),
    Quantity("y_end_mm", "displacement at its end", MM, name="y_end", head="y_i", decimals=1, get="to_displacement"),
    Quantity("dy_mm", "change of displacement", MM, name="dy", decimals=1, signed=True, get="swing.change"),
    Quantity("dE_N_mm", "largest input energy since its start", N_MM, KN_M, name="dE", decimals=1, get="most_input"),
    Quantity("dEr_N_mm", "input energy over all of it, left side of Eqs (15) and (16)", N_MM, KN_M, name="dEr", decimals=1, get="net_input"),
    Quantity("dEhr_N_mm", "energy dissipated over all of it, right side of Eq. (16), and with dEsr of Eq. (15)", N_MM, KN_M, name="dEhr", decimals=1, get="hysteretic"),
    Quantity("dEsr_N_mm", "change of the elastic strain energy over all of it", N_MM, KN_M, name="dEsr", decimals=1, get="strain"),
    Quantity("V_dE_mm_s", "dE as a velocity", MM_PER_S, M_PER_S, name="V_dE", decimals=3, get="swing.input_velocity"),
    Quantity("V_dEr_mm_s", "dEr as a velocity, 0 where the ground took energy back", MM_PER_S, M_PER_S, name="V_dEr", decimals=3, get="swing.net_input_velocity"),
    Quantity("V_dEhr_mm_s", "dEhr as a velocity", MM_PER_S, M_PER_S, name="V_dEhr", decimals=3, get="swing.hysteretic_velocity"),
)  # fmt: skip


def half_cycles(response: Response, least: float = 0.0) -> list[HalfCycle]:
    """Return the half cycles of a response whose displacement changes by at least `least` [mm], in their order."""
    swings = swings_of(response)
    return [
        HalfCycle(
            response.motion,
            float(swings.displacements[one]),
            float(swings.displacements[one + 1]),
            float(swings.most_input[one]),
            float(swings.net_input[one]),
            float(swings.hysteretic[one]),
            float(swings.strain[one]),
            swings[one],
        )
        for one in map(int, np.flatnonzero(np.abs(swings.changes) >= least))
    ]


def half_cycle_table(responses: Sequence[Response], least: float = 0.0) -> Table:
    """Return the half cycles of responses, one in each row."""
    cycles = [one for response in responses for one in half_cycles(response, least)]
    return Table(HALF_CYCLE, cycles, "half cycles")
