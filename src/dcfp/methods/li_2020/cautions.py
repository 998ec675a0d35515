"""Where a ground motion makes a method that takes pulses for straight lines unreliable: ours, with the evidence in ``docs/prediction.md``."""

from collections.abc import Callable

import numpy as np

from dcfp.methods.li_2020.constants import Constants
from dcfp.methods.prediction import Ground, Methods
from dcfp.methods.pulses import PulsePrediction, Pulses
from dcfp.motion.ground_motion import GroundMotion

#: A plateau: part of the change between two peaks within which the ground velocity rests, and of the time between them from which on it does [-].
PLATEAU_BAND, PLATEAU_SHARE = 0.2, 0.6
#: Ripples: part of the threshold of a pulse down to which they are counted too, and the factor on dy from which on they matter [-].
RIPPLE_PART, RIPPLE_FACTOR = 0.25, 1.5
#: Points of a leg at which its velocity is taken.
_POINTS = 201


def cautions(
    method: str,
    ground: Ground,
    methods: Methods,
    said: PulsePrediction,
    predict: Callable[[Pulses, Constants], PulsePrediction],
) -> tuple[str, ...]:
    """Return a sentence for each reason why what a method has `said` of a record is unreliable; `predict` says it of other pulses."""
    motion, i = ground.motion, said.governing
    if motion is None or i is None:
        return ()
    constants, pulses = methods.constants, said.pulses
    found: list[str] = []
    ratio = constants.friction_deceleration / abs(float(pulses.mean_accelerations[i]))
    if ratio >= constants.amplified_from:
        found.append(
            f"its governing pulse has a ku/kg of {ratio:.2f} (unreliable from {constants.amplified_from:g} on, where it is hardly decided"
            " whether the structure slides)"
        )
    rest = max(rest_share(motion, *pulses.times[first : first + 2].tolist()) for first in (i, i + 1))
    if rest > PLATEAU_SHARE:
        found.append(
            f"before or after the peak of its governing pulse the ground velocity has a plateau, within {PLATEAU_BAND:g} of its change for"
            f" {rest:.2f} of the time (unreliable from {PLATEAU_SHARE:g} on), where the method has a straight line"
        )
    least = RIPPLE_PART * methods.threshold
    before = said.largest.displacement_change
    after = predict(ground.pulses(least), constants).largest.displacement_change
    if max(before, after) > RIPPLE_FACTOR * min(before, after):
        found.append(
            f"with ripples down to {least:g} PGV as peaks it is {after:.0f} mm in place of {before:.0f} mm (unreliable from a factor of"
            f" {RIPPLE_FACTOR:g} on)"
        )
    return tuple(f"{motion.name}: dy by the {method} method is unreliable, since {why}." for why in found)


def rest_share(motion: GroundMotion, start: float, end: float) -> float:
    """Part of the time from one peak to the next [s] for which the ground velocity is within `PLATEAU_BAND` of its change, wherever that is most [-].

    0.2 of a straight line, 0.3 of half a cosine.
    """
    times = np.linspace(start, end, _POINTS)
    speeds = np.sort(np.interp(times, motion.time, motion.velocity))
    band = PLATEAU_BAND * float(speeds[-1] - speeds[0])
    last = np.asarray(np.searchsorted(speeds, speeds + band, side="right"), dtype=np.int64)
    return int((last - np.arange(_POINTS)).max()) / _POINTS
