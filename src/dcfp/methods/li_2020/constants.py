"""Constants of the prediction of Li et al. (2020), section 6, and what the paper prints of its methods."""

from typing import Annotated

from dcfp.methods.method import Information, Variant
from dcfp.methods.pulses import CHANGE, HYSTERETIC, INPUT
from dcfp.schema.declared import Declared, declared
from dcfp.schema.parameters import Parameter
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import FRACTION, M_PER_S, MM_PER_S2, NONE
from dcfp.system.friction.constant import NOMINAL_COEFFICIENT


@declared
class Constants(Declared):
    """What the three methods of Li et al. (2020) take as given: mu_n is from section 4.4, the amplification from Figure 17.

    Eps is the slope after a peak over that before it, kg_ave the mean slope of the pulse of the largest displacement at the reference PGV of Eq. (30), and
    zeta the velocity change of the largest pulse over the PGV.
    """

    noun = "the methods of Li et al. (2020)"

    nominal_friction: Annotated[
        float,
        Parameter(
            "constant coefficient mu_n that stands for the law",
            FRACTION,
            0.0,
            0.9999,
            symbol=r"\mu_n",
            key="nominal_mu",
            above=True,
        ),
    ] = NOMINAL_COEFFICIENT
    gravity: Annotated[
        float,
        Parameter(
            "acceleration of gravity in the paper's figures",
            MM_PER_S2,
            9000.0,
            11000.0,
            symbol="g",
            option=False,
        ),
    ] = 9810.0
    amplification: Annotated[
        float,
        Parameter("factor on velocities and slopes of a pulse with a ku/kg of 0.8 to 1", NONE, 1.0, 100.0),
    ] = 1.5
    amplified_from: Annotated[
        float, Parameter("ratio of slopes from which on a pulse is amplified", NONE, 1e-3, 10.0, option=False)
    ] = 0.8
    fall_ratio: Annotated[
        float, Parameter("eps of Eq. (26)", NONE, 1e-3, 10.0, symbol=r"\epsilon", key="eps")
    ] = 0.25
    average_slope: Annotated[
        float,
        Parameter(
            "kg_ave of Eq. (28), at a PGV of 0.25 m/s", MM_PER_S2, 1.0, 1e5, symbol=r"k_{g,\mathrm{ave}}"
        ),
    ] = 930.0
    reference_pgv: Annotated[
        float, Parameter("PGV that kg_ave belongs to", M_PER_S, 1e-3, 20.0, option=False)
    ] = 250.0
    change_ratio: Annotated[float, Parameter("zeta of Eq. (29)", NONE, 0.05, 50.0, symbol=r"\zeta", key="zeta")] = 1.5  # fmt: skip

    @property
    def friction_deceleration(self) -> float:
        """mu_n g [mm/s2]."""
        return self.nominal_friction * self.gravity

    @property
    def slides_on_average(self) -> bool:
        """Whether mu_n g is below kg_ave, as the simplified and the design method need."""
        return self.friction_deceleration < self.average_slope

    def velocity_change(self, pgv: float) -> float:
        """Velocity change |dvg| of the largest pulse of an earthquake with a PGV [mm/s], in mm/s: Eq. (29)."""
        return self.change_ratio * pgv

    def slope(self, pgv: float) -> float:
        """Slope kg of that pulse [mm/s2]: Eq. (30)."""
        return self.average_slope * pgv / self.reference_pgv

    def remarks(self, pgv: float) -> tuple[str, ...]:
        """Return what must be known of the methods at a PGV [mm/s]."""
        if not self.slides_on_average:
            return (
                f"The simplified and the design method are left out: mu_n g, {self.friction_deceleration:.0f} mm/s2, is not below"
                f" their average slope of {self.average_slope:.0f} mm/s2.",
            )
        if not 0.0 < pgv < self.reference_pgv:
            return ()
        return (
            "Li et al. (2020), section 6.2.2, give the average slope of the simplified and the design method for PGVs from"
            f" {self.reference_pgv / 1e3:g} m/s on.",
        )


#: The paper's own.
LI_2020 = Constants()

#: The paper, as it is cited beside a formula; and the names of its methods.
PAPER = "Li et al. (2020)"
PULSE, SIMPLIFIED, DESIGN = "pulse", "simplified", "design"

#: Ranges of prediction over analysis [-], and where they are printed. The pulse method: sections 6.1.2 and 6.1.3, Figure 18; the simplified
#: method: section 6.2.3, Figures 22 to 24.
PRINTED_RANGES: dict[tuple[Variant, Quantity], tuple[float, float, str]] = {
    (Variant(PULSE, Information.BLIND), CHANGE): (1.0, 2.1, "Figure 18"),
    (Variant(PULSE, Information.BLIND), INPUT): (0.8, 1.9, "section 6.1.3"),
    (Variant(PULSE, Information.BLIND), HYSTERETIC): (0.8, 1.6, "section 6.1.3"),
    (Variant(SIMPLIFIED, Information.BLIND), INPUT): (0.8, 1.5, "Figure 22"),
    (Variant(SIMPLIFIED, Information.BLIND), HYSTERETIC): (0.7, 1.6, "Figure 23"),
    (Variant(SIMPLIFIED, Information.BLIND), CHANGE): (0.7, 1.8, "Figure 24"),
}
#: Half of the last printed digit of a range [-].
PRINTED_ROUNDING = 0.05

#: The design method at PGV [mm/s]: each quantity with its last digit [mm/s, mm]. Not printed: derived from Eqs (31)-(33) with mu_n g = 421.8 mm/s2.
DERIVED_DESIGN: dict[float, dict[Quantity, tuple[float, float]]] = {
    250.0: {INPUT: (277.2, 0.1), HYSTERETIC: (248.8, 0.1), CHANGE: (73.4, 0.1)},
    1000.0: {INPUT: (1108.8, 0.1), HYSTERETIC: (692.5, 0.1), CHANGE: (568.4, 0.1)},
}
