"""Components of a station brought together: of one record, at the same times, each in its own direction."""

from collections.abc import Sequence
from dataclasses import replace
from datetime import datetime

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.motion.formats.directions import azimuth, direction, points_down
from dcfp.motion.ground_motion import GroundMotion, refined

#: How far the ratio of two time steps, or a start in time steps, may be from a whole number [-].
_CLOSE_TO_WHOLE = 1e-6
#: How far from a right angle two horizontal components may be, as for instruments set up by a compass [degrees].
_NEARLY_RIGHT = 5.0


def brought_together(components: Sequence[GroundMotion], name: str) -> tuple[list[GroundMotion], list[str]]:
    """Return components with the same time step, start and length, and what was done to them, one phrase for each step.

    A longer time step that is a multiple of the shortest is divided, which leaves the motion as it is. A component that starts later is
    moved to the nearest value of the others, and its ground is at rest before; after the end of a shorter one its ground keeps its
    velocity. A vertical component that is positive downwards is turned over.

    Raises
    ------
    InputError
        If there are not two or three components, they are of different earthquakes or stations or of times that do not overlap, one is of another direction
        than it is given for, or their time steps do not fit.
    """
    if len(components) not in (2, 3):
        msg = f"{name}: a station has two horizontal components and may have a vertical one, not {len(components)} components."
        raise InputError(msg)
    told = [
        *_own_treatment(components),
        *_check_origins(components, name),
        *_check_directions(components, name),
    ]
    told += [
        f"{one.name} is zero throughout, which is taken for a ground that does not move in its direction"
        for one in components
        if not one.acceleration.any()
    ]
    if len(components) == 3 and points_down(components[2].origin.component):
        *horizontal, down = components
        up = replace(down, acceleration=-down.acceleration)
        components = [*horizontal, up]
        told.append(f"{down.name} is positive downwards, and was turned over")
    step = min(one.time_step for one in components)
    values = [_divided(one, components, name, told) for one in components]
    delays = _delays(components, name, step, told)
    ends = [delay + own.size for delay, own in zip(delays, values, strict=True)]
    for one, end in zip(components, ends, strict=True):
        if end < max(ends):
            told.append(
                f"{one.name} ends {(max(ends) - end) * step:.3g} s earlier, and keeps its velocity from there on"
            )
    together = [
        replace(one, acceleration=np.pad(own, (delay, max(ends) - end)), time_step=step)
        for one, own, delay, end in zip(components, values, delays, ends, strict=True)
    ]
    return together, told


def _own_treatment(components: Sequence[GroundMotion]) -> list[str]:
    """Return what was done to the components before: to all of them, or to which."""
    shared = [
        step for step in components[0].treatment if all(step in one.treatment for one in components[1:])
    ]
    own = [f"{one.name}: {step}" for one in components for step in one.treatment if step not in shared]
    return [*shared, *own]


def _divided(one: GroundMotion, components: Sequence[GroundMotion], name: str, told: list[str]) -> FloatArray:
    """Return the acceleration of a component at the shortest time step of all."""
    finest = min(components, key=lambda other: other.time_step)
    ratio = one.time_step / finest.time_step
    parts = round(ratio)
    if abs(ratio - parts) > _CLOSE_TO_WHOLE * parts:
        first, second = sorted((one, finest), key=components.index)
        msg = (
            f"{name}: the time steps of {first.name} and {second.name}, {first.time_step:g} and {second.time_step:g} s, do not fit:"
            " one must be a multiple of the other; resample one of them."
        )
        raise InputError(msg)
    if parts > 1:
        told.append(f"time step of {one.name} divided by {parts}")
    return refined(one.acceleration, parts)


def _delays(components: Sequence[GroundMotion], name: str, step: float, told: list[str]) -> list[int]:
    """Return how many time steps each component starts later than the first that starts."""
    starts = [datetime.fromisoformat(one.origin.start) if one.origin.start else None for one in components]
    known = [start for start in starts if start is not None]
    if not known:
        return [0] * len(components)
    first = min(known)
    leader = components[starts.index(first)]
    delays: list[int] = []
    for one, start in zip(components, starts, strict=True):
        if start is None:
            told.append(f"{one.name} does not say when it starts, which is taken to be with {leader.name}")
            delays.append(0)
            continue
        late = (start - first).total_seconds()
        if late > leader.duration:
            msg = (
                f"{name}: {one.name} starts {late:g} s after {leader.name}, which has ended by then; the components of a station are"
                " recorded at the same time."
            )
            raise InputError(msg)
        delay = round(late / step)
        moved = delay * step - late
        words = f", moved by {1000.0 * moved:+.3g} ms to the nearest value" if abs(moved) > _CLOSE_TO_WHOLE * step else ""  # fmt: skip
        if delay or words:
            told.append(f"{one.name} starts {late:.3g} s later{words}, and its ground is at rest before")
        delays.append(delay)
    return delays


def _check_origins(components: Sequence[GroundMotion], name: str) -> list[str]:
    """Return which component does not say of which earthquake or station it is, where another says it."""
    silent: dict[tuple[str, str], list[str]] = {}
    for what, said in (
        ("earthquake", [one.origin.event for one in components]),
        ("station", [one.origin.station for one in components]),
    ):
        who_says = [place for place, words in enumerate(said) if words]
        if not who_says:
            continue
        first, mine = components[who_says[0]], said[who_says[0]]
        for one, other in zip(components, said, strict=True):
            if not other:
                silent.setdefault((one.name, first.name), []).append(what)
            elif mine.casefold().split() != other.casefold().split():
                msg = (
                    f"{name}: {first.name} and {one.name} are of different {what}s, {mine!r} and {other!r};"
                    " the components of a station are of one record."
                )
                raise InputError(msg)
    return [
        f"{one} does not say of which {' and '.join(words)} it is, which is taken to be as of {first}"
        for (one, first), words in silent.items()
    ]


def _check_directions(components: Sequence[GroundMotion], name: str) -> list[str]:
    for place, one in enumerate(components):
        label = one.origin.component
        if place < 2 and direction(label) == "UD":
            msg = f"{name}: {one.name} is the vertical component; give the two horizontal ones first and the vertical one last."
            raise InputError(msg)
        if place == 2 and azimuth(label) is not None:
            msg = f"{name}: the third component, {one.name}, is horizontal ({label}); a station has two of these, and the vertical one last."
            raise InputError(msg)
    first, second = (azimuth(one.origin.component) for one in components[:2])
    if first is None or second is None:
        return []
    off = (second - first) % 180.0 - 90.0
    words = f"{components[0].name} and {components[1].name} point to {first:g} and {second:g} degrees"
    if abs(off) > _NEARLY_RIGHT:
        msg = f"{name}: {words}; the horizontal components of a station are at right angles."
        raise InputError(msg)
    return [f"{words}, which is taken for a right angle"] if off else []
