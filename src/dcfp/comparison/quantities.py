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
    words
        In full.
    """

    name: str
    key: str
    unit: str
    words: str


CHANGE = Quantity("dy", "dy_mm", "mm", "largest change of displacement between two successive peaks")
DISPLACEMENT = Quantity("y", "y_mm", "mm", "largest displacement")
INPUT = Quantity("V_dE", "V_dE_mm_s", "mm/s", "equivalent velocity of the energy put in during a swing")
HYSTERETIC = Quantity(
    "V_dEhr", "V_dEhr_mm_s", "mm/s", "equivalent velocity of the energy dissipated during a swing"
)
TOTAL = Quantity("V_E", "V_E_mm_s", "mm/s", "equivalent velocity of all the energy put in")
#: In the order of tables.
QUANTITIES = (CHANGE, DISPLACEMENT, INPUT, HYSTERETIC, TOTAL)
