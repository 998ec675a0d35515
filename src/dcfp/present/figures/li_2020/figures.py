"""The figures of Li et al. (2020) about ground motions and predictions, in their order."""

from typing import TYPE_CHECKING, Any

from matplotlib.figure import Figure

from dcfp.errors import InputError
from dcfp.present.figures.drawing import draw_cross
from dcfp.present.figures.li_2020.marks import PaperFigure, small_figure
from dcfp.present.figures.li_2020.points import point_figures
from dcfp.present.figures.pulses import StrongPart, mark_pulse
from dcfp.present.figures.style import BLUE, OCHRE, PAGE_WIDTH, draw_line, label_axes, legend_above, style
from dcfp.present.panels import loop
from dcfp.schema.digits import metres_per_second

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dcfp.analysis import Response
    from dcfp.inference import Case
    from dcfp.methods.li_2020 import Constants

#: Record and PGV [mm/s] of Figures 13 to 15.
_HISTORY_RECORD, _HISTORY_PGV = "NCC", 250.0
#: Record of Figure 10, which no open data set has, and the other one of that earthquake.
_LOOP_RECORDS = ("JKB", "KNA")


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
            *([_loops(loops)] if loops else ()),
            *_histories(cases),
            *point_figures(cases, used),
        ]
    return sorted(drawn, key=lambda one: int(one.number))


def _loops(loops: "Mapping[tuple[str, float], tuple[Response, Response]]") -> PaperFigure:
    """Draw force against displacement with the simplified and the precise heating model, at the lowest and the highest PGV: Figure 10."""
    records = {name for name, _ in loops}
    largest = max(loops.items(), key=lambda item: item[1][0].peak_displacement)[0][0]
    record = next((name for name in _LOOP_RECORDS if name in records), largest)
    pgvs = sorted(pgv for name, pgv in loops if name == record)
    chosen = pgvs if len(pgvs) == 1 else [pgvs[0], pgvs[-1]]
    figure = small_figure(columns=2)
    axes: Any = figure.subplots(1, len(chosen), squeeze=False)[0]
    for one, pgv, letter in zip(axes, chosen, "ab", strict=False):
        draw_cross(one)
        looks = ((BLUE, "-", "simplified"), (OCHRE, (0, (4, 2)), "precise"))
        for response, (colour, dashes, label) in zip(loops[record, pgv], looks, strict=True):
            panel = loop(response)
            (path,) = panel.lines
            shown = panel.x.display(path.x), panel.y.display(path.y)
            draw_line(one, *shown, colour, path.width, linestyle=dashes, label=label)
            label_axes(one, panel.x.label, panel.y.label, 5, 5)
        one.set_title(f"({letter}) PGV {metres_per_second(pgv)}", loc="left")
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=2, borderaxespad=0.4)
    words = (
        f"Force against displacement under {record} with the simplified and with the precise heating model."
    )
    return PaperFigure("10", "Loops with both heating models", words, figure)


def _histories(cases: "Sequence[Case]") -> list[PaperFigure]:
    """Draw the case nearest to that of the paper, its record if there is, over time: Figures 13 to 15."""
    same = [case for case in cases if case.record == _HISTORY_RECORD]
    same = same or [case for case in cases if case.record == cases[0].record]
    case = min(same, key=lambda case: abs(case.pgv - _HISTORY_PGV))
    part = StrongPart.of(case)
    of_case = f"under {case.record} at a PGV of {metres_per_second(case.pgv)}"
    figures = [Figure(figsize=(PAGE_WIDTH, height), layout="constrained") for height in (4.4, 2.2, 2.2)]
    panels: Any = figures[0].subplots(3, 1, sharex=True, height_ratios=[1.15, 1.0, 1.0])
    part.draw_pulses(panels[0], case.pulses)
    if case.analysed.pulse is not None:
        mark_pulse(panels[0], case.pulses, case.analysed.pulse, BLUE)
    part.draw_energy(panels[1])
    part.draw_displacement(panels[2])
    for axes in panels[1:]:
        part.shade(axes)
    part.limit_time(list(panels))
    for figure, draw in zip(figures[1:], (part.draw_velocities, part.draw_relative_velocity), strict=True):
        axes = figure.add_subplot()
        draw(axes)
        legend_above(axes)
        part.limit_time([axes])
    described = (
        ("13", "Ground velocity, energy and displacement", f"Ground velocity with its pulses, energies and displacement {of_case}; the largest swing and its pulse are marked."),
        ("14", "Velocities of ground and structure", f"Velocities of the ground and of the structure {of_case}; the area between them is the displacement."),
        ("15", "Relative velocity", f"Relative velocity {of_case}; the area is the same as between the velocities of ground and structure."),
    )  # fmt: skip
    return [PaperFigure(*words, figure) for words, figure in zip(described, figures, strict=True)]
