"""The figures of Li et al. (2020) about ground motions and predictions, drawn from our own analyses, and all of them on one sheet."""

import io
import textwrap
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from matplotlib.image import imread
from matplotlib.lines import Line2D

from dcfp.errors import InputError
from dcfp.present.figures import style
from dcfp.present.figures.drawing import draw_cross
from dcfp.present.figures.pulses import StrongPart, mark_pulse
from dcfp.present.panels import loop
from dcfp.schema.formulas import metres_per_second
from dcfp.schema.quantities import quantity

if TYPE_CHECKING:
    from collections.abc import Collection, Mapping, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.analysis import Response
    from dcfp.arrays import FloatArray
    from dcfp.inference import Case
    from dcfp.methods.li_2020 import Constants

#: Figures with histories, and their record and PGV [mm/s].
_HISTORIES = ("13", "14", "15")
_HISTORY_RECORD, _HISTORY_PGV = "NCC", 250.0
#: Record of Figure 10, which no open data set has, and the other one of that earthquake.
_LOOP_RECORDS = ("JKB", "KNA")
#: Dashes of a prediction, and of what is dotted beside it.
_DASHED, _DOTTED = (0, (5, 2)), (0, (1.5, 1.5))
#: Values of eps that Figure 19 compares [-], with their colours and lines.
_FALL_RATIOS = ((0.1, style.OCHRE, _DOTTED), (0.25, style.INK, "-"), (0.5, style.BLUE, _DASHED))
#: Characters of a legend in an inch of a figure's width, and those that a mark takes.
_CHARACTERS, _MARK_WIDTH = 16.5, 6
#: Width of the sheet, the gap between two figures, and the height of a title [in].
_WIDTH, _GAP, _TITLE = 14.8, 0.2, 0.4
#: Characters of a title in an inch.
_TITLE_CHARACTERS = 14


@dataclass(frozen=True, eq=False)
class PaperFigure:
    """A figure after one of Li et al. (2020): its number there, what it shows in a few words, and in a sentence for a caption."""

    number: str
    title: str
    words: str
    figure: "Figure"


@style.styled
def paper_figures(
    cases: "Sequence[Case]",
    loops: "Mapping[tuple[str, float], tuple[Response, Response]]",
    constants: "Constants | None" = None,
    numbers: "Collection[str] | None" = None,
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
    numbers
        Of the figures that are wanted, such as ``["26"]``; by default all.

    Raises
    ------
    InputError
        If there is no case, or the analysis for Figures 13 to 15 was not kept.
    """
    if not cases:
        msg = "There is nothing to draw; give at least one case."
        raise InputError(msg)
    from dcfp.methods.li_2020 import LI_2020  # late: the package of predictions imports the kernels

    def is_wanted(number: str) -> bool:
        return numbers is None or number in numbers

    marks = marks_of(cases)
    drawn = [_loops(loops)] if loops and is_wanted("10") else []
    if any(is_wanted(number) for number in _HISTORIES):
        drawn += [one for one in _histories(cases) if is_wanted(one.number)]
    for number, title, words, panels in _described(cases, LI_2020 if constants is None else constants):
        if not is_wanted(number):
            continue
        figure = _small_figure(len(panels))
        for place, panel in enumerate(panels):
            _draw(figure.add_subplot(1, len(panels), place + 1), panel, cases, marks)
        _name_records(figure, marks)
        drawn.append(PaperFigure(number, title, words, figure))
    return sorted(drawn, key=lambda one: int(one.number))


def _small_figure(columns: int) -> "Figure":
    """Return an empty figure as wide as a column of the page, or as the page."""
    return style.new_figure(2.8, 3.5 if columns == 1 else style.PAGE_WIDTH)


def _loops(loops: "Mapping[tuple[str, float], tuple[Response, Response]]") -> PaperFigure:
    """Draw force against displacement with the simplified and the precise heating model, at the lowest and the highest PGV: Figure 10."""
    records = {name for name, _ in loops}
    largest = max(loops.items(), key=lambda item: item[1][0].peak_displacement)[0][0]
    record = next((name for name in _LOOP_RECORDS if name in records), largest)
    pgvs = sorted(pgv for name, pgv in loops if name == record)
    chosen = pgvs if len(pgvs) == 1 else [pgvs[0], pgvs[-1]]
    figure = _small_figure(columns=2)
    axes: Any = figure.subplots(1, len(chosen), squeeze=False)[0]
    for one, pgv, letter in zip(axes, chosen, "ab", strict=False):
        draw_cross(one)
        looks = ((style.BLUE, "-", "simplified"), (style.OCHRE, (0, (4, 2)), "precise"))
        for response, (colour, dashes, label) in zip(loops[record, pgv], looks, strict=True):
            panel = loop(response)
            (path,) = panel.lines
            shown = panel.x.display(path.x), panel.y.display(path.y)
            style.draw_line(one, *shown, colour, path.width, linestyle=dashes, label=label)
            style.label_axes(one, panel.x.label, panel.y.label, 5, 5)
        one.set_title(f"({letter}) {record}, PGV {metres_per_second(pgv)}", loc="left")
    style.legend_outside(axes[0], 2, "upper right", borderaxespad=0.4)
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
    figures = [style.new_figure(height) for height in (4.4, 2.2, 2.2)]
    panels: Any = figures[0].subplots(3, 1, sharex=True, height_ratios=[1.15, 1.0, 1.0])
    part.draw_pulses(panels[0], case.pulses)
    if case.analysed.pulse is not None:
        mark_pulse(panels[0], case.pulses, case.analysed.pulse, style.BLUE)
    part.draw_energy(panels[1])
    part.draw_displacement(panels[2])
    for axes in panels[1:]:
        part.shade(axes)
    part.limit_time(list(panels))
    for figure, draw in zip(figures[1:], (part.draw_velocities, part.draw_relative_velocity), strict=True):
        axes = figure.add_subplot()
        draw(axes)
        style.legend_above(axes)
        part.limit_time([axes])
    described = (
        ("13", "Ground velocity, energy and displacement", f"Ground velocity with its pulses, energies and displacement {of_case}; the largest swing and its pulse are marked."),
        ("14", "Velocities of ground and structure", f"Velocities of the ground and of the structure {of_case}; the area between them is the displacement."),
        ("15", "Relative velocity", f"Relative velocity {of_case}; the area is the same as between the velocities of ground and structure."),
    )  # fmt: skip
    return [PaperFigure(*words, figure) for words, figure in zip(described, figures, strict=True)]


class _Line(NamedTuple):
    """A line of a panel, with its place among the others."""

    x: Any
    y: Any
    colour: str
    dashes: Any
    label: str | None
    width: float = 0.9
    order: float = 2


@dataclass(frozen=True)
class _Panel:
    """What a panel shows: the names of its axes, a point for each case, not a number where there is none, lines, the ends of the axes, and where the legend stands."""

    x: str
    y: str
    points: "FloatArray"
    lines: "Sequence[_Line]"
    across: float
    up: float | None = None
    legend: Any = "lower right"
    ticks: int = 5


def _described(
    cases: "Sequence[Case]", constants: "Constants"
) -> "Sequence[tuple[str, str, str, tuple[_Panel, ...]]]":
    """Return number, title, caption and panels of each figure."""
    from dcfp.methods.li_2020.constants import PULSE, SIMPLIFIED  # late: the package imports the kernels

    blind = "predicted by the {} method and analysed, the largest of all pulses of the record and of all swings of the analysis, with the paper's range."
    pulse, simplified = blind.format("pulse"), blind.format("simplified")
    without = sum(case.analysed.pulse is None for case in cases)
    left_out = f" Left out of {len(cases)} analyses: {without} without a pulse behind the largest swing."
    informed = f"of the pulse that the analysis found to govern.{left_out if without else ''}"
    change, put_in, absorbed = "displacement_change", "swing_input_velocity", "swing_hysteretic_velocity"
    bounds = [case.analysed.whole.bound for case in cases]
    largest = _against_pgv(cases, "peak_displacement", bounds, ())
    energies = (
        _design(cases, constants, put_in, "input_velocity", "Eq. (31)"),
        _design(cases, constants, absorbed, "hysteretic_velocity", "Eq. (32)"),
    )
    return (
        ("11", "Largest displacement", "Largest displacement against the PGV.", (largest,)),
        ("18", "Accuracy of the pulse method for the change of displacement", f"Largest change of displacement, {pulse}", (_accuracy(cases, PULSE, change),)),
        ("19", "Absorbed part of the energy", f"Equivalent velocities of dissipated over input energy against the ratio of the slopes, with Eq. (27), {informed}", (_absorbed_ratio(cases, constants),)),
        ("20", "Input energy and change of the ground velocity", f"Equivalent velocity of the input energy against the change of the ground velocity, with Eq. (28), {informed}", (_input_over_change(cases, constants),)),
        ("22", "Accuracy of the simplified method for the input energy", f"Equivalent velocity of the input energy, {simplified}", (_accuracy(cases, SIMPLIFIED, put_in),)),
        ("23", "Accuracy of the simplified method for the dissipated energy", f"Equivalent velocity of the dissipated energy, {simplified}", (_accuracy(cases, SIMPLIFIED, absorbed),)),
        ("24", "Accuracy of the simplified method for the change of displacement", f"Largest change of displacement, {simplified}", (_accuracy(cases, SIMPLIFIED, change),)),
        ("25", "Change of the ground velocity and PGV", f"Change of the ground velocity against the PGV, with Eq. (29), {informed}", (_velocity_change(cases, constants),)),
        ("26", "Energies from the PGV alone", "Largest equivalent velocities of input and dissipated energy against the PGV, with Eqs (31) and (32).", energies),
        ("27", "Change of displacement from the PGV alone", "Largest change of displacement against the PGV, with Eq. (33).", (_design(cases, constants, change, change, "Eq. (33)"),)),
    )  # fmt: skip


def _velocity_change(cases: "Sequence[Case]", constants: "Constants") -> _Panel:
    """Show |dvg| of the governing pulse against the PGV, with Eq. (29): Figure 25."""
    entry, zeta = quantity("ground_velocity_change"), constants.change_ratio
    ends = quantity("peak_ground_velocity").display(np.array([0.0, _largest_pgv(cases)]))
    line = _Line(ends, zeta * ends, style.INK, _DASHED, rf"$\zeta={zeta:.3g}$, Eq. (29)")
    label = f"$|{entry.symbol}|$ [{entry.shown.name}]"
    found = [_of_pulse(case, "changes") for case in cases]
    return _against_pgv(cases, "ground_velocity_change", found, (line,), y=label, legend="lower right")


def _of_pulse(case: "Case", name: str) -> float:
    """Return the size of a quantity of the governing pulse; not a number where there is none."""
    pulse = case.analysed.pulse
    return np.nan if pulse is None else abs(float(getattr(case.pulses, name)[pulse]))


def _design(cases: "Sequence[Case]", constants: "Constants", name: str, attribute: str, label: str) -> _Panel:
    """Show the largest of a quantity against the PGV, with what the PGV alone tells: Figures 26 and 27."""
    from dcfp.methods.li_2020 import predict_from_pgv  # late: predictions import the kernels

    lines: list[_Line] = []
    if constants.slides_on_average:
        pgvs = np.linspace(0.02, 1.0, 100) * 1.04 * _largest_pgv(cases)
        curve = np.array([getattr(predict_from_pgv(float(pgv), constants), attribute) for pgv in pgvs])
        shown = quantity("peak_ground_velocity").display(pgvs), quantity(name).display(curve)
        lines = [_Line(*shown, style.RED, _DASHED, label, 1.0)]
    return _against_pgv(cases, name, [getattr(case.analysed.whole, attribute) for case in cases], lines)


def _against_pgv(
    cases: "Sequence[Case]",
    name: str,
    values: "Sequence[float | None]",
    lines: "Sequence[_Line]",
    *,
    y: str = "",
    legend: str = "upper left",
) -> _Panel:
    velocity, entry = quantity("peak_ground_velocity"), quantity(name)
    found = np.array([[case.pgv for case in cases], values], dtype=np.float64)
    points = np.column_stack((velocity.display(found[0]), entry.display(found[1])))
    across = 1.08 * velocity.display(_largest_pgv(cases))
    return _Panel(velocity.label, y or entry.label, points, lines, across, legend=legend)


def _largest_pgv(cases: "Sequence[Case]") -> float:
    return max(case.pgv for case in cases)


def _absorbed_ratio(cases: "Sequence[Case]", constants: "Constants") -> _Panel:
    """Show V_dEhr / V_dE of the analyses against ku/kg of the governing pulse, with Eq. (27): Figure 19."""
    # late: predictions import the kernels
    from dcfp.methods.li_2020.simplified_method import absorbed_velocity_ratio

    def point(case: "Case") -> tuple[float, float]:
        slope, swing = _of_pulse(case, "mean_accelerations"), case.analysed.governing
        if swing.input_velocity == 0.0:
            return np.nan, np.nan
        return constants.friction_deceleration / slope, swing.hysteretic_velocity / swing.input_velocity

    points = np.array([point(case) for case in cases])
    across = 1.06 * max(1.1, _farthest(points, 0))
    ratio = np.linspace(0.0, across, 400)
    lines = [
        _Line(ratio, absorbed_velocity_ratio(ratio, eps), colour, dashes, rf"$\varepsilon={eps:g}$")
        for eps, colour, dashes in _FALL_RATIOS
    ]
    put_in, absorbed = quantity("swing_input_velocity").symbol, quantity("swing_hysteretic_velocity").symbol
    label = f"${absorbed}\\,/\\,{put_in}$"
    up = 1.08 * max(1.0, _farthest(points, 1))
    return _Panel(quantity("slope_ratio").label, label, points, lines, across, up, ticks=6)


def _input_over_change(cases: "Sequence[Case]", constants: "Constants") -> _Panel:
    """Show V_dE of the analyses against |dvg| of the governing pulse, with Eq. (28): Figure 20."""
    from dcfp.methods.li_2020.simplified_method import input_velocity

    change, put_in = quantity("ground_velocity_change"), quantity("swing_input_velocity")
    changes = np.array([_of_pulse(case, "changes") for case in cases])
    inputs = np.array([case.analysed.governing.input_velocity for case in cases])
    points = np.column_stack((change.display(changes), put_in.display(inputs)))
    across, up = 1.06 * (_farthest(points, 0) or 1.0), None
    lines: list[_Line] = []
    if constants.slides_on_average:
        ends = change.shown.inner(np.array([0.0, across]))
        line = input_velocity(ends, constants.friction_deceleration, constants.average_slope)
        label = rf"Eq. (28), $k_{{g,\mathrm{{ave}}}}={constants.average_slope:.0f}$ mm/s²"
        lines = [_Line([0.0, across], put_in.display(line), style.RED, _DASHED, label, 1.0)]
        up = 1.05 * max(_farthest(points, 1), float(lines[0].y.max()))
    return _Panel(f"$|{change.symbol}|$ [{change.shown.name}]", put_in.label, points, lines, across, up)


def _accuracy(cases: "Sequence[Case]", method: str, name: str) -> _Panel:
    """Show what a blind method predicts against the analysis, with the range of their ratio that the paper prints: Figures 18 and 22 to 24."""
    from dcfp.methods.li_2020.constants import PRINTED_RANGES  # late: the package imports the kernels
    from dcfp.methods.method import Information, Variant
    from dcfp.methods.pulses import NOTHING, PREDICTION_QUANTITIES, value_of

    entry, which, variant = quantity(name), PREDICTION_QUANTITIES[name], Variant(method, Information.BLIND)
    least, largest, _ = PRINTED_RANGES[variant, which]

    both = [(case.analysed.whole, case.predicted.get(variant, NOTHING)) for case in cases]
    points = entry.display(np.array([[value_of(one, which) for one in pair] for pair in both]))
    across, up = (1.08 * (_farthest(points, along) or 1.0) for along in (0, 1))
    ends = np.array([0.0, across])
    lines = [_Line(ends, ends, style.GREY, "-", None, 0.6, 1)] if least != 1.0 else []
    dotted = _DOTTED if least != 1.0 else "-"
    for ratio, colour, dashes in ((largest, style.RED, _DASHED), (least, style.INK, dotted)):
        lines.append(_Line(ends, ratio * ends, colour, dashes, f"ratio {ratio:.1f}", 0.8, 1))
    x, y = (f"${entry.symbol}$ {how} [{entry.shown.name}]" for how in ("analysed", "predicted"))
    return _Panel(x, y, points, lines, across, max(up, across))


def _farthest(points: "FloatArray", along: int) -> float:
    """Return the largest coordinate along an axis of the points that there are, 0 without any."""
    there = np.isfinite(points).all(axis=1)
    return float(points[there, along].max(initial=0.0))


def _draw(axes: "Axes", panel: _Panel, cases: "Sequence[Case]", marks: "Mapping[str, Mark]") -> None:
    """Draw a point for each case that has one, hollow where its ordinate is zero, and the lines."""
    for record, mark in marks.items():
        x, y = panel.points[[case.record == record for case in cases]].T
        full, empty = np.isfinite(x + y) & (y != 0.0), np.isfinite(x) & (y == 0.0)
        alpha = 0.85 if mark.size > 3.0 else 0.55
        style.draw_marks(axes, x[full], y[full], *mark, markeredgewidth=0.0, alpha=alpha, zorder=3)
        if empty.any():
            style.draw_marks(axes, x[empty], y[empty], *mark, **style.HOLLOW, zorder=3)
    ends: dict[str, Any] = {"xlim": (0.0, panel.across), "ylim": (0.0, panel.up)}
    style.label_axes(axes, panel.x, panel.y, 6, panel.ticks, **ends)
    for one in panel.lines:
        look: dict[str, Any] = {"linestyle": one.dashes, "label": one.label, "zorder": one.order}
        style.draw_line(axes, one.x, one.y, one.colour, one.width, **look)
    if panel.lines:
        axes.legend(loc=panel.legend, borderaxespad=0.7)


class Mark(NamedTuple):
    """Form, size [pt] and colour of a record's points."""

    marker: str
    size: float
    colour: str


#: Marks of the records of Li et al. (2020), Table 3, in its order, in Paul Tol's muted colours, which stay apart for colour-blind eyes.
_MARKS = {
    "JKB": Mark("o", 4.2, "#332288"),
    "KNA": Mark("s", 4.2, "#CC6677"),
    "TC1": Mark("v", 4.2, "#117733"),
    "NCC": Mark("^", 4.2, "#882255"),
    "LPG": Mark("D", 4.2, "#999933"),
    "IVD": Mark("P", 5.2, "#44AA99"),
    "TSD": Mark("X", 5.2, "#AA4499"),
    "TIM": Mark("<", 4.2, "#88CCEE"),
}


def marks_of(cases: "Sequence[Case]") -> dict[str, Mark]:
    """Return the mark of every record, in the order of the cases; more records than there are marks look all the same."""
    records = list(dict.fromkeys(case.record for case in cases))
    if len(records) > len(_MARKS):
        return dict.fromkeys(records, Mark("o", 2.4, style.BLUE))
    free = iter([mark for name, mark in _MARKS.items() if name not in records])
    return {name: _MARKS[name] if name in _MARKS else next(free) for name in records}


def _name_records(figure: "Figure", marks: "Mapping[str, Mark]") -> None:
    """Write the records and their marks above a figure."""
    entries = {style.drawable(name): mark for name, mark in marks.items()}
    if len(set(marks.values())) < len(marks):
        entries = {f"{len(marks)} records": next(iter(marks.values()))}
    handles = [
        Line2D([], [], marker=mark.marker, markersize=mark.size, color=mark.colour, linestyle="none", markeredgewidth=0.0, label=name)
        for name, mark in entries.items()
    ]  # fmt: skip
    longest = max(len(name) for name in entries)
    columns = max(1, int(_CHARACTERS * figure.get_figwidth() / (longest + _MARK_WIDTH)))
    look: dict[str, Any] = {"borderaxespad": 0.4, "handlelength": 0.9, "columnspacing": 1.0}
    legend = figure.legend(handles=handles, loc="outside upper left", ncols=columns, **look)
    for text in legend.get_texts():
        text.set_parse_math(False)


@style.styled
def contact_sheet(figures: "Sequence[PaperFigure]") -> "Figure":
    """Return a new figure that shows all others as images, in rows and in their order, each at its own size below its title."""
    places: list[tuple[float, float, float, float]] = []
    left = top = lowest = 0.0
    for one in figures:
        width, tall = one.figure.get_size_inches().tolist()
        if left > 0.0 and left + width > _WIDTH:
            left, top = 0.0, lowest + _GAP
        places.append((left, top + _TITLE, width, tall))
        left, lowest = left + width + _GAP, max(lowest, top + _TITLE + tall)
    sheet = style.new_figure(lowest, _WIDTH)
    sheet.set_layout_engine("none")
    for one, (left, top, width, tall) in zip(figures, places, strict=True):
        title = f"Figure {one.number}. {one.title}"
        words = textwrap.fill(title, max(12, int(_TITLE_CHARACTERS * width)))
        up = lowest - top
        sheet.text(left / _WIDTH, up / lowest, words, weight="bold", va="bottom", size=8.0)
        place = (left / _WIDTH, (up - tall) / lowest, width / _WIDTH, tall / lowest)
        image = io.BytesIO()
        style.save_figure(one.figure, image)
        axes = sheet.add_axes(place)
        axes.imshow(imread(io.BytesIO(image.getvalue())), aspect="auto", interpolation="none")
        axes.set_axis_off()
    return sheet
