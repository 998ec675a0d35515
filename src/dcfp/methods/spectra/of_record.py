"""Elastic response spectra and input energy spectra of records: Akiyama (1985), Uang and Bertero (1988)."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray, freeze, integral
from dcfp.errors import InputError
from dcfp.kernels import oscillator as k
from dcfp.methods.spectra.elastic import TabulatedSpectrum
from dcfp.motion.ground_motion import GroundMotion, refined
from dcfp.motion.load import Motion, motion_of
from dcfp.schema.notebook import fields_card
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import M_PER_S, M_PER_S2, MM, MM2_PER_S2, MM_PER_S, MM_PER_S2, SECOND

#: Periods of a spectrum unless others are asked for [s].
PERIODS = freeze(np.geomspace(0.05, 10.0, 200))
#: Ratio of critical damping unless another is asked for [-].
DAMPING = 0.05
#: Steps in a period, below which the record's own step is divided: with them the largest displacement is within 0.7 % of that with many
#: more in the worst of 20 000 cases, and within 0.002 % in half of them.
_STEPS_IN_PERIOD = 10
#: Steps in a period from which on the largest displacement is looked for at the samples alone; in the worst of those cases it is within 0.25 %.
_SLOW = 100
#: Number of oscillators that a processor takes at once; what does not fill it costs as if it did.
_AT_ONCE = 8
#: Angle in a step up to which the response is summed as a series of so many terms, to the last digit.
_SERIES, _TERMS = 0.5, 16
#: Least and longest period [s].
SHORTEST, LONGEST = 0.01, 100.0


def checked(periods: FloatArray, damping: float) -> FloatArray:
    """Return periods as an array, if they and the damping may be those of a spectrum."""
    values = np.atleast_1d(np.asarray(periods, dtype=np.float64))
    if values.ndim != 1 or values.size == 0 or not np.isfinite(values).all():
        msg = "A spectrum needs a row of periods, each a finite number of seconds."
        raise InputError(msg)
    if values[0] < SHORTEST or values[-1] > LONGEST or (np.diff(values) <= 0.0).any():
        msg = (
            f"The periods of a spectrum must increase, from {SHORTEST:g} s at least to {LONGEST:g} s at most."
        )
        raise InputError(msg)
    if not 0.0 <= damping < 1.0:
        msg = f"The damping must be a ratio of critical damping from 0 to below 1, not {damping!r}."
        raise InputError(msg)
    return values


@lru_cache(maxsize=64)
def coefficients(periods: bytes, damping: float, step: float) -> FloatArray:
    """Return the kernel's coefficients for a step [s], shape (COEFFICIENTS, periods): exact for an acceleration that is linear over it."""
    omega = 2.0 * np.pi / np.frombuffer(periods, dtype=np.float64)
    damped = omega * np.sqrt(1.0 - damping**2)
    fade = np.exp(-damping * omega * step)
    sine, cosine = fade * np.sin(damped * step), fade * np.cos(damped * step)
    rows = np.empty((k.COEFFICIENTS, omega.size))
    # free vibration from a displacement and from a velocity
    rows[k.UU] = cosine + damping * omega / damped * sine
    rows[k.UV] = sine / damped
    rows[k.VU] = -(omega**2) * rows[k.UV]
    rows[k.VV] = cosine - damping * omega / damped * sine
    # response to an acceleration of one, and to one that grows from zero to one over the step
    risen = 1.0 - rows[k.UU]
    constant, growing = _series(omega * step, damping)
    slow = omega * step < _SERIES
    rows[k.UA] = -np.where(slow, constant, risen) / omega**2
    ramp = 1.0 - (rows[k.UV] + 2.0 * damping / omega * risen) / step
    rows[k.UC] = -np.where(slow, growing, ramp) / omega**2
    rows[k.VA] = -rows[k.UV]
    rows[k.VC] = rows[k.UA] / step
    rows[k.SQUARE] = omega**2
    rows[k.DAMPING] = 2.0 * damping * omega
    return freeze(rows)


def _series(angle: FloatArray, damping: float) -> tuple[FloatArray, FloatArray]:
    """Return omega squared times the response to a constant and to a growing acceleration [-], where the closed form would cancel.

    `angle` is omega times the step. The impulse response is a power series whose coefficients follow from the equation of motion.
    """
    constant, growing = np.zeros_like(angle), np.zeros_like(angle)
    before, one = 0.0, 1.0  # coefficients of the powers n - 1 and n
    power = angle**2
    for n in range(1, _TERMS):
        constant += one * power / (n + 1)
        growing += one * power / ((n + 1) * (n + 2))
        before, one = one, -(2.0 * damping * n * one + before) / (n * (n + 1))
        power = power * angle
    return constant, growing


def pieces(time_step: float, periods: FloatArray) -> list[tuple[slice, int]]:
    """Return groups of periods, and into how many parts the record's step is divided for each; none where the samples themselves suffice.

    A group ends where the processor's registers are full, so that some periods get a finer step than they need.
    """
    least = np.ceil(_STEPS_IN_PERIOD * time_step / periods * (1.0 - 1e-12))
    parts = (2 ** np.ceil(np.log2(np.maximum(least, 1.0)))).astype(np.int64)
    parts[periods >= _SLOW * time_step] = 0
    ends = -(-(np.flatnonzero(np.diff(parts)) + 1) // _AT_ONCE) * _AT_ONCE
    edges = [0, *np.unique(ends[ends < periods.size]).tolist(), periods.size]
    return [(slice(a, b), int(parts[a])) for a, b in pairwise(edges)]


def _marched(motion: GroundMotion, periods: FloatArray, damping: float, *, with_energy: bool) -> FloatArray:
    """Return the state of every oscillator after the motion, shape (ROWS, periods); without energies only its largest displacement counts."""
    found = np.empty((k.ROWS, periods.size))
    for part, parts in pieces(motion.time_step, periods):
        step = motion.time_step / max(parts, 1)
        acceleration = refined(motion.acceleration, parts)
        rows = coefficients(periods[part].tobytes(), damping, step)
        state = np.zeros((k.ROWS, periods[part].size))
        if with_energy:
            k.respond_with_energy(rows, step, acceleration, integral(acceleration, step), state)
        else:
            k.respond_all(rows, step if parts else None, acceleration, state)
        found[:, part] = state
    return found


#: Acceleration in place of none, of which there is no logarithm [mm/s2].
_LEAST = 1e-9


@dataclass(frozen=True, eq=False)
class ResponseSpectrum:
    """The largest response of elastic oscillators to a ground motion."""

    periods: FloatArray = field(metadata={"unit": SECOND})  #: [s], shape (n,)
    damping: float  #: ratio of critical damping [-]
    displacement: FloatArray  #: spectral displacement S_d [mm], shape (n,)
    name: str = "record"  #: what to call it
    unconfirmed: tuple[str, ...] = ()

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
    motion: Motion, periods: FloatArray = PERIODS, damping: float = DAMPING
) -> ResponseSpectrum:
    """Return the response spectrum of a ground motion, by the exact solution for acceleration that is linear between samples.

    Parameters
    ----------
    motion
        A ground motion, the name of a record or a file; what oscillates on after its end does not count.
    periods
        [s], increasing.
    damping
        Ratio of critical damping [-].

    Raises
    ------
    InputError
        If a period or the damping is out of range, or the motion is a station, of which `station_spectrum` is.
    """
    motion = motion_of(motion, vertical=True)
    periods = checked(periods, damping)
    largest = _marched(motion, periods, damping, with_energy=False)[k.PEAK_U]
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


@dataclass(frozen=True, eq=False)
class EnergySpectrum:
    """Energies that a ground motion puts into elastic oscillators, per unit mass; all arrays have the shape (n,)."""

    periods: FloatArray = field(metadata={"unit": SECOND})  #: [s]
    damping: float  #: ratio of critical damping [-]
    final: FloatArray = field(metadata={"unit": MM2_PER_S2})  #: relative, at the end of the motion [mm2/s2]
    relative: FloatArray = field(metadata={"unit": MM2_PER_S2})  #: largest at any time [mm2/s2]
    absolute: FloatArray = field(metadata={"unit": MM2_PER_S2})  #: largest at any time [mm2/s2]
    displacement: FloatArray  #: largest, relative [mm]
    velocity: FloatArray  #: largest, relative [mm/s]
    total_acceleration: FloatArray = field(metadata={"unit": MM_PER_S2})  #: largest [mm/s2]
    name: str = "record"

    @property
    def equivalent_velocity(self) -> FloatArray:
        """V_E = sqrt(2 E / m) of the largest relative input energy [mm/s], shape (n,): Akiyama (1985)."""
        return np.sqrt(2.0 * self.relative)

    def _repr_html_(self) -> str:
        return fields_card(self, f"Input energy spectra of {self.name}")


def input_energy_spectrum(
    motion: Motion, periods: FloatArray = PERIODS, damping: float = DAMPING
) -> EnergySpectrum:
    """Return the input energy spectra of a ground motion; arguments and errors as for `response_spectrum`.

    The relative input energy, - integral of a_g dv over the relative displacement, is in closed form between samples; the absolute one, the work of the
    ground on the oscillator, is more by v_g (v_g / 2 + v) for each unit of mass.
    """
    motion = motion_of(motion, vertical=True)
    periods = checked(periods, damping)
    found = _marched(motion, periods, damping, with_energy=True)
    return EnergySpectrum(
        periods=freeze(periods),
        damping=damping,
        final=freeze(found[k.INPUT]),
        relative=freeze(found[k.PEAK_INPUT]),
        absolute=freeze(found[k.PEAK_ABSOLUTE]),
        displacement=freeze(found[k.PEAK_U]),
        velocity=freeze(found[k.PEAK_V]),
        total_acceleration=freeze(found[k.PEAK_A]),
        name=motion.name,
    )


class Ordinates(NamedTuple):
    """The spectra of a ground motion at one period [s, mm, mm2/s2]."""

    motion: GroundMotion
    period: float
    displacement: float
    relative: float
    absolute: float

    @property
    def frequency(self) -> float:
        """Circular frequency [1/s]."""
        return 2.0 * math.pi / self.period


def ordinates(motion: GroundMotion, spectrum: EnergySpectrum) -> list[Ordinates]:
    """Return the spectra of a motion at every period."""
    columns = (spectrum.periods, spectrum.displacement, spectrum.relative, spectrum.absolute)
    return [Ordinates(motion, *row) for row in np.column_stack(columns).tolist()]


ORDINATES = [
    Quantity("record", "name of the ground motion", head="Record", get="motion.name"),
    Quantity("pgv_m_s", "peak ground velocity", M_PER_S, decimals=3, places=12, name="pgv", head="PGV", get="motion.peak_velocity"),
    Quantity("period_s", "period", SECOND, digits=3, name="period", head="T", get="period"),
    Quantity("S_d_mm", "spectral displacement", MM, decimals=1, name="S_d", get="displacement"),
    Quantity("S_v_mm_s", "pseudo-velocity", MM_PER_S, M_PER_S, 3, name="S_v", get=lambda one: one.displacement * one.frequency),
    Quantity("S_a_mm_s2", "pseudo-acceleration", MM_PER_S2, M_PER_S2, 3, name="S_a", get=lambda one: one.displacement * one.frequency**2),
    Quantity("V_E_mm_s", "equivalent velocity of the relative input energy", MM_PER_S, M_PER_S, 3, name="V_E", get=lambda one: (2.0 * one.relative) ** 0.5),
    Quantity("V_E_absolute_mm_s", "equivalent velocity of the absolute input energy", MM_PER_S, M_PER_S, 3, name="V_E_absolute", head="V_E abs.", get=lambda one: (2.0 * one.absolute) ** 0.5),
]  # fmt: skip
