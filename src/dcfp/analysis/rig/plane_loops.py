"""The result of a virtual test in the plane: histories of force, friction and temperature, measures of every lap, the temperature of the plates."""

import itertools
import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from dcfp.analysis.plane_response import PLANE_HISTORIES, PLANE_PEAKS
from dcfp.analysis.plane_result import PlaneResult
from dcfp.analysis.response import PEAKS
from dcfp.analysis.rig.loops import HISTORIES, TEST
from dcfp.analysis.rig.program import RigTest
from dcfp.arrays import FloatArray
from dcfp.schema.notebook import card, told
from dcfp.schema.quantities import Quantities, Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import DEGC, KN, KN_M, METRE, MM, MM_PER_S, N_PER_MM2, NONE, SECOND
from dcfp.system.plates import memory_of

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
        """Return the mean coefficient over the lap, E / (N length) [-]."""
        return self.energy / (self.load * self.length)


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class PlaneLoops(PlaneResult):
    """Histories of one test in the plane; what is called as in one direction is the magnitude.

    Attributes
    ----------
    begins
        Time at which the test begins since the plates were at the ambient temperature [s].
    lap_times
        At which the laps begin and end [s], shape (laps + 1,).
    fields
        Temperature of the plates where a point of them is hottest, and at the end; None without a field.
    """

    quantities: ClassVar[Quantities] = PLANE_TEST
    histories: ClassVar[Quantities] = PLANE_TEST_HISTORIES
    columns: ClassVar[tuple[str, ...]] = (
        "displacement_x", "displacement_y", "velocity_x", "velocity_y", "elongation_x", "elongation_y", "friction", "sliding",
        "load", "work", "pendulum", "hysteretic", "path", "point_temperature",
    )  # fmt: skip

    test: RigTest
    begins: float
    lap_times: FloatArray

    @property
    def name(self) -> str:
        """Name of the test."""
        return self.test.name

    @property
    def title(self) -> str:
        """What it is, in words."""
        return f"Virtual test {self.test.name} in the plane"

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
    def peak_displacement(self) -> float:
        """Largest distance from the middle [mm]."""
        return float(self.displacement.max())

    @property
    def peak_force(self) -> float:
        """Largest horizontal force [N]."""
        return float(self.force.max())

    @property
    def heat_age(self) -> float:
        """Time since the plates were cold, at the end [s]."""
        return self.begins + float(self.time[-1])

    @property
    def memory(self) -> float:
        """Time for which heat is remembered [s]: chosen for the whole story, up to a longest."""
        return memory_of(self.heat_age) * (1.0 + 1e-9)

    @property
    def cooled(self) -> bool:
        """Whether the plates have cooled in a pause."""
        return self.begins > 0.0

    @property
    def attributes(self) -> dict[str, Any]:
        """What a data set says of it besides its system."""
        load = None if self.test.load is None else asdict(self.test.load)
        return {
            **self.summary(),
            "laps_measured": json.dumps(lap_objects(laps_of_tests([self]))),
            "vertical_load": json.dumps(load),
        }

    def _repr_html_(self) -> str:
        rows = [told(LAPS, lap) for lap in laps_of_tests([self])]
        return card(self.title, rows=rows, remarks=self.remarks)


@dataclass(frozen=True)
class ToldLap:
    """One lap with the test that it is of."""

    lap: Lap
    loops: PlaneLoops


def laps_of_tests(tests: Sequence[PlaneLoops]) -> list[ToldLap]:
    """Return every lap of virtual tests."""
    return [ToldLap(lap, test) for test in tests for lap in test.laps]


def _pressure(one: ToldLap) -> float:
    return one.lap.load / one.loops.bearing.slider_area


#: What is told of each lap of a test.
LAPS = [
    Quantity("Test", "name of the test", get="loops.test.name", stored=False),
    Quantity("test", "name of the test", get="loops.test.name", printed=False),
    Quantity("friction", "friction law", get="loops.friction_law.name", printed=False),
    Quantity("heating", "heating model", get="loops.heating.name", printed=False),
    Quantity("waveform", "waveform", get="loops.test.waveform.kind", printed=False),
    Quantity("peak_velocity_mm_s", "largest velocity of the test", MM_PER_S, name="peak_velocity", get="loops.test.waveform.peak_velocity", printed=False),
    Quantity("period_s", "time of a lap", SECOND, name="period", get="loops.test.waveform.period", printed=False),
    Quantity("lap", "number of the lap in its test", NONE, head="Lap\n", get="lap.number"),
    Quantity("p", "mean pressure on the slider", N_PER_MM2, decimals=1, get=_pressure, stored=False),
    Quantity("v_max", "largest velocity of the test", MM_PER_S, decimals=0, get="loops.test.waveform.peak_velocity", stored=False),
    Quantity("displacement_max_mm", "largest displacement", MM, decimals=1, name="displacement_max", head="d", get="lap.displacement"),
    Quantity("path_m", "length of the path", METRE, decimals=3, name="path", head="path", get="lap.length"),
    Quantity("load_kN", "mean vertical force", KN, name="load", get="lap.load", printed=False),
    Quantity("pressure_N_mm2", "mean pressure on the slider", N_PER_MM2, name="pressure", get=_pressure, printed=False),
    Quantity("force_max_kN", "largest horizontal force", KN, decimals=0, name="force_max", head="F_max", get="lap.force"),
    Quantity("energy_kN_m", "work of the machine over the lap", KN_M, decimals=1, name="energy", head="E", get="lap.energy"),
    Quantity("friction_mean", "mean coefficient of friction, E / (N path)", NONE, decimals=4, head="mu", get="lap.friction"),
    Quantity("temperature_end_degC", "temperature of the contact at the end of the lap", DEGC, decimals=0, name="temperature_end", head="T_end", get="lap.final_temperature"),
    Quantity("temperature_max_degC", "highest temperature of the contact", DEGC, decimals=0, name="temperature_max", head="T_max", get="lap.peak_temperature"),
    Quantity("temperature_point_max_degC", "highest temperature of a point of a plate so far", DEGC, decimals=0, name="temperature_point_max", head="T_point", get="lap.point_temperature"),
    Quantity("energy_residual", "residual of the energies over the largest work of the test", NONE, get="loops.relative_energy_residual", printed=False),
    Quantity("elapsed_s", "computing time of the test", SECOND, name="elapsed", get="loops.elapsed", printed=False),
    Quantity("remarks", "what a reader must know", get="loops.remarks", printed=False),
]  # fmt: skip


def lap_objects(laps: Sequence[ToldLap]) -> list[dict[str, Any]]:
    """Return what JSON holds of laps."""
    return Table(tuple(LAPS), laps).objects()
