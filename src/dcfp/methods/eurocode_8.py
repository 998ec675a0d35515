"""The simplified linear analysis of Eurocode 8: EN 1998-1:2004, sections 10.9.2 and 10.9.3; re-centring after EN 1998-2:2005, 7.7.1.

The standards themselves were not read. Spectrum and damping correction agree in independent programs. The equation of d_dc, the torsion and most conditions are
those of the Italian NTC 2018, 7.10.5, the twin of section 10.9, and so not confirmed for Eurocode 8 itself. For gamma_x, the distance to a fault, re-centring
and the accumulation of residual displacements nothing was found.
"""

import math

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.methods.equivalent_linear import PendulumWithFriction, agreements, iterate, several
from dcfp.methods.result import Answer, Structure
from dcfp.methods.spectra.elastic import ElasticSpectrum
from dcfp.schema.check import Check, Verdict, at_least, at_most

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
    pendulum: PendulumWithFriction,
    spectrum: ElasticSpectrum,
    structure: Structure | None = None,
    yield_displacement: float = 0.2,
) -> Answer:
    """Return the displacement d_dc and the base shear: section 10.9.3.

    Parameters
    ----------
    pendulum, spectrum
        The bearing, and the spectrum at a damping of 5 %.
    structure
        What the conditions ask of the building and its site.
    yield_displacement
        d_y of the bearing [mm]; it matters only where the bearing does not re-centre.

    Raises
    ------
    AnalysisError
        If the iteration has no solution.
    """
    structure = Structure() if structure is None else structure
    steps = iterate(pendulum, spectrum, damping_correction, pendulum.effective_damping)
    d_dc, T_eff, xi = steps[-1].displacement, steps[-1].period, steps[-1].damping
    factor = accumulation_factor(d_dc, yield_displacement, pendulum.rest)
    known = agreements(pendulum, spectrum, damping_correction, pendulum.effective_damping)
    remarks = [
        *several(known, steps),
        f"The devices are to be designed for {RELIABILITY:g} d_dc, {RELIABILITY * d_dc:.0f} mm (10.3(2)).",
    ]
    if factor > 1.0:
        remarks.append(
            f"The bearing does not re-centre by EN 1998-2, 7.7.1: residual displacements add up by a factor of {factor:.2f}."
        )
    return Answer(
        method=NAME,
        displacement=d_dc,
        base_shear=pendulum.force(d_dc),
        period=T_eff,
        damping=xi,
        steps=steps,
        conditions=_conditions(pendulum, structure, d_dc, T_eff, xi),
        unconfirmed=(*spectrum.unconfirmed, *UNCONFIRMED, *((_ACCUMULATION,) if factor > 1.0 else ())),
        remarks=tuple(remarks),
    )


def _conditions(
    pendulum: PendulumWithFriction, structure: Structure, d_dc: float, T_eff: float, xi: float
) -> tuple[Check, ...]:
    ratio = pendulum.effective_stiffness(d_dc) / pendulum.effective_stiffness(0.2 * d_dc)
    rise = pendulum.force(d_dc) - pendulum.force(0.5 * d_dc)
    return (
        Check(
            "K_eff(d_dc) over K_eff(0.2 d_dc)",
            at_least(ratio, _STIFFNESS_RATIO),
            f"{ratio:.2f}",
            "at least 0.5",
            "10.9.2(5)a",
            confirmed=False,
        ),
        Check(
            "effective damping",
            at_most(xi, _MOST_DAMPING),
            f"{100 * xi:.1f} %",
            "at most 30 %",
            "10.9.2(5)b",
            confirmed=False,
        ),
        Check(
            "change of the force with rate and vertical load",
            Verdict.NOT_KNOWN,
            "not looked at; friction that depends on speed, load and heat seldom meets it",
            "at most 10 %",
            "10.9.2(5)c",
            confirmed=False,
        ),
        Check(
            "rise of the force from d_dc/2 to d_dc over the weight",
            at_least(rise, _RESTORING),
            f"{rise:.3f}",
            "at least 0.025",
            "10.9.2(5)d",
            confirmed=False,
        ),
        Check(
            "effective period",
            at_most(T_eff, _LONGEST),
            f"{T_eff:.2f} s",
            "at most 3 s",
            "10.9.3(2)c",
            confirmed=False,
        ),
        Check(
            "effective period over that of the fixed base",
            *structure.over_fixed_base(T_eff, _STIFFER),
            "at least 3",
            "10.9.3(2)c",
            confirmed=False,
        ),
        Check(
            "larger dimension of the plan",
            Verdict.NOT_KNOWN if structure.plan is None else at_most(structure.plan, _PLAN),
            "not given" if structure.plan is None else f"{structure.plan / 1e3:.0f} m",
            "at most 50 m",
            "10.9.3(2)b",
            confirmed=False,
        ),
        Check(
            "distance to a fault of magnitude 6.5 or more",
            Verdict.NOT_KNOWN
            if structure.fault_distance is None
            else at_least(structure.fault_distance, _FAULT),
            "not given" if structure.fault_distance is None else f"{structure.fault_distance / 1e6:.0f} km",
            "above 15 km",
            "10.9.3(2)a",
            confirmed=False,
        ),
        Check(
            "re-centring, d_dc over mu R",
            at_least(d_dc / pendulum.rest, _RECENTRING),
            f"{d_dc / pendulum.rest:.2f}",
            "at least 0.5",
            "EN 1998-2, 7.7.1",
            confirmed=False,
        ),
    )
