"""Bearings as equivalent linear systems, and the displacement at which the system moves as far as it stands for.

A pendulum with Coulomb friction follows from the rigid-plastic loop, and meets a reduced spectrum of a code; a bilinear one has springs (a) and (b), and meets the motion's own oscillators.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from dcfp.arrays import freeze
from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import AnalysisError
from dcfp.methods.spectra.elastic import ElasticSpectrum, displacement
from dcfp.methods.spectra.of_record import DAMPING, LONGEST, SHORTEST, response_spectrum
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.checks import fraction, positive
from dcfp.system import Bearing


@dataclass(frozen=True)
class Step:
    """One round of an iteration.

    Attributes
    ----------
    displacement
        It began with [mm].
    period
        Effective period [s].
    damping
        Effective damping ratio [-].
    reduction
        Factor on the spectrum at a damping of 5 % [-].
    """

    displacement: float
    period: float
    damping: float
    reduction: float


@dataclass(frozen=True)
class PendulumWithFriction:
    """What the methods of codes take of a bearing: F / W = mu + D / R.

    Parameters
    ----------
    radius
        Effective radius R, 2 Rs for two equal plates [mm].
    friction
        Coefficient mu [-].
    """

    radius: float
    friction: float

    def __post_init__(self) -> None:
        positive(self.radius, "effective radius", "mm")
        fraction(self.friction, "coefficient of friction")

    @property
    def free_frequency(self) -> float:
        """Circular frequency of the pendulum without friction, sqrt(g / R) [rad/s]."""
        return math.sqrt(STANDARD_GRAVITY / self.radius)

    @property
    def free_period(self) -> float:
        """Period of the pendulum without friction [s]."""
        return 2.0 * math.pi / self.free_frequency

    def force(self, displacement: float) -> float:
        """Force over the weight at a displacement [mm], mu + D / R [-]."""
        return self.friction + displacement / self.radius

    def effective_stiffness(self, displacement: float) -> float:
        """Secant stiffness over the weight at a displacement [mm], 1/R + mu/D [1/mm]."""
        return 1.0 / self.radius + self.friction / displacement

    def effective_period(self, displacement: float) -> float:
        """Period of the secant stiffness at a displacement [mm], in s."""
        return 2.0 * math.pi / math.sqrt(STANDARD_GRAVITY * self.effective_stiffness(displacement))

    def effective_damping(self, displacement: float) -> float:
        """Damping ratio of the loop at a displacement [mm], (2/pi) mu / (mu + D/R) [-]."""
        return 2.0 / math.pi * self.friction / self.force(displacement)

    @property
    def rest(self) -> float:
        """Largest displacement at which it can stay at rest, mu R [mm]."""
        return self.friction * self.radius


# The displacement at which a reduced spectrum and a bearing agree.


#: A displacement is found once a round changes it by less than that part [-]; what has not settled is looked for by changes of sign.
_SETTLED, _ROUNDS, _HALVINGS = 1e-10, 60, 60
#: Where a solution is looked for [mm].
_LEAST, _LARGEST = 1e-3, 1e5


#: Ratio of two agreements from which on they are not the same [-].
_OTHER = 1.02
#: Displacements between which a change of sign is looked for [mm].
_GRID = freeze(np.geomspace(0.5, 2e4, 160))
#: Ratio of two of them.
_STEP = float(_GRID[1] / _GRID[0])


def iterate(
    pendulum: PendulumWithFriction,
    spectrum: ElasticSpectrum,
    reduction: Callable[[float], float],
    damping: Callable[[float], float],
    start: float = 200.0,
) -> tuple[Step, ...]:
    """Return the rounds of D = S_d(T_eff(D)) times the reduction at the damping of D; the last is the solution.

    The rounds are those of hand calculation, each from the displacement of the one before. Where the spectrum and the bearing agree at
    several displacements the largest is the solution; where the rounds do not come to it, because they settle at another or go to and fro, it alone is returned.

    Parameters
    ----------
    pendulum
        The bearing.
    spectrum
        At a damping of 5 %.
    reduction
        Factor [-] at a damping ratio [-].
    damping
        Damping ratio [-] at a displacement [mm].
    start
        Displacement to begin with [mm].

    Raises
    ------
    AnalysisError
        If there is no solution.
    """
    round_from = _round(pendulum, spectrum, reduction, damping)
    known = agreements(pendulum, spectrum, reduction, damping)
    steps: list[Step] = []
    at = start
    for _ in range(_ROUNDS):
        step, found = round_from(at)
        steps.append(step)
        if abs(found - at) <= _SETTLED * at:
            if known and known[-1] > _OTHER * at:
                break
            return tuple(steps)
        at = min(max(found, _LEAST), _LARGEST)
    if not known:
        msg = "The spectrum and the bearing agree at no displacement; look at the spectrum at long periods."
        raise AnalysisError(msg)
    return (_settled(round_from, known[-1]),)


def agreements(
    pendulum: PendulumWithFriction,
    spectrum: ElasticSpectrum,
    reduction: Callable[[float], float],
    damping: Callable[[float], float],
) -> list[float]:
    """Return every displacement from 0.5 mm to 20 m at which the reduced spectrum and the bearing agree [mm], but for two that are closer than 7 %."""
    periods = 2.0 * np.pi / np.sqrt(STANDARD_GRAVITY * (1.0 / pendulum.radius + pendulum.friction / _GRID))
    factors = np.array([reduction(damping(at)) for at in _GRID.tolist()])
    with np.errstate(divide="ignore"):
        over = np.log(displacement(spectrum, periods) * factors / _GRID)
    at = np.flatnonzero((over[:-1] > 0.0) != (over[1:] > 0.0))
    share = over[at] / (over[at] - over[at + 1])
    return (_GRID[at] * (_GRID[at + 1] / _GRID[at]) ** share).tolist()


def several(found: Sequence[float], steps: Sequence[Step]) -> tuple[str, ...]:
    """Return remarks where there is more than one agreement [mm] to choose from, and where the rounds did not come to the one taken."""
    remarks: list[str] = []
    if len(found) > 1:
        words = ", ".join(f"{at:.0f}" for at in found)
        remarks.append(
            f"The spectrum and the bearing agree at {len(found)} displacements, {words} mm; the largest is taken."
        )
    if len(steps) == 1:
        remarks.append(
            "The rounds of the iteration do not come to this displacement; it was found by changes of sign."
        )
    return tuple(remarks)


def _round(
    pendulum: PendulumWithFriction,
    spectrum: ElasticSpectrum,
    reduction: Callable[[float], float],
    damping: Callable[[float], float],
) -> Callable[[float], tuple[Step, float]]:
    """Return what makes a round from a displacement [mm]: the round, and the displacement that it comes to."""

    def round_from(at: float) -> tuple[Step, float]:
        period, ratio = pendulum.effective_period(at), damping(at)
        factor = reduction(ratio)
        return Step(at, period, ratio, factor), float(displacement(spectrum, period)) * factor

    return round_from


def _settled(round_from: Callable[[float], tuple[Step, float]], near: float) -> Step:
    """Return the round at the agreement near a displacement [mm], to the last digit."""
    low, high = near / _STEP, near * _STEP
    falls = round_from(low)[1] > low
    for _ in range(_HALVINGS):
        middle = (low * high) ** 0.5
        low, high = (middle, high) if (round_from(middle)[1] > middle) == falls else (low, middle)
        if high / low - 1.0 < _SETTLED:
            break
    return round_from((low * high) ** 0.5)[0]


# A bearing as a bilinear system, and the oscillator that moves as far as the ductility it stands for.


#: Largest damping of an equivalent oscillator [-]: one with critical damping or more does not oscillate.
MOST_DAMPING = 0.99
#: A displacement is found once a round changes it by less than that part [-]; then halving takes over what has not settled.
_SAME, _BILINEAR_HALVINGS = 1e-9, 200


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
        if abs(found - at) <= _SAME * at:
            return tuple(steps)
        at = min(found, _LARGEST)
    low, high = system.yield_displacement, _LARGEST
    if round_from(low)[1] < low or round_from(high)[1] > high:
        msg = f"{motion.name}: no equivalent oscillator moves as far as the ductility it stands for."
        raise AnalysisError(msg)
    for _ in range(_BILINEAR_HALVINGS):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if round_from(middle)[1] > middle else (low, middle)
        if high / low - 1.0 < _SAME:
            break
    return (round_from(math.sqrt(low * high))[0],)


def _displacement(motion: GroundMotion, period: float, damping: float) -> float:
    return float(response_spectrum(motion, np.array([period]), damping).displacement[0])
