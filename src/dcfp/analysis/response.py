"""The result of a response history analysis: histories, peaks and how it ended; its remarks, its data set and its summary."""

import json
import math
from dataclasses import asdict, dataclass
from enum import Enum
from functools import cached_property
from operator import attrgetter
from typing import TYPE_CHECKING

import numpy as np

from dcfp.analysis.energy import EnergyBalance, equivalent_velocity
from dcfp.analysis.kernel_input import State
from dcfp.arrays import FloatArray
from dcfp.kernels import march as m
from dcfp.kernels.march import TEMPERATURE
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import motion_remarks
from dcfp.schema.citations import citations_of
from dcfp.schema.nomenclature import Quantities, quantity
from dcfp.schema.notebook import card, with_units
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import KN, M_PER_S, NONE, SECOND
from dcfp.system import Bearing, FrictionLaw, Heating
from dcfp.system.plates import Profiles, mean_temperature, profile_variables
from dcfp.system.validity import LARGEST_ANGLE, History, assumption_remarks
from dcfp.version import version

if TYPE_CHECKING:
    import xarray


class Status(Enum):
    """How an analysis ended; the value is what results and tables show."""

    OK = "ok"
    BEYOND_CAPACITY = "beyond capacity"
    STILL_MOVING = "still moving"


#: The same as numbers, for arrays.
NUMBERS = {Status.OK: 1, Status.BEYOND_CAPACITY: 2, Status.STILL_MOVING: 3}
#: Numbers for what has no `Status`: not analysed yet, and an analysis that could not be finished.
NOT_RUN, FAILED = 0, 4


@dataclass(frozen=True)
class Settings:
    """How finely and how far the analysis went; see `dcfp.respond`."""

    tail: float | None
    tolerance: float
    step: float | None
    profile_every: int | None


@dataclass(frozen=True)
class Histories:
    """Histories at equal steps; ``lines`` is what the kernels wrote, a row for each time."""

    time: FloatArray
    ground_acceleration: FloatArray
    ground_velocity: FloatArray
    lines: FloatArray


@dataclass(frozen=True, eq=False)
class Response:
    """Histories, peaks and energies of a rigid structure on a bearing, and what they came from."""

    motion: GroundMotion
    bearing: Bearing
    friction_law: FrictionLaw
    heating: Heating
    settings: Settings
    histories: Histories
    final_state: State
    rests: bool
    profiles: Profiles | None
    elapsed: float

    # ----- histories, shape (n,) -----

    @property
    def time(self) -> FloatArray:
        """Time [s]."""
        return self.histories.time

    @property
    def ground_acceleration(self) -> FloatArray:
        """Ground acceleration a_g [mm/s2]."""
        return self.histories.ground_acceleration

    @property
    def ground_velocity(self) -> FloatArray:
        """Absolute velocity of the ground v_g [mm/s]."""
        return self.histories.ground_velocity

    @property
    def displacement(self) -> FloatArray:
        """Relative displacement y [mm]."""
        return self._line(m.DISPLACEMENT)

    @property
    def velocity(self) -> FloatArray:
        """Relative velocity v [mm/s]."""
        return self._line(m.VELOCITY)

    @property
    def structure_velocity(self) -> FloatArray:
        """Absolute velocity of the structure v_u = v + v_g [mm/s]: Li et al. (2020), Eq. (13)."""
        return self.velocity + self.ground_velocity

    @property
    def elongation(self) -> FloatArray:
        """Elongation of spring (b), y - O_Y [mm]."""
        return self._line(m.ELONGATION)

    @property
    def friction(self) -> FloatArray:
        """Coefficient of friction [-]: the one at work while sliding, the one to overcome while sticking."""
        return self._line(m.FRICTION)

    @property
    def sliding(self) -> FloatArray:
        """Side on which it slides: 1, -1, or 0 while sticking."""
        return self._line(m.SIDE)

    @property
    def temperature(self) -> FloatArray:
        """Temperature of the contact [degC]; of two different plates the mean by their share of the travel."""
        return mean_temperature(self.bearing, self.histories.lines[:, m.TEMPERATURE :])

    @property
    def force(self) -> FloatArray:
        """Horizontal force of the bearing [N]."""
        pendulum = self.bearing.restoring_stiffness * self.displacement
        return pendulum + self.bearing.elastic_stiffness * self.elongation

    @property
    def structure_acceleration(self) -> FloatArray:
        """Absolute acceleration of the structure [mm/s2]."""
        return -self.force / self.bearing.mass

    @cached_property
    def energy(self) -> EnergyBalance:
        """Energies [N mm]."""
        return EnergyBalance.of(
            self.bearing,
            self.displacement,
            self.velocity,
            self.elongation,
            self.ground_velocity,
            self._line(m.INPUT) * self.bearing.mass,
            self._line(m.HYSTERETIC) * self.bearing.mass,
        )

    def _line(self, column: int) -> FloatArray:
        return self.histories.lines[:, column]

    # ----- peaks -----

    @property
    def peak_displacement(self) -> float:
        """Largest displacement y_max, to either side [mm]."""
        return float(self.final_state.march[m.PEAK_DISPLACEMENT])

    @property
    def peak_change(self) -> float:
        """Largest change of displacement between two successive peaks, dy_max [mm]; Li et al. (2020), section 6.1."""
        return float(self.final_state.march[m.PEAK_CHANGE])

    @property
    def peak_velocity(self) -> float:
        """Largest relative velocity at the ends of steps [mm/s]."""
        return float(self.final_state.march[m.PEAK_VELOCITY])

    @property
    def peak_force(self) -> float:
        """Largest horizontal force at the ends of steps [N]."""
        return float(self.final_state.march[m.PEAK_FORCE]) * self.bearing.mass

    @property
    def force_ratio(self) -> float:
        """Largest horizontal force over the weight [-]."""
        return self.peak_force / self.bearing.vertical_force

    @property
    def peak_temperature(self) -> float:
        """Highest temperature of the contact of any plate [degC]."""
        return float(self.final_state.march[m.PEAK_TEMPERATURE])

    @property
    def least_friction(self) -> float:
        """Smallest coefficient of friction while sliding [-]; where it never slides, the one at rest at the start."""
        least = float(self.final_state.march[m.LEAST_FRICTION])
        return least if math.isfinite(least) else float(self.friction[0])

    @property
    def residual_displacement(self) -> float:
        """Displacement at which it stays when the last elastic oscillation has died away [mm]."""
        stuck = float(self.displacement[-1] - self.elongation[-1])
        elastic = self.bearing.elastic_stiffness
        return stuck * elastic / (elastic + self.bearing.restoring_stiffness)

    @property
    def input_velocity(self) -> float:
        """Equivalent velocity V_E of the input energy up to the end [mm/s]; an analysis that was taken up again counts on."""
        return equivalent_velocity(float(self.energy.input[-1]), self.bearing.mass)

    @property
    def hysteretic_velocity(self) -> float:
        """Equivalent velocity V_Eh of the hysteretic energy up to the end [mm/s], counted as `input_velocity`."""
        return equivalent_velocity(float(self.energy.hysteretic[-1]), self.bearing.mass)

    @property
    def steps(self) -> int:
        """Number of steps that the integration took."""
        return int(self.final_state.march[m.STEPS])

    @property
    def status(self) -> Status:
        """How the analysis ended."""
        capacity = self.bearing.displacement_capacity
        if capacity is not None and self.peak_displacement > capacity:
            return Status.BEYOND_CAPACITY
        return Status.OK if self.rests else Status.STILL_MOVING

    @property
    def remarks(self) -> tuple[str, ...]:
        """Sentences that a reader of the peaks must know."""
        remarks: list[str] = []
        capacity = self.bearing.displacement_capacity
        if capacity is not None and self.peak_displacement > capacity:
            note = f" ({self.bearing.capacity_note})" if self.bearing.capacity_note else ""
            remarks.append(
                f"{self.motion.name}: the displacement of {self.peak_displacement:.0f} mm exceeds"
                f" the capacity of {capacity:.0f} mm{note}."
            )
        far = LARGEST_ANGLE * self.bearing.effective_radius
        if self.peak_displacement > far:
            remarks.append(
                f"{self.motion.name}: the displacement of {self.peak_displacement:.0f} mm exceeds {far:.0f} mm, half of the effective radius,"
                " where the pendulum's force is no longer linear and a plate is hardly as large."
            )
        if not self.rests:
            remarks.append(
                f"{self.motion.name}: it still moves at the end, so the residual displacement is not final."
            )
        remarks.extend(validity_remarks(self))
        return tuple(remarks)

    # ----- forms -----

    def to_dataset(self) -> "xarray.Dataset":
        """Return histories, peaks and provenance as a data set with units."""
        return dataset(self)

    def summary(self) -> dict[str, float | str]:
        """Return the peaks with their units in their names, ready for JSON."""
        return {one.key: one.datum(self) for one in PEAKS.values() if one.stored}

    def __str__(self) -> str:
        return (
            f"{self.motion.name}: y_max {self.peak_displacement:.1f} mm, F_max {self.peak_force / 1e3:.0f} kN,"
            f" T_max {self.peak_temperature:.0f} degC, V_E {self.input_velocity:.0f} mm/s ({self.status.value})"
        )

    def _repr_html_(self) -> str:
        return card(f"Response to {self.motion.name}", with_units(self.summary()), remarks=self.remarks)


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


def remarks_on(response: Response) -> list[str]:
    """Return every remark on one analysis."""
    return [*motion_remarks(response.motion), *response.remarks]


# As a data set with units and provenance.


def dataset(response: "Response") -> "xarray.Dataset":
    """Return histories as variables over ``time``, and peaks and provenance as attributes."""
    import xarray  # late: it takes long to import

    energy = response.energy
    histories = {
        "ground_acceleration": response.ground_acceleration,
        "ground_velocity": response.ground_velocity,
        "displacement": response.displacement,
        "velocity": response.velocity,
        "structure_velocity": response.structure_velocity,
        "structure_acceleration": response.structure_acceleration,
        "force": response.force,
        "friction": response.friction,
        "temperature": response.temperature,
        "sliding": response.sliding,
        "input_energy": energy.input,
        "absolute_input_energy": energy.absolute_input,
        "kinetic_energy": energy.kinetic,
        "strain_energy": energy.strain,
        "hysteretic_energy": energy.hysteretic,
        "energy_residual": energy.residual,
    }
    result = xarray.Dataset(
        {name: ("time", np.array(values), quantity(name).attributes) for name, values in histories.items()},
        coords={"time": ("time", np.array(response.time), quantity("time").attributes)},
        attrs=_provenance(response),
    )
    return result if response.profiles is None else result.merge(profile_variables(response.profiles))


def _provenance(response: "Response") -> dict[str, str | float]:
    motion = response.motion
    law = response.friction_law
    return {
        "Conventions": "CF-1.11",
        "title": f"Response of {response.bearing.name} under {motion.name}",
        "source": f"dcfp {version()}",
        "references": "\n".join(citations_of(response.friction_law.citation, "li_2020")),
        **response.summary(),
        "remarks": " ".join(response.remarks),
        "record_sha256": motion.digest,
        "record_origin": json.dumps(asdict(motion.origin)),
        "record_treatment": "; ".join(motion.treatment) or "none",
        "bearing": json.dumps(asdict(response.bearing)),
        "friction_law": repr(law),
        "heating_model": repr(response.heating),
        "settings": json.dumps(asdict(response.settings)),
    }


#: What is told of one analysis: what it is of, its peaks and how it ended; by the names of the nomenclature, as JSON, CSV and tables have it.
PEAKS = Quantities("peak of a response")
PEAKS.add(
    "record", Quantity("record", "name of the ground motion", head="Record", get=attrgetter("motion.name"))
)
PEAKS.tell(
    "peak_ground_velocity",
    "pgv_m_s",
    unit=M_PER_S,
    name="pgv",
    head="PGV",
    decimals=3,
    get=attrgetter("motion.peak_velocity"),
)
PEAKS.add("law", Quantity("friction", "friction law", printed=False, get=attrgetter("friction_law.name")))
PEAKS.add("heating", Quantity("heating", "heating model", printed=False, get=attrgetter("heating.name")))
PEAKS.tell("peak_displacement", "y_max_mm", name="y_max", decimals=1)
PEAKS.tell("peak_change", "dy_max_mm", name="dy_max", decimals=1)
PEAKS.tell("peak_velocity", "v_max_mm_s", name="v_max", decimals=3)
PEAKS.tell("residual_displacement", "residual_mm", name="residual", head="resid.", decimals=1)
PEAKS.tell("peak_force", "force_max_kN", unit=KN, name="force_max", head="F_max", decimals=0)
PEAKS.tell("force_ratio", "force_ratio", head="F/W", decimals=3, stored=False)
PEAKS.tell("peak_temperature", "temperature_max_degC", name="temperature_max", head="T_max", decimals=0)
PEAKS.tell("least_friction", "friction_min", head="mu_min", decimals=4)
PEAKS.tell("input_velocity", "V_E_mm_s", name="V_E", decimals=3)
PEAKS.tell("hysteretic_velocity", "V_Eh_mm_s", name="V_Eh", decimals=3)
PEAKS.add(
    "relative_energy_residual",
    Quantity(
        "energy_residual",
        "residual of the energy balance over the largest input energy",
        NONE,
        printed=False,
        get=attrgetter("energy.relative_residual"),
    ),
)
PEAKS.add("status", Quantity("status", "how the analysis ended", head="Status"))
PEAKS.add(
    "elapsed", Quantity("elapsed_s", "computing time of the analysis", SECOND, name="elapsed", printed=False)
)
