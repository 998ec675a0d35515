"""The figures that have a point for each record and PGV, with their captions."""

from functools import partial
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from dcfp.present.figures.li_2020.marks import (
    Mark,
    PaperFigure,
    draw_points,
    marks_of,
    name_records,
    small_figure,
)
from dcfp.present.figures.style import BLUE, ENTRIES, GREY, INK, OCHRE, RED, calm_ticks
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from matplotlib.axes import Axes

    from dcfp.inference import Case
    from dcfp.methods import Prediction
    from dcfp.methods.li_2020 import Constants
    from dcfp.schema.quantities import Quantity

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
    from dcfp.methods.li_2020.constants import PULSE, SIMPLIFIED  # late: the package imports the kernels
    from dcfp.methods.pulses import CHANGE, HYSTERETIC, INPUT

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
            (partial(draw_accuracy, method=PULSE, which=CHANGE),),
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
            (partial(draw_accuracy, method=SIMPLIFIED, which=INPUT),),
        ),
        (
            "23",
            "Accuracy of the simplified method for the dissipated energy",
            f"Equivalent velocity of the dissipated energy, predicted by the simplified method and analysed, {blind}",
            (partial(draw_accuracy, method=SIMPLIFIED, which=HYSTERETIC),),
        ),
        (
            "24",
            "Accuracy of the simplified method for the change of displacement",
            f"Largest change of displacement, predicted by the simplified method and analysed, {blind}",
            (partial(draw_accuracy, method=SIMPLIFIED, which=CHANGE),),
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


# What grows with the PGV: Figures 11, 25, 26 and 27.


#: Line of a prediction.
_DASHED = (0, (5, 2))


def draw_largest_displacement(axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]") -> None:
    """Draw y_max against the PGV: Figure 11."""
    _draw_against_pgv(axes, cases, marks, "peak_displacement", lambda case: case.analysed.whole.bound)


def draw_velocity_change(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", constants: "Constants"
) -> None:
    """Draw |dvg| of the governing pulse against the PGV, with Eq. (29): Figure 25."""

    def change(case: "Case") -> float | None:
        pulse = case.analysed.pulse
        return None if pulse is None else abs(float(case.pulses.changes[pulse]))

    entry = quantity("ground_velocity_change")
    _draw_against_pgv(axes, cases, marks, "ground_velocity_change", change)
    axes.set_ylabel(f"$|{entry.symbol}|$ [{entry.shown.name}]")
    ends = quantity("peak_ground_velocity").display(np.array([0.0, _largest_pgv(cases)]))
    label = rf"$\zeta={constants.change_ratio:.3g}$, Eq. (29)"
    axes.plot(ends, constants.change_ratio * ends, color=INK, linewidth=0.9, linestyle=_DASHED, label=label)
    axes.legend(loc="lower right", borderaxespad=0.7)


def draw_input_velocity(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", constants: "Constants"
) -> None:
    """Draw the largest V_dE against the PGV, with Eq. (31): Figure 26."""
    _draw_with_design(
        axes, cases, marks, constants, "swing_input_velocity", lambda one: one.input_velocity, "Eq. (31)"
    )


def draw_hysteretic_velocity(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", constants: "Constants"
) -> None:
    """Draw the largest V_dEhr against the PGV, with Eq. (32): Figure 26."""
    _draw_with_design(
        axes,
        cases,
        marks,
        constants,
        "swing_hysteretic_velocity",
        lambda one: one.hysteretic_velocity,
        "Eq. (32)",
    )


def draw_displacement_change(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", constants: "Constants"
) -> None:
    """Draw the largest dy against the PGV, with Eq. (33): Figure 27."""
    _draw_with_design(
        axes, cases, marks, constants, "displacement_change", lambda one: one.displacement_change, "Eq. (33)"
    )


def _draw_with_design(
    axes: "Axes",
    cases: "Sequence[Case]",
    marks: "Mapping[str, Mark]",
    constants: "Constants",
    name: str,
    value: "Callable[[Prediction], float]",
    label: str,
) -> None:
    from dcfp.methods.li_2020 import predict_from_pgv  # late: predictions import the kernels

    _draw_against_pgv(axes, cases, marks, name, lambda case: value(case.analysed.whole))
    if not constants.slides_on_average:
        return
    pgvs = np.linspace(0.02, 1.0, 100) * 1.04 * _largest_pgv(cases)
    curve = np.array([value(predict_from_pgv(float(pgv), constants)) for pgv in pgvs])
    axes.plot(
        quantity("peak_ground_velocity").display(pgvs),
        quantity(name).display(curve),
        color=RED,
        linewidth=1.0,
        linestyle=_DASHED,
        label=label,
        zorder=2,
    )
    axes.legend(loc="upper left", borderaxespad=0.7)


def _draw_against_pgv(
    axes: "Axes",
    cases: "Sequence[Case]",
    marks: "Mapping[str, Mark]",
    name: str,
    value: "Callable[[Case], float | None]",
) -> None:
    velocity, entry = quantity("peak_ground_velocity"), quantity(name)

    def point(case: "Case") -> tuple[float, float] | None:
        found = value(case)
        return None if found is None else (velocity.display(case.pgv), entry.display(found))

    draw_points(axes, cases, marks, point)
    calm_ticks(axes, 6, 5)
    axes.set_xlim(0.0, 1.08 * velocity.display(_largest_pgv(cases)))
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel(velocity.label)
    axes.set_ylabel(entry.label)


def _largest_pgv(cases: "Sequence[Case]") -> float:
    return max(case.pgv for case in cases)


# How much of a pulse's energy comes in, and how much of that is absorbed: Figures 19 and 20.


#: Values of eps that Figure 19 compares [-], with their colours and lines.
_FALL_RATIOS = ((0.1, OCHRE, (0, (1.5, 1.5))), (0.25, INK, "-"), (0.5, BLUE, (0, (5, 2))))


def draw_absorbed_ratio(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", constants: "Constants"
) -> None:
    """Draw V_dEhr / V_dE of the analyses against ku/kg of the governing pulse, with Eq. (27): Figure 19."""
    # late: predictions import the kernels
    from dcfp.methods.li_2020.simplified_method import absorbed_velocity_ratio

    def point(case: "Case") -> tuple[float, float] | None:
        pulse, swing = case.analysed.pulse, case.analysed.governing
        if pulse is None or swing.input_velocity == 0.0:
            return None
        slope = abs(float(case.pulses.mean_accelerations[pulse]))
        return constants.friction_deceleration / slope, swing.hysteretic_velocity / swing.input_velocity

    draw_points(axes, cases, marks, point)
    points = [place for place in map(point, cases) if place is not None]
    across = 1.06 * max([1.1, *(x for x, _ in points)])
    ratio = np.linspace(0.0, across, 400)
    for eps, colour, dashes in _FALL_RATIOS:
        label = rf"$\varepsilon={eps:g}$"
        curve = absorbed_velocity_ratio(ratio, eps)
        axes.plot(ratio, curve, color=colour, linewidth=0.9, linestyle=dashes, label=label, zorder=2)
    calm_ticks(axes, 6, 6)
    axes.set_xlim(0.0, across)
    axes.set_ylim(0.0, 1.08 * max([1.0, *(y for _, y in points)]))
    axes.set_xlabel(quantity("slope_ratio").label)
    put_in, absorbed = quantity("swing_input_velocity").symbol, quantity("swing_hysteretic_velocity").symbol
    axes.set_ylabel(f"${absorbed}\\,/\\,{put_in}$")
    axes.legend(loc="lower right", borderaxespad=0.7)


def draw_input_over_change(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", constants: "Constants"
) -> None:
    """Draw V_dE of the analyses against |dvg| of the governing pulse, with Eq. (28): Figure 20."""
    from dcfp.methods.li_2020.simplified_method import input_velocity

    change, put_in = quantity("ground_velocity_change"), quantity("swing_input_velocity")

    def point(case: "Case") -> tuple[float, float] | None:
        pulse = case.analysed.pulse
        if pulse is None:
            return None
        across = change.display(abs(float(case.pulses.changes[pulse])))
        return across, put_in.display(case.analysed.governing.input_velocity)

    draw_points(axes, cases, marks, point)
    points = [place for place in map(point, cases) if place is not None]
    across = 1.06 * (max((x for x, _ in points), default=0.0) or 1.0)
    if constants.slides_on_average:
        ends = change.shown.inner(np.array([0.0, across]))
        line = input_velocity(ends, constants.friction_deceleration, constants.average_slope)
        label = rf"Eq. (28), $k_{{g,\mathrm{{ave}}}}={constants.average_slope:.0f}$ mm/s²"
        axes.plot(
            [0.0, across], put_in.display(line), color=RED, linewidth=1.0, linestyle=(0, (5, 2)), label=label
        )
        axes.legend(loc="lower right", borderaxespad=0.7)
    calm_ticks(axes, 6, 5)
    axes.set_xlim(0.0, across)
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel(f"$|{change.symbol}|$ [{change.shown.name}]")
    axes.set_ylabel(put_in.label)


# Predicted from the record alone against analysed, with the paper's range: Figures 18 and 22 to 24.


def draw_accuracy(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", method: str, which: "Quantity"
) -> None:
    """Draw what a blind method predicts against the analysis, with the range of their ratio that the paper prints."""
    from dcfp.methods.li_2020.constants import PRINTED_RANGES  # late: the package imports the kernels
    from dcfp.methods.method import Information, Variant
    from dcfp.methods.pulses import value_of

    entry, variant = quantity(ENTRIES[which.title]), Variant(method, Information.BLIND)
    least, largest, _ = PRINTED_RANGES[variant, which]

    def point(case: "Case") -> tuple[float, float] | None:
        if variant not in case.predicted:
            return None
        analysed = entry.display(value_of(case.analysed.whole, which))
        predicted = entry.display(value_of(case.predicted[variant], which))
        return (analysed, predicted) if np.isfinite(predicted) else None

    draw_points(axes, cases, marks, point)
    points = [place for place in map(point, cases) if place is not None]
    across = 1.08 * (max((x for x, _ in points), default=0.0) or 1.0)
    up = 1.08 * (max((y for _, y in points), default=0.0) or 1.0)
    _draw_range(axes, least, largest, across)
    calm_ticks(axes, 6, 5)
    axes.set_xlim(0.0, across)
    axes.set_ylim(0.0, max(up, across))
    axes.set_xlabel(f"${entry.symbol}$ analysed [{entry.shown.name}]")
    axes.set_ylabel(f"${entry.symbol}$ predicted [{entry.shown.name}]")


def _draw_range(axes: "Axes", least: float, largest: float, across: float) -> None:
    ends = np.array([0.0, across])
    if least != 1.0:
        axes.plot(ends, ends, color=GREY, linewidth=0.6, zorder=1)
    for ratio, colour, dashes in (
        (largest, RED, (0, (5, 2))),
        (least, INK, (0, (1.5, 1.5)) if least != 1.0 else "-"),
    ):
        axes.plot(
            ends,
            ratio * ends,
            color=colour,
            linewidth=0.8,
            linestyle=dashes,
            label=f"ratio {ratio:.1f}",
            zorder=1,
        )
    axes.legend(loc="lower right", borderaxespad=0.7)
