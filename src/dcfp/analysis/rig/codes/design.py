"""What prototype tests are made from."""

from dataclasses import dataclass

from dcfp.analysis.rig.load import VerticalLoad
from dcfp.errors import InputError
from dcfp.system.checks import positive

#: Minimum of the total maximum displacement over the maximum displacement [-]: ASCE/SEI 7, section 17.5.3.5.
LEAST_TOTAL = 1.15


@dataclass(frozen=True)
class PrototypeDesign:
    """Design values of an isolation system.

    Parameters
    ----------
    displacement
        Maximum displacement: D_M of ASCE/SEI 7, d_bd of EN 15129 [mm].
    period
        Effective period at that displacement [s].
    pressure
        On the slider under the average load [N/mm2].
    total_displacement
        With torsion, D_TM [mm]; by default 1.15 times the displacement, the least that ASCE/SEI 7 allows.
    least_load, largest_load
        Smallest and largest vertical load over the average one [-]; by default those of Li et al. (2020), Table 2, T10 and T11.
    wind_displacement
        Amplitude of the wind cycles [mm]; by default that of Li et al. (2020), Table 2, T02.
    endurance_cycles
        Cycles at 0.75 D_M, at least 10: 30 S_M1 / (S_MS B_M); by default the 20 of Li et al. (2020), Table 2, T12.
    """

    displacement: float
    period: float
    pressure: float = 60.0
    total_displacement: float | None = None
    least_load: float = 0.5
    largest_load: float = 1.5
    wind_displacement: float = 10.0
    endurance_cycles: int = 20

    def __post_init__(self) -> None:
        positive(self.displacement, "design displacement", "mm")
        positive(self.period, "effective period", "s")
        positive(self.pressure, "pressure on the slider", "N/mm2")
        if self.total_displacement is not None:
            positive(self.total_displacement, "total displacement", "mm")
            if self.total_displacement < self.displacement:
                msg = f"The total displacement, {self.total_displacement:g} mm, must not be below the displacement, {self.displacement:g} mm."
                raise InputError(msg)
        positive(self.least_load, "smallest over the average load", "[-]")
        positive(self.largest_load, "largest over the average load", "[-]")
        positive(self.wind_displacement, "displacement of the wind cycles", "mm")
        positive(self.endurance_cycles, "number of cycles", "cycles")

    @property
    def total(self) -> float:
        """Total maximum displacement [mm]."""
        if self.total_displacement is None:
            return LEAST_TOTAL * self.displacement
        return self.total_displacement

    def load(self, factor: float = 1.0) -> VerticalLoad:
        """Return a constant load, as a factor of the average one [-]."""
        return VerticalLoad((factor * self.pressure,))
