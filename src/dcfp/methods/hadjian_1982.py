r"""Where equivalent linear systems fail: Hadjian (1982), A re-evaluation of equivalent linear models for simple yielding systems.

Equivalent periods and dampings such as Iwan's are fitted to recorded earthquakes, in which a yielding system is near its largest displacement for a moment
only. Under a strongly harmonic motion it stays there cycle after cycle: its period is then that of the secant at this very displacement, it may or may not fall
on that of the motion, and the response differs from the estimate by a factor that the estimate cannot know.

The paper could not be read; the measure of how harmonic a motion is, and its limit, are ours.
"""

import numpy as np

from dcfp.analysis import respond
from dcfp.errors import AnalysisError
from dcfp.methods.code import CodeResult
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.check import Check, at_most
from dcfp.system import LI_2020, Bearing, ConstantFriction, NoHeating
from dcfp.system.friction.constant import NOMINAL_COEFFICIENT

NAME = "Hadjian (1982)"
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

    with the Fourier transform A of the ground acceleration: the band of 20 % of its middle frequency that holds most. A measure of ours.

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
        NAME,
        confirmed=False,
    )


def inelastic_over_estimate(
    result: CodeResult,
    motion: GroundMotion,
    bearing: Bearing = LI_2020,
    friction: float = NOMINAL_COEFFICIENT,
) -> float:
    """Return the displacement by response history analysis over that of a result [-], for the same motion, bearing and constant friction [-].

    Only what happens within the motion counts, as in a response spectrum.
    """
    found = respond(motion, bearing, ConstantFriction(friction), NoHeating(), tail=0.0)
    return found.peak_displacement / result.displacement
