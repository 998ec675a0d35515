"""The result of a virtual test: histories of force, friction and temperature; its remarks, its data set and its rows."""

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from dcfp.analysis.result import Result
from dcfp.analysis.rig.measures import Cycle, cycles_of, zero_crossings
from dcfp.analysis.rig.program import RigTest
from dcfp.arrays import FloatArray
from dcfp.schema.notebook import card, told
from dcfp.schema.quantities import Quantities, Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import DEGC, KN, KN_M, KN_PER_MM, MM, MM_PER_S, N_PER_MM2, NONE, SECOND
from dcfp.system import Bearing
from dcfp.system.plates import memory_of

if TYPE_CHECKING:
    from dcfp.analysis.rig.measurement import Measurement


#: What is told of one test as a whole.
TEST = Quantities("quantity of a test")
TEST.add("test", Quantity("test", "name of the test", get="test.name"))
TEST.add("law", Quantity("friction", "friction law", get="friction_law.name"))
TEST.add("heating", Quantity("heating", "heating model", get="heating.name"))
TEST.add("waveform", Quantity("waveform", "waveform", get="test.waveform.kind"))
TEST.add("begins", Quantity("begins_s", "time since the plates were cold, at the start", SECOND, decimals=1, name="begins"))  # fmt: skip
TEST.add("count", Quantity("cycles", "number of cycles", NONE, decimals=0, get=lambda one: len(one.cycles)))
TEST.tell("peak_displacement", "displacement_max_mm", name="displacement_max", decimals=1)
TEST.tell("peak_velocity", "velocity_max_mm_s", name="velocity_max", decimals=3)
TEST.tell("peak_temperature", "temperature_max_degC", name="temperature_max", decimals=0)
TEST.tell("elapsed", "elapsed_s")

#: Its histories.
HISTORIES = Quantities("history of a test")
for _name in (
    "displacement", "velocity", "force", "load", "friction", "temperature", "sliding", "work", "hysteretic_energy",
):  # fmt: skip
    HISTORIES.tell(_name)


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Loops(Result):
    """Histories of one test.

    Attributes
    ----------
    begins
        Time at which the test begins since the plates were at the ambient temperature [s].
    cycle_times
        At which the cycles begin and end [s], shape (cycles + 1,).
    """

    quantities: ClassVar[Quantities] = TEST
    histories: ClassVar[Quantities] = HISTORIES
    columns: ClassVar[tuple[str, ...]] = (
        "displacement", "velocity", "elongation", "friction", "sliding", "load", "work", "hysteretic",
    )  # fmt: skip

    test: RigTest
    begins: float
    cycle_times: FloatArray

    @property
    def name(self) -> str:
        """Name of the test."""
        return self.test.name

    @property
    def title(self) -> str:
        """What it is, in words."""
        return f"Virtual test {self.test.name}"

    @property
    def load(self) -> FloatArray:
        """Vertical force [N]."""
        return self.line("load")

    @property
    def friction_force(self) -> FloatArray:
        """Force of spring (b) [N]."""
        return self.bearing.elastic_stiffness * self.elongation

    @property
    def force(self) -> FloatArray:
        """Horizontal force [N]."""
        return self.load * self.displacement / self.bearing.effective_radius + self.friction_force

    @property
    def work(self) -> FloatArray:
        """Work of the machine on the bearing since the start of the test [N mm]."""
        return self.line("work")

    @property
    def hysteretic_energy(self) -> FloatArray:
        """Energy dissipated by friction since the start of the test [N mm]."""
        return self.line("hysteretic")

    @property
    def crossings(self) -> FloatArray:
        """Time [s], force [N] and load [N] wherever the displacement passes zero, shape (crossings, 3)."""
        return zero_crossings(self)

    @cached_property
    def cycles(self) -> tuple[Cycle, ...]:
        """Measures of each cycle."""
        return cycles_of(self, self.work, self.temperature)

    @property
    def peak_displacement(self) -> float:
        """Largest displacement, to either side [mm]."""
        return float(np.abs(self.displacement).max())

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
            "cycles": json.dumps(cycle_objects(cycles_of_tests([self]))),
            "vertical_load": json.dumps(load),
        }

    def _repr_html_(self) -> str:
        rows = [told(CYCLES, cycle) for cycle in cycles_of_tests([self])]
        return card(self.title, rows=rows, remarks=self.remarks)


@dataclass(frozen=True)
class ToldCycle:
    """One cycle with the name of its test and the area of the slider [mm2]; the loops of a virtual test, or the file of a measured one."""

    cycle: Cycle
    test: str
    area: float
    loops: "Loops | None" = None
    file: str | None = None


def cycles_of_tests(tests: Sequence[Loops]) -> list[ToldCycle]:
    """Return every cycle of virtual tests."""
    return [
        ToldCycle(one, test.name, test.bearing.slider_area, test) for test in tests for one in test.cycles
    ]


def cycles_of_measurement(name: str, measurement: "Measurement", bearing: Bearing) -> list[ToldCycle]:
    """Return every cycle of a measured test beside the test `name`."""
    return [ToldCycle(one, name, bearing.slider_area, file=measurement.name) for one in measurement.cycles]


def _of(get: Callable[[Loops], Any], measured: object = None) -> Callable[[ToldCycle], Any]:
    return lambda one: measured if one.loops is None else get(one.loops)


def _pressure(one: ToldCycle) -> float:
    return one.cycle.load * (1.0 / one.area)


#: What is told of each cycle of a test; of a measured one there is no model, which is said in place of its names.
CYCLES = [
    Quantity("Test", "name of the test", get=lambda one: one.test if one.loops else "  measured", stored=False),
    Quantity("test", "name of the test", get="test", printed=False),
    Quantity("friction", "friction law", get=_of(lambda test: test.friction_law.name, "measured"), printed=False),
    Quantity("heating", "heating model", get=_of(lambda test: test.heating.name, "measured"), printed=False),
    Quantity("waveform", "waveform", get=_of(lambda test: test.test.waveform.kind, "recorded"), printed=False),
    Quantity("file", "measured file", get="file", printed=False),
    Quantity("peak_velocity_mm_s", "largest velocity of the test", MM_PER_S, name="peak_velocity", get=_of(lambda test: test.test.waveform.peak_velocity), printed=False),
    Quantity("period_s", "period of the test", SECOND, name="period", get=_of(lambda test: test.test.waveform.period), printed=False),
    Quantity("cycle", "number of the cycle in its test", NONE, head="Cycle\n", get="cycle.number"),
    Quantity("p", "mean pressure on the slider", N_PER_MM2, decimals=1, get=_pressure, stored=False),
    Quantity("v_max", "largest velocity of the test", MM_PER_S, decimals=0, get=_of(lambda test: test.test.waveform.peak_velocity), stored=False),
    Quantity("displacement_max_mm", "largest displacement d+", MM, decimals=1, name="displacement_max", head="d+", get="cycle.largest"),
    Quantity("displacement_min_mm", "smallest displacement d-", MM, decimals=1, name="displacement_min", head="d-", get="cycle.least", printed=False),
    Quantity("force_at_displacement_max_kN", "force at d+", KN, name="force_at_displacement_max", get="cycle.force_at_largest", printed=False),
    Quantity("force_at_displacement_min_kN", "force at d-", KN, name="force_at_displacement_min", get="cycle.force_at_least", printed=False),
    Quantity("load_kN", "mean vertical force", KN, name="load", get="cycle.load", printed=False),
    Quantity("keff_kN_mm", "effective stiffness", KN_PER_MM, decimals=3, name="keff", head="k_eff", get="cycle.effective_stiffness"),
    Quantity("beta_eff", "effective damping", NONE, decimals=3, head="b_eff", get="cycle.effective_damping"),
    Quantity("post_yield_stiffness_kN_mm", "post-yield stiffness", KN_PER_MM, decimals=3, name="post_yield_stiffness", head="k_d", get="cycle.post_yield_stiffness"),
    Quantity("strength_kN", "characteristic strength", KN, decimals=0, name="strength", head="Q_d", get="cycle.strength"),
    Quantity("energy_kN_m", "energy per cycle", KN_M, decimals=1, name="energy", head="E", get="cycle.energy"),
    Quantity("friction_of_loop", "coefficient of the Coulomb loop of the same area", NONE, decimals=4, head="mu_loop", get="cycle.loop_friction", printed=False),
    Quantity("friction_at_zero", "coefficient of friction at zero displacement", NONE, decimals=4, head="mu_0", get="cycle.friction"),
    Quantity("friction_at_zero_first", "the same at the start of the cycle", NONE, get=lambda one: next(iter(one.cycle.crossings), None), printed=False),
    Quantity("friction_at_zero_second", "the same in its middle", NONE, get=lambda one: next(iter(one.cycle.crossings[1:]), None), printed=False),
    Quantity("temperature_max_degC", "highest temperature of the contact", DEGC, decimals=0, name="temperature_max", head="T_max", get="cycle.peak_temperature"),
    Quantity("pressure_N_mm2", "mean pressure on the slider", N_PER_MM2, name="pressure", get=_pressure, printed=False),
    Quantity("elapsed_s", "computing time of the test", SECOND, name="elapsed", get=_of(lambda test: test.elapsed), printed=False),
    Quantity("remarks", "what a reader must know", get=_of(lambda test: test.remarks, ()), printed=False),
]  # fmt: skip


def cycle_objects(cycles: Sequence[ToldCycle]) -> list[dict[str, Any]]:
    """Return what JSON holds of cycles; only those of a measured test have a file."""
    rows = Table(tuple(CYCLES), cycles).objects()
    return [{key: value for key, value in row.items() if key != "file" or value is not None} for row in rows]
