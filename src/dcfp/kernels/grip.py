"""What sticking and sliding along a prescribed path share: the bearing in the machine and the state of spring (b)."""

from typing import NamedTuple

from dcfp.kernels._jit import kernel
from dcfp.kernels.friction import mean_coefficient, with_reference
from dcfp.kernels.heat_state import Heat
from dcfp.kernels.law import Law
from dcfp.kernels.motion import Structure
from dcfp.kernels.path import Piece, displacement_at, load_at, reference_at, velocity_at

# four points of Gauss on (0, 1): exact for the work, whose integrands are of the sixth order in time
GAUSS_POINTS = (0.06943184420297371, 0.33000947820757187, 0.6699905217924281, 0.9305681557970263)
GAUSS_PARTS = (0.17392742256872692, 0.32607257743127307, 0.32607257743127307, 0.17392742256872692)


class Rig(NamedTuple):
    """The bearing in the machine."""

    area: float  # of the slider [mm2]
    radius: float  # effective radius of the bearing [mm]
    elastic: float  # stiffness kf of spring (b) [N/mm]


class Grip(NamedTuple):
    """State of spring (b)."""

    elongation: float  # [mm]
    side: int  # of sliding; 0 while sticking
    friction: float  # coefficient: mobilised while sliding, available while sticking


class Stroke(NamedTuple):
    """Outcome of one step, which may have been refused (length 0)."""

    grip: Grip
    length: float  # [s]
    work: float  # of the machine on the bearing [N mm]
    hysteretic: float  # dissipated by friction [N mm]
    fits: bool  # False if the heating model ran out of cells


@kernel
def under(structure: Structure, rig: Rig, load: float) -> Structure:
    """Return the structure under another vertical force [N]."""
    return Structure(
        structure.restoring,
        structure.elastic,
        structure.gravity,
        load / rig.area,
        load / rig.elastic,
        structure.plates,
        structure.first_share,
        structure.second_share,
        structure.first_speed,
        structure.second_speed,
    )


@kernel
def available(
    law: Law, structure: Structure, rig: Rig, heat: Heat, piece: Piece, time: float, first: int
) -> float:
    """Coefficient of friction [-] at a time in a piece, at the temperatures noted from entry `first` on."""
    here = under(structure, rig, load_at(piece, time))
    at_load = with_reference(law, reference_at(piece, time))
    return mean_coefficient(at_load, here, abs(velocity_at(piece, time)), heat.notes, first)


@kernel
def pendulum_work(rig: Rig, piece: Piece, now: float, length: float) -> float:
    """Work against spring (a), N / R y dy, over a step [N mm]."""
    total = 0.0
    for k in range(4):
        t = now + length * GAUSS_POINTS[k]
        total += GAUSS_PARTS[k] * load_at(piece, t) * displacement_at(piece, t) * velocity_at(piece, t)
    return total * length / rig.radius
