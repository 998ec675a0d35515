"""The vertical load of a test."""

from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.system import Bearing

#: Pressures on the slider that a wrong unit would pass [N/mm2].
LEAST_PRESSURE, LARGEST_PRESSURE = 0.1, 1000.0


@dataclass(frozen=True)
class VerticalLoad:
    """A vertical load, linear between its times and constant before and after them.

    Parameters
    ----------
    values
        Pressures on the slider [N/mm2], or forces [N].
    times
        At which they act [s]; increasing; none needed for a constant load.
    is_pressure
        Which of the two the values are.
    """

    values: tuple[float, ...]
    times: tuple[float, ...] = (0.0,)
    is_pressure: bool = True

    def __post_init__(self) -> None:
        if len(self.values) != len(self.times) or not self.values:
            msg = f"A vertical load has {len(self.times)} times but {len(self.values)} values."
            raise InputError(msg)
        if not np.isfinite([*self.values, *self.times]).all() or (np.diff(self.times) <= 0.0).any():
            msg = "The times of a vertical load must increase, and all its numbers must be finite."
            raise InputError(msg)
        if min(self.values) <= 0.0:
            what = "pressure" if self.is_pressure else "vertical force"
            msg = (
                f"The {what} falls to {min(self.values):g}: a sliding bearing takes no tension, so the load"
                " must stay above zero (compression is positive)."
            )
            raise InputError(msg)

    @classmethod
    def force(cls, newton: float) -> "VerticalLoad":
        """Return a constant force [N]."""
        return cls((newton,), is_pressure=False)

    def at(self, time: FloatArray, bearing: Bearing) -> FloatArray:
        """Return the force [N] at times [s].

        Raises
        ------
        InputError
            If the pressure is out of any sensible range, as it is where a unit was wrong.
        """
        factor = bearing.slider_area if self.is_pressure else 1.0
        forces = np.asarray(np.interp(time, self.times, np.array(self.values) * factor))
        check_load(forces, bearing)
        return forces


def check_load(forces: FloatArray, bearing: Bearing) -> None:
    """Refuse vertical forces [N] under which the pressure on the slider is out of any sensible range.

    Raises
    ------
    InputError
        If it is.
    """
    pressures = forces / bearing.slider_area
    for extreme in (float(pressures.min()), float(pressures.max())):
        if not LEAST_PRESSURE <= extreme <= LARGEST_PRESSURE:
            msg = (
                f"A vertical load of {extreme * bearing.slider_area / 1e3:.4g} kN puts {extreme:.3g} N/mm2 on a slider of"
                f" {bearing.slider_diameter:g} mm; from {LEAST_PRESSURE:g} to {LARGEST_PRESSURE:g} N/mm2 is possible:"
                " look at the unit of the load."
            )
            raise InputError(msg)
