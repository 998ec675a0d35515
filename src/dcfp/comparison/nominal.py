"""The nominal coefficient of friction of any bearing: Li et al. (2020), section 4.4."""

from dataclasses import dataclass, replace

from dcfp.bearing import LI_2020 as PAPER_BEARING
from dcfp.bearing import Bearing, ConstantFriction, FrictionLaw, Heating, Li2020
from dcfp.bearing.friction.constant import NOMINAL_COEFFICIENT
from dcfp.rig import Program, RigTest, Sine, run_program

#: Dependency test T01 of Li et al. (2020), Table 1 [mm, mm/s], as far as the second cycle, in which mu_n is measured.
_AMPLITUDE, _PEAK_VELOCITY, _CYCLES = 200.0, 400.0, 2
#: Amplitude over the effective radius of a bearing for which that is too far [-].
_LARGEST_AMPLITUDE = 0.4


@dataclass(frozen=True)
class Nominal:
    """A nominal coefficient.

    Attributes
    ----------
    value
        mu_n [-].
    source
        Where it comes from, in words.
    """

    value: float
    source: str


def nominal_coefficient(bearing: Bearing, friction: FrictionLaw, heating: Heating) -> Nominal:
    """Return the constant coefficient that stands for a law in the methods of Li et al. (2020).

    For the paper's own law and pressure it is the 0.043 of the tests; a constant law is its own; any other is put through the test
    that gave 0.043, dependency test T01 at the bearing's pressure, on the virtual machine: the mean at zero displacement in the second cycle.
    """
    if isinstance(friction, ConstantFriction):
        return Nominal(friction.mu, "the constant coefficient itself")
    if friction == Li2020() and bearing.pressure == PAPER_BEARING.pressure:
        return Nominal(NOMINAL_COEFFICIENT, "tests, Li et al. (2020), section 4.4")
    amplitude = min(_AMPLITUDE, _LARGEST_AMPLITUDE * bearing.effective_radius)
    wave = Sine(amplitude, _PEAK_VELOCITY, _CYCLES)
    # the capacity limits an earthquake, not what the material does
    free = replace(bearing, displacement_capacity=None)
    loops = run_program(Program("T01", (RigTest("T01", wave),)), free, friction, heating)[0]
    return Nominal(loops.cycles[1].friction, "virtual dependency test T01, second cycle")
