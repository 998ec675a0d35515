"""The virtual test machine: one interval of a prescribed path, a cubic displacement under a vertical load that changes linearly."""

import math
from typing import NamedTuple

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import BearingModel, mean_coefficient, with_reference
from dcfp.kernels.law import Law
from dcfp.kernels.motion import SystemConstants

# four points of Gauss on (0, 1): exact for the work, whose integrands are of the sixth order in time
GAUSS_POINTS = (0.06943184420297371, 0.33000947820757187, 0.6699905217924281, 0.9305681557970263)
GAUSS_PARTS = (0.17392742256872692, 0.32607257743127307, 0.32607257743127307, 0.17392742256872692)


class MachineConstants(NamedTuple):
    """The bearing in the machine."""

    area: float  # of the slider [mm2]
    radius: float  # effective radius of the bearing [mm]
    elastic: float  # stiffness kf of spring (b) [N/mm]


class PathInterval(NamedTuple):
    """One interval; time in it starts from zero.

    The displacement is ``displacement`` + ``velocity`` t + ``second`` t2 + ``third`` t3.
    """

    displacement: float  # [mm]
    velocity: float  # [mm/s]
    second: float  # [mm/s2]
    third: float  # [mm/s3]
    load: float  # vertical force [N]
    load_rate: float  # [N/s]
    reference: float  # of the friction law at the pressure of this load [-]
    reference_rate: float  # [1/s]


class ImposedMotion(NamedTuple):
    """A machine on its path."""

    machine: MachineConstants
    path: PathInterval
    clock: float  # time at the start of the interval [s]
    now: float  # time in the interval [s]


@kernel
def displacement_at(path: PathInterval, time: float) -> float:
    """Displacement [mm]."""
    return path.displacement + time * (path.velocity + time * (path.second + time * path.third))


@kernel
def velocity_at(path: PathInterval, time: float) -> float:
    """Velocity [mm/s]."""
    return path.velocity + time * (2.0 * path.second + time * 3.0 * path.third)


@kernel
def load_at(path: PathInterval, time: float) -> float:
    """Vertical force [N]."""
    return path.load + time * path.load_rate


@kernel
def law_at(law: Law, imposed: ImposedMotion | None, elapsed: float) -> Law:
    """Return the law at the pressure of a time [s] from now."""
    if imposed is None:
        return law
    path = imposed.path
    return with_reference(law, path.reference + (imposed.now + elapsed) * path.reference_rate)


@kernel
def system_at(system: SystemConstants, imposed: ImposedMotion | None, elapsed: float) -> SystemConstants:
    """Return the system at a time [s] from now; in the machine under the force of that time, in N instead of per unit mass."""
    if imposed is None:
        return system
    load, machine = load_at(imposed.path, imposed.now + elapsed), imposed.machine
    return SystemConstants(
        system.restoring,
        machine.elastic,
        load,
        load / machine.area,
        load / machine.elastic,
        system.plates,
        system.first_share,
        system.second_share,
        system.first_speed,
        system.second_speed,
    )


@kernel
def friction_at(model: BearingModel, imposed: ImposedMotion, elapsed: float, first: int) -> float:
    """Coefficient of friction [-] at a time [s] from now, at the temperatures from entry `first` of the workspace on."""
    speed = abs(velocity_at(imposed.path, imposed.now + elapsed))
    here = system_at(model.system, imposed, elapsed)
    return mean_coefficient(BearingModel(law_at(model.law, imposed, elapsed), here, model.heat), speed, first)


@kernel
def pendulum_work(imposed: ImposedMotion, length: float) -> float:
    """Work against spring (a), N / R y dy, over a step [N mm]."""
    path = imposed.path
    total = 0.0
    for k in range(4):
        t = imposed.now + length * GAUSS_POINTS[k]
        total += GAUSS_PARTS[k] * load_at(path, t) * displacement_at(path, t) * velocity_at(path, t)
    return total * length / imposed.machine.radius


@kernel
def next_turn(path: PathInterval, now: float, end: float) -> float:
    """First time after `now` and before `end` at which the velocity passes zero, or infinity."""
    a, b, c = 3.0 * path.third, 2.0 * path.second, path.velocity
    earliest = math.inf
    near = now + 1e-9 * (end - now)
    if a == 0.0:
        root = -c / b if b != 0.0 else math.inf
        return root if near < root < end else math.inf
    under_root = b * b - 4.0 * a * c
    if under_root < 0.0:
        return math.inf
    q = -0.5 * (b + math.copysign(math.sqrt(under_root), b))
    for root in (q / a, c / q if q != 0.0 else math.inf):
        if near < root < end:
            earliest = min(earliest, root)
    return earliest


@kernel
def time_at(path: PathInterval, now: float, end: float, target: float) -> float:
    """Time between `now` and `end`, where the displacement goes one way, at which it is `target` [mm].

    Newton's iteration inside a bracket.
    """
    low, high = now, end
    rising = displacement_at(path, end) > displacement_at(path, now)
    t = 0.5 * (low + high)
    for _ in range(60):
        away = displacement_at(path, t) - target
        if (away > 0.0) == rising:
            high = t
        else:
            low = t
        rate = velocity_at(path, t)
        better = t - away / rate if rate != 0.0 else low - 1.0
        if not low <= better <= high:
            better = 0.5 * (low + high)
        close = abs(better - t) < 1e-12 * (end - now)
        t = better
        if close:
            break
    return t
