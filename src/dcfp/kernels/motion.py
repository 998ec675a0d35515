"""What every kernel shares: the system's constants, the state of the motion, what drives it, and what a step brings.

In a response analysis everything is per unit mass of the structure: stiffness in 1/s2, force in mm/s2, energy in mm2/s2. The test machine
imposes the motion, and its forces and energies are in N and N mm.
"""

from typing import NamedTuple

from dcfp.kernels._jit import kernel

#: How an integration can end.
DONE, AT_REST, OUT_OF_CELLS, NO_PROGRESS, NO_NUMBER = range(5)


class SystemConstants(NamedTuple):
    """A rigid structure on the bearing.

    A plate has a share of the relative travel, and a speed in the friction law that is a factor times the relative one.
    Two equal plates are represented by one, with half the travel.
    """

    restoring: float  # spring (a), kra / m [1/s2]
    elastic: float  # spring (b), kf / m [1/s2]
    gravity: float  # vertical force, N / m [mm/s2]
    pressure: float  # on the slider [N/mm2]
    yield_per_mu: float  # N / kf, elongation at which spring (b) yields under a coefficient of one [mm]
    plates: int  # that differ: 1 or 2
    first_share: float
    second_share: float
    first_speed: float
    second_speed: float


class Motion(NamedTuple):
    """Of the structure relative to the ground, or of the machine's platen."""

    displacement: float  # y [mm]
    velocity: float  # v [mm/s]


class SpringState(NamedTuple):
    """State of spring (b)."""

    elongation: float  # y - O_Y [mm]
    slip_sign: int  # sign of the elongation while sliding, 0 while sticking
    friction: float  # coefficient: mobilised while sliding, available while sticking


class GroundInput(NamedTuple):
    """Ground acceleration from now on: ``acceleration`` [mm/s2] + ``rate`` [mm/s3] t."""

    acceleration: float
    rate: float


class StepControl(NamedTuple):
    """How finely an interval is stepped through."""

    interval: float  # between samples [s]
    fewest_halvings: int  # of it, for a step of sliding
    tolerance: float  # of the coefficient's distance from its chord in the middle of a step [-]


class StepStart(NamedTuple):
    """From where a step is taken."""

    ground: GroundInput
    motion: Motion
    spring: SpringState
    time: float  # [s]
    remaining: float  # of the interval [s]


class StepResult(NamedTuple):
    """Outcome of one step, which may have been cut short by an event or refused (length 0)."""

    motion: Motion
    spring: SpringState
    length: float  # [s]
    work: float  # of the ground, - integral of ag v dt [mm2/s2], or of the machine [N mm]
    hysteretic: float  # dissipated by friction [mm2/s2] or [N mm]
    turning: float  # displacement [mm] at which the velocity passed zero, or NaN; not told by the machine
    fits: bool  # False if the heating model ran out of cells


@kernel
def share(system: SystemConstants, plate: int) -> float:
    """Share of the relative travel that a plate takes [-]."""
    return system.first_share if plate == 0 else system.second_share


@kernel
def speed_factor(system: SystemConstants, plate: int) -> float:
    """Speed in the friction law on a plate over the relative speed [-]."""
    return system.first_speed if plate == 0 else system.second_speed
