"""The figure of a test program: a sheet of one test, the dependencies of friction, or the loops of many tests."""

from typing import TYPE_CHECKING

from dcfp.present.figures.dependency import dependency_tests, plot_dependency
from dcfp.present.figures.rig_overview import plot_tests
from dcfp.present.figures.rig_sheet import plot_test

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.figure import Figure

    from dcfp.analysis.rig import Loops, Measurement, Program


def plot_program(
    program: "Program", runs: "Mapping[str, Sequence[Loops]]", measured: "Mapping[str, Measurement]"
) -> "Figure":
    """Draw what fits the program, on a new figure.

    Parameters
    ----------
    program
        What was run.
    runs
        Its tests by the name of the model.
    measured
        Measured tests by the name of the test that they belong to.
    """
    first = next(iter(runs.values()))
    if len(runs) == 1 and len(first) == 1:
        return plot_test(first[0], measured.get(first[0].test.name))
    if dependency_tests(program) is not None:
        return plot_dependency(program, runs, measured)
    return plot_tests(program, runs, measured)
