"""The simplified linear analysis and the elastic spectrum of Eurocode 8: EN 1998-1:2004, sections 10.9 and 3.2.2.2; re-centring after EN 1998-2:2005, 7.7.1.

The standards themselves were not read. Spectrum and damping correction agree in independent programs. The equation of d_dc, the torsion and most conditions
are those of the Italian NTC 2018, 7.10.5, the twin of section 10.9, and so not confirmed for Eurocode 8 itself. For gamma_x, the distance to a fault, re-centring and the
accumulation of residual displacements nothing was found.
"""

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Annotated, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.methods.code import (
    CodeInputs,
    CodeMethod,
    CodeResult,
    Structure,
    decimals_of,
    demand_formula,
    equivalent_formulas,
    iterated,
    millimetres,
    shear_formula,
    unless_unknown,
)
from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.methods.method import Look
from dcfp.methods.spectra.elastic import DesignSpectrum, ElasticSpectrum
from dcfp.schema.check import Check, Verdict, at_least, at_most
from dcfp.schema.declared import declared
from dcfp.schema.formulas import Formula, number
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import M_PER_S2, NONE

NAME = "Eurocode 8 simplified"
#: Least damping correction [-]: section 3.2.2.2(3).
_LEAST_CORRECTION = 0.55
#: Factor on the displacement for the devices gamma_x [-]: section 10.3(2).
RELIABILITY = 1.2
#: Limits of sections 10.9.2 and 10.9.3.
_STIFFNESS_RATIO, _MOST_DAMPING, _RESTORING = 0.5, 0.30, 0.025
_LONGEST, _STIFFER, _PLAN, _FAULT = 3.0, 3.0, 50e3, 15e6
#: Displacement over the largest displacement at rest, from which on a bearing re-centres [-]: EN 1998-2, 7.7.1.
_RECENTRING = 0.5
#: d_y of the bearing [mm]; it matters only where the bearing does not re-centre.
_YIELD = 0.2
UNCONFIRMED = (
    "the equation of d_dc, which was read in the Italian code of the same family",
    "gamma_x of 1.2 on the devices' displacement",
)
_ACCUMULATION = "the factor for residual displacements that add up"


def damping_correction(damping: float) -> float:
    """Damping correction eta [-] at a damping ratio [-]: Eq. (3.6), sqrt(10 / (5 + xi)) with xi in percent, at least 0.55."""
    return max(math.sqrt(10.0 / (5.0 + 100.0 * damping)), _LEAST_CORRECTION)


def accumulation_factor(displacement: float, yield_displacement: float, rest: float) -> float:
    """Factor for residual displacements that add up [-]: EN 1998-2, Eq. (7.29b); 1 for a bearing that re-centres.

    `displacement` d_cd, `yield_displacement` d_y and `rest` d_r [mm].
    """
    d_cd, d_y, d_r = displacement, yield_displacement, rest
    if d_cd / d_r >= _RECENTRING:
        return 1.0
    return 1.0 + 1.35 * (1.0 - (d_y / d_cd) ** 0.6) / (1.0 + 80.0 * (d_cd / d_r) ** 1.5)


def torsion_factors(
    places: FloatArray, stiffness: FloatArray, eccentricity: tuple[float, float]
) -> tuple[FloatArray, FloatArray]:
    r"""Return the factors on the displacement of every device along x and along y [-], shape (n,): EN 1998-1, 10.9.3(7), read in NTC 2018, (7.10.4) and (7.10.5).

    .. math::
        \delta_{xi} = 1 + \frac{e_y}{r_y^2} y_i, \quad \delta_{yi} = 1 + \frac{e_x}{r_x^2} x_i, \quad
        r_x^2 = \frac{\sum (x_i^2 K_{yi} + y_i^2 K_{xi})}{\sum K_{yi}}, \quad
        r_y^2 = \frac{\sum (x_i^2 K_{yi} + y_i^2 K_{xi})}{\sum K_{xi}}

    Parameters
    ----------
    places
        x_i and y_i from the centre of stiffness [mm], shape (n, 2).
    stiffness
        K_xi and K_yi, effective [N/mm], shape (n, 2).
    eccentricity
        e_x and e_y, total, of the mass [mm].
    """
    x, y = np.asarray(places, dtype=np.float64).T
    K_x, K_y = np.asarray(stiffness, dtype=np.float64).T
    rotational = float((x**2 * K_y + y**2 * K_x).sum())
    e_x, e_y = eccentricity
    return 1.0 + e_y * y * K_x.sum() / rotational, 1.0 + e_x * x * K_y.sum() / rotational


def simplified_linear_analysis(
    pendulum: PendulumWithFriction, spectrum: ElasticSpectrum, structure: Structure | None = None
) -> CodeResult:
    """Return the displacement d_dc and the base shear: section 10.9.3.

    Parameters
    ----------
    pendulum, spectrum
        The bearing, and the spectrum at a damping of 5 %.
    structure
        What the conditions ask of the building and its site.

    Raises
    ------
    AnalysisError
        If the iteration has no solution.
    """
    found = iterated(NAME, pendulum, spectrum, damping_correction)
    factor = accumulation_factor(found.displacement, _YIELD, pendulum.rest)
    return replace(
        found,
        conditions=_conditions(pendulum, structure or Structure(), found),
        unconfirmed=(*found.unconfirmed, *UNCONFIRMED, *((_ACCUMULATION,) if factor > 1.0 else ())),
    )


def _remarks(results: Sequence[CodeResult], inputs: CodeInputs) -> tuple[str, ...]:
    """Return the displacement of the devices, and whether residual displacements add up."""
    d_dc = results[0].displacement
    remarks = [
        f"The devices are to be designed for {RELIABILITY:g} d_dc, {RELIABILITY * d_dc:.0f} mm (10.3(2))."
    ]
    factor = accumulation_factor(d_dc, _YIELD, inputs.pendulum.rest)
    if factor > 1.0:
        remarks.append(
            f"The bearing does not re-centre by EN 1998-2, 7.7.1: residual displacements add up by a factor of {factor:.2f}."
        )
    return tuple(remarks)


def _formulas(result: CodeResult, inputs: CodeInputs) -> tuple[Formula, ...]:
    demand, d_dc, xi = demand_formula(result, inputs), result.displacement, result.damping or 0.0
    eta, digits, code = damping_correction(xi), number(xi, 4), "EN 1998-1"
    return (
        *equivalent_formulas(result, inputs, 'T_"eff"', "xi", f"{code}, 10.9.3"),
        demand,
        Formula(f"Damping correction, at least {_LEAST_CORRECTION:g}", f"eta = max(sqrt(10 / (5 + 100 xi)), {_LEAST_CORRECTION:g})", f"max(sqrt(10 / (5 + 100 times {digits})), {_LEAST_CORRECTION:g})", eta, 4, "", f"{code}, Eq. (3.6)"),
        Formula("Displacement of the centre of stiffness", 'd_"dc" = eta thin S_d (T_"eff")', f"{number(eta, 4)} times {millimetres(demand.value)}", d_dc, decimals_of(d_dc), "mm", f"{code}, 10.9.3", confirmed=False),
        Formula("Design displacement of the devices", 'gamma_x d_"dc"', f"{RELIABILITY:g} times {millimetres(d_dc)}", RELIABILITY * d_dc, 1, "mm", f"{code}, 10.3(2)", confirmed=False),
        shear_formula(result, inputs, f"{code}, 10.9.3"),
    )  # fmt: skip


_condition = partial(Check, confirmed=False)


def _conditions(pendulum: PendulumWithFriction, structure: Structure, found: CodeResult) -> tuple[Check, ...]:
    d_dc, T_eff, xi = found.displacement, found.period or 0.0, found.damping or 0.0
    ratio = pendulum.effective_stiffness(d_dc) / pendulum.effective_stiffness(0.2 * d_dc)
    rise, centred = pendulum.force(d_dc) - pendulum.force(0.5 * d_dc), d_dc / pendulum.rest
    plan = unless_unknown(structure.plan, lambda plan: (at_most(plan, _PLAN), f"{plan / 1e3:.0f} m"))
    fault = unless_unknown(
        structure.fault_distance, lambda far: (at_least(far, _FAULT), f"{far / 1e6:.0f} km")
    )
    rate = (Verdict.NOT_KNOWN, "not looked at; friction that depends on speed, load and heat seldom meets it")
    return (
        _condition("K_eff(d_dc) over K_eff(0.2 d_dc)", at_least(ratio, _STIFFNESS_RATIO), f"{ratio:.2f}", "at least 0.5", "10.9.2(5)a"),
        _condition("effective damping", at_most(xi, _MOST_DAMPING), f"{100 * xi:.1f} %", "at most 30 %", "10.9.2(5)b"),
        _condition("change of the force with rate and vertical load", *rate, "at most 10 %", "10.9.2(5)c"),
        _condition("rise of the force from d_dc/2 to d_dc over the weight", at_least(rise, _RESTORING), f"{rise:.3f}", "at least 0.025", "10.9.2(5)d"),
        _condition("effective period", at_most(T_eff, _LONGEST), f"{T_eff:.2f} s", "at most 3 s", "10.9.3(2)c"),
        _condition("effective period over that of the fixed base", *structure.over_fixed_base(T_eff, _STIFFER), "at least 3", "10.9.3(2)c"),
        _condition("larger dimension of the plan", *plan, "at most 50 m", "10.9.3(2)b"),
        _condition("distance to a fault of magnitude 6.5 or more", *fault, "above 15 km", "10.9.3(2)a"),
        _condition("re-centring, d_dc over mu R", at_least(centred, _RECENTRING), f"{centred:.2f}", "at least 0.5", "EN 1998-2, 7.7.1"),
    )  # fmt: skip


EUROCODE_8 = CodeMethod(
    key="eurocode8",
    name=NAME,
    citations=("en_1998_1_2004", "en_1998_2_2005"),
    look=Look("p", "ochre", 1.1),
    calculate=lambda inputs: simplified_linear_analysis(inputs.pendulum, inputs.spectrum, inputs.structure),
    remarks=_remarks,
    formulas=_formulas,
    symbols=("d_dc", "T_eff", "xi", "V/W"),
)


#: S [-], T_B, T_C and T_D [s] of every ground type: Table 3.2 (type 1) and Table 3.3 (type 2).
TABLES: dict[int, dict[str, tuple[float, float, float, float]]] = {
    1: {
        "A": (1.0, 0.15, 0.4, 2.0),
        "B": (1.2, 0.15, 0.5, 2.0),
        "C": (1.15, 0.20, 0.6, 2.0),
        "D": (1.35, 0.20, 0.8, 2.0),
        "E": (1.4, 0.15, 0.5, 2.0),
    },
    2: {
        "A": (1.0, 0.05, 0.25, 1.2),
        "B": (1.35, 0.05, 0.25, 1.2),
        "C": (1.5, 0.10, 0.25, 1.2),
        "D": (1.8, 0.10, 0.30, 1.2),
        "E": (1.6, 0.05, 0.25, 1.2),
    },
}
#: Plateau over the ground acceleration [-]: Eqs (3.2) to (3.5).
_PLATEAU = 2.5


@declared
class Eurocode8Spectrum(DesignSpectrum):
    """Four branches, rising, of constant acceleration, velocity and displacement: section 3.2.2.2.

    Type 1 is for regions of large earthquakes, type 2 where those that matter are below M_s 5.5; a_g has the importance factor in it. The code gives the
    spectrum up to 4 s; beyond, the displacement is kept constant here, which is on the safe side of its Annex A.
    """

    noun = "a spectrum of Eurocode 8"
    option: ClassVar[str] = "eurocode"
    words: ClassVar[str] = "ground acceleration a_g on ground type A [m/s2]"

    ground_acceleration: Annotated[
        float, Parameter("ground acceleration a_g on ground type A", M_PER_S2, 0.01, 50.0, symbol="a_g")
    ]
    ground: Annotated[str, Parameter("ground type of Eurocode 8", choices=tuple(TABLES[1]))] = "B"
    kind: Annotated[int, Parameter("type of the spectrum of Eurocode 8", NONE, 1, 2, key="type")] = 1

    @property
    def name(self) -> str:
        """What to call it."""
        return (
            f"Eurocode 8 type {self.kind}, ground {self.ground}, a_g {self.ground_acceleration / 1e3:g} m/s²"
        )

    def acceleration(self, period: ArrayLike) -> FloatArray:
        """Pseudo-acceleration S_e at a damping of 5 % [mm/s2] at a period [s]: Eqs (3.2)-(3.5)."""
        T = np.maximum(np.asarray(period, dtype=np.float64), 1e-9)
        S, T_B, T_C, T_D = TABLES[self.kind][self.ground]
        rising = 1.0 + T / T_B * (_PLATEAU - 1.0)
        falling = _PLATEAU * T_C / T
        shape = np.select([T < T_B, T <= T_C, T <= T_D], [rising, _PLATEAU, falling], falling * T_D / T)
        return np.asarray(self.ground_acceleration * S * shape)
