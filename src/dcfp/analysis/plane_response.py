"""The result of an analysis in the plane: histories in two directions, energies, peaks, and how it ended."""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import ClassVar

import numpy as np

from dcfp.analysis.hottest_point import rise_between_points
from dcfp.analysis.plane_result import PlaneResult, add_directions
from dcfp.analysis.response import HISTORIES as OF_LINE
from dcfp.analysis.response import PEAKS, RigidResponse
from dcfp.arrays import FloatArray
from dcfp.kernels import plane_swings
from dcfp.kernels._jit import Records
from dcfp.kernels.plane_integrate import PLANE_STATE, PlaneExtremes
from dcfp.motion.station import Station
from dcfp.schema.quantities import Quantities, Quantity
from dcfp.schema.units import DEGC, KN, M_PER_S, M_PER_S2, MM, MM_PER_S, MM_PER_S2, NEWTON
from dcfp.system import System
from dcfp.system.fields import PlaneHeat, cold_heat


@dataclass(frozen=True)
class PlaneState:
    """Everything that an integration in the plane changes: where it can be taken up again.

    Attributes
    ----------
    integration
        Motion, energies and peaks: one `dcfp.kernels.plane_integrate.PlaneState`, shape (1,).
    heat
        Heat in the plates.
    ground_velocity
        Of the ground at this moment [mm/s], shape (2,).
    system
        What it is the state of.
    """

    integration: Records
    heat: PlaneHeat
    ground_velocity: FloatArray
    system: System

    @property
    def extremes(self) -> PlaneExtremes:
        """What was added up or compared on the way, per unit mass."""
        return PlaneExtremes(*self.integration["extremes"][0].item())

    @property
    def elongation(self) -> complex:
        """Elongation of spring (b) [mm], x + i y."""
        return complex(self.integration["motion"]["elongation"][0])

    def copy(self) -> "PlaneState":
        """Return a copy that shares no array with this one."""
        return replace(self, integration=self.integration.copy(), heat=self.heat.copy())

    def with_room(self, factor: float) -> "PlaneState":
        """Return a copy that shares no array with this one, whose plates have room for so many times the displacement."""
        heat = self.heat.with_room(factor, self.system)
        return replace(self, integration=self.integration.copy(), heat=heat)

    def afresh(self) -> "PlaneState":
        """Return the same motion and heat with energies and peaks begun anew, for the next earthquake."""
        state = self.copy()
        new = _integration_at_rest(float(self.heat.plates.temperature.max()))
        for name in ("extremes", "steps", "status", "at_rest"):
            state.integration[name] = new[name]
        state.heat.begin_peaks(state.system, float(state.integration["time"][0]))
        return state


def _integration_at_rest(temperature: float) -> Records:
    integration = np.zeros(1, PLANE_STATE)
    integration["extremes"]["temperature"] = temperature
    integration["extremes"]["friction"] = math.inf
    integration["motion"]["yield_radius"] = -1.0  # it has not begun
    return integration


def plane_state_at_rest(system: System) -> PlaneState:
    """Return the state at rest and at the ambient temperature."""
    return PlaneState(_integration_at_rest(system.heating.ambient), cold_heat(system), np.zeros(2), system)


_POINT = Quantity("temperature_point_max_degC", "highest temperature of a point of a plate", DEGC, decimals=0, symbol=r"T_{\mathrm{point,max}}", name="temperature_point_max", head="T_point", get="peak_point_temperature")  # fmt: skip

#: What is told of one analysis in the plane; the names of one direction mean the magnitude in the plane.
PLANE_PEAKS = Quantities("peak of a response in the plane")
PLANE_PEAKS.take(PEAKS, "record", "peak_ground_velocity", "law", "heating", "peak_displacement")
for _place, _name in enumerate(("x", "y"), 1):
    PLANE_PEAKS.add(
        f"peak_displacement_{_name}",
        Quantity(f"y{_place}_max_mm", f"largest displacement in direction {_name}", MM, decimals=1, symbol=rf"y_{{{_place},\mathrm{{max}}}}", name=f"y{_place}_max"),
    )  # fmt: skip
PLANE_PEAKS.take(PEAKS, "peak_change")
PLANE_PEAKS.take(PEAKS, "peak_velocity", printed=False)  # a table of all would be too wide
PLANE_PEAKS.take(PEAKS, "residual_displacement", "peak_force", "force_ratio", "peak_temperature")
PLANE_PEAKS.add("peak_point_temperature", _POINT)
for _name, _key, _words in (("least_load", "load_min", "smallest"), ("largest_load", "load_max", "largest")):
    PLANE_PEAKS.add(_name, Quantity(f"{_key}_kN", f"{_words} vertical force", KN, decimals=0, name=_key, symbol=rf"N_{{\mathrm{{{_key[-3:]}}}}}", printed=False))  # fmt: skip
PLANE_PEAKS.add("uplift", Quantity("uplift", "whether it ever lifts off", printed=False))
PLANE_PEAKS.take(PEAKS, "least_friction", "hysteretic_velocity", printed=False)
PLANE_PEAKS.take(PEAKS, "input_velocity", "relative_energy_residual", "status", "elapsed")

#: Its histories: by direction, and the magnitudes.
PLANE_HISTORIES = Quantities("history of a response in the plane")
for _key, _words, _unit, _shown, _symbol in (
    ("ground_acceleration", "ground acceleration", MM_PER_S2, M_PER_S2, "a_{{g,{0}}}"),
    ("ground_velocity", "ground velocity", MM_PER_S, M_PER_S, "v_{{g,{0}}}"),
    ("displacement", "displacement of the isolation layer", MM, MM, "y_{0}"),
    ("velocity", "relative velocity", MM_PER_S, M_PER_S, "v_{0}"),
    ("force", "horizontal force", NEWTON, KN, "F_{0}"),
):
    for _place, _name in enumerate(("x", "y"), 1):
        PLANE_HISTORIES.add(
            f"{_key}_{_name}",
            Quantity(f"{_key}_{_name}", f"{_words} in direction {_name}", _unit, _shown, symbol=_symbol.format(_place)),
        )  # fmt: skip
for _key in ("displacement", "velocity", "force"):
    _one = OF_LINE.defined[_key]
    PLANE_HISTORIES.add(_key, replace(_one, words=f"{_one.words}, resultant"))
PLANE_HISTORIES.take(OF_LINE, "friction", "temperature", "sliding")
PLANE_HISTORIES.take(OF_LINE, "input_energy", "absolute_input_energy", "kinetic_energy", "strain_energy", "hysteretic_energy", "energy_residual")  # fmt: skip


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class PlaneResponse(PlaneResult, RigidResponse):
    """Histories, peaks and energies of a rigid structure on a bearing in two directions; its ``final_state`` is where it can be gone on with.

    What is called as in one direction is the magnitude in the plane.
    """

    quantities: ClassVar[Quantities] = PLANE_PEAKS
    histories: ClassVar[Quantities] = PLANE_HISTORIES
    columns: ClassVar[tuple[str, ...]] = (
        "displacement_x", "displacement_y", "velocity_x", "velocity_y", "elongation_x", "elongation_y", "friction", "sliding",
        "input", "hysteretic", "lifting", "point_temperature",
    )  # fmt: skip

    motion: Station
    loads: FloatArray
    final_state: PlaneState

    @property
    def title(self) -> str:
        """What it is, in words."""
        return f"Response to {self.motion.name} in the plane"

    @property
    def load(self) -> FloatArray:
        """Vertical force [N]: one number where it does not change."""
        return self.loads

    def _energies(self) -> tuple[FloatArray, FloatArray, dict[str, FloatArray]]:
        mass, ground = self.bearing.mass, self.ground_velocity
        of_ground = mass * (ground * (0.5 * ground + self.velocity_vectors)).sum(axis=1)
        return of_ground, 0.5 * mass * self.velocity**2, {"lifting": mass * self.line("lifting")}

    @property
    def peak_displacement_x(self) -> float:
        """Largest displacement in direction x, at the ends of steps [mm]."""
        return self.final_state.extremes.displacement_x

    @property
    def peak_displacement_y(self) -> float:
        """Largest displacement in direction y, at the ends of steps [mm]."""
        return self.final_state.extremes.displacement_y

    @cached_property
    def peak_change(self) -> float:
        """Largest change of displacement between two successive peaks, dy_max [mm], in whatever direction it is largest."""
        return largest_change(self.displacement_vectors, self.velocity_vectors, float(self.time[1]))

    @cached_property
    def rise_between_points(self) -> float:
        """By how much a point between those of the grid became hotter than all of these [degC]; nothing where it began warm, for its path before is not kept."""
        state, bearing = self.final_state, self.bearing
        if float(state.integration["time"][0]) > self.time[-1] + 0.5 * self.time[1]:
            return 0.0
        work = (
            np.diff(self.line("hysteretic")) * bearing.mass / bearing.vertical_force
        )  # mu times the slip [mm]
        interval = float(self.time[1])
        # mu N |v| over the area; `work` is of the load already
        flux = (
            bearing.pressure * (self.load / bearing.vertical_force) * self.line("friction")
            * self.velocity * self.line("sliding")
        )  # fmt: skip
        return rise_between_points(
            self.system,
            state.heat,
            self.displacement_vectors,
            flux,
            bearing.pressure * work / interval,
            self._coefficients_over_mean(),
            interval,
        )

    def _coefficients_over_mean(self) -> FloatArray:
        """Return the coefficient of each plate that differs over that of the bearing [-], shape (n, plates), as far as speed and temperature make them differ."""
        bearing, law, temperatures = self.bearing, self.friction_law, self.plate_temperatures
        if temperatures.shape[1] == 1:
            return np.ones_like(temperatures)
        shares = np.array(bearing.shares)
        speeds = self.velocity[:, np.newaxis] * (shares if law.speed_is_of_surface else 1.0)
        each = law.coefficient(bearing.pressure, speeds, temperatures)
        return each / (each @ shares)[:, np.newaxis]

    @property
    def _anchor(self) -> float:
        return abs(complex(*self.displacement_vectors[-1]) - self.final_state.elongation)

    @property
    def least_load(self) -> float:
        """Smallest vertical force [N]."""
        return float(self.load.min())

    @property
    def largest_load(self) -> float:
        """Largest vertical force [N]."""
        return float(self.load.max())

    @property
    def uplift(self) -> bool:
        """Whether it ever lifts off."""
        return self.least_load <= 0.0

    @property
    def slip_work(self) -> float:
        """Sum of mu N times the slip [N mm], which the hysteretic energy of the balance equals but for the error of the steps."""
        return self.final_state.extremes.rubbed * self.bearing.mass

    @property
    def remarks(self) -> tuple[str, ...]:
        """Sentences that a reader must know, also on the vertical motion."""
        if self.load.size > 1:
            ratio = self.load / self.bearing.vertical_force
            lifts = ", so that it lifts off" if self.uplift else ""
            told = (f"{self.name}: the vertical force follows the vertical component, from {ratio.min():.2f} to {ratio.max():.2f} times the weight{lifts}.",)  # fmt: skip
        elif self.motion.vertical is not None:
            told = (f"{self.name}: the vertical component is left out, and the vertical force is constant.",)
        else:
            told = ()
        return (*super().remarks, *told)


add_directions(PlaneResponse, ground_acceleration="ground_acceleration", ground_velocity="ground_velocity")


def largest_change(
    displacement: FloatArray, velocity: FloatArray, interval: float, directions: int = 180
) -> float:
    """Return the largest change of displacement between two successive peaks in any direction [mm].

    Parameters
    ----------
    displacement, velocity
        Histories [mm, mm/s], shape (n, 2).
    interval
        Between two rows [s].
    directions
        Number of directions of half a turn that are looked at.
    """
    angles = np.arange(directions) * (math.pi / directions)
    work = np.empty((plane_swings.ROWS, directions))
    work[plane_swings.COSINE], work[plane_swings.SINE] = np.cos(angles), np.sin(angles)
    return plane_swings.largest_change(displacement, velocity, interval, work)
