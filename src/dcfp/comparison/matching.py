"""Which pulse of the ground a swing of the structure belongs to."""

import numpy as np

from dcfp.prediction.pulses import Pulses
from dcfp.response.swings import Swing


def pulse_behind(swing: Swing, pulses: Pulses) -> int | None:
    """Return the number of the pulse that caused a swing, counted from zero; None where there is none.

    While the ground velocity rises to a peak the structure stays behind, so that y falls, and it goes on falling until some time after the peak.
    The pulse of a swing therefore has its peak within the swing and the sign opposite to the swing's; of several the one with the largest
    velocity change is meant. There is none where ripples below the threshold, or the pendulum alone, have moved the structure.
    """
    if swing.change == 0.0:
        return None
    fits = (swing.start <= pulses.peaks) & (pulses.peaks <= swing.end)
    fits &= np.sign(pulses.changes) == -np.sign(swing.change)
    if not fits.any():
        return None
    return int(np.argmax(np.where(fits, np.abs(pulses.changes), 0.0)))
