"""What the methods of codes take of a spectrum: the pseudo-acceleration at a damping of 5 %."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.schema.notebook import fields_card


class ElasticSpectrum(Protocol):
    """An elastic spectrum at a damping of 5 %."""

    @property
    def name(self) -> str:
        """What to call it."""
        ...

    @property
    def unconfirmed(self) -> tuple[str, ...]:
        """What in it could not be confirmed in its source; nothing where all could."""
        ...

    def acceleration(self, period: ArrayLike) -> FloatArray:
        """Pseudo-acceleration S_a [mm/s2] at a period [s]."""
        ...


def displacement(spectrum: ElasticSpectrum, period: ArrayLike) -> FloatArray:
    """Spectral displacement S_d = S_a (T / 2 pi)^2 [mm] at a period [s]."""
    return spectrum.acceleration(period) * (np.asarray(period) / (2.0 * np.pi)) ** 2


def velocity(spectrum: ElasticSpectrum, period: ArrayLike) -> FloatArray:
    """Pseudo-velocity S_v = S_a T / 2 pi [mm/s] at a period [s]."""
    return spectrum.acceleration(period) * np.asarray(period) / (2.0 * np.pi)


@dataclass(frozen=True, eq=False)
class TabulatedSpectrum:
    """Pseudo-accelerations at periods, with straight lines between their logarithms.

    Below the first period the acceleration is that of the first, beyond the last the displacement is that of the last.

    Parameters
    ----------
    periods
        [s], increasing, shape (n,).
    accelerations
        Pseudo-acceleration at a damping of 5 % [mm/s2], positive, shape (n,).
    name
        What to call it.

    Raises
    ------
    InputError
        If there are fewer than two periods, or a value is not positive, or the periods do not increase.
    """

    periods: FloatArray
    accelerations: FloatArray
    name: str = "spectrum"
    unconfirmed: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        periods = np.asarray(self.periods, dtype=np.float64)
        values = np.asarray(self.accelerations, dtype=np.float64)
        if periods.ndim != 1 or periods.size < 2 or periods.shape != values.shape:
            msg = f"{self.name}: a spectrum needs at least two periods, and an acceleration for each."
            raise InputError(msg)
        good = np.isfinite(periods).all() and np.isfinite(values).all()
        if not (good and (periods > 0.0).all() and (values > 0.0).all() and (np.diff(periods) > 0.0).all()):
            msg = f"{self.name}: periods and accelerations of a spectrum must be positive, and the periods increase."
            raise InputError(msg)
        object.__setattr__(self, "periods", freeze(periods))
        object.__setattr__(self, "accelerations", freeze(values))

    def acceleration(self, period: ArrayLike) -> FloatArray:
        """Pseudo-acceleration [mm/s2] at a period [s]."""
        wanted = np.asarray(period, dtype=np.float64)
        within = np.clip(wanted, self.periods[0], self.periods[-1])
        found = np.exp(np.interp(np.log(within), np.log(self.periods), np.log(self.accelerations)))
        beyond = np.maximum(wanted / self.periods[-1], 1.0)
        return np.asarray(found / beyond**2)

    def _repr_html_(self) -> str:
        return fields_card(self, f"Spectrum {self.name}")
