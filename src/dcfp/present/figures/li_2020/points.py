"""The figures that have a point for each record and PGV, with their captions."""

from functools import partial
from typing import TYPE_CHECKING, TypeAlias

from dcfp.present.figures.li_2020.accuracy import draw_accuracy
from dcfp.present.figures.li_2020.by_pgv import (
    draw_displacement_change,
    draw_hysteretic_velocity,
    draw_input_velocity,
    draw_largest_displacement,
    draw_velocity_change,
)
from dcfp.present.figures.li_2020.energy import draw_absorbed_ratio, draw_input_over_change
from dcfp.present.figures.li_2020.marks import Mark, marks_of, name_records, small_figure
from dcfp.present.figures.li_2020.paper_figure import PaperFigure

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from matplotlib.axes import Axes

    from dcfp.inference import Case
    from dcfp.methods.li_2020 import Constants

    #: What draws the points of all cases on axes.
    Draw: TypeAlias = Callable[[Axes, Sequence[Case], Mapping[str, Mark]], None]
    Described: TypeAlias = tuple[str, str, str, tuple[Draw, ...]]


def point_figures(cases: "Sequence[Case]", constants: "Constants") -> list[PaperFigure]:
    """Draw every figure that has a point for each case."""
    marks = marks_of(cases)
    found: list[PaperFigure] = []
    for number, title, words, draws in _described(cases, constants):
        figure = small_figure(len(draws))
        for place, draw in enumerate(draws):
            draw(figure.add_subplot(1, len(draws), place + 1), cases, marks)
        name_records(figure, marks)
        found.append(PaperFigure(number, title, words, figure))
    return found


def _described(cases: "Sequence[Case]", constants: "Constants") -> "tuple[Described, ...]":
    """Return number, title, caption and panels of each figure."""
    from dcfp.inference.case import (  # late: the package imports the kernels
        CHANGE,
        HYSTERETIC,
        INPUT,
        Basis,
        Method,
    )

    blind = (
        "the largest of all pulses of the record and of all swings of the analysis, with the paper's range."
    )
    informed = f"of the pulse that the analysis found to govern.{_left_out(cases)}"
    return (
        (
            "11",
            "Largest displacement",
            "Largest displacement against the PGV.",
            (draw_largest_displacement,),
        ),
        (
            "18",
            "Accuracy of the pulse method for the change of displacement",
            f"Largest change of displacement, predicted by the pulse method and analysed, {blind}",
            (partial(draw_accuracy, view=(Method.PULSE, Basis.BLIND), which=CHANGE),),
        ),
        (
            "19",
            "Absorbed part of the energy",
            f"Equivalent velocities of dissipated over input energy against the ratio of the slopes, with Eq. (27), {informed}",
            (partial(draw_absorbed_ratio, constants=constants),),
        ),
        (
            "20",
            "Input energy and change of the ground velocity",
            f"Equivalent velocity of the input energy against the change of the ground velocity, with Eq. (28), {informed}",
            (partial(draw_input_over_change, constants=constants),),
        ),
        (
            "22",
            "Accuracy of the simplified method for the input energy",
            f"Equivalent velocity of the input energy, predicted by the simplified method and analysed, {blind}",
            (partial(draw_accuracy, view=(Method.SIMPLIFIED, Basis.BLIND), which=INPUT),),
        ),
        (
            "23",
            "Accuracy of the simplified method for the dissipated energy",
            f"Equivalent velocity of the dissipated energy, predicted by the simplified method and analysed, {blind}",
            (partial(draw_accuracy, view=(Method.SIMPLIFIED, Basis.BLIND), which=HYSTERETIC),),
        ),
        (
            "24",
            "Accuracy of the simplified method for the change of displacement",
            f"Largest change of displacement, predicted by the simplified method and analysed, {blind}",
            (partial(draw_accuracy, view=(Method.SIMPLIFIED, Basis.BLIND), which=CHANGE),),
        ),
        (
            "25",
            "Change of the ground velocity and PGV",
            f"Change of the ground velocity against the PGV, with Eq. (29), {informed}",
            (partial(draw_velocity_change, constants=constants),),
        ),
        (
            "26",
            "Energies from the PGV alone",
            "Largest equivalent velocities of input and dissipated energy against the PGV, with Eqs (31) and (32).",
            (
                partial(draw_input_velocity, constants=constants),
                partial(draw_hysteretic_velocity, constants=constants),
            ),
        ),
        (
            "27",
            "Change of displacement from the PGV alone",
            "Largest change of displacement against the PGV, with Eq. (33).",
            (partial(draw_displacement_change, constants=constants),),
        ),
    )


def _left_out(cases: "Sequence[Case]") -> str:
    without = sum(case.analysed.pulse is None for case in cases)
    if not without:
        return ""
    return f" Left out of {len(cases)} analyses: {without} without a pulse behind the largest swing."
