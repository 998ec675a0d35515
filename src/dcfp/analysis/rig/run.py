"""Runs a test program on the virtual machine, with one model or with several side by side."""

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from dcfp.analysis.rig.loops import Loops
from dcfp.analysis.rig.program import Program, RigTest, VerticalLoad, check_stroke
from dcfp.analysis.rig.waveform import Travel
from dcfp.arrays import FloatArray, freeze
from dcfp.errors import AnalysisError, InputError
from dcfp.kernels import drive as d
from dcfp.kernels.grip import Rig, available
from dcfp.kernels.heat_state import PRESENT, Heat
from dcfp.kernels.heating import place_slider
from dcfp.kernels.law import Law
from dcfp.kernels.path import Piece
from dcfp.system import (
    LI_2020,
    Bearing,
    ConstantFriction,
    FrictionLaw,
    Heating,
    Li2020,
    NoHeating,
    PreciseHeating,
    SimplifiedHeating,
    plates_of,
)
from dcfp.system.plates import (
    PlateHeat,
    Profiles,
    cold_plates,
    heat_of,
    horizon_for,
    profile_now,
    structure_of,
)

#: Default of how far the coefficient may be off its chord in a step, relative [-].
TOLERANCE = 0.02


def run_program(
    program: Program,
    bearing: Bearing = LI_2020,
    friction: FrictionLaw | None = None,
    heating: Heating | None = None,
    *,
    tolerance: float = TOLERANCE,
    profile_every: int | None = None,
    report: Callable[[], None] | None = None,
) -> tuple[Loops, ...]:
    """Run every test of a program.

    Parameters
    ----------
    program
        Tests in their order; the plates keep their heat through a pause, and start cold where a test has none.
    bearing
        By default that of Li et al. (2020); its own pressure is replaced by the load of each test.
    friction
        By default the law of Li et al. (2020), Eqs (7)-(10).
    heating
        By default the simplified model, Li et al. (2020), section 4.2.
    tolerance
        How far the coefficient of friction in the middle of a step may be from the mean of its ends, relative to it [-];
        looked at where the ends differ by more than that.
    profile_every
        Keep the temperature along the plates at every so many samples; needs the precise heating model.
    report
        Called after each test.

    Returns
    -------
    tuple of Loops
        One for each test.

    Raises
    ------
    InputError
        If a test goes beyond the plate or a load is out of range, or an argument is.
    AnalysisError
        If a test cannot be finished.
    """
    friction = Li2020() if friction is None else friction
    heating = SimplifiedHeating() if heating is None else heating
    if not (math.isfinite(tolerance) and 0.0 < tolerance < 1.0):
        msg = f"The tolerance must lie between 0 and 1, not {tolerance!r}."
        raise InputError(msg)
    if profile_every is not None and (heating.name != "precise" or profile_every < 1):
        msg = "The temperature along the plates needs the precise heating model and a positive number of samples."
        raise InputError(msg)
    for test in program.tests:
        check_stroke(test, bearing)
    loops: list[Loops] = []
    for story in program.stories:
        machine = _Machine(story, bearing, friction, heating, tolerance, profile_every)
        for test in story:
            loops.append(machine.run(test))
            if report is not None:
                report()
    return tuple(loops)


class _Machine:
    """A bearing through one story of tests."""

    def __init__(
        self,
        story: Sequence[RigTest],
        bearing: Bearing,
        friction: FrictionLaw,
        heating: Heating,
        tolerance: float,
        profile_every: int | None,
    ) -> None:
        self.bearing, self.friction, self.heating = bearing, friction, heating
        self.tolerance, self.profile_every = tolerance, profile_every
        self.structure = structure_of(bearing, friction)
        self.rig = Rig(bearing.slider_area, bearing.effective_radius, bearing.elastic_stiffness)
        self.travels = {test.name: test.waveform.travel() for test in story}
        duration = sum(float(travel.lengths.sum()) for travel in self.travels.values())
        duration += sum(test.pause or 0.0 for test in story[1:])
        self.plates: PlateHeat = cold_plates(
            bearing,
            heating,
            reach=max(travel.largest for travel in self.travels.values()),
            horizon=horizon_for(duration),
        )
        self.clock = 0.0

    def run(self, test: RigTest) -> Loops:
        """Run the next test of the story."""
        travel = self.travels[test.name]
        if test.load is not None:
            travel = travel.cut_at(np.array(test.load.times))
        heat = heat_of(self.plates, self.bearing, self.heating)
        if self.clock > 0.0 and test.pause:
            self._pause(heat, test.pause)
        place_slider(heat, self.structure, self.clock, float(travel.pieces[0, 0]))
        law, pieces = self._pieces(test, travel)
        lines = np.empty((travel.lengths.size + 1, d.TEMPERATURE + self.structure.plates))
        lines[0] = self._first_line(law, heat, pieces[0])
        state = self._state()
        begins = self.clock
        began = time.perf_counter()
        profiles = self._drive(test, law, heat, travel, pieces, state, lines)
        elapsed = time.perf_counter() - began
        self.clock = float(state[d.STATE_TIME])
        return Loops(
            test=test,
            bearing=self.bearing,
            friction_law=self.friction,
            heating=self.heating,
            time=freeze(travel.time),
            lines=freeze(lines),
            begins=begins,
            cycle_times=freeze(travel.cycles),
            profiles=Profiles.of(profiles, self.bearing, self.heating) if profiles else None,
            elapsed=elapsed,
        )

    def _state(self) -> FloatArray:
        state = np.zeros(d.STATE_SIZE)
        state[d.STATE_TIME] = self.clock
        return state

    def _pieces(self, test: RigTest, travel: Travel) -> tuple[Law, FloatArray]:
        """Return the law at some pressure, and the path with load and reference of the law in each piece."""
        vertical = VerticalLoad((self.bearing.pressure,)) if test.load is None else test.load
        load = vertical.at(travel.time, self.bearing)
        pressure = load / self.bearing.slider_area
        law = self.friction.at_pressure(float(pressure[0]))
        levels, place = np.unique(pressure, return_inverse=True)
        reference = np.array([self.friction.at_pressure(float(level)).reference for level in levels])[place]
        rates = (np.diff(values) / travel.lengths for values in (load, reference))
        load_rate, reference_rate = rates
        return law, np.column_stack((travel.pieces, load[:-1], load_rate, reference[:-1], reference_rate))

    def _first_line(self, law: Law, heat: Heat, first: FloatArray) -> FloatArray:
        line = np.zeros(d.TEMPERATURE + self.structure.plates)
        piece = Piece(*(float(value) for value in first))
        line[d.DISPLACEMENT], line[d.VELOCITY] = piece.displacement, piece.velocity
        line[d.FRICTION] = available(law, self.structure, self.rig, heat, piece, 0.0, PRESENT)
        line[d.LOAD] = piece.load
        line[d.TEMPERATURE :] = self.plates.temperature
        return line

    def _pause(self, heat: Heat, length: float) -> None:
        """Let the plates cool."""
        lines = np.empty((2, d.TEMPERATURE + self.structure.plates))
        lines[0] = 0.0
        pieces = np.array([[0.0, 0.0, 0.0, 0.0, self.bearing.vertical_force, 0.0, 1.0, 0.0]])
        state = self._state()
        law = self.friction.at_pressure(self.bearing.pressure)
        d.drive(law, self.structure, self.rig, heat, np.array([length]), pieces, self.tolerance, state, lines)
        self.clock += length

    def _drive(
        self,
        test: RigTest,
        law: Law,
        heat: Heat,
        travel: Travel,
        pieces: FloatArray,
        state: FloatArray,
        lines: FloatArray,
    ) -> list[tuple[float, FloatArray]]:
        """Drive through the whole path; return the profiles that were asked for."""
        profiles: list[tuple[float, FloatArray]] = []
        part = self.profile_every or travel.lengths.size
        for first in range(0, travel.lengths.size, part):
            last = min(first + part, travel.lengths.size)
            status, done = d.drive(
                law, self.structure, self.rig, heat, travel.lengths[first:last], pieces[first:last],
                self.tolerance, state, lines[first:],
            )  # fmt: skip
            if status == d.NO_NUMBER:
                raise self.friction.no_number(test.name, float(travel.time[first + done]))
            if status != d.DONE:
                msg = f"{test.name}: the test makes no progress at {travel.time[first + done]:.4g} s; look at the friction law."
                raise AnalysisError(msg)
            if self.profile_every is not None:
                line = lines[last]
                flux = abs(line[d.SIDE] * line[d.FRICTION] * line[d.VELOCITY]) * line[d.LOAD] / self.rig.area
                now = float(state[d.STATE_TIME])
                profiles.append(
                    (float(travel.time[last]), profile_now(heat, self.structure, now, float(flux)))
                )
        return profiles


# The same tests with several models, side by side.


@dataclass(frozen=True)
class Model:
    """A friction law and a heating model under a short name."""

    name: str
    friction: FrictionLaw
    heating: Heating


def paper_models(friction: FrictionLaw, heating: Heating) -> tuple[Model, ...]:
    """Return the three models that Li et al. (2020), section 4, compare.

    A law with precise and with simplified heating, and the constant nominal coefficient without any.

    Parameters
    ----------
    friction
        Law of the first two.
    heating
        From which the plates are taken; if it is the precise model, its cells too.
    """
    plates = plates_of(heating)
    precise = heating if isinstance(heating, PreciseHeating) else PreciseHeating(**plates)
    return (
        Model("precise", friction, precise),
        Model("simplified", friction, SimplifiedHeating(**plates)),
        Model("constant", ConstantFriction(), NoHeating(**plates)),
    )


def run_models(
    program: Program,
    bearing: Bearing,
    models: tuple[Model, ...],
    *,
    tolerance: float = TOLERANCE,
    report: Callable[[], None] | None = None,
) -> dict[str, tuple[Loops, ...]]:
    """Run a program with every model; return the tests by the name of the model. Arguments as in `run_program`."""
    return {
        model.name: run_program(
            program, bearing, model.friction, model.heating, tolerance=tolerance, report=report
        )
        for model in models
    }
