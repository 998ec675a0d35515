"""The result of a virtual test: histories of force, friction and temperature; its remarks, its data set and its rows."""

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.analysis.rig.measures import Cycle, cycles_of, zero_crossings
from dcfp.analysis.rig.program import RigTest
from dcfp.arrays import FloatArray
from dcfp.kernels import drive as d
from dcfp.kernels.drive import TEMPERATURE
from dcfp.schema.citations import citations_of
from dcfp.schema.nomenclature import quantity
from dcfp.schema.notebook import card, with_units
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import DEGC, KN, KN_M, KN_PER_MM, MM, MM_PER_S, N_PER_MM2, NONE, SECOND
from dcfp.system import Bearing, FrictionLaw, Heating
from dcfp.system.plates import Profiles, mean_temperature, memory_of, profile_variables
from dcfp.system.validity import History, assumption_remarks
from dcfp.version import version

if TYPE_CHECKING:
    import xarray

    from dcfp.analysis.rig.measurement import Measurement


@dataclass(frozen=True, eq=False)
class Loops:
    """Histories of one test, and what they came from.

    Attributes
    ----------
    test
        What was done.
    bearing, friction_law, heating
        To what.
    time
        From the start of the test [s], shape (n,).
    lines
        What the kernels wrote, a row for each time.
    begins
        Time at which the test begins since the plates were at the ambient temperature [s].
    cycle_times
        At which the cycles begin and end [s], shape (cycles + 1,).
    profiles
        Temperature along the plates, where it was asked for.
    elapsed
        Computing time [s].
    """

    test: RigTest
    bearing: Bearing
    friction_law: FrictionLaw
    heating: Heating
    time: FloatArray
    lines: FloatArray
    begins: float
    cycle_times: FloatArray
    profiles: Profiles | None
    elapsed: float

    @property
    def displacement(self) -> FloatArray:
        """Displacement y [mm]."""
        return self.lines[:, d.DISPLACEMENT]

    @property
    def velocity(self) -> FloatArray:
        """Velocity v [mm/s]; at a corner of the displacement the one before it."""
        return self.lines[:, d.VELOCITY]

    @property
    def elongation(self) -> FloatArray:
        """Elongation of spring (b) [mm]."""
        return self.lines[:, d.ELONGATION]

    @property
    def friction(self) -> FloatArray:
        """Coefficient of friction [-]: the one at work while sliding, the one to overcome while sticking."""
        return self.lines[:, d.FRICTION]

    @property
    def sliding(self) -> FloatArray:
        """Side on which it slides: 1, -1, or 0 while sticking."""
        return self.lines[:, d.SIDE]

    @property
    def load(self) -> FloatArray:
        """Vertical force [N]."""
        return self.lines[:, d.LOAD]

    @property
    def temperature(self) -> FloatArray:
        """Temperature of the contact [degC]; of two different plates the mean by their share of the travel."""
        return mean_temperature(self.bearing, self.lines[:, d.TEMPERATURE :])

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
        return self.lines[:, d.WORK]

    @property
    def hysteretic_energy(self) -> FloatArray:
        """Energy dissipated by friction since the start of the test [N mm]."""
        return self.lines[:, d.HYSTERETIC]

    @property
    def crossings(self) -> FloatArray:
        """Time [s], force [N] and load [N] wherever the displacement passes zero, shape (crossings, 3)."""
        return zero_crossings(self)

    @cached_property
    def cycles(self) -> tuple[Cycle, ...]:
        """Measures of each cycle."""
        return cycles_of(self)

    @property
    def peak_displacement(self) -> float:
        """Largest displacement, to either side [mm]."""
        return float(np.abs(self.displacement).max())

    @property
    def peak_temperature(self) -> float:
        """Highest temperature of the contact of any plate [degC]."""
        return float(self.lines[:, d.TEMPERATURE :].max())

    @property
    def remarks(self) -> tuple[str, ...]:
        """Sentences that a reader of the measures must know."""
        return tuple(validity_remarks(self))

    def to_dataset(self) -> "xarray.Dataset":
        """Return histories, measures and provenance as a data set with units."""
        return dataset(self)

    def __str__(self) -> str:
        first = self.cycles[0]
        return (
            f"{self.test.name}: {len(self.cycles)} cycles, k_eff {first.effective_stiffness / 1e3:.3f} kN/mm,"
            f" beta_eff {first.effective_damping:.3f}, T_max {self.peak_temperature:.0f} degC"
        )

    def _repr_html_(self) -> str:

        rows = [with_units(row) for row in cycle_objects(cycles_of_tests([self]))]
        return card(f"Virtual test {self.test.name}", rows=rows, remarks=self.remarks)


def validity_remarks(loops: "Loops") -> list[str]:
    """Return a sentence for each assumption that a test left."""
    duration = loops.begins + float(loops.time[-1])
    return assumption_remarks(
        History(
            name=loops.test.name,
            bearing=loops.bearing,
            friction_law=loops.friction_law,
            heating=loops.heating,
            velocity=loops.velocity,
            friction=loops.friction,
            temperatures=loops.lines[:, TEMPERATURE:],
            slides=bool(loops.sliding.any()),
            load=loops.load,
            duration=duration,
            memory=memory_of(duration) * (1.0 + 1e-9),  # chosen for the whole story, up to a longest
            rests=loops.begins > 0.0,
        )
    )


# The measures of each cycle with what they are of.


@dataclass(frozen=True)
class ToldCycle:
    """One cycle and the test that it is of.

    Attributes
    ----------
    cycle
        Its measures.
    test
        Name of the test.
    area
        Of the slider [mm2].
    loops
        The virtual test; None for a measured one.
    file
        Name of a measured test; None for a virtual one.
    """

    cycle: Cycle
    test: str
    area: float
    loops: "Loops | None" = None
    file: str | None = None


def cycles_of_tests(tests: Sequence[Loops]) -> list[ToldCycle]:
    """Return every cycle of virtual tests."""
    return [
        ToldCycle(one, test.test.name, test.bearing.slider_area, test)
        for test in tests
        for one in test.cycles
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
    Quantity("displacement_min_mm", "smallest displacement d-", MM, name="displacement_min", get="cycle.least", printed=False),
    Quantity("force_at_displacement_max_kN", "force at d+", KN, name="force_at_displacement_max", get="cycle.force_at_largest", printed=False),
    Quantity("force_at_displacement_min_kN", "force at d-", KN, name="force_at_displacement_min", get="cycle.force_at_least", printed=False),
    Quantity("load_kN", "mean vertical force", KN, name="load", get="cycle.load", printed=False),
    Quantity("keff_kN_mm", "effective stiffness", KN_PER_MM, decimals=3, name="keff", head="k_eff", get="cycle.effective_stiffness"),
    Quantity("beta_eff", "effective damping", NONE, decimals=3, head="b_eff", get="cycle.effective_damping"),
    Quantity("post_yield_stiffness_kN_mm", "post-yield stiffness", KN_PER_MM, decimals=3, name="post_yield_stiffness", head="k_d", get="cycle.post_yield_stiffness"),
    Quantity("strength_kN", "characteristic strength", KN, decimals=0, name="strength", head="Q_d", get="cycle.strength"),
    Quantity("energy_kN_m", "energy per cycle", KN_M, decimals=1, name="energy", head="E", get="cycle.energy"),
    Quantity("friction_of_loop", "coefficient of the Coulomb loop of the same area", NONE, get="cycle.loop_friction", printed=False),
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


# As a data set with units and provenance.


def dataset(loops: "Loops") -> "xarray.Dataset":
    """Return histories over ``time``, measures over ``cycle``, and provenance as attributes."""
    import xarray  # late: it takes long to import

    histories = {
        "displacement": loops.displacement,
        "velocity": loops.velocity,
        "force": loops.force,
        "load": loops.load,
        "friction": loops.friction,
        "temperature": loops.temperature,
        "sliding": loops.sliding,
        "work": loops.work,
        "hysteretic_energy": loops.hysteretic_energy,
    }
    result = xarray.Dataset(
        {name: ("time", np.array(values), quantity(name).attributes) for name, values in histories.items()},
        coords={"time": ("time", np.array(loops.time), quantity("time").attributes)},
        attrs=_provenance(loops),
    )
    return result if loops.profiles is None else result.merge(profile_variables(loops.profiles))


def _provenance(loops: "Loops") -> dict[str, str | float]:
    test = loops.test
    return {
        "Conventions": "CF-1.11",
        "title": f"Virtual test {test.name} of {loops.bearing.name}",
        "source": f"dcfp {version()}",
        "references": "\n".join(citations_of(loops.friction_law.citation, "li_2020")),
        "test": test.name,
        "waveform": test.waveform.kind,
        "begins_s": loops.begins,
        "cycles": json.dumps(cycle_objects(cycles_of_tests([loops]))),
        "vertical_load": json.dumps(None if test.load is None else asdict(test.load)),
        "bearing": json.dumps(asdict(loops.bearing)),
        "friction_law": repr(loops.friction_law),
        "heating_model": repr(loops.heating),
        "remarks": " ".join(loops.remarks),
        "elapsed_s": loops.elapsed,
    }
