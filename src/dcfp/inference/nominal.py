"""The nominal coefficient of friction of any bearing: Li et al. (2020), section 4.4."""

from dataclasses import dataclass, replace

from dcfp.analysis.rig import Program, RigTest, Sine, run_program
from dcfp.system import LI_2020 as PAPER_BEARING
from dcfp.system import Bearing, ConstantFriction, FrictionLaw, Heating, Li2020, SimplifiedHeating
from dcfp.system.friction.constant import NOMINAL_COEFFICIENT

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

    A constant law is its own. Any other is put through dependency test T01, which gave the paper's 0.043, on the virtual machine at the
    bearing's pressure. Of the paper's law that result is taken relative to the one of the paper's own bearing, heating and ambient temperature, for which
    mu_n then is the 0.043 of the tests; of another law it is taken as it is.
    """
    if isinstance(friction, ConstantFriction):
        return Nominal(friction.mu, "the constant coefficient itself")
    found = _tested(bearing, friction, heating)
    if not isinstance(friction, Li2020):
        return Nominal(found, "virtual dependency test T01, second cycle")
    ratio = found / _tested(PAPER_BEARING, Li2020(), SimplifiedHeating())
    tests = "tests, Li et al. (2020), section 4.4"
    if ratio == 1.0:
        return Nominal(NOMINAL_COEFFICIENT, tests)
    words = f"{NOMINAL_COEFFICIENT:g} of the {tests}, times {ratio:.3f} by the virtual dependency test T01"
    return Nominal(NOMINAL_COEFFICIENT * ratio, words)


def _tested(bearing: Bearing, friction: FrictionLaw, heating: Heating) -> float:
    """Mean coefficient at zero displacement in the second cycle of T01 on the virtual machine [-]."""
    wave = Sine(min(_AMPLITUDE, _LARGEST_AMPLITUDE * bearing.effective_radius), _PEAK_VELOCITY, _CYCLES)
    # the capacity limits an earthquake, not what the material does
    free = replace(bearing, displacement_capacity=None)
    (loops,) = run_program(Program("T01", (RigTest("T01", wave),)), free, friction, heating)
    return loops.cycles[1].friction
