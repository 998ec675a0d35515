"""Equal storeys on one bearing in one direction, beside the rigid structure of the same mass."""

from typing import NamedTuple

import numpy as np

from dcfp.analysis.plan.history import respond_plan
from dcfp.analysis.plan.response import PlanResponse
from dcfp.analysis.response import Response
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import in_plane
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import DEGC, M_PER_S, M_PER_S2, MM, MM_PER_S, NONE
from dcfp.system import System
from dcfp.system.plan import EQUAL, Plan
from dcfp.system.storeys import Storey


def shear_building(storeys: int, period: float, system: System, damping: float = 0.02) -> Plan:
    """Return equal storeys on a base as heavy as a floor, which one bearing carries under its own load.

    Parameters
    ----------
    storeys, period
        Number of storeys, and first period on a fixed base [s].
    system
        Bearing with friction law and heating model.
    damping
        Ratio of the first mode on a fixed base, in proportion to the stiffness.

    Raises
    ------
    InputError
        If a value is out of range.
    """
    mass = system.bearing.mass
    floor = Storey(mass / (storeys + 1), 1e6)
    # of one bearing and one component nothing turns: the sides do not count
    plan = Plan(
        np.zeros((1, 2)), system, mass=mass, sides=(1e4, 1e4), storeys=(floor,) * storeys, damping=damping, spring=EQUAL,
        name=f"{storeys} storeys",
    )  # fmt: skip
    return plan.with_first_period(period)


def respond_in_one_direction(plan: Plan, motion: GroundMotion) -> PlanResponse:
    """Analyse a building under one component, which moves it in x; the loads of its bearings are constant."""
    return respond_plan(plan, in_plane(motion), overturning=False)


class BesideRigid(NamedTuple):
    """A building and the rigid structure on the same bearing under the same ground motion."""

    building: PlanResponse
    rigid: Response

    @property
    def velocity_ratio(self) -> float | None:
        """V_E of the building over that of the rigid structure [-]."""
        rigid = self.rigid.input_velocity
        return self.building.input_velocity / rigid if rigid > 0.0 else None

    @property
    def remarks(self) -> list[str]:
        """Sentences that a reader must know; of the capacity those of the building."""
        one, capacity = self.building, self.rigid.bearing.displacement_capacity
        name = one.motion.name
        remarks: list[str] = []
        if capacity is not None and one.peak_displacement > capacity:
            remarks.append(
                f"{name}: the displacement of {one.peak_displacement:.0f} mm exceeds the capacity of {capacity:.0f} mm."
            )
        if not one.rests:
            remarks.append(f"{name}: the building still oscillates at the end of the analysis.")
        return [*remarks, *(remark for remark in self.rigid.remarks if "capacity" not in remark)]


def _largest_drift(one: BesideRigid) -> float:
    return float(one.building.peak_drift.max())


def _largest_acceleration(one: BesideRigid) -> float:
    return float(one.building.peak_floor_acceleration.max())


#: What is told of it.
BESIDE_RIGID = (
    Quantity("record", "name of the ground motion", head="Record", get="building.motion.name"),
    Quantity("pgv_m_s", "peak ground velocity", M_PER_S, decimals=3, places=12, head="PGV", get="building.motion.peak_velocity"),
    Quantity("y_max_mm", "largest displacement of the isolation layer", MM, decimals=1, head="y_max", get="building.peak_displacement"),
    Quantity("y_max_rigid_mm", "the same of the rigid structure", MM, decimals=1, head="rigid", get="rigid.peak_displacement"),
    Quantity("V_E_mm_s", "equivalent velocity of the input energy", MM_PER_S, M_PER_S, 3, head="V_E", get="building.input_velocity"),
    Quantity("V_E_rigid_mm_s", "the same of the rigid structure", MM_PER_S, M_PER_S, 3, head="rigid", get="rigid.input_velocity"),
    Quantity("V_E_ratio", "V_E over that of the rigid structure", NONE, decimals=3, head="V_E over\nrigid", get="velocity_ratio", stored=False),
    Quantity("drift_max_mm", "largest drift of a storey", MM, decimals=1, head="drift", get=_largest_drift),
    Quantity("drifts_mm", "largest drift of each storey", MM, get="building.peak_drift", flat=False, printed=False),
    Quantity("floor_acceleration_max_m_s2", "largest acceleration of a floor", M_PER_S2, decimals=2, head="floor acc.", get=_largest_acceleration),
    Quantity("floor_accelerations_m_s2", "largest acceleration of each floor", M_PER_S2, get="building.peak_floor_acceleration", flat=False, printed=False),
    Quantity("temperature_max_degC", "highest temperature of the contact", DEGC, get="building.hottest", printed=False),
    Quantity("energy_residual", "residual of the energy balance over the largest input energy", NONE, get="building.energy.relative_residual", printed=False),
    Quantity("rests", "whether it has come to rest", get="building.rests", printed=False),
    Quantity("remarks", "what a reader must know", get="remarks", printed=False),
)  # fmt: skip
