"""Bearings as equivalent linear systems, and the displacement at which the system moves as far as it stands for."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from dcfp.arrays import freeze
from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import AnalysisError
from dcfp.methods.spectra.elastic import ElasticSpectrum, displacement
from dcfp.schema.declared import Declared, declared
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import MM
from dcfp.system.friction.law import coefficient_parameter


@dataclass(frozen=True)
class Step:
    """One round of an iteration."""

    displacement: float  #: that it began with [mm]
    period: float  #: effective period [s]
    damping: float  #: effective damping ratio [-]
    reduction: float  #: factor on the spectrum at a damping of 5 % [-]


#: A constant coefficient of friction.
FRICTION = coefficient_parameter("coefficient of friction", r"\mu")


@declared
class PendulumWithFriction(Declared):
    """What the methods of codes take of a bearing: F / W = mu + D / R."""

    radius: Annotated[
        float, Parameter("effective radius, 2 Rs for two equal plates", MM, 0.0, symbol="R", above=True)
    ]
    friction: Annotated[float, FRICTION]

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


#: Rounds of hand calculation at most, and halvings of an interval.
_ROUNDS, _HALVINGS = 60, 200
#: A displacement is found once a round changes it by less than that part [-].
_SETTLED = 1e-10
#: Where a solution is looked for [mm].
LEAST, LARGEST = 1e-3, 1e5
#: Ratio of two agreements from which on they are not the same [-].
_OTHER = 1.02
#: Displacements between which a change of sign is looked for [mm], and the ratio of two of them [-].
_GRID = freeze(np.geomspace(0.5, 2e4, 160))
_STEP = float(_GRID[1] / _GRID[0])

#: From a displacement [mm] the round that begins with it, and the displacement that it comes to [mm].
Round = Callable[[float], tuple[Step, float]]


def rounds(round_from: Round, start: float, settled: float, least: float = 0.0) -> tuple[list[Step], bool]:
    """Return rounds, each from the displacement of the one before, and whether the last changed it by less than a part [-].

    `start` and the `least` displacement to begin a round with [mm].
    """
    steps: list[Step] = []
    at = start
    for _ in range(_ROUNDS):
        step, found = round_from(at)
        steps.append(step)
        if abs(found - at) <= settled * at:
            return steps, True
        at = min(max(found, least), LARGEST)
    return steps, False


def halved(is_low: Callable[[float], bool], low: float, high: float, part: float = 0.0) -> float:
    """Return the number up to which something holds, between two positive ones, to a part of it [-]: zero for the last digit."""
    for _ in range(_HALVINGS):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if is_low(middle) else (low, middle)
        if high / low - 1.0 < part:
            break
    return math.sqrt(low * high)


def iterate(
    pendulum: PendulumWithFriction,
    spectrum: ElasticSpectrum,
    reduction: Callable[[float], float],
    part: float = 1.0,
    start: float = 200.0,
) -> tuple[tuple[Step, ...], tuple[str, ...]]:
    """Return the rounds of D = S_d(T_eff(D)) times the reduction at the damping of D, the last of which is the solution, and remarks on them.

    Where the spectrum and the bearing agree at several displacements the largest is the solution; where the rounds, which are those of hand calculation, do
    not come to it, because they settle at another or go to and fro, it alone is returned.

    Parameters
    ----------
    pendulum
        The bearing.
    spectrum
        At a damping of 5 %.
    reduction
        Factor [-] at a damping ratio [-].
    part
        Part of the damping of the loop that counts [-].
    start
        Displacement to begin with [mm].

    Raises
    ------
    AnalysisError
        If there is no solution.
    """

    def round_from(at: float) -> tuple[Step, float]:
        period, damping = pendulum.effective_period(at), part * pendulum.effective_damping(at)
        factor = reduction(damping)
        return Step(at, period, damping, factor), float(displacement(spectrum, period)) * factor

    known = _agreements(pendulum, spectrum, lambda at: reduction(part * pendulum.effective_damping(at)))
    steps, is_settled = rounds(round_from, start, _SETTLED, LEAST)
    remarks: list[str] = []
    if len(known) > 1:
        words = ", ".join(f"{at:.0f}" for at in known)
        remarks.append(
            f"The spectrum and the bearing agree at {len(known)} displacements, {words} mm; the largest is taken."
        )
    if not is_settled or (known and known[-1] > _OTHER * steps[-1].displacement):
        if not known:
            msg = (
                "The spectrum and the bearing agree at no displacement; look at the spectrum at long periods."
            )
            raise AnalysisError(msg)
        low, high = known[-1] / _STEP, known[-1] * _STEP
        falls = round_from(low)[1] > low
        steps = [round_from(halved(lambda at: (round_from(at)[1] > at) == falls, low, high, _SETTLED))[0]]
    if len(steps) == 1:
        remarks.append(
            "The rounds of the iteration do not come to this displacement; it was found by changes of sign."
        )
    return tuple(steps), tuple(remarks)


def _agreements(
    pendulum: PendulumWithFriction, spectrum: ElasticSpectrum, factor: Callable[[float], float]
) -> list[float]:
    """Return every displacement from 0.5 mm to 20 m at which the spectrum times a factor at it and the bearing agree [mm], but for two that are closer than 7 %."""
    periods = 2.0 * np.pi / np.sqrt(STANDARD_GRAVITY * (1.0 / pendulum.radius + pendulum.friction / _GRID))
    factors = np.array([factor(at) for at in _GRID.tolist()])
    with np.errstate(divide="ignore"):
        over = np.log(displacement(spectrum, periods) * factors / _GRID)
    at = np.flatnonzero((over[:-1] > 0.0) != (over[1:] > 0.0))
    share = over[at] / (over[at] - over[at + 1])
    return (_GRID[at] * (_GRID[at + 1] / _GRID[at]) ** share).tolist()
