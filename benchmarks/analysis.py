"""One response analysis, with the call of the kernels apart from all that is around it."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from stopwatch import once

from dcfp.analysis.integration import DEFAULT, halvings
from dcfp.analysis.response import State, state_at_rest
from dcfp.kernels.integrate import TEMPERATURE, integrate
from dcfp.kernels.motion import StepControl
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import load_motion
from dcfp.system import Bearing, FrictionLaw, Heating, SimplifiedHeating, System
from dcfp.system.plates import kernel_model

if TYPE_CHECKING:
    from dcfp.arrays import FloatArray

#: The records of the paper that come with `dcfp`.
RECORDS = ("KNA", "NCC", "LPG", "IVD")
#: The single concave bearing with the pendulum of the paper's double concave one.
SINGLE = Bearing(radii=(9000.0,), slider_diameter=400.0, pressure=60.0, elastic_stiffness=1.9e6)


def motion_at(name: str, peak_velocity: float = 500.0) -> GroundMotion:
    """Return a named record scaled to a PGV [mm/s]."""
    return load_motion(name).scaled_to_pgv(peak_velocity)


def refined(motion: GroundMotion, parts: int) -> GroundMotion:
    """Return the same piecewise linear motion with `parts` steps in place of one."""
    samples = motion.acceleration.size
    places = np.arange((samples - 1) * parts + 1) / parts
    return GroundMotion(np.interp(places, np.arange(samples), motion.acceleration), motion.time_step / parts)


@dataclass
class Analysis:
    """An analysis without free motion after the record, from rest, on the arrays that `dcfp.respond` would make.

    Attributes
    ----------
    state
        What the last march left behind.
    lines
        The histories that it wrote.
    """

    motion: GroundMotion
    bearing: Bearing
    friction: FrictionLaw
    heating: Heating = field(default_factory=SimplifiedHeating)
    tolerance: float = DEFAULT.tolerance

    def __post_init__(self) -> None:
        """Make all that a march takes, and run one so that the kernels are compiled."""
        self.system = System(self.bearing, self.friction, self.heating)
        self.acceleration: FloatArray = np.array(self.motion.acceleration)
        self.at_rest = state_at_rest(self.system)
        self.lines: FloatArray = np.zeros(
            (self.acceleration.size, TEMPERATURE + len(set(self.bearing.radii)))
        )
        self.state: State = self.at_rest
        self.coarsest = halvings(self.motion.time_step)
        self.march()

    def march(self) -> float:
        """March once through the record; return the time of the kernels' call [s]."""
        self.state = self.at_rest.copy()
        model = kernel_model(self.system, self.state.plates)
        control = StepControl(self.motion.time_step, self.coarsest, self.tolerance)
        given = (model, self.acceleration, control, self.acceleration.size)
        return once(lambda: integrate(*given, self.state.integration, 0, self.lines, True))

    @property
    def peak_displacement(self) -> float:
        """Largest displacement [mm]."""
        return self.state.extremes.displacement

    @property
    def steps(self) -> int:
        """Number of steps that the integration took."""
        return int(self.state.integration["steps"][0])
