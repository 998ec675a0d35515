"""What the phases of the motion share: the structure's constants, its state and what a step brings.

Everything is per unit mass of the structure: stiffness in 1/s2, force in mm/s2, energy in mm2/s2.
"""

from typing import NamedTuple

from dcfp.kernels._jit import kernel


class Structure(NamedTuple):
    """A rigid structure on the bearing.

    A plate has a share of the relative travel, and a speed in the friction law that is a factor times the relative one.
    Two equal plates are represented by one, with half the travel.
    """

    restoring: float  # spring (a), kra / m [1/s2]
    elastic: float  # spring (b), kf / m [1/s2]
    gravity: float  # vertical force, N / m [mm/s2]
    pressure: float  # on the slider [N/mm2]
    reach: float  # N / kf, elongation of spring (b) under a coefficient of one [mm]
    plates: int  # that differ: 1 or 2
    first_share: float
    second_share: float
    first_speed: float
    second_speed: float


class Motion(NamedTuple):
    """State of the motion.

    ``elongation`` is that of spring (b), y - O_Y; ``side`` is its sign while sliding and 0 while sticking.
    """

    displacement: float  # y [mm]
    velocity: float  # v [mm/s]
    elongation: float  # [mm]
    side: int


class Push(NamedTuple):
    """Ground acceleration from now on: ``now`` [mm/s2] + ``rate`` [mm/s3] t."""

    now: float
    rate: float


class Advance(NamedTuple):
    """Outcome of one step, which may have been cut short by an event or refused (length 0)."""

    motion: Motion
    length: float  # [s]
    input: float  # - integral of ag v dt [mm2/s2]
    hysteretic: float  # dissipated by friction [mm2/s2]
    friction: float  # coefficient at the end: mobilised while sliding, available while sticking
    turning: float  # displacement [mm] at which the velocity passed zero, or NaN
    fits: bool  # False if the heating model ran out of cells


@kernel
def share(structure: Structure, plate: int) -> float:
    """Share of the relative travel that a plate takes [-]."""
    return structure.first_share if plate == 0 else structure.second_share


@kernel
def speed_factor(structure: Structure, plate: int) -> float:
    """Speed in the friction law on a plate over the relative speed [-]."""
    return structure.first_speed if plate == 0 else structure.second_speed
