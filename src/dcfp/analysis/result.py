"""What every result has: a system, histories by name, what is told of it, its forms, its remarks and its figure."""

import json
import math
import textwrap
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import cached_property
from pkgutil import resolve_name
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from dcfp.analysis.assumptions import OF_MODEL
from dcfp.arrays import FloatArray, freeze, integral
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import Station
from dcfp.schema.check import Check
from dcfp.schema.citations import citations_of
from dcfp.schema.notebook import card, fields_card, told
from dcfp.schema.parameters import unknown
from dcfp.schema.quantities import Quantities, quantity
from dcfp.system import Bearing, FrictionLaw, Heating, System
from dcfp.system.plates import Profiles, mean_temperature, profile_variables
from dcfp.version import version

if TYPE_CHECKING:
    import pandas as pd
    import xarray
    from matplotlib.figure import Figure

#: What draws a result: named, for the figures know the analyses, and not the other way round.
_FIGURE = "dcfp.present.figures:figure_of"
#: Characters of a line of what a result says of itself.
_WIDTH = 100
#: Time for which the heat in the plates is remembered within 1 % of the temperature [s].
LONGEST_MEMORY = 600.0


@dataclass(frozen=True)
class EnergyBalance:
    """Histories of the energies [N mm], shape (n,): Li et al. (2020), Eqs (3)-(6).

    Attributes
    ----------
    input
        Relative input energy E, Eq. (4): the work of - m a_g on the relative displacement, of a building summed over base and floors.
    absolute_input
        Absolute input energy, the work that the ground does on the structure (Uang and Bertero 1988).
    kinetic, hysteretic, damping
        E_k of the relative velocity, Eq. (5); E_h, dissipated by friction; E_xi, taken by the damping of a building.
    pendulum, spring, storeys
        Parts of the elastic strain energy E_s: in spring (a), in spring (b), and in the storeys of a building.
    lifting
        Work of the part of the pendulum's force that a changing vertical force makes.
    """

    input: FloatArray
    absolute_input: FloatArray
    kinetic: FloatArray
    pendulum: FloatArray
    spring: FloatArray
    hysteretic: FloatArray
    storeys: FloatArray | float = 0.0
    damping: FloatArray | float = 0.0
    lifting: FloatArray | float = 0.0

    @property
    def strain(self) -> FloatArray:
        """Elastic strain energy E_s [N mm]."""
        return self.storeys + self.pendulum + self.spring

    @property
    def residual(self) -> FloatArray:
        """E - E_s - E_k - E_xi - E_h, less the lifting, by which Eq. (6) fails to close [N mm]."""
        return self.input - self.strain - self.kinetic - self.damping - self.hysteretic - self.lifting

    @property
    def relative_residual(self) -> float:
        """Largest residual over the largest input energy [-]."""
        largest = float(np.abs(self.input).max())
        return float(np.abs(self.residual).max()) / largest if largest > 0.0 else 0.0

    def _repr_html_(self) -> str:
        return fields_card(self, "Energies over time [N mm]")


def equivalent_velocity(energy: float, mass: float) -> float:
    """Equivalent velocity V_E = sqrt(2 E / m) of an energy [N mm] and a mass [t], in mm/s (Akiyama 1985)."""
    return math.sqrt(max(2.0 * energy / mass, 0.0))


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class HistoryResult(ABC):
    """Histories over ``time`` [s], with the computing time [s], and what is told of them.

    Attributes
    ----------
    quantities, histories
        What is told of such a result, and its histories over time, by name.
    dimensions
        What a history has a value for besides each time, by its name.
    """

    quantities: ClassVar[Quantities]
    histories: ClassVar[Quantities]
    dimensions: ClassVar[Mapping[str, str]] = {}

    time: FloatArray
    elapsed: float

    @property
    @abstractmethod
    def name(self) -> str:
        """What it is of, to begin a sentence with."""

    @property
    @abstractmethod
    def title(self) -> str:
        """What it is, in words."""

    @property
    @abstractmethod
    def remarks(self) -> tuple[str, ...]:
        """Sentences that a reader must know."""

    def history(self, name: str) -> FloatArray:
        """Return a history over time by its name, in the units of the package.

        Raises
        ------
        InputError
            If there is none of that name.
        """
        if name not in self.histories:
            msg = unknown(name, self.histories, "history")
            raise InputError(msg)
        return self.histories[name].of(self)

    def summary(self) -> dict[str, Any]:
        """Return what is told of it with units in the names, ready for JSON."""
        return {one.key: one.datum(self) for one in self.quantities.values() if one.stored}

    def to_dataset(self) -> "xarray.Dataset":
        """Return histories over ``time`` with their units, and what is told of it and its provenance as attributes."""
        import xarray  # late: it takes long to import

        variables = {
            name: (
                ("time", self.dimensions[name]) if name in self.dimensions else "time",
                np.array(one.of(self)),
                one.attributes,
            )
            for name, one in self.histories.items()
        }
        coordinates = {"time": ("time", np.array(self.time), quantity("time").attributes)}
        return xarray.Dataset(variables, coords=coordinates, attrs=self._provenance())

    def to_dataframe(self) -> "pd.DataFrame":
        """Return the histories that have one value for each time as columns of a table over ``time``."""
        names = [name for name in self.histories if name not in self.dimensions]
        return self.to_dataset()[names].to_dataframe()

    def plot(self, **options: Any) -> "Figure":
        """Draw it on a figure; what can be chosen, the function of `dcfp.present.figures` for such a result says."""
        return resolve_name(_FIGURE)(self, **options)

    def _provenance(self) -> dict[str, Any]:
        return {
            "Conventions": "CF-1.11",
            "title": self.title,
            "source": f"dcfp {version()}",
            # NetCDF knows no truth values
            **{
                key: int(value) if isinstance(value, bool) else value
                for key, value in self.attributes.items()
            },
            "remarks": " ".join(self.remarks),
        }

    @property
    def attributes(self) -> dict[str, Any]:
        """What a data set says of it besides its system."""
        return self.summary()

    def __repr__(self) -> str:
        numbers = ", ".join(
            f"{one.title} {one.text(self)} {one.shown.text if one.shown.has_dimension else ''}".strip()
            for one in self.quantities.values()
            if one.printed and one.is_number
        )
        lines = textwrap.wrap(numbers, _WIDTH, initial_indent="  ", subsequent_indent="  ")
        return "\n".join([self.title, *lines])

    def _repr_html_(self) -> str:
        return card(self.title, told(self.quantities.values(), self), remarks=self.remarks)


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Result(HistoryResult):
    """Histories over ``time`` [s] of a system, shape (n,), with the computing time [s], and what is told of them.

    Attributes
    ----------
    lines
        What the kernels wrote, a row for each time; it ends with `columns` and the temperatures of the plates.
    profiles
        Temperature along the plates, where it was kept.
    """

    columns: ClassVar[tuple[str, ...]]

    system: System
    lines: FloatArray
    profiles: Profiles | None = None

    @property
    def bearing(self) -> Bearing:
        """Bearing of the system."""
        return self.system.bearing

    @property
    def friction_law(self) -> FrictionLaw:
        """Friction law of the system."""
        return self.system.friction

    @property
    def heating(self) -> Heating:
        """Heating model of the system."""
        return self.system.heating

    def line(self, name: str) -> FloatArray:
        """Return a history that the kernels wrote, by its name among `columns`."""
        first = self.lines.shape[1] - len(self.columns) - len(set(self.bearing.radii))
        return self.lines[:, first + self.columns.index(name)]

    @property
    def displacement(self) -> FloatArray:
        """Displacement y of the isolation layer [mm]."""
        return self.line("displacement")

    @property
    def velocity(self) -> FloatArray:
        """Relative velocity v of the plates [mm/s]; at a corner of the displacement the one before it."""
        return self.line("velocity")

    @property
    def elongation(self) -> FloatArray:
        """Elongation of spring (b), y - O_Y [mm]."""
        return self.line("elongation")

    @property
    def friction(self) -> FloatArray:
        """Coefficient of friction [-]: the one at work while sliding, the one to overcome while sticking."""
        return self.line("friction")

    @property
    def sliding(self) -> FloatArray:
        """Side on which it slides: 1, -1, or 0 while sticking."""
        return self.line("sliding")

    @property
    def plate_temperatures(self) -> FloatArray:
        """Temperature of the contact on each plate that differs [degC], shape (n, plates)."""
        return self.lines[:, -len(set(self.bearing.radii)) :]

    @property
    def temperature(self) -> FloatArray:
        """Temperature of the contact [degC]; of two different plates the mean by their share of the travel."""
        return mean_temperature(self.bearing, self.plate_temperatures)

    @property
    def force(self) -> FloatArray:
        """Horizontal force of the bearing [N]."""
        pendulum = self.bearing.restoring_stiffness * self.displacement
        return pendulum + self.bearing.elastic_stiffness * self.elongation

    @property
    def load(self) -> FloatArray:
        """Vertical force [N]: one number where it does not change."""
        return np.array([self.bearing.vertical_force])

    @property
    def slides(self) -> bool:
        """Whether it ever slides."""
        return bool(self.sliding.any())

    @property
    def peak_velocity(self) -> float:
        """Largest relative velocity [mm/s]."""
        return float(np.abs(self.velocity).max())

    @property
    def peak_temperature(self) -> float:
        """Highest temperature of the contact of any plate [degC]."""
        return float(self.plate_temperatures.max())

    @property
    def heat_age(self) -> float:
        """Time since the plates were cold, at the end [s]."""
        return float(self.time[-1])

    @property
    def memory(self) -> float:
        """Time for which the heat in the plates is remembered within 1 % of the temperature [s]."""
        return LONGEST_MEMORY

    @property
    def cooled(self) -> bool:
        """Whether the plates have cooled in a pause."""
        return False

    @property
    def checks(self) -> tuple[Check, ...]:
        """Every assumption with whether it was kept to."""
        return tuple(one for check in OF_MODEL.values() for one in check(self))

    @property
    def remarks(self) -> tuple[str, ...]:
        """Sentences that a reader must know."""
        return tuple(one.remark for one in self.checks if one.remark)

    def to_dataset(self) -> "xarray.Dataset":
        """Return histories over ``time`` with their units, the temperature along the plates where it was kept, and what is told of it and its provenance as attributes."""
        dataset = super().to_dataset()
        return dataset if self.profiles is None else dataset.merge(profile_variables(self.profiles))

    def _provenance(self) -> dict[str, Any]:
        return super()._provenance() | {
            "title": f"{self.title}, {self.bearing.name}",
            "references": "\n".join(citations_of(self.friction_law.citation, "li_2020")),
            "bearing": json.dumps(asdict(self.bearing)),
            "friction_law": repr(self.friction_law),
            "heating_model": repr(self.heating),
        }


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class MotionResult(Result):
    """A result of a ground motion, with the acceleration of the ground [mm/s2], its velocity at the start [mm/s], and whether it rests: no more sliding can come."""

    motion: GroundMotion | Station
    ground_acceleration: FloatArray
    starting_velocity: FloatArray | float = 0.0
    rests: bool

    @property
    def name(self) -> str:
        """Name of the ground motion."""
        return self.motion.name

    @cached_property
    def ground_velocity(self) -> FloatArray:
        """Velocity of the ground [mm/s]."""
        return freeze(self.starting_velocity + integral(self.ground_acceleration, float(self.time[1])))

    @cached_property
    def energy(self) -> EnergyBalance:
        """Energies [N mm]."""
        bearing, put_in = self.bearing, self.line("input") * self.bearing.mass
        ground, kinetic, of_storeys = self._energies()
        return EnergyBalance(
            input=put_in,
            absolute_input=put_in + ground,
            kinetic=kinetic,
            pendulum=0.5 * bearing.restoring_stiffness * self.displacement**2,
            spring=0.5 * bearing.elastic_stiffness * self.elongation**2,
            hysteretic=self.line("hysteretic") * bearing.mass,
            **of_storeys,
        )

    @abstractmethod
    def _energies(self) -> tuple[FloatArray, FloatArray, dict[str, FloatArray]]:
        """Return E_abs - E, for a motion that starts from rest, the kinetic energy, and what only storeys have [N mm]."""

    @property
    def input_velocity(self) -> float:
        """Equivalent velocity V_E of the input energy up to the end, with all of the mass [mm/s]; an analysis that was taken up again counts on."""
        return equivalent_velocity(float(self.line("input")[-1]) * self.bearing.mass, self.bearing.mass)

    @property
    def hysteretic_velocity(self) -> float:
        """Equivalent velocity V_Eh of the hysteretic energy up to the end [mm/s], counted as `input_velocity`."""
        return equivalent_velocity(float(self.line("hysteretic")[-1]) * self.bearing.mass, self.bearing.mass)
