"""The ground motion of a station: two horizontal components and, where it was recorded, the vertical one, at the same times."""

import hashlib
import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.motion.formats.registry import direction
from dcfp.motion.ground_motion import GroundMotion, Origin, refined
from dcfp.schema.notebook import card
from dcfp.schema.parameters import PGV

#: How far the ratio of two time steps may be from a whole number [-].
_CLOSE_TO_WHOLE = 1e-6


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
            msg = f"{self.name}: the station has no vertical component; join it as the third one, as in east.AT2+north.AT2+up.AT2."
            raise InputError(msg)
        return self.vertical

    @property
    def origin(self) -> Origin:
        """Where the motion came from: what the two horizontal components have in common, and their names."""
        one, other = self.x.origin, self.y.origin
        component = " + ".join(motion.origin.component or motion.name for motion in self.components)
        source = one.source if one.source == other.source else f"{one.source} + {other.source}"
        return replace(one, component=component, source=source)

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
        return replace(
            self, x=x, y=y, vertical=vertical, treatment=(*self.treatment, f"scaled by {factor:.6g}")
        )

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
        return replace(
            self,
            x=replace(self.x, acceleration=cosine * x - sine * y),
            y=replace(self.y, acceleration=sine * x + cosine * y),
            treatment=(*self.treatment, f"rotated by {angle:g} degrees"),
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


def _largest(vectors: FloatArray) -> float:
    return math.sqrt(float((vectors**2).sum(axis=1).max()))


def joined(components: Sequence[GroundMotion], name: str) -> Station:
    """Return the station of two horizontal components and perhaps the vertical one, in this order.

    A longer time step that is a multiple of the shortest is divided, which leaves the motion as it is; after the end of a shorter
    component its ground keeps its velocity. Both are told in the treatment.

    Raises
    ------
    InputError
        If there are not two or three components, they are of different earthquakes or stations, one is of another direction than it is
        given for, or their time steps do not fit.
    """
    if len(components) not in (2, 3):
        msg = f"{name}: a station has two horizontal components and may have a vertical one, not {len(components)} components."
        raise InputError(msg)
    _check_origins(components, name)
    _check_directions(components, name)
    step = min(one.time_step for one in components)
    treatment: list[str] = []
    values: list[FloatArray] = []
    for one in components:
        ratio = one.time_step / step
        parts = round(ratio)
        if abs(ratio - parts) > _CLOSE_TO_WHOLE * parts:
            msg = (
                f"{name}: the time steps of {components[0].name} and {one.name}, {components[0].time_step:g} and {one.time_step:g} s, do not fit:"
                " one must be a multiple of the other; resample one of them."
            )
            raise InputError(msg)
        if parts > 1:
            treatment.append(f"time step of {one.name} divided by {parts}")
        values.append(refined(one.acceleration, parts))
    longest = max(one.size for one in values)
    x, y, *rest = (
        replace(one, acceleration=_lengthened(own, longest), time_step=step)
        for one, own in zip(components, values, strict=True)
    )
    for one, own in zip(components, values, strict=True):
        missing = (longest - own.size) * step
        if missing > 0.0:
            treatment.append(f"{one.name} ends {missing:.3g} s earlier, and keeps its velocity from there on")
    return Station(x, y, rest[0] if rest else None, name, tuple(treatment))


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


def _lengthened(values: FloatArray, size: int) -> FloatArray:
    return np.concatenate((values, np.zeros(size - values.size)))


def _check_origins(components: Sequence[GroundMotion], name: str) -> None:
    first = components[0]
    for one in components[1:]:
        for what, mine, other in (
            ("earthquakes", first.origin.event, one.origin.event),
            ("stations", first.origin.station, one.origin.station),
        ):
            if mine and other and mine != other:
                msg = (
                    f"{name}: {first.name} and {one.name} are of different {what}, {mine!r} and {other!r};"
                    " the components of a station are of one record."
                )
                raise InputError(msg)


def _check_directions(components: Sequence[GroundMotion], name: str) -> None:
    for place, one in enumerate(components):
        found = direction(one.origin.component)
        if place < 2 and found == "UD":
            msg = f"{name}: {one.name} is the vertical component; give the two horizontal ones first and the vertical one last."
            raise InputError(msg)
        if place == 2 and (found in ("NS", "EW") or _azimuth(one) is not None):
            msg = f"{name}: the third component, {one.name}, is horizontal ({one.origin.component}); a station has two of these, and the vertical one last."
            raise InputError(msg)
    first, second = (_azimuth(one) for one in components[:2])
    if first is not None and second is not None and (second - first) % 180.0 != 90.0:
        msg = (
            f"{name}: {components[0].name} and {components[1].name} point to {first:g} and {second:g} degrees;"
            " the horizontal components of a station are at right angles."
        )
        raise InputError(msg)


def _azimuth(motion: GroundMotion) -> float | None:
    """Return the direction of a component from north [degrees], where its name plainly says it."""
    found = direction(motion.origin.component)
    if found in ("NS", "EW"):
        return 0.0 if found == "NS" else 90.0
    match = re.fullmatch(r"(\d{3})(?:\s*deg)?", motion.origin.component.strip(), re.IGNORECASE)
    return float(match.group(1)) % 360.0 if match and int(match.group(1)) <= 360 else None
