"""A bearing as a bilinear system, and the oscillator that moves as far as the ductility it stands for."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from dcfp.errors import AnalysisError
from dcfp.methods.result import Step
from dcfp.methods.spectra import response_spectrum
from dcfp.methods.spectra.of_record import DAMPING, LONGEST, SHORTEST
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.checks import fraction
from dcfp.system import Bearing

#: Largest damping of an equivalent oscillator [-]: one with critical damping or more does not oscillate.
MOST_DAMPING = 0.99
#: A displacement is found once a round changes it by less than that part [-]; then halving takes over what has not settled.
_SETTLED, _ROUNDS, _HALVINGS = 1e-9, 60, 200
#: Up to where a solution is looked for [mm].
_LARGEST = 1e5


@dataclass(frozen=True)
class Bilinear:
    """Springs (a) and (b) of a bearing together, then spring (a) alone; without viscous damping.

    Attributes
    ----------
    initial_period
        T_0, of the stiffness kra + kf [s].
    yield_displacement
        r_f = mu N / kf, at which the slider begins to slide [mm].
    hardening
        Second stiffness over the first, kra / (kra + kf) [-].
    """

    initial_period: float
    yield_displacement: float
    hardening: float

    @classmethod
    def of(cls, bearing: Bearing, friction: float) -> "Bilinear":
        """Return the system of a bearing and a constant coefficient of friction [-].

        Raises
        ------
        InputError
            If the coefficient is not between 0 and 1.
        """
        mu = fraction(friction, "coefficient of friction")
        stiffness = bearing.restoring_stiffness + bearing.elastic_stiffness
        return cls(
            initial_period=2.0 * math.pi * math.sqrt(bearing.mass / stiffness),
            yield_displacement=mu * bearing.vertical_force / bearing.elastic_stiffness,
            hardening=bearing.restoring_stiffness / stiffness,
        )


#: Equivalent over initial period, and equivalent damping ratio, of a system at a ductility [-].
Rule = Callable[[Bilinear, float], tuple[float, float]]


def secant(system: Bilinear, ductility: float) -> tuple[float, float]:
    r"""Return the rule of the secant stiffness and the loop's area, which follows from the mechanics without a fit.

    .. math::
        \frac{T_{eq}}{T_0} = \sqrt{\frac{\mu_d}{1 + \alpha (\mu_d - 1)}}, \qquad
        \zeta_{eq} = \frac2\pi \frac{(1 - \alpha)(\mu_d - 1)}{\mu_d\,(1 + \alpha (\mu_d - 1))}
    """
    mu, alpha = max(ductility, 1.0), system.hardening
    force = 1.0 + alpha * (mu - 1.0)
    return math.sqrt(mu / force), 2.0 / math.pi * (1.0 - alpha) * (mu - 1.0) / (mu * force)


def equivalent_oscillator(motion: GroundMotion, system: Bilinear, rule: Rule) -> tuple[Step, ...]:
    """Return the rounds of D = S_d(T_eq, zeta_eq at the ductility of D) on the motion's own oscillators; the last is the solution.

    They begin with the displacement of the system that does not yield, which is the answer where it stays below yielding. Where the rounds go to and fro
    without settling, the interval in which they do is halved instead, and only the solution is returned. Periods end at 100 s, and dampings at 0.99.

    Raises
    ------
    AnalysisError
        If there is no solution up to 100 m.
    """

    def round_from(at: float) -> tuple[Step, float]:
        lengthening, zeta = rule(system, at / system.yield_displacement)
        period = min(max(system.initial_period * lengthening, SHORTEST), LONGEST)
        zeta = min(zeta, MOST_DAMPING)
        found, usual = _displacement(motion, period, zeta), _displacement(motion, period, DAMPING)
        return Step(at, period, zeta, found / usual if usual > 0.0 else 1.0), found

    at = round_from(0.0)[1]
    steps: list[Step] = []
    for _ in range(_ROUNDS):
        step, found = round_from(at)
        steps.append(step)
        if abs(found - at) <= _SETTLED * at:
            return tuple(steps)
        at = min(found, _LARGEST)
    low, high = system.yield_displacement, _LARGEST
    if round_from(low)[1] < low or round_from(high)[1] > high:
        msg = f"{motion.name}: no equivalent oscillator moves as far as the ductility it stands for."
        raise AnalysisError(msg)
    for _ in range(_HALVINGS):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if round_from(middle)[1] > middle else (low, middle)
        if high / low - 1.0 < _SETTLED:
            break
    return (round_from(math.sqrt(low * high))[0],)


def _displacement(motion: GroundMotion, period: float, damping: float) -> float:
    return float(response_spectrum(motion, np.array([period]), damping).displacement[0])
