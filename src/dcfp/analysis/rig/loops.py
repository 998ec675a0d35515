"""The result of a virtual test: histories of force, friction and temperature; its remarks, its data set and its rows."""

import json
import math
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from dcfp.analysis.rig.measures import Cycle, cycles_of, zero_crossings
from dcfp.analysis.rig.program import RigTest
from dcfp.arrays import FloatArray
from dcfp.kernels import drive as d
from dcfp.kernels.drive import TEMPERATURE
from dcfp.schema.citations import citations_of
from dcfp.schema.nomenclature import quantity
from dcfp.schema.notebook import card, with_units
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

        rows = [with_units(row) for row in cycle_rows(self)]
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


# The measures of each cycle with their units in their names.


def cycle_rows(loops: "Loops") -> list[dict[str, float | str | None]]:
    """Return what the command line's JSON holds for each cycle of a test."""
    shared = {
        "test": loops.test.name,
        "friction": loops.friction_law.name,
        "heating": loops.heating.name,
        "waveform": loops.test.waveform.kind,
        "peak_velocity_mm_s": loops.test.waveform.peak_velocity,
        "period_s": loops.test.waveform.period,
    }
    pressure = 1.0 / loops.bearing.slider_area
    return [
        {**shared, **measures(cycle), "pressure_N_mm2": cycle.load * pressure, "elapsed_s": loops.elapsed}
        for cycle in loops.cycles
    ]


def measured_rows(name: str, measurement: "Measurement") -> list[dict[str, float | str | None]]:
    """Return the same for each cycle of a measured test beside the test `name`; there is no model, which is said in place of its names."""
    shared = {
        "test": name,
        "friction": "measured",
        "heating": "measured",
        "waveform": "recorded",
        "file": measurement.name,
    }
    return [{**shared, **measures(cycle)} for cycle in measurement.cycles]


def measures(cycle: Cycle) -> dict[str, float | None]:
    """Return the measures of one cycle; None where one does not exist."""
    return {
        "cycle": cycle.number,
        "displacement_max_mm": cycle.largest,
        "displacement_min_mm": cycle.least,
        "force_at_displacement_max_kN": cycle.force_at_largest / 1e3,
        "force_at_displacement_min_kN": cycle.force_at_least / 1e3,
        "load_kN": cycle.load / 1e3,
        "keff_kN_mm": _known(cycle.effective_stiffness / 1e3),
        "beta_eff": _known(cycle.effective_damping),
        "post_yield_stiffness_kN_mm": _known(cycle.post_yield_stiffness / 1e3),
        "strength_kN": _known(cycle.strength / 1e3),
        "energy_kN_m": cycle.energy / 1e6,
        "friction_of_loop": _known(cycle.loop_friction),
        "friction_at_zero": _known(cycle.friction),
        "friction_at_zero_first": cycle.crossings[0] if cycle.crossings else None,
        "friction_at_zero_second": cycle.crossings[1] if len(cycle.crossings) > 1 else None,
        "temperature_max_degC": _known(cycle.peak_temperature),
    }


def _known(value: float) -> float | None:
    return None if math.isnan(value) else value


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
        "cycles": json.dumps(cycle_rows(loops)),
        "vertical_load": json.dumps(None if test.load is None else asdict(test.load)),
        "bearing": json.dumps(asdict(loops.bearing)),
        "friction_law": repr(loops.friction_law),
        "heating_model": repr(loops.heating),
        "remarks": " ".join(loops.remarks),
        "elapsed_s": loops.elapsed,
    }
