"""The result of a virtual test in the plane: histories of force, friction and temperature, measures of every lap, the temperature of the plates."""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import ClassVar

import numpy as np

from dcfp.analysis.plane_response import PLANE_HISTORIES, PLANE_PEAKS
from dcfp.analysis.plane_result import PlaneResult
from dcfp.analysis.response import PEAKS
from dcfp.analysis.rig.loops import CYCLES, HISTORIES
from dcfp.analysis.rig.virtual_test import TEST, VirtualTest
from dcfp.arrays import FloatArray
from dcfp.schema.quantities import Quantities, Quantity
from dcfp.schema.units import DEGC, KN, METRE, NONE

#: What is told of one test in the plane as a whole.
PLANE_TEST = Quantities("quantity of a test in the plane")
PLANE_TEST.take(TEST, "test", "law", "heating", "waveform", "begins")
PLANE_TEST.add("count", Quantity("laps", "number of laps", NONE, decimals=0, get=lambda one: len(one.laps)))
PLANE_TEST.take(TEST, "peak_displacement", "peak_velocity")
PLANE_TEST.take(PEAKS, "peak_force", "peak_temperature")
PLANE_TEST.take(PLANE_PEAKS, "peak_point_temperature")
PLANE_TEST.tell("relative_energy_residual", "energy_residual")
PLANE_TEST.take(TEST, "elapsed")

#: Its histories.
PLANE_TEST_HISTORIES = Quantities("history of a test in the plane")
for _name in ("displacement", "velocity", "force"):
    PLANE_TEST_HISTORIES.take(PLANE_HISTORIES, f"{_name}_x", f"{_name}_y", _name)
PLANE_TEST_HISTORIES.take(HISTORIES, "load", "friction", "temperature", "sliding", "work")
for _name in ("strain_energy", "hysteretic_energy", "energy_residual"):
    PLANE_TEST_HISTORIES.tell(_name)


@dataclass(frozen=True)
class Lap:
    """Measures of one lap.

    Attributes
    ----------
    displacement, force
        Largest distance from the middle [mm], and largest horizontal force [N].
    load
        Mean vertical force [N].
    energy
        Work of the machine over the lap [N mm].
    length
        How long the path is [mm].
    final_temperature, peak_temperature, point_temperature
        Mean of the contact at the end of the lap, its highest value in the lap, and the highest of a point of the plates up to then [degC].
    """

    number: int
    displacement: float
    force: float
    load: float
    energy: float
    length: float
    final_temperature: float
    peak_temperature: float
    point_temperature: float

    @property
    def friction(self) -> float:
        """Mean coefficient over the lap, E / (N length) [-]."""
        return self.energy / (self.load * self.length)


_CYCLES = {one.key: one for one in CYCLES}
#: What is told of each lap of a test: of a cycle, but for what a loop alone has.
LAPS = [
    *(_CYCLES[key] for key in ("Test", "test", "friction", "heating", "waveform", "peak_velocity_mm_s")),
    replace(_CYCLES["period_s"], words="time of a lap"),
    Quantity("lap", "number of the lap in its test", NONE, head="Lap\n", get="cycle.number"),
    *(_CYCLES[key] for key in ("p", "v_max")),
    replace(_CYCLES["displacement_max_mm"], words="largest displacement", head="d", get="cycle.displacement"),
    Quantity("path_m", "length of the path", METRE, decimals=3, name="path", head="path", get="cycle.length"),
    *(_CYCLES[key] for key in ("load_kN", "pressure_N_mm2")),
    Quantity("force_max_kN", "largest horizontal force", KN, decimals=0, name="force_max", head="F_max", get="cycle.force"),
    replace(_CYCLES["energy_kN_m"], words="work of the machine over the lap"),
    Quantity("friction_mean", "mean coefficient of friction, E / (N path)", NONE, decimals=4, head="mu", get="cycle.friction"),
    Quantity("temperature_end_degC", "temperature of the contact at the end of the lap", DEGC, decimals=0, name="temperature_end", head="T_end", get="cycle.final_temperature"),
    _CYCLES["temperature_max_degC"],
    Quantity("temperature_point_max_degC", "highest temperature of a point of a plate so far", DEGC, decimals=0, name="temperature_point_max", head="T_point", get="cycle.point_temperature"),
    Quantity("energy_residual", "residual of the energies over the largest work of the test", NONE, get="loops.relative_energy_residual", printed=False),
    *(_CYCLES[key] for key in ("elapsed_s", "remarks")),
]  # fmt: skip


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class PlaneLoops(PlaneResult, VirtualTest):
    """Histories of one test in the plane; what is called as in one direction is the magnitude.

    Attributes
    ----------
    lap_times
        At which the laps begin and end [s], shape (laps + 1,).
    fields
        Temperature of the plates where a point of them is hottest, and at the end; None without a field.
    """

    quantities: ClassVar[Quantities] = PLANE_TEST
    histories: ClassVar[Quantities] = PLANE_TEST_HISTORIES
    round_name: ClassVar[str] = "lap"
    rounds_key: ClassVar[str] = "laps_measured"
    rounds_told: ClassVar[Sequence[Quantity]] = LAPS
    columns: ClassVar[tuple[str, ...]] = (
        "displacement_x", "displacement_y", "velocity_x", "velocity_y", "elongation_x", "elongation_y", "friction", "sliding",
        "load", "work", "pendulum", "hysteretic", "path", "point_temperature",
    )  # fmt: skip

    lap_times: FloatArray

    @property
    def title(self) -> str:
        """What it is, in words."""
        return f"{super().title} in the plane"

    @property
    def load(self) -> FloatArray:
        """Vertical force [N]."""
        return self.line("load") * self.bearing.vertical_force

    @property
    def work(self) -> FloatArray:
        """Work of the machine on the bearing since the start of the test [N mm]."""
        return self.line("work") * self.bearing.mass

    @property
    def hysteretic_energy(self) -> FloatArray:
        """Sum of mu N times the slip since the start of the test [N mm]."""
        return self.line("hysteretic") * self.bearing.mass

    @property
    def strain_energy(self) -> FloatArray:
        """Energy that both springs have taken since the start of the test [N mm]; under a load that changes, the work against spring (a)."""
        spring = 0.5 * self.bearing.elastic_stiffness * self.elongation**2
        return self.line("pendulum") * self.bearing.mass + spring - spring[0]

    @property
    def energy_residual(self) -> FloatArray:
        """Work of the machine that neither the springs nor the friction account for [N mm]."""
        return self.work - self.strain_energy - self.hysteretic_energy

    @property
    def relative_energy_residual(self) -> float:
        """Largest residual of the energies over the largest work [-]."""
        largest = float(np.abs(self.work).max())
        return float(np.abs(self.energy_residual).max()) / largest if largest > 0.0 else 0.0

    @property
    def path(self) -> FloatArray:
        """Length of the path since the start of the test [mm]."""
        return self.line("path")

    @property
    def point_temperature(self) -> FloatArray:
        """Highest temperature of a point of the plates so far in the test [degC]; without a field, that of the contact."""
        return self.line("point_temperature")

    @property
    def rounds(self) -> Sequence[Lap]:
        """Its laps."""
        return self.laps

    @cached_property
    def laps(self) -> tuple[Lap, ...]:
        """Measures of each lap."""
        time = self.time
        slack = 1e-9 * float(time[-1] - time[0])
        known = (self.displacement, self.force, self.load, self.temperature, self.point_temperature)
        laps: list[Lap] = []
        for number, (first, last) in enumerate(itertools.pairwise(self.lap_times.tolist()), start=1):
            inside = (time >= first - slack) & (time <= last + slack)
            displacement, force, load, temperature, point = (one[inside] for one in known)
            energy, length = (
                float(np.diff(np.interp([first, last], time, one))[0]) for one in (self.work, self.path)
            )
            laps.append(
                Lap(
                    number, float(displacement.max()), float(force.max()), float(load.mean()), energy, length,
                    float(temperature[-1]), float(temperature.max()), float(point.max()),
                )
            )  # fmt: skip
        return tuple(laps)

    @property
    def peak_force(self) -> float:
        """Largest horizontal force [N]."""
        return float(self.force.max())
