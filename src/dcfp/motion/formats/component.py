"""One component of a record file: from values in the file's unit to a ground motion with names."""

from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.motion.formats.source import SourceText
from dcfp.motion.formats.units import unit_size
from dcfp.motion.ground_motion import GroundMotion, Origin

#: Time steps that a record can have [s]; anything else is a damaged header.
SHORTEST_STEP = 1e-5
LONGEST_STEP = 10.0

#: Largest acceleration that is believed [mm/s2]: some 100 000 g.
LARGEST_ACCELERATION = 1e9


@dataclass(frozen=True, eq=False)
class Component:
    """A ground motion, the unit its file is written in, and the names by which it can be asked for."""

    motion: GroundMotion
    unit: str
    names: tuple[str, ...] = ()


def build_component(
    source: SourceText,
    values: FloatArray,
    *,
    unit: str,
    time_step: float,
    origin: Origin,
    scale: float = 1.0,
    names: tuple[str, ...] = (),
    several: bool = False,
) -> Component:
    """Make a component from the values in the file.

    Parameters
    ----------
    source
        The file, for messages and for the motion's name.
    values
        Acceleration in the file's unit.
    unit
        That unit, as `canonical_unit` spells it.
    time_step
        Interval between two values [s].
    origin
        Where the values came from.
    scale
        How many units one value stands for [-].
    names
        Further names of the component, beside ``origin.component``.
    several
        Whether there are other components in the file, or in files of the same stem, so that the name of the
        motion must say which it is.

    Raises
    ------
    InputError
        If the time step or a value cannot be true of a ground motion, or there is only one value.
    """
    check_time_step(source, time_step)
    if values.size < 2:
        source.fail("the file holds fewer than two acceleration values.")
    with np.errstate(over="ignore", under="ignore"):
        acceleration = values * (scale * unit_size(unit))
    wrong = np.flatnonzero(~(np.abs(acceleration) <= LARGEST_ACCELERATION))
    if wrong.size:
        source.fail(f"acceleration value {wrong[0] + 1} is beyond 100 000 g; the value or the unit is wrong.")
    stem = source.path.stem or source.path.name
    name = f"{stem} {origin.component}" if several and origin.component else stem
    motion = GroundMotion(acceleration, time_step, name, origin)
    return Component(motion, unit, (origin.component, *names))


def check_time_step(source: SourceText, time_step: float) -> None:
    """Check that a time step [s] can be that of a record.

    Raises
    ------
    InputError
        If it is not between `SHORTEST_STEP` and `LONGEST_STEP`.
    """
    if not SHORTEST_STEP <= time_step <= LONGEST_STEP:
        source.fail(
            f"the time step is {time_step:g} s; a record has one between {SHORTEST_STEP:g} and "
            f"{LONGEST_STEP:g} s."
        )
