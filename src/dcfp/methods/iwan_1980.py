r"""An elastic system in place of a yielding one: Iwan (1980), Estimating inelastic response spectra from elastic spectra.

.. math::
    T_{eq} / T_0 = 1 + 0.121\,(\mu_d - 1)^{0.939}, \qquad
    \zeta_{eq} = \zeta_0 + 0.0587\,(\mu_d - 1)^{0.371}

with the ductility :math:`\mu_d`. The four constants, and that they were fitted to ductilities from 2 to 8, could not be confirmed: no source that
could be read prints them. A friction bearing yields at a fraction of a millimetre, so its ductility is in the hundreds, and every answer says so.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from dcfp.errors import AnalysisError
from dcfp.methods.code import (
    MECHANICS,
    OF_RECORD,
    CodeInputs,
    CodeMethod,
    CodeResult,
    decimals_of,
    millimetres,
)
from dcfp.methods.equivalent_linear import FRICTION, LARGEST, Step, halved, rounds
from dcfp.methods.method import Look
from dcfp.methods.spectra.of_record import DAMPING, LONGEST, SHORTEST, response_spectrum
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.check import Check, Verdict, at_most
from dcfp.schema.formulas import Formula, number
from dcfp.system import LI_2020, Bearing
from dcfp.system.friction.constant import NOMINAL_COEFFICIENT

NAME, HADJIAN = "Iwan (1980)", "Hadjian (1982)"
#: Factor and power of the period, and of the damping [-]; unconfirmed.
PERIOD, DAMPED = (0.121, 0.939), (0.0587, 0.371)
#: Largest ductility of the fit [-]; unconfirmed.
LEAST_DUCTILITY, LARGEST_DUCTILITY = 2.0, 8.0
#: Largest damping of an equivalent oscillator [-]: one with critical damping or more does not oscillate.
MOST_DAMPING = 0.99
#: A displacement is found once a round changes it by less than that part [-].
_SAME = 1e-9
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


@dataclass(frozen=True)
class Bilinear:
    """Springs (a) and (b) of a bearing together, then spring (a) alone; without viscous damping."""

    initial_period: float  #: T_0, of the stiffness kra + kf [s]
    yield_displacement: float  #: r_f = mu N / kf, at which the slider begins to slide [mm]

    @classmethod
    def of(cls, bearing: Bearing, friction: float) -> "Bilinear":
        """Return the system of a bearing and a constant coefficient of friction [-].

        Raises
        ------
        InputError
            If the coefficient is not between 0 and 1.
        """
        mu = FRICTION.checked(friction, "The coefficient of friction")
        stiffness = bearing.restoring_stiffness + bearing.elastic_stiffness
        return cls(
            initial_period=2.0 * math.pi * math.sqrt(bearing.mass / stiffness),
            yield_displacement=mu * bearing.vertical_force / bearing.elastic_stiffness,
        )


def equivalent_oscillator(
    motion: GroundMotion, system: Bilinear, rule: Callable[[float], tuple[float, float]]
) -> tuple[Step, ...]:
    """Return the rounds of D = S_d(T_eq, zeta_eq at the ductility of D) on the motion's own oscillators; the last is the solution.

    They begin with the displacement of the system that does not yield. Where they go to and fro without settling, the interval in which they do is halved
    instead, and only the solution is returned. `rule` gives the equivalent over the initial period and the equivalent damping ratio at a ductility [-].

    Raises
    ------
    AnalysisError
        If there is no solution up to 100 m.
    """

    def round_from(at: float) -> tuple[Step, float]:
        lengthening, zeta = rule(at / system.yield_displacement)
        period = min(max(system.initial_period * lengthening, SHORTEST), LONGEST)
        zeta = min(zeta, MOST_DAMPING)
        at_period = partial(response_spectrum, motion, np.array([period]))
        found, usual = (float(at_period(damping).displacement[0]) for damping in (zeta, DAMPING))
        return Step(at, period, zeta, found / usual if usual > 0.0 else 1.0), found

    steps, is_settled = rounds(round_from, round_from(0.0)[1], _SAME)
    if is_settled:
        return tuple(steps)
    low, high = system.yield_displacement, LARGEST
    if round_from(low)[1] < low or round_from(high)[1] > high:
        msg = f"{motion.name}: no equivalent oscillator moves as far as the ductility it stands for."
        raise AnalysisError(msg)
    return (round_from(halved(lambda at: round_from(at)[1] > at, low, high, _SAME))[0],)


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
    steps = equivalent_oscillator(motion, system, lambda mu: (lengthening(mu), added_damping(mu)))
    last = steps[-1]
    ductility = last.displacement / system.yield_displacement
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
            at_most(last.period, bearing.period),
            f"{last.period:.2f} s",
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
    stiffness = (bearing.restoring_stiffness + bearing.elastic_stiffness) / bearing.vertical_force
    return CodeResult(
        method=NAME,
        displacement=last.displacement,
        base_shear=min(
            friction + last.displacement / bearing.effective_radius, stiffness * last.displacement
        ),
        period=last.period,
        damping=last.damping,
        steps=steps,
        conditions=conditions,
        unconfirmed=UNCONFIRMED,
        remarks=tuple(remarks),
    )


# Where equivalent linear systems fail: Hadjian (1982), A re-evaluation of equivalent linear models for simple yielding systems. Equivalent periods and
# dampings are fitted to recorded earthquakes, in which a yielding system is near its largest displacement for a moment only; under a strongly harmonic motion
# it stays there cycle after cycle. The paper could not be read; the measure of how harmonic a motion is, and its limit, are ours.

#: Half width of the band over its middle frequency [-]: ours.
HALF_WIDTH = 0.1
#: Share from which on a motion counts as strongly harmonic [-]: ours. A sine of three cycles has 0.55, of ten 0.90; the hundred records of FEMA P-695 have 0.10
#: to 0.42.
STRONGLY_HARMONIC = 0.5
#: Length of the transform over that of the motion, so that the band is many lines wide [-], and least number of lines in the motion's duration.
_PADDING = 8


def harmonic_share(motion: GroundMotion) -> tuple[float, float]:
    r"""Return the share of the acceleration's energy in the band around its dominant period [-], and that period [s].

    .. math:: \max_f \int_{0.9 f}^{1.1 f} |A|^2\,df \Big/ \int_0^\infty |A|^2\,df

    with the Fourier transform A of the ground acceleration: the band of 20 % of its middle frequency that holds most.

    Raises
    ------
    AnalysisError
        If the ground does not move.
    """
    samples = _PADDING * motion.acceleration.size
    power = np.abs(np.fft.rfft(motion.acceleration, samples)) ** 2
    frequency = np.fft.rfftfreq(samples, motion.time_step)
    total = float(power.sum())
    if total == 0.0:
        msg = f"{motion.name}: the ground does not move, so it has no dominant period."
        raise AnalysisError(msg)
    edges = np.concatenate(([0.0], frequency + 0.5 * frequency[1]))
    below = np.concatenate(([0.0], np.cumsum(power)))
    upper = np.interp((1.0 + HALF_WIDTH) * frequency, edges, below)
    within = upper - np.interp((1.0 - HALF_WIDTH) * frequency, edges, below)
    place = 1 + int(np.argmax(within[1:]))
    return float(within[place]) / total, 1.0 / float(frequency[place])


def harmonic_condition(motion: GroundMotion) -> Check:
    """Return whether a motion is far enough from harmonic for an equivalent system that was fitted to earthquakes.

    Raises
    ------
    AnalysisError
        If the ground does not move.
    """
    share, period = harmonic_share(motion)
    return Check(
        "share of the motion's energy within 10 % of its dominant frequency",
        at_most(share, STRONGLY_HARMONIC),
        f"{100.0 * share:.0f} % at {period:.2f} s",
        "at most 50 %, a limit of ours",
        HADJIAN,
        confirmed=False,
    )


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


IWAN_1980 = CodeMethod(
    key="iwan",
    name=NAME,
    citations=("iwan_1980", "hadjian_1982"),
    look=Look("*", "blue", 1.2, order=1),
    calculate=_calculate,
    formulas=_formulas,
    needs_record=True,
)
