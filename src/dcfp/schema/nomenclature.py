"""The nomenclature: what histories and measures are called, their symbols and their units, each once.

Axis labels, heads of tables and the attributes of data sets all come from here; what belongs to one kind of result is added where that result is.
"""

from dataclasses import replace
from operator import attrgetter
from typing import Any

from dcfp.schema.quantities import Quantity
from dcfp.schema.registry import Registry
from dcfp.schema.units import (
    DEGC,
    KN,
    KN_M,
    M_PER_S,
    M_PER_S2,
    MM,
    MM_PER_S,
    MM_PER_S2,
    N_MM,
    NEWTON,
    NONE,
    SECOND,
)  # fmt: skip

#: Every quantity by its name in data sets; in the units of the package, and how it is shown.
NOMENCLATURE: Registry[Quantity] = Registry("quantity")


class Quantities(Registry[Quantity]):
    """What is told of one kind of result, by name, in the order of its columns; its numbers are in the nomenclature too."""

    def add(self, name: str, thing: Quantity) -> Quantity:
        """Add a quantity, of the result's attribute of that name unless it says how to get it."""
        if thing.is_number and name not in NOMENCLATURE.defined:
            NOMENCLATURE.add(name, replace(thing, key=name, name="", unit=thing.unit.inner_unit, get=None))
        return super().add(name, thing if thing.get else replace(thing, get=attrgetter(name)))

    def tell(self, name: str, key: str = "", /, **changes: Any) -> Quantity:
        """Add a quantity of the nomenclature, under a key of JSON and with other changes."""
        return self.add(name, replace(NOMENCLATURE.defined[name], key=key or name, **changes))

    def take(self, other: "Quantities", *names: str) -> None:
        """Add quantities of another kind of result as they are there."""
        for name in names:
            self.add(name, other.defined[name])


def quantity(name: str) -> Quantity:
    """Return one quantity by its name."""
    return NOMENCLATURE[name]


for _one in (
    Quantity("time", "time", SECOND, symbol="t"),
    Quantity("displacement", "displacement of the isolation layer", MM, symbol="y"),
    Quantity("velocity", "relative velocity", MM_PER_S, M_PER_S, symbol="v"),
    Quantity("structure_velocity", "absolute velocity of the structure", MM_PER_S, M_PER_S, symbol="v_u"),
    Quantity("ground_velocity", "ground velocity", MM_PER_S, M_PER_S, symbol="v_g"),
    Quantity("ground_displacement", "ground displacement", MM, symbol="y_g"),
    Quantity("ground_acceleration", "ground acceleration", MM_PER_S2, M_PER_S2, symbol="a_g"),
    Quantity("structure_acceleration", "absolute acceleration of the structure", MM_PER_S2, M_PER_S2, symbol="a_u"),
    Quantity("force", "horizontal force", NEWTON, KN, symbol="F"),
    Quantity("friction", "coefficient of friction", NONE, symbol=r"\mu"),
    Quantity("temperature", "temperature of the contact", DEGC, symbol="T"),
    Quantity("plate_temperature", "temperature of the plate's surface", DEGC, symbol="T"),
    Quantity("plate_position", "position on the plate", MM, symbol="x"),
    Quantity("input_energy", "input energy", N_MM, KN_M, symbol="E"),
    Quantity("absolute_input_energy", "absolute input energy", N_MM, KN_M, symbol="E_{abs}"),
    Quantity("kinetic_energy", "kinetic energy", N_MM, KN_M, symbol="E_k"),
    Quantity("strain_energy", "elastic strain energy", N_MM, KN_M, symbol="E_s"),
    Quantity("hysteretic_energy", "hysteretic energy", N_MM, KN_M, symbol="E_h"),
    Quantity("energy_residual", "residual of the energy balance", N_MM, KN_M, symbol="E - E_s - E_k - E_h"),
    Quantity("sliding", "direction of sliding, 0 while sticking", NONE, symbol="s"),
    Quantity("load", "vertical force, compression positive", NEWTON, KN, symbol="N"),
    Quantity("work", "work of the machine on the bearing", N_MM, KN_M, symbol="W"),
    Quantity("displacement_change", "change of displacement between two successive peaks", MM, symbol=r"\Delta y"),
    Quantity("ground_velocity_change", "change of ground velocity from the peak before a pulse to its own", MM_PER_S, M_PER_S, symbol=r"\Delta v_g"),
    Quantity("ground_velocity_slope", "slope of the ground velocity before the peak of a pulse", MM_PER_S2, M_PER_S2, symbol="k_g"),
    Quantity("slope_ratio", "slope that friction gives the structure over that of the ground", NONE, symbol="k_u / k_g"),
    Quantity("swing_input_velocity", "equivalent velocity of the energy put in during a swing", MM_PER_S, M_PER_S, symbol=r"V_{\Delta E}"),
    Quantity("swing_hysteretic_velocity", "equivalent velocity of the energy dissipated during a swing", MM_PER_S, M_PER_S, symbol=r"V_{\Delta E_{hr}}"),
    Quantity("peak_ground_velocity", "peak ground velocity", MM_PER_S, M_PER_S, symbol=r"\mathrm{PGV}"),
    Quantity("peak_displacement", "largest displacement of the isolation layer", MM, symbol=r"y_{\mathrm{max}}"),
    Quantity("peak_change", "largest change of displacement between two successive peaks", MM, symbol=r"\Delta y_{\mathrm{max}}"),
    Quantity("peak_velocity", "largest relative velocity", MM_PER_S, M_PER_S, symbol=r"v_{\mathrm{max}}"),
    Quantity("peak_force", "largest horizontal force", NEWTON, KN, symbol=r"F_{\mathrm{max}}"),
    Quantity("force_ratio", "largest horizontal force over the weight", NONE, symbol=r"F_{\mathrm{max}} / W"),
    Quantity("peak_temperature", "highest temperature of the contact", DEGC, symbol=r"T_{\mathrm{max}}"),
    Quantity("least_friction", "smallest coefficient of friction while sliding", NONE, symbol=r"\mu_{\mathrm{min}}"),
    Quantity("residual_displacement", "residual displacement", MM, symbol="y_r"),
    Quantity("input_velocity", "equivalent velocity of the input energy", MM_PER_S, M_PER_S, symbol="V_E"),
    Quantity("hysteretic_velocity", "equivalent velocity of the hysteretic energy", MM_PER_S, M_PER_S, symbol="V_{E_h}"),
    Quantity("relative_energy_residual", "residual of the energy balance over the largest input energy", NONE),
    Quantity("elapsed", "computing time of the analysis", SECOND, name="elapsed", printed=False),
):  # fmt: skip
    NOMENCLATURE.add(_one.key, _one)
