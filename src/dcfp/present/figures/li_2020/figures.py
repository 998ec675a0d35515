"""The figures of Li et al. (2020) about ground motions and predictions, in their order."""

from typing import TYPE_CHECKING

from dcfp.errors import InputError
from dcfp.present.figures.li_2020.histories import (
    draw_both_velocities,
    draw_loops_of_both_models,
    draw_relative_velocity,
    draw_velocity_energy_displacement,
    history_figure,
    loops_record,
)
from dcfp.present.figures.li_2020.marks import PaperFigure, small_figure
from dcfp.present.figures.li_2020.points import point_figures
from dcfp.present.figures.style import style
from dcfp.schema.digits import metres_per_second

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dcfp.analysis import Response
    from dcfp.inference import Case
    from dcfp.methods.li_2020 import Constants

#: Record and PGV [mm/s] of Figures 13 to 15.
_HISTORY_RECORD, _HISTORY_PGV = "NCC", 250.0


def paper_figures(
    cases: "Sequence[Case]",
    loops: "Mapping[tuple[str, float], tuple[Response, Response]]",
    constants: "Constants | None" = None,
) -> list[PaperFigure]:
    """Draw Figures 10, 11, 13 to 15, 18 to 20 and 22 to 27 of Li et al. (2020) from our own analyses.

    Parameters
    ----------
    cases
        Records at several PGVs, with their analyses kept.
    loops
        Analyses with the simplified and with the precise heating model, by record and PGV [mm/s]; without any there is no Figure 10.
    constants
        Of the predictions; by default those of the paper.

    Raises
    ------
    InputError
        If there is no case, or the analysis for Figures 13 to 15 was not kept.
    """
    if not cases:
        msg = "There is nothing to draw; give at least one case."
        raise InputError(msg)
    from dcfp.methods.li_2020 import LI_2020  # late: the package of predictions imports the kernels

    used = LI_2020 if constants is None else constants
    with style():
        drawn = [
            *(_loops(loops) if loops else ()),
            *_histories(cases),
            *point_figures(cases, used),
        ]
    return sorted(drawn, key=lambda one: int(one.number))


def _loops(loops: "Mapping[tuple[str, float], tuple[Response, Response]]") -> list[PaperFigure]:
    figure = small_figure(columns=2)
    draw_loops_of_both_models(figure, loops)
    words = f"Force against displacement under {loops_record(loops)} with the simplified and with the precise heating model."
    return [PaperFigure("10", "Loops with both heating models", words, figure)]


def _history_case(cases: "Sequence[Case]") -> "Case":
    """Return the case nearest to that of the paper: its record if there is, and the PGV closest to its own."""
    same = [case for case in cases if case.record == _HISTORY_RECORD] or [
        case for case in cases if case.record == cases[0].record
    ]
    return min(same, key=lambda case: abs(case.pgv - _HISTORY_PGV))


def _histories(cases: "Sequence[Case]") -> list[PaperFigure]:
    case = _history_case(cases)
    of_case = f"under {case.record} at a PGV of {metres_per_second(case.pgv)}"
    found: list[PaperFigure] = []
    for number, height, draw, title, words in (
        (
            "13",
            4.4,
            draw_velocity_energy_displacement,
            "Ground velocity, energy and displacement",
            f"Ground velocity with its pulses, energies and displacement {of_case}; the largest swing and its pulse are marked.",
        ),
        (
            "14",
            2.2,
            draw_both_velocities,
            "Velocities of ground and structure",
            f"Velocities of the ground and of the structure {of_case}; the area between them is the displacement.",
        ),
        (
            "15",
            2.2,
            draw_relative_velocity,
            "Relative velocity",
            f"Relative velocity {of_case}; the area is the same as between the velocities of ground and structure.",
        ),
    ):
        figure = history_figure(height)
        draw(figure, case)
        found.append(PaperFigure(number, title, words, figure))
    return found
