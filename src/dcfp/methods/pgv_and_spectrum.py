r"""The design method with one more number: the spectral velocity at the period of the isolated structure. Ours, on Eqs (29)-(33) of Li et al. (2020).

The velocity change of the largest pulse is :math:`\zeta\,\mathrm{PGV}` in Eq. (29), with one zeta for every earthquake. What pushes the bearing is the part of the PGV that is at long periods, so here

.. math:: \zeta = 1.34 \left(\frac{S_v(T_e)}{\mathrm{PGV}}\right)^{0.4}, \qquad T_e = 2 \pi \sqrt{\frac{W}{k_{\mathrm{eff}}(\Delta y)\,g}}

with the pseudo-velocity S_v at 5 % of damping, and the secant period of the bearing at the change of displacement that is predicted, by iteration. Both numbers are fitted to the
hundred components of FEMA P-695 at four PGVs, to no bias in the mean of the logarithms of dy; ``docs/prediction.md`` has the scatter, also on other sets.
"""

import math
from dataclasses import replace
from typing import Any

from scipy import optimize

from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.methods.li_2020.constants import Constants
from dcfp.methods.li_2020.simplified_method import predict_from_pgv
from dcfp.methods.method import Information, Look
from dcfp.methods.prediction import Ground, Methods, Predicted, PredictionMethod
from dcfp.methods.pulses import Prediction
from dcfp.methods.spectra.elastic import ElasticSpectrum, velocity
from dcfp.schema.formulas import Formula, number

NAME = "design with spectrum"
#: The factor and the power of zeta [-].
FACTOR, POWER = 1.34, 0.4
#: Changes of displacement between which the one is looked for whose secant period it belongs to [mm].
_SEARCHED = (1e-3, 1e5)
_SOURCE = "Li et al. (2020), Eqs (29)-(33), with a zeta by the spectrum (ours)"

_optimize: Any = optimize


def spectral_change_ratio(spectrum: ElasticSpectrum, pgv: float, period: float) -> float:
    """Return zeta [-] by a spectrum at the secant period [s] and a PGV [mm/s]."""
    return FACTOR * (float(velocity(spectrum, period)) / pgv) ** POWER


def predict_with_spectrum(
    pgv: float, spectrum: ElasticSpectrum, effective_radius: float, constants: Constants
) -> tuple[Prediction, float] | None:
    """Return what the largest pulse of an earthquake with a PGV [mm/s] and a spectrum does, and the secant period [s]; None where none goes with the spectrum.

    Parameters
    ----------
    effective_radius
        Of the bearing [mm].

    Raises
    ------
    InputError
        If the PGV is not positive, or mu_n g is not below kg_ave.
    """
    pendulum = PendulumWithFriction(effective_radius, constants.nominal_friction)

    def at(change: float) -> tuple[Prediction, float]:
        period = pendulum.effective_period(change)
        ratio = spectral_change_ratio(spectrum, pgv, period)
        return predict_from_pgv(pgv, replace(constants, change_ratio=ratio)), period

    def excess(logarithm: float) -> float:
        said, _ = at(math.exp(logarithm))
        return math.log(max(said.displacement_change, 1e-300)) - logarithm

    low, high = (math.log(one) for one in _SEARCHED)
    if excess(low) <= 0.0 or excess(high) >= 0.0:
        return None
    return at(math.exp(_optimize.brentq(excess, low, high, xtol=1e-10)))


def _predicted(ground: Ground, methods: Methods) -> tuple[Prediction, float] | None:
    if ground.spectrum is None or not (methods.constants.slides_on_average and ground.pgv > 0.0):
        return None
    radius = methods.system.bearing.effective_radius
    return predict_with_spectrum(ground.pgv, ground.spectrum, radius, methods.constants)


def _predict(ground: Ground, methods: Methods) -> Predicted | None:
    found = _predicted(ground, methods)
    return None if found is None else Predicted(found[0])


def _formulas(ground: Ground, methods: Methods) -> tuple[Formula, ...]:
    """Return the method with its numbers; nothing where it cannot be used."""
    found = _predicted(ground, methods)
    if found is None or ground.spectrum is None:
        return ()
    said, period = found
    ratio = spectral_change_ratio(ground.spectrum, ground.pgv, period)
    spectral = float(velocity(ground.spectrum, period))
    k_u = methods.constants.friction_deceleration
    return (
        Formula("Ratio of the velocity change of the largest pulse to the PGV", 'zeta = 1.34 (S_v (T_e) / "PGV")^0.4', f"{FACTOR:g} times ({number(spectral, 1)} / {number(ground.pgv, 1)})^{POWER:g}", ratio, 3, "", _SOURCE),
        Formula("Change of displacement", 'Delta y = V_(Delta E "hr")^2 / (2 k_u)', f"{number(said.hysteretic_velocity, 1)}^2 / (2 times {number(k_u, 1)})", said.displacement_change, 1, "mm", _SOURCE),
    )  # fmt: skip


DESIGN_WITH_SPECTRUM = PredictionMethod(
    key="design_with_spectrum",
    name=NAME,
    head="design+S",
    knows=(Information.SPECTRUM,),
    citations=("li_2020",),
    look=Look("D", "grey", 1.1, order=2),
    predict=_predict,
    formulas=_formulas,
)
