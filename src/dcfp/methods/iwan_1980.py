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
from dcfp.errors import AnalysisError, InputError
from dcfp.methods.code import (
    MECHANICS,
    OF_RECORD,
    CodeInputs,
    CodeMethod,
    CodeResult,
    decimals_of,
    millimetres,
)
from dcfp.methods.equivalent_linear import MOST_DAMPING, Bilinear, Step, equivalent_oscillator, secant
from dcfp.methods.hadjian_1982 import harmonic_condition
from dcfp.methods.method import Look, register
from dcfp.methods.spectra import EnergySpectrum, input_energy_spectrum
from dcfp.methods.spectra.of_record import DAMPING, LONGEST
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.check import Check, Verdict, at_most
from dcfp.schema.checks import finite
from dcfp.schema.formulas import Formula, number
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
) -> CodeResult:
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
    result = _result(NAME, bearing, friction, steps)
    return replace(result, conditions=conditions, unconfirmed=UNCONFIRMED, remarks=tuple(remarks))


def secant_linear(
    motion: GroundMotion, bearing: Bearing = LI_2020, friction: float = NOMINAL_COEFFICIENT
) -> CodeResult:
    """Return the same with the secant stiffness and the loop's damping in place of Iwan's constants, to compare; arguments and errors as there."""
    steps = equivalent_oscillator(motion, Bilinear.of(bearing, friction), secant)
    return _result(SECANT, bearing, friction, steps)


def _result(method: str, bearing: Bearing, friction: float, steps: tuple[Step, ...]) -> CodeResult:
    last = steps[-1]
    stiffness = (bearing.restoring_stiffness + bearing.elastic_stiffness) / bearing.vertical_force
    force = friction + last.displacement / bearing.effective_radius
    return CodeResult(
        method=method,
        displacement=last.displacement,
        base_shear=min(force, stiffness * last.displacement),
        period=last.period,
        damping=last.damping,
        steps=steps,
    )


def input_velocity(motion: GroundMotion, result: CodeResult) -> float:
    """V_E = sqrt(2 E / m) [mm/s] of the equivalent system of a result under the ground motion it is of.

    Raises
    ------
    InputError
        If the result has no equivalent period and damping.
    """
    if result.period is None or result.damping is None:
        msg = f"{result.method}: an input energy needs an equivalent period and damping, which this result does not have."
        raise InputError(msg)
    spectrum = input_energy_spectrum(motion, np.array([result.period]), result.damping)
    return float(spectrum.equivalent_velocity[0])


def _calculate(inputs: CodeInputs) -> CodeResult:
    if inputs.motion is None or inputs.bearing is None:
        msg = f"{NAME} needs a record and a bearing, not a spectrum alone."
        raise AnalysisError(msg)
    return equivalent_linear(inputs.motion, inputs.bearing, inputs.pendulum.friction)


def _formulas(result: CodeResult, inputs: CodeInputs) -> tuple[Formula, ...]:
    if inputs.bearing is None:
        return ()
    system, D = Bilinear.of(inputs.bearing, inputs.pendulum.friction), result.displacement
    ductility = result.steps[-1].displacement / system.yield_displacement
    digits = 1 if ductility >= 100.0 else 3
    (factor, power), (added, damped) = PERIOD, DAMPED
    T_eq, zeta_eq = result.period or 0.0, result.damping or 0.0
    start, d = number(system.initial_period, 5), number(ductility, digits)
    is_capped = added_damping(ductility) > zeta_eq + 1e-9
    is_longest = system.initial_period * lengthening(ductility) > T_eq * (1.0 + 1e-9)
    period = "" if is_longest else f"{start} times (1 + {factor:g} times ({d} - 1)^{power:g})"
    damping = "" if is_capped else f"{added:g} times ({d} - 1)^{damped:g}"
    return (
        Formula("Period before yielding", 'T_0 = 2 pi sqrt(m / (k_"ra" + k_f))', "", system.initial_period, 5, "s", MECHANICS),
        Formula("Ductility", "mu_d = D / r_f", f"{millimetres(D)} / {number(system.yield_displacement, 5)}", ductility, digits, "", NAME),
        Formula("Equivalent period", f'T_"eq" = T_0 (1 + {factor:g} (mu_d - 1)^{power:g})', period, T_eq, 3, "s", NAME, confirmed=False),
        Formula("Equivalent damping, less than critical", f'zeta_"eq" = {added:g} (mu_d - 1)^{damped:g}', damping, zeta_eq, 4, "", NAME, confirmed=False),
        Formula("Displacement of this oscillator under the record", "D", "", D, decimals_of(D), "mm", OF_RECORD),
    )  # fmt: skip


IWAN_1980 = register(
    CodeMethod(
        key="iwan",
        name=NAME,
        citations=("iwan_1980", "hadjian_1982"),
        look=Look("*", "blue", 1.2, order=1),
        calculate=_calculate,
        formulas=_formulas,
        needs_record=True,
    )
)
