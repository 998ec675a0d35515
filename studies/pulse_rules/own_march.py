"""A march from peak to peak, or from node to node, that shares nothing with the package: constant friction, legs and spring at choice.

The ground velocity between two peaks is a straight line or half a cosine. The structure is rigid, sticks or slides with a constant coefficient of
friction, and the pendulum pulls or does not. Steps are so short that the pull may be held at its value in their middle.
"""

import math
from typing import NamedTuple

import numba
import numpy as np
from numpy.typing import NDArray

from dcfp.methods import Nodes, Prediction, Pulses

#: Longest step [s], and longest wait for the structure to rest after the last peak [s].
STEP, REST = 0.002, 120.0


class Choice(NamedTuple):
    """What is in the march.

    Attributes
    ----------
    cosine
        Whether the legs are half cosines, not straight.
    friction
        mu_n g [mm/s2].
    restoring
        Square of the pendulum's angular frequency, g / (2 Rs) [1/s2]; zero for no spring.
    """

    cosine: bool
    friction: float
    restoring: float


def march(pulses: Pulses | Nodes, choice: Choice) -> Prediction:
    """Return largest change of displacement, displacement and energies of a march."""
    change, displacement, most_input, hysteretic = _march(
        pulses.times, pulses.velocities, choice.cosine, choice.friction, choice.restoring
    )
    return Prediction(change, math.sqrt(2.0 * most_input), math.sqrt(2.0 * hysteretic), displacement)


@numba.njit(cache=False)
def _march(
    times: NDArray[np.float64],
    velocities: NDArray[np.float64],
    cosine: bool,
    friction: float,
    restoring: float,
) -> tuple[float, float, float, float]:
    y = v = 0.0
    turn = work = most = 0.0  # displacement at the last turn; input energy since, and its largest
    best_change = best_y = best_most = best_hysteretic = 0.0
    for leg in range(times.size):
        last = leg == times.size - 1
        length = REST if last else times[leg + 1] - times[leg]
        count = math.ceil(length / STEP)
        rise = 0.0 if last else velocities[leg + 1] - velocities[leg]
        for i in range(count):
            left = length / count
            part = 1.0 / count
            if cosine:
                part = 0.5 * (math.cos(math.pi * i / count) - math.cos(math.pi * (i + 1) / count))
            ground = rise * part / left
            for _ in range(4):
                pull = ground + restoring * (y + 0.5 * v * left)
                if v == 0.0:
                    if abs(pull) <= friction:
                        break
                    side = -1.0 if pull > 0.0 else 1.0
                else:
                    side = 1.0 if v > 0.0 else -1.0
                a = -pull - side * friction
                stops = v != 0.0 and (v + a * left) * side <= 0.0
                span = -v / a if stops else left
                travel = v * span + 0.5 * a * span * span
                y += travel
                v = 0.0 if stops else v + a * span
                left -= span
                work -= ground * travel
                most = max(most, work)
                best_y = max(best_y, abs(y))
                best_change = max(best_change, abs(y - turn))
                best_most = max(best_most, most)
                best_hysteretic = max(best_hysteretic, friction * abs(y - turn))
                if stops:
                    turn = y
                    work = most = 0.0
                if left <= 0.0:
                    break
            if last and v == 0.0 and restoring * abs(y) <= friction:
                break
    return best_change, best_y, best_most, best_hysteretic
