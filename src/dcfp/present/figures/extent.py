"""How much of a history is worth showing."""

from typing import TYPE_CHECKING, TypeAlias, TypeGuard

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dcfp.analysis import Response
    from dcfp.analysis.rig import Loops

    #: What has a displacement, a force, friction and temperature over time.
    History: TypeAlias = Response | Loops

#: Part of the hysteretic energy, or of the peak velocity of the ground, below which nothing of note happens [-].
_LITTLE = 0.001
_QUIET = 0.05
#: Part of the time at the start that has to be quiet before it is left out [-].
_LONG_START = 0.2


def shown(history: "History") -> slice:
    """Return the samples in which something happens; of a test all of them.

    Those of an analysis end a little after the last thousandth of the hysteretic energy, or after the ground has become quiet where
    nothing slides; a long quiet start is left out.
    """
    samples = int(history.time.size)
    if not _is_response(history):
        return slice(0, samples)
    places = np.flatnonzero(_busy(history))
    if places.size < 2:
        return slice(0, samples)
    first, last = int(places[0]), int(places[-1])
    margin = 2 + (last - first) // 12
    start = max(0, first - margin) if first > _LONG_START * last else 0
    return slice(start, min(samples, last + margin))


def _is_response(history: "History") -> "TypeGuard[Response]":
    return hasattr(history, "motion")


def _busy(response: "Response") -> "NDArray[np.bool_]":
    dissipated = response.energy.hysteretic
    whole = float(dissipated[-1])
    if whole > 0.0:
        return (dissipated > _LITTLE * whole) & (dissipated < (1.0 - _LITTLE) * whole)
    ground = np.abs(response.ground_velocity)
    return ground > _QUIET * float(ground.max())


def line_width(history: "History") -> float:
    """Return the width [pt] at which the waves of a history stay apart."""
    part = shown(history)
    span = float(history.time[part.stop - 1] - history.time[part.start])
    return 0.9 if span < 25.0 else 0.7 if span < 60.0 else 0.5
