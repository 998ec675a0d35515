"""The equivalent lateral force procedure: ASCE/SEI 7-16, section 17.5.

The standard itself was not read. D_M, T_M, B_M, V_b, V_st and the form of D_TM agree in two or three independent transcriptions: a program of
Amin-Moghaddasi (ASCE7_16_Design_Framework), one of H. Pham (mgrubisic/tfp-database), and the Peruvian E.031, whose equations are those of chapter 17.
One source only gives the least D_TM, P_T, and the exponent for abrupt loops. The conditions are in `asce_2016_conditions`.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.methods.equivalent_linear import PendulumWithFriction, agreements, iterate, several
from dcfp.methods.result import Answer, Structure
from dcfp.methods.spectra.elastic import ElasticSpectrum
from dcfp.schema.check import Check, Verdict, at_least, at_most
from dcfp.schema.checks import positive

NAME = "ASCE 7-16 ELF"
#: Damping ratio and factor B_M [-]: Table 17.5-1.
DAMPING_TABLE = (
    (0.02, 0.8),
    (0.05, 1.0),
    (0.10, 1.2),
    (0.20, 1.5),
    (0.30, 1.7),
    (0.40, 1.9),
    (0.50, 2.0),
)
#: Least total over maximum displacement [-]: section 17.5.3.3.
_LEAST_TORSION = 1.15
#: Damping at which the exponent 1 - 2.5 beta of V_st is zero [-].
_POWERLESS = 0.4
UNCONFIRMED = ("the least D_TM of 1.15 D_M, which one source gives",)


@dataclass(frozen=True)
class Bounds:
    """Property modification factors on the coefficient of friction: section 17.2.8.

    Parameters
    ----------
    least, largest
        lambda_min and lambda_max [-].
    source
        Where they come from, in words.
    """

    least: float = 1.0
    largest: float = 1.0
    source: str = "nominal properties"

    def __post_init__(self) -> None:
        positive(self.least, "lambda_min", "-")
        positive(self.largest, "lambda_max", "-")
        if self.least > self.largest:
            msg = f"lambda_min, {self.least:g}, must not exceed lambda_max, {self.largest:g}."
            raise InputError(msg)


def damping_factor(damping: float) -> float:
    """Factor B_M [-] at a damping ratio [-]: Table 17.5-1, with straight lines between."""
    ratios = [ratio for ratio, _ in DAMPING_TABLE]
    factors = [factor for _, factor in DAMPING_TABLE]
    return float(np.interp(damping, ratios, factors))


def maximum_displacement(one_second: float, period: float, factor: float) -> float:
    """Maximum displacement D_M = g S_M1 T_M / (4 pi^2 B_M) [mm]: Eq. (17.5-1).

    `one_second` S_M1 in units of gravity [-], `period` T_M [s], `factor` B_M [-].
    """
    return STANDARD_GRAVITY * one_second * period / (4.0 * math.pi**2 * factor)


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
    pendulum: PendulumWithFriction,
    spectrum: ElasticSpectrum,
    structure: Structure | None = None,
    bounds: Bounds | None = None,
) -> Answer:
    """Return the maximum displacement and the base shear by the procedure: section 17.5.

    Displacement is that of the lower bound of friction, and base shear the larger of both bounds. With a spectrum that has another shape than
    S_M1 / T, D_M is S_d(T_M) / B_M, which is Eq. (17.5-1) on its branch of constant velocity.

    Raises
    ------
    AnalysisError
        If the iteration has no solution.
    """
    structure = Structure() if structure is None else structure
    bounds = Bounds() if bounds is None else bounds
    answers = [
        _with(replace(pendulum, friction=pendulum.friction * part), spectrum, structure)
        for part in dict.fromkeys((bounds.least, bounds.largest))
    ]
    lower = answers[0]
    shear = max(one.base_shear for one in answers)
    conditions = lower.conditions
    remarks = [
        *(remark for one in answers for remark in one.remarks),
        f"D_TM is at least {_LEAST_TORSION:g} D_M, {_LEAST_TORSION * lower.displacement:.0f} mm.",
    ]
    if bounds.least != bounds.largest:
        upper = answers[1]
        conditions += tuple(
            replace(one, name=f"{one.name}, upper bound") for one in upper.conditions if one not in conditions
        )
        remarks.append(
            f"Upper bound: D_M {upper.displacement:.0f} mm, T_M {upper.period or 0.0:.2f} s, beta_M {100.0 * (upper.damping or 0.0):.1f} %, V_b/W"
            f" {upper.base_shear:.3f}; lower bound: V_b/W {lower.base_shear:.3f}."
        )
        remarks.append(
            f"Friction from {bounds.least:g} to {bounds.largest:g} times mu ({bounds.source}): displacement from the lower, force from the"
            " worse bound."
        )
    if structure.weight_above is not None:
        shears = [_structure_shears(one, structure.weight_above) for one in answers]
        above, abrupt = (max(values) for values in zip(*shears, strict=True))
        remarks.append(
            f"V_st/W of the structure above is {above:.3f}, and {abrupt:.3f} by the exponent for loops with an abrupt yield (one source)."
        )
        if max(one.damping or 0.0 for one in answers) > _POWERLESS:
            remarks.append(
                "Above a damping of 40 % the exponent of V_st is negative, and V_st larger than V_b: the equation was not made for that."
            )
    return replace(lower, base_shear=shear, conditions=conditions, remarks=tuple(remarks))


def _structure_shears(answer: Answer, weight_above: float) -> tuple[float, float]:
    damping = answer.damping or 0.0
    return (
        structure_shear(answer.base_shear, weight_above, damping),
        structure_shear(answer.base_shear, weight_above, damping, abrupt=True),
    )


def _with(pendulum: PendulumWithFriction, spectrum: ElasticSpectrum, structure: Structure) -> Answer:

    def reduction(damping: float) -> float:
        return 1.0 / damping_factor(damping)

    steps = iterate(pendulum, spectrum, reduction, pendulum.effective_damping)
    known = agreements(pendulum, spectrum, reduction, pendulum.effective_damping)
    D_M, T_M, beta_M = steps[-1].displacement, steps[-1].period, steps[-1].damping
    return Answer(
        method=NAME,
        displacement=D_M,
        base_shear=pendulum.effective_stiffness(D_M) * D_M,
        period=T_M,
        damping=beta_M,
        steps=steps,
        remarks=several(known, steps),
        conditions=conditions(pendulum, structure, D_M, T_M, beta_M),
        unconfirmed=(*spectrum.unconfirmed, *UNCONFIRMED),
    )


# Under which conditions the equivalent lateral force procedure may be used: ASCE/SEI 7-16, sections
# 17.2.4.4 and 17.4.1.
#
# None could be confirmed in the standard. Codes of its family have the same numbers for the period (E.031
# of Peru; 4 s in the Turkish code of 2018), the damping (E.031, the Turkish code and the Italian NTC 2018),
# the height (E.031 and the Turkish code), the fixed base (E.031 and NTC) and the softening (E.031). The
# rise of the force by 0.025 W is that of NTC 2018, 7.10.5.2; AASHTO asks for half of it. For the site class
# nothing was found but the Turkish code, which admits its classes ZA to ZD.


#: Limits of section 17.4.1: period [s], damping [-], fixed-base periods in a period, stiffness over that at 0.2 D_M, height [mm].
_LONGEST, _MOST_DAMPING, _STIFFER, _SOFTENING, _HEIGHT = 5.0, 0.30, 3.0, 1.0 / 3.0, 65.0 * 304.8
#: Rise of the force between half of D_M and D_M over the weight [-]: section 17.2.4.4.
_RESTORING = 0.025
#: Site classes on which the procedure may be used.
_SITES = ("A", "B", "C", "D")
_SECTION = "17.4.1"


def conditions(
    pendulum: PendulumWithFriction, structure: Structure, D_M: float, T_M: float, beta_M: float
) -> tuple[Check, ...]:
    """Return the conditions at D_M [mm], T_M [s] and beta_M [-]."""
    softening = pendulum.effective_stiffness(D_M) / pendulum.effective_stiffness(0.2 * D_M)
    restoring = pendulum.force(D_M) - pendulum.force(0.5 * D_M)
    return (
        Check(
            "effective period T_M",
            at_most(T_M, _LONGEST),
            f"{T_M:.2f} s",
            f"at most {_LONGEST:g} s",
            _SECTION,
            confirmed=False,
        ),
        Check(
            "effective damping",
            at_most(beta_M, _MOST_DAMPING),
            f"{100 * beta_M:.1f} %",
            "at most 30 %",
            _SECTION,
            confirmed=False,
        ),
        Check(
            "T_M over the period of the fixed base",
            *structure.over_fixed_base(T_M, _STIFFER),
            "at least 3",
            _SECTION,
            confirmed=False,
        ),
        Check(
            "k_eff(D_M) over k_eff(0.2 D_M)",
            at_least(softening, _SOFTENING),
            f"{softening:.2f}",
            "above 1/3",
            _SECTION,
            confirmed=False,
        ),
        Check(
            "restoring force, F(D_M) - F(D_M/2) over W",
            at_least(restoring, _RESTORING),
            f"{restoring:.3f}",
            "at least 0.025",
            "17.2.4.4",
            confirmed=False,
        ),
        Check(
            "height of the structure above",
            Verdict.NOT_KNOWN if structure.height is None else at_most(structure.height, _HEIGHT),
            "not given" if structure.height is None else f"{structure.height / 1e3:.1f} m",
            "at most 65 ft (19.8 m), or four storeys",
            _SECTION,
            confirmed=False,
        ),
        Check(
            "site class",
            Verdict.NOT_KNOWN
            if structure.site_class is None
            else (Verdict.MET if structure.site_class in _SITES else Verdict.NOT_MET),
            structure.site_class or "not given",
            "A, B, C or D",
            _SECTION,
            confirmed=False,
        ),
    )
