"""The quantities in which predictions are compared with the analysis."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Quantity:
    """One of them.

    Attributes
    ----------
    name
        Short, as in tables.
    key
        In JSON and data, with its unit.
    unit
        "mm" or "mm/s".
    """

    name: str
    key: str
    unit: str


#: Largest change of displacement between two successive peaks, and largest displacement.
CHANGE, DISPLACEMENT = Quantity("dy", "dy_mm", "mm"), Quantity("y", "y_mm", "mm")
#: Equivalent velocities of the energies put in and dissipated during a swing, and of all the energy put in.
INPUT, HYSTERETIC = Quantity("V_dE", "V_dE_mm_s", "mm/s"), Quantity("V_dEhr", "V_dEhr_mm_s", "mm/s")
TOTAL = Quantity("V_E", "V_E_mm_s", "mm/s")
#: In the order of tables.
QUANTITIES = (CHANGE, DISPLACEMENT, INPUT, HYSTERETIC, TOTAL)
