"""Runs a test program on the virtual machine, with one model or with several side by side."""

import time
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path

import numpy as np

from dcfp.analysis.integration import DEFAULT, NOTHING, Integration, Keep
from dcfp.analysis.rig.loops import Loops
from dcfp.analysis.rig.program import Program, RigTest, VerticalLoad, check_stroke
from dcfp.analysis.rig.read import program_of
from dcfp.analysis.rig.waveform import Travel
from dcfp.arrays import FloatArray, freeze
from dcfp.errors import AnalysisError
from dcfp.kernels import drive as d
from dcfp.kernels.grip import Rig, available
from dcfp.kernels.heat_state import PRESENT, Heat
from dcfp.kernels.heating import place_slider
from dcfp.kernels.law import Law
from dcfp.kernels.path import Piece
from dcfp.schema.parameters import refuse_other
from dcfp.system import (
    ConstantFriction,
    FrictionLaw,
    Heating,
    NoHeating,
    PreciseHeating,
    SimplifiedHeating,
    System,
    SystemLike,
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


def run_program(
    program: Program | str | Path,
    bearing: SystemLike = None,
    friction: FrictionLaw | str | None = None,
    heating: Heating | str | None = None,
    *,
    tolerance: float = DEFAULT.tolerance,
    keep: Keep = NOTHING,
    report: Callable[[], None] | None = None,
) -> tuple[Loops, ...]:
    """Run every test of a program.

    Parameters
    ----------
    program
        Tests in their order, or what `load_program` takes; the plates keep their heat through a pause, and start cold where a test has none.
    bearing, friction, heating
        As for `dcfp.respond`; the bearing's own pressure is replaced by the load of each test.
    tolerance
        How far the coefficient of friction in the middle of a step may be from the mean of its ends, relative to it [-]: `Integration`.
    keep
        What to keep of each test beside its histories.
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
    system, integration = System.of(bearing, friction, heating), Integration(tolerance=tolerance)
    program = program_of(program)
    refuse_other(keep, Keep, "keep", "a Keep")
    for test in program.tests:
        check_stroke(test, system.bearing)
    _load_kernels()
    loops: list[Loops] = []
    for story in program.stories:
        machine = _Machine(story, system, integration.tolerance, keep)
        for test in story:
            loops.append(machine.run(test))
            if report is not None:
                report()
    return tuple(loops)


class _Machine:
    """A bearing through one story of tests."""

    def __init__(self, story: Sequence[RigTest], system: System, tolerance: float, keep: Keep) -> None:
        self.system, self.tolerance, self.keep = system, tolerance, keep
        self.bearing, self.friction = system.bearing, system.friction
        self.structure = structure_of(system)
        self.rig = Rig(
            self.bearing.slider_area, self.bearing.effective_radius, self.bearing.elastic_stiffness
        )
        self.travels = {test.name: test.waveform.travel() for test in story}
        duration = sum(float(travel.lengths.sum()) for travel in self.travels.values())
        duration += sum(test.pause or 0.0 for test in story[1:])
        self.plates: PlateHeat = cold_plates(
            system,
            reach=max((travel.largest for travel in self.travels.values()), default=0.0),
            horizon=horizon_for(duration),
        )
        self.clock = 0.0

    def run(self, test: RigTest) -> Loops:
        """Run the next test of the story."""
        travel = self.travels[test.name]
        if test.load is not None:
            travel = travel.cut_at(np.array(test.load.times))
        heat = heat_of(self.plates, self.system)
        if self.clock > 0.0 and test.pause:
            self.pause(heat, test.pause)
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
            system=self.system,
            time=freeze(travel.time),
            lines=freeze(lines),
            begins=begins,
            cycle_times=freeze(travel.cycles),
            profiles=Profiles.of(profiles, self.system) if profiles else None,
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

    def pause(self, heat: Heat, length: float) -> None:
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
        every = self.keep.interval(travel.lengths.size, self.system.heating)
        part = every or travel.lengths.size
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
            if every is not None:
                line = lines[last]
                flux = abs(line[d.SIDE] * line[d.FRICTION] * line[d.VELOCITY]) * line[d.LOAD] / self.rig.area
                now = float(state[d.STATE_TIME])
                profiles.append(
                    (float(travel.time[last]), profile_now(heat, self.structure, now, float(flux)))
                )
        return profiles


@cache
def _load_kernels() -> None:
    """Have the kernels compiled or loaded, and their arguments' types known, so that the time of a test is its own."""
    machine = _Machine((), System(), DEFAULT.tolerance, NOTHING)
    machine.pause(heat_of(machine.plates, machine.system), 1e-3)


# The same tests with several models, side by side.


def paper_models(system: System) -> dict[str, System]:
    """Return the three models that Li et al. (2020), section 4, compare, by a short name.

    A law with precise and with simplified heating, and the constant nominal coefficient without any; bearing, law and plates are those of a
    `system`, and if its heating is precise, its cells too.
    """
    plates = plates_of(system.heating)
    precise = system.heating if isinstance(system.heating, PreciseHeating) else PreciseHeating(**plates)
    return {
        "precise": System(system.bearing, system.friction, precise),
        "simplified": System(system.bearing, system.friction, SimplifiedHeating(**plates)),
        "constant": System(system.bearing, ConstantFriction(), NoHeating(**plates)),
    }


def run_models(
    program: Program,
    models: Mapping[str, System],
    *,
    tolerance: float = DEFAULT.tolerance,
    report: Callable[[], None] | None = None,
) -> dict[str, tuple[Loops, ...]]:
    """Run a program with every model; return the tests by the name of the model. Arguments as in `run_program`."""
    return {
        name: run_program(program, system, tolerance=tolerance, report=report)
        for name, system in models.items()
    }
