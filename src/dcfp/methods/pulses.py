"""Velocity pulses of a ground motion: Li et al. (2020), section 6.1.1."""

import math
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.kernels.pulses import find_extremes, find_turning_points
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import Motion, motion_of
from dcfp.motion.station import Station
from dcfp.schema.notebook import card, fields_card
from dcfp.schema.parameters import Parameter
from dcfp.schema.quantities import Quantities, Quantity
from dcfp.schema.units import FRACTION, MM_PER_S, SECOND

#: How far the ground velocity must turn back for a peak to count, and what is usual; see ``docs/prediction.md`` for the evidence.
TURN = Parameter(
    "part of PGV by which the ground velocity must turn back for a peak to count",
    FRACTION,
    0.0,
    1.0,
    above=True,
)
THRESHOLD = 0.2


def scaled_velocities(velocities: FloatArray, factor: float, noun: str) -> FloatArray:
    """Return the velocities of pulses or nodes, as the `noun` says, multiplied by `factor` [-].

    Raises
    ------
    InputError
        If the factor is zero or not a finite number.
    """
    if not math.isfinite(factor) or factor == 0.0:
        msg = f"{noun} can be scaled by a finite number other than zero, not by {factor!r}."
        raise InputError(msg)
    return velocities * factor


@dataclass(frozen=True, eq=False)
class Pulses:
    """Successive peaks of a ground velocity, up and down in turn.

    Pulse i goes from the peak before, vg_(i-1), over its own, vg_i, to the next one, vg_(i+1), so that there are two
    pulses fewer than peaks. The arrays below have an entry for each pulse.
    """

    times: FloatArray = field(metadata={"unit": SECOND})  #: of the peaks [s], shape (n,), increasing
    velocities: FloatArray = field(metadata={"unit": MM_PER_S})  #: of the ground there [mm/s], shape (n,)
    threshold: float = THRESHOLD  #: part of PGV by which the velocity had to turn back [-]

    def __post_init__(self) -> None:
        times = np.asarray(self.times, dtype=np.float64)
        velocities = np.asarray(self.velocities, dtype=np.float64)
        if times.ndim != 1 or times.shape != velocities.shape:
            msg = f"The peaks need as many times as velocities, not {times.size} and {velocities.size}."
            raise InputError(msg)
        if not (
            np.isfinite(times).all() and np.isfinite(velocities).all() and (times[1:] > times[:-1]).all()
        ):
            msg = "The times of the peaks must be finite and increase, and their velocities be finite."
            raise InputError(msg)
        rises = velocities[1:] - velocities[:-1]
        if (rises[1:] * rises[:-1] >= 0.0).any() or (rises == 0.0).any():
            msg = "The peaks must go up and down in turn."
            raise InputError(msg)
        object.__setattr__(self, "times", freeze(times))
        object.__setattr__(self, "velocities", freeze(velocities))

    @property
    def count(self) -> int:
        """Number of pulses."""
        return max(self.times.size - 2, 0)

    @property
    def starts(self) -> FloatArray:
        """Times of the peaks before [s], shape (count,)."""
        return self.times[: self.count]

    @property
    def peaks(self) -> FloatArray:
        """Times of the pulses' own peaks [s], shape (count,)."""
        return self.times[1 : 1 + self.count]

    @property
    def ends(self) -> FloatArray:
        """Times of the peaks after [s], shape (count,)."""
        return self.times[2 : 2 + self.count]

    @property
    def changes(self) -> FloatArray:
        """Differences dvg_i [mm/s], shape (count,): Eq. (14)."""
        return self.velocities[1 : 1 + self.count] - self.velocities[: self.count]

    @property
    def mean_accelerations(self) -> FloatArray:
        """Slopes kg_i before the peaks [mm/s2], shape (count,): Eq. (18)."""
        return self.changes / (self.peaks - self.starts)

    @property
    def next_mean_accelerations(self) -> FloatArray:
        """Slopes kg_(i+1) after the peaks [mm/s2], shape (count,): Eq. (18)."""
        return (self.velocities[2:] - self.velocities[1 : 1 + self.count]) / (self.ends - self.peaks)

    def scaled(self, factor: float) -> "Pulses":
        """Return the pulses of the same motion multiplied by `factor` [-].

        Raises
        ------
        InputError
            If the factor is zero or not a finite number.
        """
        return replace(self, velocities=scaled_velocities(self.velocities, factor, "Pulses"))

    def _repr_html_(self) -> str:
        rows = [
            {"peak [s]": time, "velocity [mm/s]": velocity}
            for time, velocity in zip(self.times.tolist(), self.velocities.tolist(), strict=True)
        ]
        return card(f"{self.count} velocity pulses", {"threshold": self.threshold}, rows=rows)


def find_pulses(motion: Motion, threshold: float = THRESHOLD) -> Pulses:
    """Return the velocity pulses of a ground motion, which do not depend on where it was sampled: by the rule of ``docs/prediction.md``.

    Parameters
    ----------
    motion
        The ground motion; or the name of a record, or a file.
    threshold
        Part of the PGV [-], above 0 and at most 1.

    Raises
    ------
    InputError
        If the threshold is out of range.
    """
    threshold = TURN.checked(threshold, "The threshold of a pulse")
    return _chosen(*_extremes(motion_of(motion)), threshold)


def find_pulses_along(station: Station, angle: float, threshold: float = THRESHOLD) -> Pulses:
    """Return the velocity pulses of a station in a horizontal direction, from x towards y by an `angle` [degrees]; as `find_pulses` does.

    Raises
    ------
    InputError
        If the threshold is out of range.
    """
    threshold = TURN.checked(threshold, "The threshold of a pulse")
    x, y = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    acceleration = x * station.x.acceleration + y * station.y.acceleration
    velocity = x * station.x.velocity + y * station.y.velocity
    return _chosen(*_extremes_of(acceleration, velocity, station.time_step), threshold)


def _chosen(times: FloatArray, velocities: FloatArray, threshold: float) -> Pulses:
    """Return the pulses among the extremes of a ground velocity."""
    least = threshold * max(float(velocities.max()), -float(velocities.min()))
    if least == 0.0:
        return Pulses(times[:0], velocities[:0], threshold)
    places = np.empty(velocities.size + 1, dtype=np.int64)
    chosen = places[: find_turning_points(velocities, least, places)]
    return Pulses(times[chosen], velocities[chosen], threshold)


@lru_cache(maxsize=1)  # one record is looked at with several thresholds, one after the other
def _extremes(motion: GroundMotion) -> tuple[FloatArray, FloatArray]:
    """Return time and value of every extreme of the ground velocity, and of its two ends."""
    return _extremes_of(motion.acceleration, motion.velocity, motion.time_step)


def _extremes_of(
    acceleration: FloatArray, velocity: FloatArray, time_step: float
) -> tuple[FloatArray, FloatArray]:
    times, velocities = np.empty((2, 2 * velocity.size))
    count = find_extremes(acceleration, velocity, time_step, times, velocities)
    return times[:count], velocities[:count]


@dataclass(frozen=True)
class Prediction:
    """Largest change of displacement between two of its peaks, and the energies that go with it, as far as a method says."""

    displacement_change: float  #: dy [mm]
    input_velocity: float  #: equivalent velocity V_dE of the energy put in on the way [mm/s]
    hysteretic_velocity: float  #: equivalent velocity V_dEhr of the energy dissipated on the way [mm/s]
    displacement: float | None = None  #: largest, y_max [mm]; dy stands for it where there is none
    #: equivalent velocity V_E of all the energy put in [mm/s]
    total_velocity: float | None = field(default=None, metadata={"unit": MM_PER_S})

    @property
    def bound(self) -> float:
        """What the method offers for y_max [mm]: its own, or dy, which Li et al. (2020), section 6.1.2, take as conservative."""
        return self.displacement_change if self.displacement is None else self.displacement

    def _repr_html_(self) -> str:
        return fields_card(self, "Prediction")


#: What is said where there is nothing to say it of.
NOTHING = Prediction(math.nan, math.nan, math.nan)

#: What is predicted, as it is compared and told, in the order of tables.
PREDICTION_QUANTITIES = Quantities("quantity of a prediction")
#: Largest change of displacement between two successive peaks, and largest displacement.
CHANGE = PREDICTION_QUANTITIES.tell("displacement_change", "dy_mm", name="dy", decimals=1)
DISPLACEMENT = PREDICTION_QUANTITIES.tell(
    "peak_displacement", "y_mm", name="y", head="y_max", decimals=1, get="displacement"
)
#: Equivalent velocities of the energies put in and dissipated during a swing, and of all the energy put in.
INPUT = PREDICTION_QUANTITIES.tell(
    "swing_input_velocity", "V_dE_mm_s", name="V_dE", shown=MM_PER_S, decimals=1, get="input_velocity"
)
HYSTERETIC = PREDICTION_QUANTITIES.tell(
    "swing_hysteretic_velocity",
    "V_dEhr_mm_s",
    name="V_dEhr",
    shown=MM_PER_S,
    decimals=1,
    get="hysteretic_velocity",
)
TOTAL = PREDICTION_QUANTITIES.tell(
    "input_velocity", "V_E_mm_s", name="V_E", shown=MM_PER_S, decimals=1, get="total_velocity"
)


def value_of(prediction: Prediction, quantity: Quantity) -> float:
    """Return a quantity of a prediction; not a number where it has none, and dy where it has no largest displacement of its own."""
    value = prediction.bound if quantity is DISPLACEMENT else quantity.of(prediction)
    return math.nan if value is None else value


@dataclass(frozen=True, eq=False)
class PulsePrediction:
    """What a method predicts of every pulse of a record: arrays of shape (count,) of what `Prediction` has."""

    pulses: Pulses
    displacement_change: FloatArray
    input_velocity: FloatArray
    hysteretic_velocity: FloatArray

    @property
    def governing(self) -> int | None:
        """Number of the pulse with the largest displacement, counted from zero; None where nothing moves."""
        if self.pulses.count == 0 or self.displacement_change.max() == 0.0:
            return None
        return int(np.argmax(self.displacement_change))

    @property
    def largest(self) -> Prediction:
        """Largest of each over all pulses, zero where there is none: blind, from the record only."""
        return Prediction(*(float(values.max(initial=0.0)) for values in self._values))

    @property
    def _values(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        return self.displacement_change, self.input_velocity, self.hysteretic_velocity

    def of(self, pulse: int | None) -> Prediction:
        """Return what one pulse does, counted from zero; not a number where it is None."""
        return NOTHING if pulse is None else Prediction(*(float(values[pulse]) for values in self._values))

    def _repr_html_(self) -> str:
        facts = {"pulses": self.pulses.count, "governing pulse": self.governing}
        return fields_card(self.largest, "Prediction from pulses, the largest of all", facts)
