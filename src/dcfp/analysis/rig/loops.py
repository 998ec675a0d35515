"""The result of a virtual test: histories of force, friction and temperature."""

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from dcfp.analysis.rig.measures import Cycle, cycles_of, zero_crossings
from dcfp.analysis.rig.program import RigTest
from dcfp.analysis.rig.validity import validity_remarks
from dcfp.arrays import FloatArray
from dcfp.kernels import drive as d
from dcfp.schema.notebook import card, with_units
from dcfp.system import Bearing, FrictionLaw, Heating
from dcfp.system.plates import mean_temperature
from dcfp.system.profiles import Profiles

if TYPE_CHECKING:
    import xarray


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
        from dcfp.analysis.rig.dataset import dataset

        return dataset(self)

    def __str__(self) -> str:
        first = self.cycles[0]
        return (
            f"{self.test.name}: {len(self.cycles)} cycles, k_eff {first.effective_stiffness / 1e3:.3f} kN/mm,"
            f" beta_eff {first.effective_damping:.3f}, T_max {self.peak_temperature:.0f} degC"
        )

    def _repr_html_(self) -> str:
        from dcfp.analysis.rig.summary import cycle_rows

        rows = [with_units(row) for row in cycle_rows(self)]
        return card(f"Virtual test {self.test.name}", rows=rows, remarks=self.remarks)
