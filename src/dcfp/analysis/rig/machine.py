"""What the virtual machine does in one direction and in the plane: it takes a bearing through tests between which the plates keep their heat."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Generic, TypeVar

import numpy as np

from dcfp.analysis.rig.program import Program, RigTest, VerticalLoad, check_stroke, load_program
from dcfp.analysis.rig.virtual_test import VirtualTest
from dcfp.analysis.rig.waveform import Travel
from dcfp.arrays import FloatArray
from dcfp.schema.parameters import refuse_other
from dcfp.system import System
from dcfp.system.plates import horizon_for, system_constants

Tested = TypeVar("Tested", bound=VirtualTest)


class Machine(ABC, Generic[Tested]):
    """A bearing through some tests, the plates at the ambient temperature before the first of them."""

    def __init__(self, tests: Sequence[RigTest], system: System) -> None:
        self.system, self.bearing, self.friction = system, system.bearing, system.friction
        self.constants = system_constants(system)
        self.travels = {test.name: test.waveform.travel() for test in tests}
        self.reach = max((travel.largest for travel in self.travels.values()), default=0.0)
        duration = sum(float(travel.lengths.sum()) for travel in self.travels.values())
        self.horizon = horizon_for(duration + sum(test.pause or 0.0 for test in tests[1:]))
        self.clock = 0.0

    @abstractmethod
    def run(self, test: RigTest) -> Tested:
        """Run the next of the tests."""

    def travel(self, test: RigTest) -> Travel:
        """Return the displacement of a test in pieces, over each of which the load changes linearly too."""
        travel = self.travels[test.name]
        return travel if test.load is None else travel.cut_at(np.array(test.load.times))

    def loads(self, test: RigTest, travel: Travel) -> tuple[FloatArray, FloatArray]:
        """Return the vertical force [N] at the ends of the pieces of a test, and the reference of the friction law at its pressure [-].

        Raises
        ------
        InputError
            If the pressure is out of any sensible range.
        """
        vertical = VerticalLoad((self.bearing.pressure,)) if test.load is None else test.load
        load = vertical.at(travel.time, self.bearing)
        levels, place = np.unique(load / self.bearing.slider_area, return_inverse=True)
        known = [self.friction.at_pressure(float(level)).reference for level in levels]
        return load, np.array(known)[place]


def checked_program(program: Program | str | Path, system: System) -> Program:
    """Return a program, or load it, if none of its tests goes beyond the plate.

    Raises
    ------
    InputError
        If one does, or there is no such program.
    """
    if isinstance(program, (str, Path)):
        program = load_program(program)
    refuse_other(program, Program, "program", "a Program, the name of one or a file")
    for test in program.tests:
        check_stroke(test, system.bearing)
    return program


def run_all(
    program: Program,
    machine: Callable[[Sequence[RigTest]], Machine[Tested]],
    report: Callable[[], None] | None,
) -> tuple[Tested, ...]:
    """Run every test of a program, on a new machine wherever the plates begin cold; `report` is called after each."""
    found: list[Tested] = []
    for tests in program.sequences:
        one = machine(tests)
        for test in tests:
            found.append(one.run(test))
            if report is not None:
                report()
    return tuple(found)
