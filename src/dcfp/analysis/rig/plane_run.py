"""Runs a test program on the virtual machine in two directions."""

import time
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

import numpy as np

from dcfp.analysis.integration import DEFAULT, Integration
from dcfp.analysis.plane_fields import Fields, fields_at
from dcfp.analysis.plane_history import TOLERANCE
from dcfp.analysis.rig.machine import Machine, checked_program, run_all
from dcfp.analysis.rig.plane_loops import PlaneLoops
from dcfp.analysis.rig.program import Program, RigTest
from dcfp.analysis.rig.waveform import Sine, Travel
from dcfp.arrays import FloatArray, freeze
from dcfp.errors import AnalysisError
from dcfp.kernels import imposed_path as k
from dcfp.kernels._jit import Records
from dcfp.kernels.motion import DONE, NO_NUMBER
from dcfp.kernels.plane_integrate import X, Y
from dcfp.system import FrictionLaw, Heating, PreciseHeating, System, SystemLike
from dcfp.system.fields import PlaneHeat, cold_heat

#: Room beyond the furthest end of a piece, relative to it [-]: a piece bends outwards.
_ROOM = 1.01


def run_in_the_plane(
    program: Program | str | Path,
    bearing: SystemLike = None,
    friction: FrictionLaw | str | None = None,
    heating: Heating | str | None = None,
    *,
    tolerance: float = DEFAULT.tolerance,
    report: Callable[[], None] | None = None,
) -> tuple[PlaneLoops, ...]:
    """Run every test of a program in two directions, under a round contact; tests in one direction go along x.

    Parameters
    ----------
    program
        Tests in their order, or what `load_program` takes; the plates keep their heat through a pause, and start cold where a test has none.
    bearing, friction, heating
        As for `dcfp.respond` with a station: the precise heating model where nothing says which. The bearing's own pressure is replaced by the load of each test.
    tolerance
        How fine the steps are: `Integration`.
    report
        Called after each test.

    Returns
    -------
    tuple of PlaneLoops
        One for each test.

    Raises
    ------
    InputError
        If a test goes beyond the plate or a load is out of range, or an argument is.
    AnalysisError
        If a test cannot be finished.
    """
    system = System.of(bearing, friction, heating, usual=PreciseHeating.name)
    integration = Integration(tolerance=tolerance)
    program = checked_program(program, system)
    _load_kernels()
    return run_all(program, lambda tests: _PlaneMachine(tests, system, integration.tolerance), report)


class _PlaneMachine(Machine[PlaneLoops]):
    """A bearing through tests in the plane."""

    def __init__(self, tests: Sequence[RigTest], system: System, tolerance: float) -> None:
        super().__init__(tests, system)
        self.tolerance = TOLERANCE * tolerance / DEFAULT.tolerance
        self.heat: PlaneHeat = cold_heat(system, _ROOM * self.reach, horizon=self.horizon)
        self.place = 0j

    def run(self, test: RigTest) -> PlaneLoops:
        """Run the next of the tests."""
        travel = self.travel(test)
        pause = (test.pause or 0.0) if self.clock > 0.0 else 0.0
        start = complex(travel.pieces[0, 0])
        model = self.heat.model(self.system)
        self.clock += pause
        k.cool_and_place(model, self.heat.field, pause, self.clock, self.place, start)
        begins, cold = self.clock, self.heat.copy()
        pieces = self._pieces(test, travel)
        began = time.perf_counter()
        lines = self._followed(test, self.heat, travel, pieces, begins)
        elapsed = time.perf_counter() - began
        self.clock = begins + float(travel.lengths.sum())
        self.place = complex(*lines[-1, [X, Y]])
        return PlaneLoops(
            test=test,
            system=self.system,
            time=freeze(travel.time),
            lines=freeze(lines),
            begins=begins,
            lap_times=freeze(travel.cycles),
            fields=self._fields(test, cold, travel, pieces, lines, begins),
            elapsed=elapsed,
        )

    def _pieces(self, test: RigTest, travel: Travel) -> Records:
        """Return the path with load and reference of the law in each piece."""
        load, reference = self.loads(test, travel)
        ratio = load / self.bearing.vertical_force
        pieces = np.zeros(travel.lengths.size, k.PATH_PIECE)
        for place, name in enumerate(("position", "velocity", "second", "third")):
            pieces[name] = travel.pieces[:, place]
        for name, values in (("load", ratio), ("reference", reference)):
            pieces[name] = values[:-1]
            pieces[f"{name}_rate"] = np.diff(values) / travel.lengths
        return pieces

    def _followed(
        self,
        test: RigTest,
        heat: PlaneHeat,
        travel: Travel,
        pieces: Records,
        begins: float,
        count: int | None = None,
    ) -> FloatArray:
        """Follow the first pieces of a path from a time [s] on, by default all; return the histories. The heat changes."""
        lengths = travel.lengths[:count]
        lines = np.empty((lengths.size + 1, k.TEMPERATURE + self.constants.plates))
        model = heat.model(self.system)
        status, done = k.follow(
            model, heat.field, lengths, pieces[: lengths.size], self.tolerance, begins, lines
        )
        if status == NO_NUMBER:
            raise self.friction.no_number(test.name, float(travel.time[done]))
        if status != DONE:
            msg = f"{test.name}: the slider left the part of the plate that the heat model covers."
            raise AnalysisError(msg)
        return lines

    def _fields(
        self,
        test: RigTest,
        cold: PlaneHeat,
        travel: Travel,
        pieces: Records,
        lines: FloatArray,
        begins: float,
    ) -> Fields | None:
        """Return the temperature of the plates where a point is hottest and at the end; to the first of these it is run again."""
        if not isinstance(self.system.heating, PreciseHeating):
            return None
        last = travel.lengths.size
        hottest = max(int(lines[:, k.POINT].argmax()), 1)

        def go_on(_: int, piece: int) -> tuple[PlaneHeat, float]:
            if piece == last:
                return self.heat, self.clock
            self._followed(test, cold, travel, pieces, begins, piece)
            return cold, begins + float(travel.time[piece])

        moments = sorted({hottest, last})
        return fields_at(moments, travel.time, lines, lines[:, k.LOAD], self.system, self.heat, go_on)


@cache
def _load_kernels() -> None:
    """Have the kernels compiled or loaded, so that the time of a test is its own."""
    test = RigTest("", Sine(1.0, 1.0, 1))
    _PlaneMachine((test,), System(heating=PreciseHeating()), DEFAULT.tolerance).run(test)
