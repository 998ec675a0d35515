"""Runs a test program on the virtual machine."""

import time
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

import numpy as np

from dcfp.analysis.integration import DEFAULT, NOTHING, Integration, Keep
from dcfp.analysis.rig.loops import Loops
from dcfp.analysis.rig.machine import Machine, checked_program, run_all
from dcfp.analysis.rig.program import Program, RigTest
from dcfp.analysis.rig.waveform import Travel
from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.kernels import integrate as k
from dcfp.kernels._jit import Records
from dcfp.kernels.friction import BearingModel
from dcfp.kernels.heat_state import PRESENT, Heat
from dcfp.kernels.heating import place_slider
from dcfp.kernels.imposed_motion import ImposedMotion, MachineConstants, PathInterval, friction_at
from dcfp.kernels.law import Law
from dcfp.kernels.motion import DONE, NO_NUMBER
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
    profile_now,
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
    program = checked_program(program, system)
    refuse_other(keep, Keep, "keep", "a Keep")
    if program.plane:
        msg = f"{program.name}: its tests go in two directions; run_in_the_plane runs them."
        raise InputError(msg)
    _load_kernels()
    return run_all(program, lambda tests: _Machine(tests, system, integration.tolerance, keep), report)


class _Machine(Machine[Loops]):
    """A bearing through tests in one direction."""

    def __init__(self, tests: Sequence[RigTest], system: System, tolerance: float, keep: Keep) -> None:
        super().__init__(tests, system)
        self.tolerance, self.keep = tolerance, keep
        self.machine = MachineConstants(
            self.bearing.slider_area, self.bearing.effective_radius, self.bearing.elastic_stiffness
        )
        self.plates: PlateHeat = cold_plates(system, reach=self.reach, horizon=self.horizon)

    def run(self, test: RigTest) -> Loops:
        """Run the next of the tests."""
        travel = self.travel(test)
        heat = heat_of(self.plates, self.system)
        if self.clock > 0.0 and test.pause:
            self.pause(heat, test.pause)
        place_slider(heat, self.constants, self.clock, float(travel.pieces[0, 0]))
        law, path = self._path(test, travel)
        model = BearingModel(law, self.constants, heat)
        lines = np.empty((travel.lengths.size + 1, k.TEST_TEMPERATURE + self.constants.plates))
        first, lines[0] = PathInterval(*path[0].item()), 0.0
        imposed = ImposedMotion(self.machine, first, self.clock, 0.0)
        friction = friction_at(model, imposed, 0.0, PRESENT)
        lines[0, [k.DISPLACEMENT, k.VELOCITY]] = first.displacement, first.velocity
        lines[0, [k.FRICTION, k.LOAD]] = friction, first.load
        lines[0, k.TEST_TEMPERATURE :] = self.plates.temperature
        state = self._state()
        state["spring"]["friction"] = friction
        begins = self.clock
        began = time.perf_counter()
        profiles = self._imposed(test, model, travel, path, state, lines)
        elapsed = time.perf_counter() - began
        self.clock = float(state["time"][0])
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

    def _state(self) -> Records:
        state = np.zeros(1, k.TEST_STATE)
        state["time"] = self.clock
        return state

    def _path(self, test: RigTest, travel: Travel) -> tuple[Law, Records]:
        """Return the law at some pressure, and the path with load and reference of the law in each interval."""
        load, reference = self.loads(test, travel)
        law = self.friction.at_pressure(float(load[0]) / self.bearing.slider_area)
        load_rate, reference_rate = (np.diff(values) / travel.lengths for values in (load, reference))
        columns = (travel.pieces, load[:-1], load_rate, reference[:-1], reference_rate)
        return law, np.column_stack(columns).view(k.PATH)[:, 0]

    def pause(self, heat: Heat, length: float) -> None:
        """Let the plates cool."""
        lines = np.empty((2, k.TEST_TEMPERATURE + self.constants.plates))
        at_rest = PathInterval(0.0, 0.0, 0.0, 0.0, self.bearing.vertical_force, 0.0, 1.0, 0.0)
        model = BearingModel(self.friction.at_pressure(self.bearing.pressure), self.constants, heat)
        path, lengths = np.array([at_rest], k.PATH), np.array([length])
        k.impose_motion(model, self.machine, lengths, path, self.tolerance, self._state(), lines)
        self.clock += length

    def _imposed(
        self,
        test: RigTest,
        model: BearingModel,
        travel: Travel,
        path: Records,
        state: Records,
        lines: FloatArray,
    ) -> list[tuple[float, FloatArray]]:
        """Impose the whole path; return the profiles that were asked for."""
        profiles: list[tuple[float, FloatArray]] = []
        every = self.keep.interval(travel.lengths.size, self.system.heating)
        part = every or travel.lengths.size
        for first in range(0, travel.lengths.size, part):
            last = min(first + part, travel.lengths.size)
            lengths, intervals = travel.lengths[first:last], path[first:last]
            status, done = k.impose_motion(
                model, self.machine, lengths, intervals, self.tolerance, state, lines[first:]
            )
            if status != DONE:
                failure = self.friction.no_number if status == NO_NUMBER else self.friction.no_progress
                raise failure(test.name, float(travel.time[first + done]))
            if every is not None:
                line = lines[last]
                heating = abs(line[k.SLIP_SIGN] * line[k.FRICTION] * line[k.VELOCITY]) * line[k.LOAD]
                now, flux = float(state["time"][0]), float(heating / self.machine.area)
                profile = profile_now(model.heat, self.constants, now, flux)
                profiles.append((float(travel.time[last]), profile))
        return profiles


@cache
def _load_kernels() -> None:
    """Have the kernels compiled or loaded, and their arguments' types known, so that the time of a test is its own."""
    machine = _Machine((), System(), DEFAULT.tolerance, NOTHING)
    machine.pause(heat_of(machine.plates, machine.system), 1e-3)


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
