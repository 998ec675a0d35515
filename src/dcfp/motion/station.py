"""The ground motion of a station: two horizontal components and, where it was recorded, the vertical one, at the same times."""

import hashlib
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.motion.alignment import brought_together
from dcfp.motion.formats.directions import azimuth
from dcfp.motion.ground_motion import GroundMotion, Origin, provenance
from dcfp.motion.kyoshin_files import vertical_beside
from dcfp.schema.notebook import card
from dcfp.schema.parameters import PGV

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True, eq=False)
class Station:
    """Two horizontal components `x` and `y` of a ground motion, and the `vertical` one or None, at the same times.

    Parameters
    ----------
    x, y, vertical
        Of the same time step and length.
    name
        Short name for tables and figures.
    treatment
        What was done to bring them together, one phrase for each step.
    parts
        The components before they were brought together; none where they were changed since.

    Raises
    ------
    InputError
        If time steps or lengths differ; `joined` brings components together.
    """

    x: GroundMotion
    y: GroundMotion
    vertical: GroundMotion | None = None
    name: str = "station"
    treatment: tuple[str, ...] = ()
    parts: tuple[GroundMotion, ...] = ()

    def __post_init__(self) -> None:
        """Check that the components go together."""
        for one in self.components[1:]:
            if one.time_step != self.time_step or one.acceleration.size != self.x.acceleration.size:
                msg = f"{self.name}: the components of a station must have the same time step and length; join them first."
                raise InputError(msg)

    @property
    def components(self) -> tuple[GroundMotion, ...]:
        """The two or three components."""
        return (self.x, self.y) if self.vertical is None else (self.x, self.y, self.vertical)

    def require_vertical(self) -> GroundMotion:
        """Return the vertical component.

        Raises
        ------
        InputError
            If there is none.
        """
        if self.vertical is None:
            file = vertical_beside(self.x.origin.source)
            how = f"put its file {file} beside the others, or join" if file else "join"
            msg = f"{self.name}: the station has no vertical component; {how} it as the third one, as in east.AT2+north.AT2+up.AT2."
            raise InputError(msg)
        return self.vertical

    @property
    def origin(self) -> Origin:
        """Where the motion came from: what is said of x, with the names of all components and the sources of the horizontal ones."""
        one, other = self.x.origin, self.y.origin
        component = " + ".join(motion.origin.component or motion.name for motion in self.components)
        source = one.source if one.source == other.source else f"{one.source} + {other.source}"
        return replace(one, component=component, source=source)

    @property
    def azimuths(self) -> tuple[float, float] | None:
        """Where x and y point, clockwise from north [degrees], where the names of both components plainly say it."""
        first, second = (azimuth(one.origin.component) for one in (self.x, self.y))
        return None if first is None or second is None else (first, second)

    @property
    def orientation(self) -> str:
        """Where x and y point and which way round they are, in words; empty where that is not known."""
        if self.azimuths is None:
            return ""
        x, y = self.azimuths
        way = "counter-clockwise" if (x - y) % 360.0 < 180.0 else "clockwise"
        return f"x points to {x:g} and y to {y:g} degrees from north, so that from x to y is {way} seen from above"

    @property
    def time_step(self) -> float:
        """Interval between two values [s]."""
        return self.x.time_step

    @property
    def duration(self) -> float:
        """Time from the first to the last value [s]."""
        return self.x.duration

    @cached_property
    def acceleration(self) -> FloatArray:
        """Horizontal ground acceleration [mm/s2], shape (n, 2)."""
        return freeze(np.column_stack((self.x.acceleration, self.y.acceleration)))

    @cached_property
    def velocity(self) -> FloatArray:
        """Horizontal ground velocity [mm/s], shape (n, 2)."""
        return freeze(np.column_stack((self.x.velocity, self.y.velocity)))

    @cached_property
    def displacement(self) -> FloatArray:
        """Horizontal ground displacement [mm], shape (n, 2)."""
        return freeze(np.column_stack((self.x.displacement, self.y.displacement)))

    @cached_property
    def peak_acceleration(self) -> float:
        """PGA of the resultant [mm/s2]."""
        return _largest(self.acceleration)

    @cached_property
    def peak_velocity(self) -> float:
        """PGV of the resultant [mm/s], at the times of the values."""
        return _largest(self.velocity)

    @cached_property
    def peak_displacement(self) -> float:
        """PGD of the resultant [mm], at the times of the values."""
        return _largest(self.displacement)

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the components."""
        return hashlib.sha256("".join(one.digest for one in self.components).encode()).hexdigest()

    def scaled(self, factor: float) -> "Station":
        """Return the station with all its components multiplied by `factor` [-]."""
        x, y, *rest = (one.scaled(factor) for one in self.components)
        vertical = rest[0] if rest else None
        treatment = (*self.treatment, f"scaled by {factor:.6g}")
        return replace(self, x=x, y=y, vertical=vertical, treatment=treatment, parts=())

    def scaled_to_pgv(self, peak_velocity: float) -> "Station":
        """Return the station scaled so that the PGV of its horizontal resultant is `peak_velocity` [mm/s].

        Raises
        ------
        InputError
            If `peak_velocity` is out of range, or the ground does not move.
        """
        peak_velocity = PGV.checked(peak_velocity, f"{self.name}: the PGV to scale to")
        if self.peak_velocity == 0.0:
            msg = f"{self.name}: every value is zero, so the station cannot be scaled to a PGV."
            raise InputError(msg)
        return self.scaled(peak_velocity / self.peak_velocity)

    def rotated(self, angle: float) -> "Station":
        """Return the station with its horizontal motion turned from x towards y by an `angle` [degrees].

        The same as turning the axes the other way, which is what becomes of the directions of x and y.

        Raises
        ------
        InputError
            If the angle is not finite.
        """
        if not math.isfinite(angle):
            msg = f"{self.name}: the angle to rotate by must be a finite number of degrees, not {angle!r}."
            raise InputError(msg)
        cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        x, y = self.x.acceleration, self.y.acceleration
        labels = "x", "y"
        if self.azimuths is not None:
            from_x, from_y = self.azimuths
            turned = angle if (from_x - from_y) % 360.0 < 180.0 else -angle
            labels = f"{(from_x + turned) % 360.0:g} deg", f"{(from_y + turned) % 360.0:g} deg"
        return replace(
            self,
            x=_turned(self.x, cosine * x - sine * y, labels[0]),
            y=_turned(self.y, sine * x + cosine * y, labels[1]),
            treatment=(*self.treatment, f"rotated by {angle:g} degrees"),
            parts=(),
        )

    def to_dataset(self) -> "xarray.Dataset":
        """Return the histories of x, y and, where there is one, the vertical over ``time``, and the provenance as attributes."""
        parts = {
            name: one.to_dataset() for name, one in zip(("x", "y", "vertical"), self.components, strict=False)
        }
        data = parts["x"].drop_vars(list(parts["x"].data_vars))
        for name, part in parts.items():
            for quantity, values in part.data_vars.items():
                words = f"{values.attrs['long_name']}, {name if name == 'vertical' else f'direction {name}'}"
                data[f"{quantity}_{name}"] = values.assign_attrs(long_name=words)
        return data.assign_attrs(
            title=f"Ground motion of the station {self.name}",
            record=self.name,
            **provenance(self.digest, self.origin, self.treatment),
        )

    def _repr_html_(self) -> str:
        facts = {
            "PGA [mm/s2]": self.peak_acceleration,
            "PGV [mm/s]": self.peak_velocity,
            "PGD [mm]": self.peak_displacement,
            "duration [s]": self.duration,
            "time_step [s]": self.time_step,
            **{name: value for name, value in vars(self.origin).items() if value},
            "SHA-256": self.digest,
        }
        return card(f"Station {self.name}", facts, remarks=self.treatment)


def _turned(motion: GroundMotion, acceleration: FloatArray, label: str) -> GroundMotion:
    return replace(motion, acceleration=acceleration, origin=replace(motion.origin, component=label))


def _largest(vectors: FloatArray) -> float:
    return math.sqrt(float((vectors**2).sum(axis=1).max()))


def joined(components: Sequence[GroundMotion], name: str) -> Station:
    """Return the station of two horizontal components and perhaps the vertical one, in this order.

    What `dcfp.motion.alignment.brought_together` does to them, and its errors, are told in the treatment.
    """
    (x, y, *rest), treatment = brought_together(components, name)
    return Station(x, y, rest[0] if rest else None, name, tuple(treatment), tuple(components))


def stations_of(records: Sequence[GroundMotion | Station]) -> list[Station]:
    """Return records that are all stations; none where all are single components.

    Raises
    ------
    InputError
        If there are both.
    """
    stations = [one for one in records if isinstance(one, Station)]
    if stations and len(stations) != len(records):
        msg = "Stations are analysed in the plane and single components in one direction; give only stations, or only single components."
        raise InputError(msg)
    return stations


def one_direction(name: str, choices: Sequence[str]) -> InputError:
    """Return the sentence that a station is no motion of one direction, with the names of its horizontal components."""
    return InputError(
        f"{name} is a station with two horizontal components, and this takes one direction; choose {' or '.join(choices)}."
    )


def in_plane(record: GroundMotion | Station) -> Station:
    """Return a station; a single component is one whose other direction stands still."""
    if isinstance(record, Station):
        return record
    return Station(record, replace(record, acceleration=0.0 * record.acceleration), name=record.name)
