"""What a method of prediction is given, the system, the constants and an earthquake, and what it says."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Annotated

from dcfp.analysis.assumptions import LARGEST_YIELD_RADIUS
from dcfp.analysis.rig import Program, RigTest, Sine, run_program
from dcfp.errors import InputError
from dcfp.methods.li_2020.constants import LI_2020, Constants
from dcfp.methods.method import METHODS, Information, Method
from dcfp.methods.nodes import LEAVE, TOLERANCE, Nodes, find_nodes
from dcfp.methods.pulses import (
    THRESHOLD,
    TURN,
    Prediction,
    PulsePrediction,
    Pulses,
    find_pulses,
)
from dcfp.methods.spectra.elastic import ElasticSpectrum
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.declared import Declared, declared
from dcfp.schema.formulas import Formula
from dcfp.system import LI_2020 as PAPER_BEARING
from dcfp.system import ConstantFriction, Li2020, System
from dcfp.system.friction.constant import NOMINAL_COEFFICIENT

#: Part by which a PGV that was scaled to may be off [-].
_ROUNDING = 1e-6


@declared
class Methods(Declared):
    """What stands on the ground, and how the methods of prediction are set: see `find_pulses` for the threshold, `find_nodes` for the tolerance of the march."""

    system: System = field(default_factory=System)
    constants: Constants = LI_2020
    threshold: Annotated[float, TURN] = THRESHOLD
    march_tolerance: Annotated[float, replace(LEAVE, option=False)] = TOLERANCE

    @classmethod
    def of(cls, system: System, nominal: "Nominal | None" = None) -> "Methods":
        """Return the methods for a system, with the nominal coefficient that stands for its law."""
        nominal = nominal_coefficient(system) if nominal is None else nominal
        return cls(system, replace(LI_2020, nominal_friction=nominal.value))

    def remarks(self, pgv: float) -> tuple[str, ...]:
        """Return what must be known of the methods at a PGV [mm/s]."""
        remarks = list(self.constants.remarks(pgv * (1.0 + _ROUNDING)))
        law, bearing = self.system.friction, self.system.bearing
        if law.caution:
            remarks.append(f"Friction law {law.name}: {law.caution}")
        stretch = self.constants.nominal_friction * bearing.vertical_force / bearing.elastic_stiffness
        if stretch > LARGEST_YIELD_RADIUS:
            remarks.append(
                f"Spring (b) stretches {stretch:.1f} mm before the bearing slides; the predictions take it as rigid."
            )
        return tuple(remarks)


@dataclass(frozen=True, eq=False)
class Ground:
    """An earthquake as the methods of prediction know it, with its pulses by the threshold and its nodes by the tolerance as far as they have been looked for."""

    pgv: float  #: [mm/s]
    motion: GroundMotion | None = None  #: the record; None where only the PGV is known
    spectrum: ElasticSpectrum | None = None  #: its elastic spectrum, where that is known
    found: dict[float, Pulses] = field(default_factory=dict[float, Pulses], repr=False)
    legs: dict[float, Nodes] = field(default_factory=dict[float, Nodes], repr=False)

    @classmethod
    def of(cls, motion: GroundMotion) -> "Ground":
        """Return what is known of a record."""
        return cls(motion.peak_velocity, motion)

    def pulses(self, threshold: float) -> Pulses:
        """Return the velocity pulses by a threshold [-], found once.

        Raises
        ------
        InputError
            If only the PGV is known.
        """
        if threshold not in self.found:
            self.found[threshold] = find_pulses(self._record, threshold)
        return self.found[threshold]

    def nodes(self, tolerance: float) -> Nodes:
        """Return the nodes of the ground velocity by a tolerance [-], found once.

        Raises
        ------
        InputError
            If only the PGV is known.
        """
        if tolerance not in self.legs:
            self.legs[tolerance] = find_nodes(self._record, tolerance)
        return self.legs[tolerance]

    @property
    def _record(self) -> GroundMotion:
        if self.motion is None:
            msg = "Pulses are of a record; of this earthquake only the PGV is known."
            raise InputError(msg)
        return self.motion


@dataclass(frozen=True, eq=False)
class Predicted:
    """What a method says of an earthquake."""

    prediction: Prediction  #: without the analysis
    by_pulse: PulsePrediction | None = None  #: of every pulse, where the method takes one after the other
    remarks: tuple[str, ...] = ()  #: sentences that a reader must know
    nodes: int | None = None  #: number of nodes of straight legs that it takes the ground velocity for

    def knowing(self, information: Information, pulse: int | None) -> Prediction:
        """Return the prediction with that information; `pulse` is the number of the one that the analysis found to govern, or None."""
        informed = information is Information.INFORMED and self.by_pulse is not None
        return self.by_pulse.of(pulse) if informed and self.by_pulse is not None else self.prediction


@dataclass(frozen=True, kw_only=True)
class PredictionMethod(Method):
    """A method that predicts from a ground velocity, where it can be used; formulas are the governing pulse with its numbers, for the report."""

    predict: Callable[[Ground, Methods], Predicted | None]
    of_pulses: Callable[[Pulses, Methods], PulsePrediction | None] | None = (
        None  #: what every pulse does, of a method of pulses
    )
    formulas: Callable[[Ground, Methods], tuple[Formula, ...]] | None = None
    without: str = "the method cannot be used"  #: why there may be no formulas, in words


def prediction_methods() -> Mapping[str, PredictionMethod]:
    """Return every method of prediction by its name, in the order of tables."""
    return {one.name: one for one in METHODS.values() if isinstance(one, PredictionMethod)}


#: Dependency test T01 of Li et al. (2020), Table 1 [mm, mm/s], as far as the second cycle, in which mu_n is measured.
_AMPLITUDE, _PEAK_VELOCITY, _CYCLES = 200.0, 400.0, 2
#: Amplitude over the effective radius of a bearing for which that is too far [-].
_LARGEST_AMPLITUDE = 0.4


@dataclass(frozen=True)
class Nominal:
    """A nominal coefficient mu_n."""

    value: float
    source: str  #: where it comes from, in words


def nominal_coefficient(system: System) -> Nominal:
    """Return the constant coefficient that stands for a law in the methods of Li et al. (2020).

    A constant law is its own. Any other is put through dependency test T01, which gave the paper's 0.043, on the virtual machine; of the paper's law that
    result is taken relative to the one of the paper's own bearing, heating and ambient temperature.
    """
    law = system.friction
    if isinstance(law, ConstantFriction):
        return Nominal(law.mu, "the constant coefficient itself")
    found = _tested(system)
    if not isinstance(law, Li2020):
        return Nominal(found, "virtual dependency test T01, second cycle")
    ratio = found / _tested(System(PAPER_BEARING))
    tests = "tests, Li et al. (2020), section 4.4"
    if ratio == 1.0:
        return Nominal(NOMINAL_COEFFICIENT, tests)
    words = f"{NOMINAL_COEFFICIENT:g} of the {tests}, times {ratio:.3f} by the virtual dependency test T01"
    return Nominal(NOMINAL_COEFFICIENT * ratio, words)


def _tested(system: System) -> float:
    """Mean coefficient at zero displacement in the second cycle of T01 on the virtual machine [-]."""
    bearing = system.bearing
    wave = Sine(min(_AMPLITUDE, _LARGEST_AMPLITUDE * bearing.effective_radius), _PEAK_VELOCITY, _CYCLES)
    # the capacity limits an earthquake, not what the material does
    free = replace(system, bearing=replace(bearing, displacement_capacity=None))
    (loops,) = run_program(Program("T01", (RigTest("T01", wave),)), free)
    return loops.cycles[1].friction
