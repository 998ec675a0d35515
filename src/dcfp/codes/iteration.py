"""The displacement at which a reduced spectrum and a bearing agree."""

from collections.abc import Callable

from dcfp.codes.equivalent_linear import PendulumWithFriction
from dcfp.codes.result import Step
from dcfp.errors import AnalysisError
from dcfp.spectrum.elastic import ElasticSpectrum, displacement

#: A displacement is found once a round changes it by less than that part [-]; then halving takes over what has not settled.
_SETTLED, _ROUNDS, _HALVINGS = 1e-10, 60, 200
#: Where a solution is looked for [mm].
_LEAST, _LARGEST = 1e-3, 1e5


def iterate(
    pendulum: PendulumWithFriction,
    spectrum: ElasticSpectrum,
    reduction: Callable[[float], float],
    damping: Callable[[float], float],
    start: float = 200.0,
) -> tuple[Step, ...]:
    """Return the rounds of D = S_d(T_eff(D)) times the reduction at the damping of D; the last is the solution.

    The rounds are those of hand calculation, each from the displacement of the one before. Where they go to and fro without settling, the
    interval in which they do is halved instead, and only the solution is returned.

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
        If there is no solution between a micrometre and 100 m.
    """

    def round_from(at: float) -> tuple[Step, float]:
        period, ratio = pendulum.effective_period(at), damping(at)
        factor = reduction(ratio)
        return Step(at, period, ratio, factor), float(displacement(spectrum, period)) * factor

    steps: list[Step] = []
    at = start
    for _ in range(_ROUNDS):
        step, found = round_from(at)
        steps.append(step)
        if abs(found - at) <= _SETTLED * at:
            return tuple(steps)
        at = min(max(found, _LEAST), _LARGEST)
    return (_halved(round_from),)


def _halved(round_from: Callable[[float], tuple[Step, float]]) -> Step:
    low, high = _LEAST, _LARGEST
    if (round_from(low)[1] - low) * (round_from(high)[1] - high) > 0.0:
        msg = "The spectrum and the bearing agree at no displacement; look at the spectrum at long periods."
        raise AnalysisError(msg)
    for _ in range(_HALVINGS):
        middle = (low * high) ** 0.5
        low, high = (middle, high) if round_from(middle)[1] > middle else (low, middle)
        if high / low - 1.0 < _SETTLED:
            break
    return round_from((low * high) ** 0.5)[0]
