"""The equivalent lateral force procedure: ASCE/SEI 7-16, section 17.5."""

import math
from dataclasses import dataclass, replace

import numpy as np

from dcfp.bearing.checks import positive
from dcfp.codes.equivalent_linear import PendulumWithFriction
from dcfp.codes.iteration import iterate
from dcfp.codes.result import Answer, Condition, Verdict, at_least, at_most
from dcfp.codes.structure import Structure
from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.spectrum.elastic import ElasticSpectrum

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
#: Limits of section 17.4.1: period [s], damping [-], fixed-base periods in a period, stiffness over that at 0.2 D_M, height [mm].
_LONGEST, _MOST_DAMPING, _STIFFER, _SOFTENING, _HEIGHT = 5.0, 0.30, 3.0, 1.0 / 3.0, 65.0 * 304.8
#: Rise of the force between half of D_M and D_M over the weight [-]: section 17.2.4.4.
_RESTORING = 0.025
_SECTION = "17.4.1"


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
        P_T of translational to rotational period of the isolation [-].
    """
    torsion = 1.0 + distance / ratio**2 * 12.0 * eccentricity / (width**2 + length**2)
    return displacement * max(torsion, _LEAST_TORSION)


def structure_shear(base_shear: float, weight_above: float, damping: float) -> float:
    """Shear of the structure above over the whole weight, V_st / W [-]: Eqs (17.5-6) and (17.5-7).

    `base_shear` V_b / W, `weight_above` W_s / W, without the base level, and `damping` beta_M [-].
    """
    return base_shear * weight_above ** (1.0 - 2.5 * damping)


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
    remarks = (
        f"D_TM is at least {_LEAST_TORSION:g} D_M, {_LEAST_TORSION * lower.displacement:.0f} mm.",
        f"Friction from {bounds.least:g} to {bounds.largest:g} times mu ({bounds.source}): displacement from the lower, force from the"
        " worse bound.",
    )
    return replace(lower, base_shear=shear, remarks=remarks)


def _with(pendulum: PendulumWithFriction, spectrum: ElasticSpectrum, structure: Structure) -> Answer:
    steps = iterate(
        pendulum, spectrum, lambda damping: 1.0 / damping_factor(damping), pendulum.effective_damping
    )
    D_M, T_M, beta_M = steps[-1].displacement, steps[-1].period, steps[-1].damping
    return Answer(
        method=NAME,
        displacement=D_M,
        base_shear=pendulum.effective_stiffness(D_M) * D_M,
        period=T_M,
        damping=beta_M,
        steps=steps,
        conditions=_conditions(pendulum, structure, D_M, T_M, beta_M),
        unconfirmed=spectrum.unconfirmed,
    )


def _conditions(
    pendulum: PendulumWithFriction, structure: Structure, D_M: float, T_M: float, beta_M: float
) -> tuple[Condition, ...]:
    softening = pendulum.effective_stiffness(D_M) / pendulum.effective_stiffness(0.2 * D_M)
    restoring = pendulum.force(D_M) - pendulum.force(0.5 * D_M)
    return (
        Condition(
            "effective period T_M",
            at_most(T_M, _LONGEST),
            f"{T_M:.2f} s",
            f"at most {_LONGEST:g} s",
            _SECTION,
        ),
        Condition(
            "effective damping",
            at_most(beta_M, _MOST_DAMPING),
            f"{100 * beta_M:.1f} %",
            "at most 30 %",
            _SECTION,
        ),
        Condition(
            "T_M over the period of the fixed base",
            at_least(T_M, _STIFFER * structure.fixed_base_period),
            "rigid structure"
            if structure.fixed_base_period == 0.0
            else f"{T_M / structure.fixed_base_period:.1f}",
            "at least 3",
            _SECTION,
        ),
        Condition(
            "k_eff(D_M) over k_eff(0.2 D_M)",
            at_least(softening, _SOFTENING),
            f"{softening:.2f}",
            "above 1/3",
            _SECTION,
        ),
        Condition(
            "restoring force, F(D_M) - F(D_M/2) over W",
            at_least(restoring, _RESTORING),
            f"{restoring:.3f}",
            "at least 0.025",
            "17.2.4.4",
        ),
        Condition(
            "height of the structure above",
            Verdict.NOT_KNOWN if structure.height is None else at_most(structure.height, _HEIGHT),
            "not given" if structure.height is None else f"{structure.height / 1e3:.1f} m",
            "at most 65 ft (19.8 m), or four storeys",
            _SECTION,
        ),
        Condition(
            "site class",
            Verdict.NOT_KNOWN
            if structure.site_class is None
            else (Verdict.MET if structure.site_class in "ABCD" else Verdict.NOT_MET),
            structure.site_class or "not given",
            "A, B, C or D",
            _SECTION,
        ),
    )
