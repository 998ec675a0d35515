"""Which pulse of the ground a swing of the structure belongs to."""

import numpy as np

from dcfp.analysis.swings import Swing
from dcfp.methods.pulses import Pulses

#: Part of a swing that lies in the rise of a pulse, from which on the pulse is behind it even if it has its peak later [-].
_MOST = 0.5


def pulse_behind(swing: Swing, pulses: Pulses) -> int | None:
    """Return the number of the pulse that caused a swing, counted from zero; None where there is none.

    While the ground velocity rises to a peak the structure stays behind, so that y falls, and it goes on falling until it has caught up,
    as a rule some time after the peak. The pulse of a swing therefore has the sign opposite to the swing's, and its peak within the swing; or, where the
    structure catches up before the peak, at least half of the swing in its rise. Of several the one with the largest velocity change is meant. There is
    none where ripples below the threshold, or the pendulum alone, have moved the structure.
    """
    if swing.change == 0.0:
        return None
    peak_within = (swing.start <= pulses.peaks) & (pulses.peaks <= swing.end)
    together = np.minimum(swing.end, pulses.peaks) - np.maximum(swing.start, pulses.starts)
    fits = peak_within | (together >= _MOST * (swing.end - swing.start))
    fits &= np.sign(pulses.changes) == -np.sign(swing.change)
    if not fits.any():
        return None
    return int(np.argmax(np.where(fits, np.abs(pulses.changes), 0.0)))
