"""Between which intensities each record first exceeds a capacity."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray


@dataclass(frozen=True, eq=False)
class FirstExceedance:
    """For each record the intensities between which it first exceeds a capacity, in their unit.

    Attributes
    ----------
    lower
        The highest intensity before, shape (records,); 0 where there is none.
    upper
        The first intensity at which it exceeds; infinity where it never does.
    returns
        How many records are within the capacity again at a higher intensity.
    """

    lower: FloatArray
    upper: FloatArray
    returns: int

    def reason(self, shown: Callable[[float], str]) -> str:
        """Return why no lognormal distribution can be fitted to all of them, as the end of a sentence; empty if it can.

        `shown` writes an intensity with its unit.
        """
        number = self.upper.size
        if not np.isfinite(self.upper).any():
            return (
                f"none of the {number} records exceeds it up to {shown(self.lower.min())},"
                " which is only a lower bound of the median"
            )
        if not (self.lower > 0.0).any():
            return f"all of the {number} records exceed it at {shown(self.upper.max())}, the lowest intensity, already"
        first, last = float(self.lower.max()), float(self.upper.min())
        if first <= last:
            between = f"between {shown(first)} and {shown(last)}" if first < last else f"about {shown(first)}"
            return f"the intensities are too far apart to see a dispersion {between}; add some there"
        if not ((self.lower > 0.0) & np.isfinite(self.upper)).any():
            return (
                f"the records exceed it at the lowest intensity or not at all up to {shown(first)};"
                " widen the range of the intensities"
            )
        return ""


def first_exceedance(intensities: FloatArray, values: FloatArray, capacity: float) -> FirstExceedance:
    """Return between which intensities each record first exceeds a capacity.

    Parameters
    ----------
    intensities
        Increasing, shape (i,).
    values
        Of the quantity, shape (records, i); what is not a number is not known, and widens the interval. A record of which nothing is known is left out.
    capacity
        In the unit of the quantity.
    """
    lower: list[float] = []
    upper: list[float] = []
    returns = 0
    for row in values:
        known = np.isfinite(row)
        if not known.any():
            continue
        at, exceeds = intensities[known], row[known] > capacity
        first = int(np.argmax(exceeds)) if exceeds.any() else at.size
        lower.append(float(at[first - 1]) if first > 0 else 0.0)
        upper.append(float(at[first]) if first < at.size else np.inf)
        returns += not exceeds[first:].all()
    return FirstExceedance(np.array(lower), np.array(upper), returns)
