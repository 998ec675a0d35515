"""The virtual test machine: the paper's ASCE test, all of its rows."""

import numpy as np
from figure import Figure
from stopwatch import in_turn, once, ratio

import dcfp
from dcfp.analysis.rig import load_program, run_program
from dcfp.system import Heating

ROUNDS = 20


def figures() -> list[Figure]:
    """Return the time of all rows with the precise model, measures included, and what the models cost beside each other."""
    program = load_program("asce")

    def measure(heating: Heating) -> None:
        for test in run_program(program, heating=heating):
            _ = test.cycles

    models = (dcfp.PreciseHeating(), dcfp.SimplifiedHeating(), dcfp.NoHeating())
    precise, simplified, none = in_turn(
        [lambda heating=heating: once(lambda: measure(heating)) for heating in models], ROUNDS
    )
    cycles = sum(test.waveform.cycles for test in program.tests)
    note = f"{len(program.tests)} tests of {cycles:g} cycles in all, with their measures"
    return [
        Figure("ASCE test, precise model", float(np.median(precise)), "s", at_most=1.0, note=note),
        Figure("ASCE test, precise over simplified", ratio(precise, simplified), at_most=2.0),
        Figure("ASCE test, none over simplified", ratio(none, simplified)),
    ]
