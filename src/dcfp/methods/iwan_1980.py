r"""An elastic system in place of a yielding one: Iwan (1980), Estimating inelastic response spectra from elastic spectra.

.. math::
    T_{eq} / T_0 = 1 + 0.121\,(\mu_d - 1)^{0.939}, \qquad
    \zeta_{eq} = \zeta_0 + 0.0587\,(\mu_d - 1)^{0.371}

with the ductility :math:`\mu_d`. The four constants, and that they were fitted to ductilities from 2 to 8, could not be confirmed: no source that
could be read prints them. A friction bearing yields at a fraction of a millimetre, so its ductility is in the hundreds, and every answer says so.
"""

from dataclasses import dataclass, replace

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.methods.bilinear import MOST_DAMPING, Bilinear, equivalent_oscillator, secant
from dcfp.methods.hadjian_1982 import harmonic_condition
from dcfp.methods.result import Answer, Step
from dcfp.methods.spectra import EnergySpectrum, input_energy_spectrum
from dcfp.methods.spectra.of_record import DAMPING, LONGEST
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.check import Check, Verdict, at_most
from dcfp.schema.checks import finite
from dcfp.system import LI_2020, Bearing
from dcfp.system.friction.constant import NOMINAL_COEFFICIENT

NAME, SECANT = "Iwan (1980)", "secant stiffness"
#: Factor and power of the period, and of the damping [-]; unconfirmed.
PERIOD, DAMPED = (0.121, 0.939), (0.0587, 0.371)
#: Largest ductility of the fit [-]; unconfirmed.
LEAST_DUCTILITY, LARGEST_DUCTILITY = 2.0, 8.0
UNCONFIRMED = (
    "the constants 0.121, 0.939, 0.0587 and 0.371 of Iwan (1980), and their range of ductility from 2 to 8",
)


def lengthening(ductility: float) -> float:
    """Equivalent over initial period T_eq / T_0 [-] at a ductility [-]; 1 where it does not yield."""
    factor, power = PERIOD
    return 1.0 + factor * max(ductility - 1.0, 0.0) ** power


def added_damping(ductility: float) -> float:
    """Equivalent less initial damping ratio, zeta_eq - zeta_0 [-], at a ductility [-]; 0 where it does not yield."""
    factor, power = DAMPED
    return factor * max(ductility - 1.0, 0.0) ** power


@dataclass(frozen=True, eq=False)
class InelasticEnergySpectrum:
    """Input energies of yielding systems, read off an elastic spectrum; per unit mass.

    Attributes
    ----------
    periods
        Initial periods T_0 [s], shape (n,).
    ductility, damping
        Of the yielding systems, and their initial damping ratio [-].
    elastic
        Spectrum of the ground motion at the equivalent periods and damping, in the same order.
    unconfirmed
        What in it could not be confirmed.
    """

    periods: FloatArray
    ductility: float
    damping: float
    elastic: EnergySpectrum
    unconfirmed: tuple[str, ...] = UNCONFIRMED

    @property
    def equivalent_velocity(self) -> FloatArray:
        """V_E = sqrt(2 E / m) [mm/s], shape (n,)."""
        return self.elastic.equivalent_velocity


def inelastic_input_energy(
    motion: GroundMotion, periods: FloatArray, ductility: float, damping: float = DAMPING
) -> InelasticEnergySpectrum:
    """Return the input energy spectrum of systems that yield to a ductility [-], from the elastic one at T_eq and zeta_eq.

    `periods` are initial periods [s], increasing; `damping` is zeta_0 [-].

    Raises
    ------
    InputError
        If the ductility is below 1, or an equivalent period or damping is not that of an oscillator.
    """
    if finite(ductility, "ductility", "-") < 1.0:
        msg = f"The ductility must be at least 1, not {ductility!r}."
        raise InputError(msg)
    initial = np.atleast_1d(np.asarray(periods, dtype=np.float64))
    equivalent, zeta = initial * lengthening(ductility), damping + added_damping(ductility)
    if not (np.isfinite(equivalent).all() and (equivalent <= LONGEST).all() and zeta <= MOST_DAMPING):
        msg = (
            f"At a ductility of {ductility:g} the equivalent system has periods up to {np.max(equivalent, initial=0.0):.3g} s and a damping of"
            f" {100.0 * zeta:.0f} %; periods up to {LONGEST:g} s and less than critical damping can be looked up."
        )
        raise InputError(msg)
    return InelasticEnergySpectrum(
        initial, ductility, damping, input_energy_spectrum(motion, equivalent, zeta)
    )


def equivalent_linear(
    motion: GroundMotion, bearing: Bearing = LI_2020, friction: float = NOMINAL_COEFFICIENT
) -> Answer:
    """Return the displacement at which the motion's own oscillator of T_eq and zeta_eq moves as far as the ductility it stands for.

    `friction` is a constant coefficient [-]. A friction bearing that slides never meets the conditions: its ductility is far outside the fit.

    Raises
    ------
    InputError
        If the coefficient is not between 0 and 1.
    AnalysisError
        If there is no such displacement up to 100 m, or the ground does not move.
    """
    system = Bilinear.of(bearing, friction)
    harmonic = harmonic_condition(motion)
    steps = equivalent_oscillator(motion, system, lambda _, mu: (lengthening(mu), added_damping(mu)))
    T_eq, ductility = steps[-1].period, steps[-1].displacement / system.yield_displacement
    conditions = (
        Check(
            "ductility, displacement over yield displacement",
            Verdict.NOT_KNOWN if ductility < LEAST_DUCTILITY else at_most(ductility, LARGEST_DUCTILITY),
            f"{ductility:.0f}" if ductility >= 100.0 else f"{ductility:.3g}",
            "at most 8, fitted from 2 to 8",
            NAME,
            confirmed=False,
        ),
        Check(
            "equivalent period",
            at_most(T_eq, bearing.period),
            f"{T_eq:.2f} s",
            f"at most {bearing.period:.2f} s, the pendulum's without friction",
            "mechanics: no secant is softer than the second slope",
        ),
        harmonic,
    )
    remarks: list[str] = []
    zeta = added_damping(ductility)
    if zeta > MOST_DAMPING:
        remarks.append(
            f"The formula gives a damping of {100.0 * zeta:.0f} % of critical, which no oscillator has; {100.0 * MOST_DAMPING:.0f} % was taken."
        )
    wanted = system.initial_period * lengthening(ductility)
    if wanted > LONGEST:
        remarks.append(
            f"The formula gives a period of {wanted:.0f} s; {LONGEST:.0f} s, the longest, was taken."
        )
    answer = _answer(NAME, bearing, friction, steps)
    return replace(answer, conditions=conditions, unconfirmed=UNCONFIRMED, remarks=tuple(remarks))


def secant_linear(
    motion: GroundMotion, bearing: Bearing = LI_2020, friction: float = NOMINAL_COEFFICIENT
) -> Answer:
    """Return the same with the secant stiffness and the loop's damping in place of Iwan's constants, to compare; arguments and errors as there."""
    steps = equivalent_oscillator(motion, Bilinear.of(bearing, friction), secant)
    return _answer(SECANT, bearing, friction, steps)


def _answer(method: str, bearing: Bearing, friction: float, steps: tuple[Step, ...]) -> Answer:
    last = steps[-1]
    stiffness = (bearing.restoring_stiffness + bearing.elastic_stiffness) / bearing.vertical_force
    force = friction + last.displacement / bearing.effective_radius
    return Answer(
        method=method,
        displacement=last.displacement,
        base_shear=min(force, stiffness * last.displacement),
        period=last.period,
        damping=last.damping,
        steps=steps,
    )


def input_velocity(motion: GroundMotion, answer: Answer) -> float:
    """V_E = sqrt(2 E / m) [mm/s] of the equivalent system of an answer under the ground motion it is of.

    Raises
    ------
    InputError
        If the answer has no equivalent period and damping.
    """
    if answer.period is None or answer.damping is None:
        msg = f"{answer.method}: an input energy needs an equivalent period and damping, which this answer does not have."
        raise InputError(msg)
    spectrum = input_energy_spectrum(motion, np.array([answer.period]), answer.damping)
    return float(spectrum.equivalent_velocity[0])
