"""The equivalent lateral force procedure and the spectrum of ASCE/SEI 7-16: sections 17.5 and 11.4.

The standard itself was not read. D_M, T_M, B_M, V_b and V_st agree in two or three independent transcriptions: a program of Amin-Moghaddasi
(ASCE7_16_Design_Framework), one of H. Pham (mgrubisic/tfp-database), and the Peruvian E.031, whose equations are those of chapter 17. One source only
gives the least D_TM and the exponent for abrupt loops. Of the conditions below none could be confirmed.
"""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Annotated, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.constants import STANDARD_GRAVITY
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
from dcfp.schema.units import SECOND, Unit

NAME = "ASCE 7-16 ELF"
#: Accelerations of this code are in units of gravity.
GRAVITIES = Unit("g", udunits="1", typed="g_0", meant=(("%", 0.01),))
#: Damping ratio and factor B_M [-]: Table 17.5-1.
DAMPING_TABLE = ((0.02, 0.8), (0.05, 1.0), (0.10, 1.2), (0.20, 1.5), (0.30, 1.7), (0.40, 1.9), (0.50, 2.0))
#: Least total over maximum displacement [-]: section 17.5.3.3.
_LEAST_TORSION = 1.15
#: Damping at which the exponent 1 - 2.5 beta of V_st is zero [-].
_POWERLESS = 0.4
UNCONFIRMED = ("the least D_TM of 1.15 D_M, which one source gives",)


def damping_factor(damping: float) -> float:
    """Factor B_M [-] at a damping ratio [-]: Table 17.5-1, with straight lines between."""
    ratios, factors = zip(*DAMPING_TABLE, strict=True)
    return float(np.interp(damping, ratios, factors))


def total_displacement(
    displacement: float, eccentricity: float, distance: float, width: float, length: float, ratio: float = 1.0
) -> float:
    """Total maximum displacement D_TM [mm]: Eq. (17.5-3), and not under 1.15 D_M.

    Parameters
    ----------
    displacement
        D_M [mm].
    eccentricity
        e, with the accidental one [mm].
    distance
        y, of the element from the centre of rigidity [mm].
    width, length
        b and d, of the plan [mm].
    ratio
        P_T of translational to rotational period of the isolation [-]; one source has it at least 1.
    """
    torsion = 1.0 + distance / ratio**2 * 12.0 * eccentricity / (width**2 + length**2)
    return displacement * max(torsion, _LEAST_TORSION)


def structure_shear(base_shear: float, weight_above: float, damping: float, *, abrupt: bool = False) -> float:
    r"""Shear of the structure above over the whole weight, V_st / W [-]: Eq. (17.5-7), :math:`V_{st} = V_b (W_s/W)^{1 - 2.5 \beta_M}`.

    Parameters
    ----------
    base_shear
        V_b / W [-].
    weight_above
        W_s / W, without the base level [-].
    damping
        beta_M [-].
    abrupt
        Take 3.5 in place of 2.5, for loops with an abrupt transition from before to after yielding. That of a friction pendulum is one, but the
        exception is confirmed by one source only, so that 2.5 is the default; with 3.5 the shear is larger.
    """
    return base_shear * weight_above ** (1.0 - (3.5 if abrupt else 2.5) * damping)


def equivalent_lateral_force(
    pendulum: PendulumWithFriction, spectrum: ElasticSpectrum, structure: Structure | None = None
) -> CodeResult:
    """Return the maximum displacement and the base shear by the procedure: section 17.5.

    With a spectrum that has another shape than S_M1 / T, D_M is S_d(T_M) / B_M, which is Eq. (17.5-1) on its branch of constant velocity.

    Raises
    ------
    AnalysisError
        If the iteration has no solution.
    """
    found = iterated(NAME, pendulum, spectrum, lambda damping: 1.0 / damping_factor(damping))
    D_M = found.displacement
    return replace(
        found,
        base_shear=pendulum.effective_stiffness(D_M) * D_M,
        conditions=_conditions(pendulum, structure or Structure(), found),
        unconfirmed=(*found.unconfirmed, *UNCONFIRMED),
    )


def _remarks(results: Sequence[CodeResult], inputs: CodeInputs) -> tuple[str, ...]:
    """Return the least D_TM, and the shear of the structure above with the worse bound."""
    D_TM = _LEAST_TORSION * results[0].displacement
    remarks = [f"D_TM is at least {_LEAST_TORSION:g} D_M, {D_TM:.0f} mm."]
    weight = inputs.structure.weight_above
    if weight is None:
        return tuple(remarks)
    known = [(one.base_shear, one.damping or 0.0) for one in results]
    above = max(structure_shear(shear, weight, damping) for shear, damping in known)
    abrupt = max(structure_shear(shear, weight, damping, abrupt=True) for shear, damping in known)
    remarks.append(
        f"V_st/W of the structure above is {above:.3f}, and {abrupt:.3f} by the exponent for loops with an abrupt yield (one source)."
    )
    if max(damping for _, damping in known) > _POWERLESS:
        remarks.append(
            "Above a damping of 40 % the exponent of V_st is negative, and V_st larger than V_b: the equation was not made for that."
        )
    return tuple(remarks)


def _formulas(result: CodeResult, inputs: CodeInputs) -> tuple[Formula, ...]:
    demand, D_M = demand_formula(result, inputs), result.displacement
    factor = damping_factor(result.damping or 0.0)
    code = "ASCE/SEI 7-16"
    return (
        *equivalent_formulas(result, inputs, "T_M", "beta_M", f"{code}, section 17.5"),
        demand,
        Formula("Damping factor, straight lines between", "B_M", "", factor, 4, "", f"{code}, Table 17.5-1"),
        Formula("Maximum displacement", "D_M = (S_d (T_M)) / B_M", f"{millimetres(demand.value)} / {number(factor, 4)}", D_M, decimals_of(D_M), "mm", f"{code}, Eq. (17.5-1)"),
        Formula("Least total maximum displacement", f'D_"TM" = {_LEAST_TORSION:g} D_M', f"{_LEAST_TORSION:g} times {millimetres(D_M)}", _LEAST_TORSION * D_M, 1, "mm", f"{code}, 17.5.3.3", confirmed=False),
        shear_formula(result, inputs, f"{code}, section 17.5"),
    )  # fmt: skip


# None of the conditions could be confirmed in the standard. Codes of its family have the same numbers for the period (E.031 of Peru; 4 s in the Turkish code
# of 2018), the damping (E.031, the Turkish code and the Italian NTC 2018), the height (E.031 and the Turkish code), the fixed base (E.031 and NTC) and the
# softening (E.031). The rise of the force by 0.025 W is that of NTC 2018, 7.10.5.2; AASHTO asks for half of it. For the site class nothing was found but the
# Turkish code, which admits its classes ZA to ZD.
#: Limits of section 17.4.1: period [s], damping [-], fixed-base periods in a period, stiffness over that at 0.2 D_M, height [mm].
_LONGEST, _MOST_DAMPING, _STIFFER, _SOFTENING, _HEIGHT = 5.0, 0.30, 3.0, 1.0 / 3.0, 65.0 * 304.8
#: Rise of the force between half of D_M and D_M over the weight [-]: section 17.2.4.4.
_RESTORING = 0.025
#: Site classes on which the procedure may be used.
_SITES = ("A", "B", "C", "D")
_condition = partial(Check, source="17.4.1", confirmed=False)


def _conditions(pendulum: PendulumWithFriction, structure: Structure, found: CodeResult) -> tuple[Check, ...]:
    D_M, T_M, beta_M = found.displacement, found.period or 0.0, found.damping or 0.0
    softening = pendulum.effective_stiffness(D_M) / pendulum.effective_stiffness(0.2 * D_M)
    rise = pendulum.force(D_M) - pendulum.force(0.5 * D_M)
    height = unless_unknown(structure.height, lambda h: (at_most(h, _HEIGHT), f"{h / 1e3:.1f} m"))
    site = unless_unknown(structure.site_class, lambda letter: (Verdict.of(letter in _SITES), letter))
    return (
        _condition("effective period T_M", at_most(T_M, _LONGEST), f"{T_M:.2f} s", f"at most {_LONGEST:g} s"),
        _condition("effective damping", at_most(beta_M, _MOST_DAMPING), f"{100 * beta_M:.1f} %", "at most 30 %"),
        _condition("T_M over the period of the fixed base", *structure.over_fixed_base(T_M, _STIFFER), "at least 3"),
        _condition("k_eff(D_M) over k_eff(0.2 D_M)", at_least(softening, _SOFTENING), f"{softening:.2f}", "above 1/3"),
        _condition("restoring force, F(D_M) - F(D_M/2) over W", at_least(rise, _RESTORING), f"{rise:.3f}", "at least 0.025", source="17.2.4.4"),
        _condition("height of the structure above", *height, "at most 65 ft (19.8 m), or four storeys"),
        _condition("site class", *site, "A, B, C or D"),
    )  # fmt: skip


ASCE_2016 = CodeMethod(
    key="asce7",
    name=NAME,
    citations=("asce_7_2016",),
    look=Look("v", "blue"),
    calculate=lambda inputs: equivalent_lateral_force(inputs.pendulum, inputs.spectrum, inputs.structure),
    remarks=_remarks,
    formulas=_formulas,
    symbols=("D_M", "T_M", "beta_M", "V_b/W"),
)


#: Part of T_S at which the plateau begins, and of it the value at period zero [-].
_START, _AT_ZERO = 0.2, 0.4


@declared
class Asce2016Spectrum(DesignSpectrum):
    """Four branches, rising, of constant acceleration, velocity and displacement: sections 11.4.6 and 11.4.7."""

    noun = "a spectrum of ASCE 7-16"
    option: ClassVar[str] = "asce"
    words: ClassVar[str] = "S_MS and S_M1 [g], and T_L [s] (8 unless given)"
    behind: ClassVar[tuple[int, int]] = (2, 3)
    doubts: ClassVar[tuple[str, ...]] = ("the branches below T_S and beyond T_L of the spectrum",)

    short: Annotated[
        float, Parameter("acceleration S_MS at short periods", GRAVITIES, 1e-3, 10.0, symbol="S_{MS}")
    ]
    one_second: Annotated[
        float, Parameter("acceleration S_M1 at 1 s", GRAVITIES, 1e-3, 10.0, symbol="S_{M1}")
    ]
    long_period: Annotated[
        float, Parameter("long-period transition T_L", SECOND, 0.1, 30.0, symbol="T_L")
    ] = 8.0

    @property
    def name(self) -> str:
        """What to call it."""
        return f"ASCE 7-16, S_MS {self.short:g} g, S_M1 {self.one_second:g} g"

    def acceleration(self, period: ArrayLike) -> FloatArray:
        """Pseudo-acceleration [mm/s2] at a period [s]."""
        T = np.asarray(period, dtype=np.float64)
        T_S = self.one_second / self.short
        T_0 = _START * T_S
        T_L = self.long_period
        rising = self.short * (_AT_ZERO + (1.0 - _AT_ZERO) * T / T_0)
        velocity = self.one_second / np.maximum(T, 1e-9)
        falling = velocity * T_L / np.maximum(T, 1e-9)
        S_a = np.select([T < T_0, T <= T_S, T <= T_L], [rising, self.short, velocity], falling)
        return np.asarray(S_a * STANDARD_GRAVITY)
