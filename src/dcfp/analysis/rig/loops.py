"""The result of a virtual test in one direction: histories of force, friction and temperature, and what is told of its cycles."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from dcfp.analysis.rig.measures import Cycle, cycles_of, zero_crossings
from dcfp.analysis.rig.virtual_test import TEST, ToldRound, VirtualTest
from dcfp.arrays import FloatArray
from dcfp.schema.quantities import Quantities, Quantity
from dcfp.schema.units import DEGC, KN, KN_M, KN_PER_MM, MM, MM_PER_S, N_PER_MM2, NONE, SECOND
from dcfp.system import Bearing

if TYPE_CHECKING:
    from dcfp.analysis.rig.measurement import Measurement

#: Its histories.
HISTORIES = Quantities("history of a test")
for _name in (
    "displacement", "velocity", "force", "load", "friction", "temperature", "sliding", "work", "hysteretic_energy",
):  # fmt: skip
    HISTORIES.tell(_name)


def _of(get: Callable[[VirtualTest], Any], measured: object = None) -> Callable[[ToldRound], Any]:
    return lambda one: measured if one.loops is None else get(one.loops)


def _pressure(one: ToldRound) -> float:
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


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Loops(VirtualTest):
    """Histories of one test in one direction.

    Attributes
    ----------
    cycle_times
        At which the cycles begin and end [s], shape (cycles + 1,).
    """

    quantities: ClassVar[Quantities] = TEST
    histories: ClassVar[Quantities] = HISTORIES
    round_name: ClassVar[str] = "cycle"
    rounds_key: ClassVar[str] = "cycles"
    rounds_told: ClassVar[Sequence[Quantity]] = CYCLES
    columns: ClassVar[tuple[str, ...]] = (
        "displacement", "velocity", "elongation", "friction", "sliding", "load", "work", "hysteretic",
    )  # fmt: skip

    cycle_times: FloatArray

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

    @property
    def rounds(self) -> Sequence[Cycle]:
        """Its cycles."""
        return self.cycles

    @cached_property
    def cycles(self) -> tuple[Cycle, ...]:
        """Measures of each cycle."""
        return cycles_of(self, self.work, self.temperature)


def cycles_of_measurement(name: str, measurement: "Measurement", bearing: Bearing) -> list[ToldRound]:
    """Return every cycle of a measured test beside the test `name`."""
    return [ToldRound(one, name, bearing.slider_area, file=measurement.name) for one in measurement.cycles]
