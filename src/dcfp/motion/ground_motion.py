"""A ground motion: acceleration at equal time steps, and where it came from."""

import hashlib
import json
import math
from dataclasses import asdict, dataclass, field, replace
from datetime import datetime, timedelta
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from dcfp.arrays import FloatArray, freeze, integral
from dcfp.errors import InputError
from dcfp.schema.notebook import card, fields_card
from dcfp.schema.parameters import PGV
from dcfp.schema.quantities import quantity
from dcfp.version import version

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class Origin:
    """Where a ground motion came from; empty where its source does not say."""

    event: str = ""
    station: str = ""
    component: str = ""
    source: str = ""  #: file name, or the package and set that the record came from
    file_format: str = ""  #: format that the values were read from, for example ``"PEER AT2"``
    processing: str = ""  #: what baseline correction or filter is already in the values, in words
    citation: str = ""  #: how the data ask to be cited; empty when nothing is asked
    start: str = ""  #: when the first value was recorded, as ISO 8601 with the offset from UTC

    def later(self, seconds: float) -> "Origin":
        """Return the origin of a motion whose first value is so much later [s]."""
        if not self.start:
            return self
        return replace(
            self, start=(datetime.fromisoformat(self.start) + timedelta(seconds=seconds)).isoformat()
        )

    def _repr_html_(self) -> str:
        return fields_card(self, "Origin of a ground motion")


def provenance(digest: str, origin: Origin, treatment: tuple[str, ...]) -> dict[str, str]:
    """Return what a data set says of where a motion came from, and of what was done to it."""
    told = "; ".join(treatment) or "none"
    return {"record_sha256": digest, "record_origin": json.dumps(asdict(origin)), "record_treatment": told}


#: What `GroundMotion.as_horizontal` adds to the treatment.
TAKEN_AS_HORIZONTAL = "the vertical component, taken as horizontal"


@dataclass(frozen=True, eq=False)
class GroundMotion:
    """Ground acceleration at equal time steps, linear in between, starting at rest.

    Parameters
    ----------
    acceleration
        Ground acceleration at ``0, time_step, 2 time_step, ...`` [mm/s2], shape (n,), n >= 2.
    time_step
        Interval between two values [s].
    name
        Short name for tables and figures.
    origin
        Where the values came from.
    treatment
        What this package did to the values since they were read, one phrase for each step.

    Raises
    ------
    InputError
        If the values are fewer than two or not finite, or the time step is not positive.
    """

    acceleration: FloatArray
    time_step: float
    name: str = "motion"
    origin: Origin = field(default_factory=Origin)
    treatment: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        """Check the values, and keep them where they cannot be changed."""
        values = np.asarray(self.acceleration, dtype=np.float64)
        if values.ndim != 1 or values.size < 2:
            msg = f"{self.name}: a ground motion needs at least two acceleration values in one column."
            raise InputError(msg)
        if not np.isfinite(values).all():
            first = int(np.flatnonzero(~np.isfinite(values))[0])
            msg = f"{self.name}: acceleration value {first + 1} is not a finite number."
            raise InputError(msg)
        if not (np.isfinite(self.time_step) and self.time_step > 0.0):
            msg = f"{self.name}: the time step must be a positive number of seconds, not {self.time_step!r}."
            raise InputError(msg)
        object.__setattr__(self, "acceleration", freeze(values))
        object.__setattr__(self, "time_step", float(self.time_step))

    @property
    def duration(self) -> float:
        """Time from the first to the last value [s]."""
        return (self.acceleration.size - 1) * self.time_step

    @cached_property
    def time(self) -> FloatArray:
        """Time of each value [s], shape (n,)."""
        return freeze(np.arange(self.acceleration.size, dtype=np.float64) * self.time_step)

    @cached_property
    def velocity(self) -> FloatArray:
        """Ground velocity [mm/s], shape (n,): the exact integral of the acceleration, from rest."""
        return freeze(integral(self.acceleration, self.time_step))

    @cached_property
    def displacement(self) -> FloatArray:
        """Ground displacement [mm], shape (n,): the exact double integral, from rest."""
        a, v, dt = self.acceleration, self.velocity, self.time_step
        steps = v[:-1] * dt + (2.0 * a[:-1] + a[1:]) * dt**2 / 6.0
        return freeze(np.concatenate(([0.0], np.cumsum(steps))))

    @cached_property
    def peak_acceleration(self) -> float:
        """PGA [mm/s2]."""
        return float(np.abs(self.acceleration).max())

    @cached_property
    def peak_velocity(self) -> float:
        """PGV [mm/s], at the times of the values."""
        return float(np.abs(self.velocity).max())

    @cached_property
    def peak_displacement(self) -> float:
        """PGD [mm], at the times of the values."""
        return float(np.abs(self.displacement).max())

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the time step and the acceleration: the same motion has the same digest."""
        content = np.float64(self.time_step).tobytes() + self.acceleration.tobytes()
        return hashlib.sha256(content).hexdigest()

    def scaled(self, factor: float) -> "GroundMotion":
        """Return the motion with its acceleration multiplied by `factor` [-]."""
        if not np.isfinite(factor):
            msg = f"{self.name}: the scale factor must be a finite number, not {factor!r}."
            raise InputError(msg)
        step = f"scaled by {factor:.6g}"
        return replace(self, acceleration=self.acceleration * factor, treatment=(*self.treatment, step))

    def scaled_to_pgv(self, peak_velocity: float) -> "GroundMotion":
        """Return the motion scaled so that its PGV is `peak_velocity` [mm/s].

        Raises
        ------
        InputError
            If `peak_velocity` is out of range, or the motion has no velocity to scale.
        """
        peak_velocity = PGV.checked(peak_velocity, f"{self.name}: the PGV to scale to")
        if self.peak_velocity == 0.0:
            msg = f"{self.name}: every value is zero, so the record cannot be scaled to a PGV."
            raise InputError(msg)
        return self.scaled(peak_velocity / self.peak_velocity)

    def as_horizontal(self) -> "GroundMotion":
        """Return the vertical component for an analysis that takes it as horizontal, which is refused otherwise."""
        return replace(self, treatment=(*self.treatment, TAKEN_AS_HORIZONTAL))

    def to_dataset(self) -> "xarray.Dataset":
        """Return the histories over ``time``, and the provenance as attributes."""
        import xarray  # late: it takes long to import

        histories = {
            "ground_acceleration": self.acceleration,
            "ground_velocity": self.velocity,
            "ground_displacement": self.displacement,
        }
        return xarray.Dataset(
            {
                name: ("time", np.array(values), quantity(name).attributes)
                for name, values in histories.items()
            },
            coords={"time": ("time", np.array(self.time), quantity("time").attributes)},
            attrs={
                "Conventions": "CF-1.11",
                "title": f"Ground motion {self.name}",
                "source": f"dcfp {version()}",
                "references": self.origin.citation,
                "record": self.name,
                **provenance(self.digest, self.origin, self.treatment),
            },
        )

    def _repr_html_(self) -> str:
        facts = {
            "PGA [mm/s2]": self.peak_acceleration,
            "PGV [mm/s]": self.peak_velocity,
            "PGD [mm]": self.peak_displacement,
            "duration [s]": self.duration,
            "time_step [s]": self.time_step,
            "values": self.acceleration.size,
            **{name: value for name, value in vars(self.origin).items() if value},
            "SHA-256": self.digest,
        }
        return card(f"Ground motion {self.name}", facts, remarks=self.treatment)


#: Longest free motion after the record that is waited for [s].
LONGEST_TAIL = 120.0


def with_tail(acceleration: FloatArray, time_step: float, tail: float | None) -> FloatArray:
    """Return an acceleration [mm/s2], rows `time_step` [s] apart, followed by none for `tail` [s], or for as long as may be waited."""
    samples = round((LONGEST_TAIL if tail is None else tail) / time_step)
    # zeros that nobody looks at take no time
    whole = np.zeros((len(acceleration) + samples, *acceleration.shape[1:]))
    whole[: len(acceleration)] = acceleration
    return whole


def parts_in(time_step: float, longest: float) -> int:
    """Return into how many parts a time step [s] is divided so that none is longer than `longest` [s]."""
    return max(1, math.ceil(time_step / longest * (1.0 - 1e-12)))


def refined(acceleration: FloatArray, parts: int) -> FloatArray:
    """Return the same piecewise linear motion with `parts` steps in place of one; samples are rows."""
    if parts <= 1:
        return acceleration
    change = np.diff(acceleration, axis=0)
    fine = np.empty((len(change) * parts + 1, *acceleration.shape[1:]))
    for part in range(parts):
        fine[part:-1:parts] = acceleration[:-1] + change * (part / parts)
    fine[-1] = acceleration[-1]
    return fine
