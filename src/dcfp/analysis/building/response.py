"""Response history analysis of a shear building on a bearing, and its result."""

import time
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, NamedTuple

import numpy as np

from dcfp.analysis.building.shear_building import ShearBuilding
from dcfp.analysis.building.transition import building_of
from dcfp.analysis.integration import Integration
from dcfp.analysis.response import HISTORIES as OF_RESPONSE
from dcfp.analysis.response import PEAKS, Response
from dcfp.analysis.result import MotionResult
from dcfp.arrays import FloatArray, first_rows, freeze
from dcfp.kernels import building as k
from dcfp.motion.ground_motion import parts_in, with_tail
from dcfp.motion.load import Motion, motion_of
from dcfp.schema.parameters import refuse_other
from dcfp.schema.quantities import Quantities, Quantity
from dcfp.schema.units import DEGC, KN_M, M_PER_S, M_PER_S2, MM, MM_PER_S, MM_PER_S2, N_MM, NONE
from dcfp.system import FrictionLaw, Heating, System, SystemLike
from dcfp.system.plates import cold_plates, heat_of, system_constants

#: Longest fine step, unless another is asked for [s]; and over the shortest period on a fixed base [-], but for steps that are short already [s].
LONGEST_STEP, PERIOD_FRACTION, SHORT_STEP = 0.002, 0.1, 0.0002

#: What is told of it as a whole.
BUILDING = Quantities("quantity of a building's response")
BUILDING.take(PEAKS, "record", "peak_ground_velocity")
BUILDING.add("storeys", Quantity("storeys", "number of storeys", NONE, decimals=0, get="building.storeys"))
BUILDING.take(PEAKS, "peak_displacement")
BUILDING.add("drift", Quantity("drift_max_mm", "largest drift of a storey", MM, decimals=1, name="drift_max", head="drift", get=lambda one: float(one.peak_drift.max())))  # fmt: skip
BUILDING.add("floor_acceleration", Quantity("floor_acceleration_max_m_s2", "largest acceleration of a floor", M_PER_S2, decimals=2, name="floor_acceleration_max", head="floor acc.", get=lambda one: float(one.peak_acceleration.max())))  # fmt: skip
BUILDING.take(PEAKS, "peak_temperature", "input_velocity", "hysteretic_velocity", "relative_energy_residual")
BUILDING.add("rests", Quantity("rests", "whether it has come to rest"))
BUILDING.take(PEAKS, "elapsed")

#: Its histories.
HISTORIES = Quantities("history of a building's response")
HISTORIES.take(OF_RESPONSE, "ground_acceleration", "displacement", "velocity", "force", "friction", "temperature", "sliding")  # fmt: skip
HISTORIES.take(OF_RESPONSE, "input_energy", "absolute_input_energy", "kinetic_energy", "strain_energy", "hysteretic_energy")  # fmt: skip
for _one in (
    Quantity("damping_energy", "energy taken by the damping of the storeys", N_MM, KN_M, symbol=r"E_\xi", get="energy.damping"),
    Quantity("floor_displacement", "displacement of base and floors", MM, symbol="u"),
    Quantity("floor_acceleration", "absolute acceleration of base and floors", MM_PER_S2, M_PER_S2, symbol="a"),
    Quantity("drift", "drift of each storey, from below", MM, symbol=r"\delta"),
):  # fmt: skip
    HISTORIES.add(_one.key, _one)
HISTORIES.take(OF_RESPONSE, "energy_residual")


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class BuildingResponse(MotionResult):
    """Histories, peaks and energies of a building on a bearing.

    Attributes
    ----------
    building
        With the masses that the bearing carries, `ShearBuilding.scaled_to`.
    step
        Fine step of the integration [s]; peaks are looked for at its ends, and where the base turns.
    """

    quantities: ClassVar[Quantities] = BUILDING
    histories: ClassVar[Quantities] = HISTORIES
    columns: ClassVar[tuple[str, ...]] = (
        "elongation", "friction", "sliding", "input", "hysteretic", "damped",
    )  # fmt: skip
    dimensions: ClassVar[Mapping[str, str]] = {
        "floor_displacement": "floor", "floor_acceleration": "floor", "drift": "storey",
    }  # fmt: skip

    building: ShearBuilding
    step: float
    _peaks: FloatArray
    _state: FloatArray
    _resistance: FloatArray

    @property
    def title(self) -> str:
        """What it is, in words."""
        return f"{self.building.storeys} storeys under {self.motion.name}"

    @property
    def floor_displacement(self) -> FloatArray:
        """Displacement of base and floors relative to the ground [mm], shape (n, storeys + 1)."""
        return self.lines[:, : self._floors]

    @property
    def floor_velocity(self) -> FloatArray:
        """Velocity of base and floors relative to the ground [mm/s], shape (n, storeys + 1)."""
        return self.lines[:, self._floors : 2 * self._floors]

    @property
    def displacement(self) -> FloatArray:
        """Displacement y of the isolation layer, which is that of the base [mm], shape (n,)."""
        return self.floor_displacement[:, 0]

    @property
    def velocity(self) -> FloatArray:
        """Relative velocity of the plates, which is that of the base [mm/s], shape (n,)."""
        return self.floor_velocity[:, 0]

    @property
    def drift(self) -> FloatArray:
        """Drift of each storey, from below [mm], shape (n, storeys)."""
        return np.diff(self.floor_displacement, axis=1)

    @cached_property
    def floor_acceleration(self) -> FloatArray:
        """Absolute acceleration of base and floors [mm/s2], shape (n, storeys + 1)."""
        accelerations = self.lines[:, : 2 * self._floors] @ self._resistance.T
        accelerations[:, 0] -= self.bearing.elastic_stiffness * self.elongation / self.building.masses[0]
        return freeze(accelerations)

    def _energies(self) -> tuple[FloatArray, FloatArray, dict[str, FloatArray]]:
        masses, stiffnesses = np.array(self.building.masses), np.array(self.building.stiffnesses)
        ground, total = self.ground_velocity, self.bearing.mass
        of_storeys = {
            "storeys": 0.5 * self.drift**2 @ stiffnesses,
            "damping": self.line("damped") * total,
        }
        put_in = ground * (0.5 * total * ground + self.floor_velocity @ masses)
        return put_in, 0.5 * self.floor_velocity**2 @ masses, of_storeys

    @property
    def peak_displacement(self) -> float:
        """Largest displacement y_max of the isolation layer, to either side [mm]."""
        return float(self._peaks[k.PEAK_DRIFT, 0])

    @property
    def peak_drift(self) -> FloatArray:
        """Largest drift of each storey, to either side [mm], shape (storeys,)."""
        return self._peaks[k.PEAK_DRIFT, 1:]

    @property
    def peak_acceleration(self) -> FloatArray:
        """Largest absolute acceleration of base and floors [mm/s2], shape (storeys + 1,)."""
        return self._peaks[k.PEAK_ACCELERATION]

    @property
    def peak_temperature(self) -> float:
        """Highest temperature of the contact of any plate [degC]."""
        return float(self._state[k.PEAK_TEMPERATURE])

    @property
    def _floors(self) -> int:
        return self.building.storeys + 1


def respond_building(
    motion: Motion,
    building: ShearBuilding,
    bearing: SystemLike = None,
    friction: FrictionLaw | str | None = None,
    heating: Heating | str | None = None,
    *,
    pgv: float | None = None,
    step: float | None = None,
    tail: float | None = None,
) -> BuildingResponse:
    """Analyse a shear building on a bearing under a ground motion.

    Parameters
    ----------
    motion, bearing, friction, heating, pgv, tail
        As for `dcfp.respond`; without damping the analysis may well go on for all of 120 s. The vertical force is constant.
    building
        Its masses and stiffnesses are multiplied by one factor, so that the bearing carries the sum of the masses: `ShearBuilding.scaled_to`.
    step
        Longest fine step [s]; by default 0.002 s, or a tenth of the shortest period on a fixed base where that is less, down to 0.0002 s.

    Returns
    -------
    BuildingResponse
        Histories at the record's samples, peaks and energies.

    Raises
    ------
    InputError
        If an argument is out of range, or there is none of such a name.
    AnalysisError
        If the analysis cannot be finished.
    """
    motion = motion_of(motion, pgv)
    refuse_other(building, ShearBuilding, "building", "a ShearBuilding")
    system = System.of(bearing, friction, heating)
    bearing, friction, heating = system.bearing, system.friction, system.heating
    integration = Integration(step=step, tail=tail)
    longest = _longest_step(building) if integration.step is None else integration.step
    parts = parts_in(motion.time_step, longest)
    fine = motion.time_step / parts
    acceleration = with_tail(motion.acceleration, motion.time_step, tail)
    # from one sample of the record after its last, where the ground has stopped accelerating
    free_from = motion.acceleration.size if tail is None else acceleration.size
    own = building_of(building, bearing, fine)
    constants = system_constants(system)
    law = friction.at_pressure(bearing.pressure)
    lines = np.empty((acceleration.size, 2 * own.floors + k.LINE_SIZE + constants.plates))
    plates = cold_plates(system)
    state, peaks = np.zeros(k.STATE_SIZE), np.zeros((2, own.floors))

    def march(ground: FloatArray) -> tuple[int, int, bool]:
        own.vectors[:], state[:], peaks[:] = 0.0, 0.0, 0.0
        state[k.ROOM], state[k.PEAK_TEMPERATURE] = k.TICKS, heating.ambient
        heat = heat_of(plates.with_room(0), system)
        return k.integrate_building(law, constants, heat, own, ground, parts, free_from, state, peaks, lines)

    march(np.zeros(2))  # has the kernels compiled or loaded, so that the time of an analysis is its own
    began = time.perf_counter()
    status, done, rests = march(acceleration)
    while status == k.OUT_OF_CELLS:  # the slider left the line of cells
        plates = plates.with_room(plates.cells.shape[1])
        began = time.perf_counter()
        status, done, rests = march(acceleration)
    elapsed = time.perf_counter() - began
    if status == k.NO_PROGRESS:
        raise friction.no_progress(motion.name, done * motion.time_step)
    if not np.isfinite(lines[: done + 1]).all():
        raise friction.no_number(motion.name)
    return BuildingResponse(
        motion=motion,
        system=system,
        building=building.scaled_to(bearing.mass),
        step=fine,
        time=freeze(np.arange(done + 1) * motion.time_step),
        ground_acceleration=first_rows(acceleration, done + 1),
        rests=rests,
        elapsed=elapsed,
        lines=first_rows(lines, done + 1),
        _peaks=freeze(peaks),
        _state=freeze(state),
        _resistance=own.resistance,
    )


def _longest_step(building: ShearBuilding) -> float:
    shortest = PERIOD_FRACTION * float(building.fixed_base_periods[-1])
    return min(LONGEST_STEP, max(SHORT_STEP, shortest))


class BesideRigid(NamedTuple):
    """A building and the rigid structure on the same bearing under the same ground motion."""

    building: BuildingResponse
    rigid: Response

    @property
    def velocity_ratio(self) -> float | None:
        """V_E of the building over that of the rigid structure [-]."""
        rigid = self.rigid.input_velocity
        return self.building.input_velocity / rigid if rigid > 0.0 else None

    @property
    def remarks(self) -> list[str]:
        """Sentences that a reader must know; of the capacity those of the building."""
        one, capacity = self.building, self.building.bearing.displacement_capacity
        name = one.motion.name
        remarks: list[str] = []
        if capacity is not None and one.peak_displacement > capacity:
            remarks.append(
                f"{name}: the displacement of {one.peak_displacement:.0f} mm exceeds the capacity of {capacity:.0f} mm."
            )
        if not one.rests:
            remarks.append(f"{name}: the building still oscillates at the end of the analysis.")
        return [*remarks, *(remark for remark in self.rigid.remarks if "capacity" not in remark)]


#: What is told of it.
BESIDE_RIGID = [
    Quantity("record", "name of the ground motion", head="Record", get="building.motion.name"),
    Quantity("pgv_m_s", "peak ground velocity", M_PER_S, decimals=3, places=12, head="PGV", get="building.motion.peak_velocity"),
    Quantity("y_max_mm", "largest displacement of the isolation layer", MM, decimals=1, head="y_max", get="building.peak_displacement"),
    Quantity("y_max_rigid_mm", "the same of the rigid structure", MM, decimals=1, head="rigid", get="rigid.peak_displacement"),
    Quantity("V_E_mm_s", "equivalent velocity of the input energy", MM_PER_S, M_PER_S, 3, head="V_E", get="building.input_velocity"),
    Quantity("V_E_rigid_mm_s", "the same of the rigid structure", MM_PER_S, M_PER_S, 3, head="rigid", get="rigid.input_velocity"),
    Quantity("V_E_ratio", "V_E over that of the rigid structure", NONE, decimals=3, head="V_E over\nrigid", get="velocity_ratio", stored=False),
    Quantity("drift_max_mm", "largest drift of a storey", MM, decimals=1, head="drift", get=lambda one: float(one.building.peak_drift.max())),
    Quantity("drifts_mm", "largest drift of each storey", MM, get="building.peak_drift", flat=False, printed=False),
    Quantity("floor_acceleration_max_m_s2", "largest acceleration of a floor", M_PER_S2, decimals=2, head="floor acc.", get=lambda one: float(one.building.peak_acceleration.max())),
    Quantity("floor_accelerations_m_s2", "largest acceleration of each floor", M_PER_S2, get="building.peak_acceleration", flat=False, printed=False),
    Quantity("temperature_max_degC", "highest temperature of the contact", DEGC, get="building.peak_temperature", printed=False),
    Quantity("energy_residual", "residual of the energy balance over the largest input energy", NONE, get="building.energy.relative_residual", printed=False),
    Quantity("rests", "whether it has come to rest", get="building.rests", printed=False),
    Quantity("remarks", "what a reader must know", get="remarks", printed=False),
]  # fmt: skip
