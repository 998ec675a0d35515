"""Elastic response spectra of records."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.kernels import oscillators as k
from dcfp.methods.spectra.elastic import TabulatedSpectrum
from dcfp.methods.spectra.oscillators import DAMPING, PERIODS, checked, coefficients, pieces
from dcfp.motion.ground_motion import GroundMotion, refined
from dcfp.schema.notebook import fields_card

#: Acceleration in place of none, of which there is no logarithm [mm/s2].
_LEAST = 1e-9


@dataclass(frozen=True, eq=False)
class ResponseSpectrum:
    """The largest response of elastic oscillators to a ground motion.

    Attributes
    ----------
    periods
        [s], shape (n,).
    damping
        Ratio of critical damping [-].
    displacement
        Spectral displacement S_d [mm], shape (n,).
    name
        What to call it.
    """

    periods: FloatArray
    damping: float
    displacement: FloatArray
    name: str = "record"
    unconfirmed: tuple[str, ...] = ()

    @property
    def pseudo_velocity(self) -> FloatArray:
        """Pseudo-velocity S_v = omega S_d [mm/s], shape (n,)."""
        return self.displacement * (2.0 * np.pi / self.periods)

    @property
    def pseudo_acceleration(self) -> FloatArray:
        """Pseudo-acceleration S_a = omega^2 S_d [mm/s2], shape (n,)."""
        return self.displacement * (2.0 * np.pi / self.periods) ** 2

    def acceleration(self, period: ArrayLike) -> FloatArray:
        """Pseudo-acceleration [mm/s2] at a period [s], interpolated."""
        return self._table.acceleration(period)

    @cached_property
    def _table(self) -> TabulatedSpectrum:
        return TabulatedSpectrum(self.periods, np.maximum(self.pseudo_acceleration, _LEAST), self.name)

    def _repr_html_(self) -> str:
        return fields_card(self, f"Response spectrum of {self.name}")


def response_spectrum(
    motion: GroundMotion, periods: FloatArray = PERIODS, damping: float = DAMPING
) -> ResponseSpectrum:
    """Return the response spectrum of a ground motion, by the exact solution for acceleration that is linear between samples.

    Parameters
    ----------
    motion
        The ground motion; what oscillates on after its end does not count.
    periods
        [s], increasing.
    damping
        Ratio of critical damping [-].

    Raises
    ------
    InputError
        If a period or the damping is out of range.
    """
    periods = checked(periods, damping)
    largest = np.empty(periods.size)
    for part, parts in pieces(motion, periods):
        step = motion.time_step / max(parts, 1)
        run = k.respond_all if parts else k.respond_slowly
        state = np.zeros((k.ROWS, periods[part].size))
        run(
            coefficients(np.ascontiguousarray(periods[part]), damping, step),
            step,
            refined(motion.acceleration, parts),
            state,
        )
        largest[part] = state[k.PEAK_U]
    return ResponseSpectrum(freeze(periods), damping, freeze(largest), motion.name)


def spectrum_of_set(spectra: Sequence[ResponseSpectrum], part: float | None = None) -> ResponseSpectrum:
    """Return the geometric mean of spectra, or the displacement that a `part` [-] of them stays below, period by period.

    Raises
    ------
    InputError
        If there is none, or they differ in periods or damping, or the part is not between 0 and 1.
    """
    if not spectra:
        msg = "A spectrum of a set needs at least one spectrum."
        raise InputError(msg)
    first = spectra[0]
    if any(one.damping != first.damping or not np.array_equal(one.periods, first.periods) for one in spectra):
        msg = "The spectra of a set must have the same periods and the same damping."
        raise InputError(msg)
    values = np.array([one.displacement for one in spectra])
    if part is None:
        middle, words = np.exp(np.log(np.maximum(values, 1e-12)).mean(axis=0)), "geometric mean"
    elif 0.0 < part < 1.0:
        middle, words = np.quantile(values, part, axis=0), f"{100.0 * part:g} % below"
    else:
        msg = f"The part of the spectra must lie between 0 and 1, not {part!r}."
        raise InputError(msg)
    return ResponseSpectrum(first.periods, first.damping, freeze(middle), f"{words} of {len(spectra)}")
