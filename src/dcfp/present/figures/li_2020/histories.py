"""One record at one PGV over time: Figures 13, 14 and 15; and the loop with the simplified heating model beside that with the precise one: Figure 10."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from dcfp.present.figures.drawing import between_equal_limits, draw_cross
from dcfp.present.figures.pulses import (
    draw_displacement,
    draw_pulses,
    draw_velocities,
    during,
    history_width,
    limit_time,
    mark_change,
    mark_pulse,
    name_swing,
    response_of,
    shade_swing,
    strong_part,
)
from dcfp.present.figures.style import BLUE, GREY, INK, OCHRE, PAGE_WIDTH, calm_ticks, legend_above
from dcfp.present.panels import line_width, shown
from dcfp.schema.digits import metres_per_second, millimetres
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Mapping

    from matplotlib.axes import Axes

    from dcfp.analysis import Response
    from dcfp.analysis.swings import Swing
    from dcfp.inference import Case


def draw_velocity_energy_displacement(figure: Figure, case: "Case") -> None:
    """Draw ground velocity with its pulses, input energy and displacement, with the largest swing marked: Figure 13."""
    response, swing = response_of(case), case.analysed.swing
    limits = strong_part(response, swing)
    width = history_width(limits)
    panels: Any = figure.subplots(3, 1, sharex=True, height_ratios=[1.15, 1.0, 1.0])
    draw_pulses(panels[0], response, case.pulses, width)
    if case.analysed.pulse is not None:
        mark_pulse(panels[0], case.pulses, case.analysed.pulse, BLUE)
    _draw_energy(panels[1], response, swing, width)
    draw_displacement(panels[2], response, swing, width)
    if swing is not None:
        for axes in panels[1:]:
            shade_swing(axes, swing)
    limit_time(list(panels), limits)
    figure.align_ylabels(list(panels))


def draw_both_velocities(figure: Figure, case: "Case") -> None:
    """Draw the velocities of ground and structure, with the area that is the largest swing: Figure 14."""
    response, swing = response_of(case), case.analysed.swing
    limits = strong_part(response, swing)
    axes = figure.add_subplot()
    draw_velocities(axes, response, swing, history_width(limits))
    legend_above(axes)
    limit_time([axes], limits)


def draw_relative_velocity(figure: Figure, case: "Case") -> None:
    """Draw the relative velocity, with the area that is the largest swing: Figure 15."""
    response, swing = response_of(case), case.analysed.swing
    limits = strong_part(response, swing)
    entry = quantity("velocity")
    axes = figure.add_subplot()
    velocity = entry.display(response.velocity)
    axes.plot(response.time, velocity, color=BLUE, linewidth=history_width(limits), label=f"${entry.symbol}$")
    if swing is not None:
        time, inside = during(swing, response.time, velocity)
        area = rf"area $=\Delta y=$ {millimetres(abs(swing.change))}"
        axes.fill_between(time, 0.0, inside, color=OCHRE, alpha=0.7, linewidth=0.0, label=area)
    axes.set_ylabel(entry.label)
    between_equal_limits(axes, float(np.abs(velocity).max()))
    legend_above(axes)
    limit_time([axes], limits)


def history_figure(height: float) -> Figure:
    """Return an empty figure as wide as the page [in]."""
    return Figure(figsize=(PAGE_WIDTH, height), layout="constrained")


def _draw_energy(axes: "Axes", response: "Response", swing: "Swing | None", width: float) -> None:
    entry = quantity("input_energy")
    energy = entry.display(response.energy.input)
    for name, values, colour in (
        ("hysteretic_energy", entry.display(response.energy.hysteretic), GREY),
        ("input_energy", energy, INK),
    ):
        axes.plot(response.time, values, color=colour, linewidth=width, label=f"${quantity(name).symbol}$")
    if swing is not None:
        _draw_input(axes, swing, *during(swing, response.time, energy))
    axes.set_ylabel(entry.label)
    lowest = min(0.0, float(energy.min()))
    axes.set_ylim(lowest, max(1.25 * float(energy.max()), lowest + 1e-3))
    axes.legend(loc="upper left", borderaxespad=0.7)


def _draw_input(axes: "Axes", swing: "Swing", *history: "np.ndarray") -> None:
    """Mark the energy put in from the start of a swing to its largest."""
    time, energy = history
    place = int(energy.argmax())
    mark_change(axes, (float(time[0]), float(time[place])), (float(energy[0]), float(energy[place])))
    symbol = quantity("swing_input_velocity").symbol
    name_swing(axes, swing, rf"$\Delta E$:  ${symbol}$ {metres_per_second(swing.input_velocity)}")


# The loop with the simplified heating model beside that with the precise one: Figure 10.


#: Record of Figure 10, which no open data set has, and the other one of that earthquake.
_RECORDS = ("JKB", "KNA")


def loops_record(loops: "Mapping[tuple[str, float], tuple[Response, Response]]") -> str:
    """Return the record to be drawn: that of the paper, else the other one of its earthquake, else that of the largest displacement."""
    records = {record for record, _ in loops}
    for record in _RECORDS:
        if record in records:
            return record
    largest = max(loops.items(), key=lambda item: item[1][0].peak_displacement)
    return largest[0][0]


def draw_loops_of_both_models(
    figure: "Figure", loops: "Mapping[tuple[str, float], tuple[Response, Response]]"
) -> None:
    """Draw force against displacement with the simplified and the precise heating model, at the lowest and the highest PGV: Figure 10.

    `loops` has both analyses, simplified and precise, by record and PGV [mm/s].
    """
    record = loops_record(loops)
    pgvs = sorted(pgv for name, pgv in loops if name == record)
    chosen = pgvs if len(pgvs) == 1 else [pgvs[0], pgvs[-1]]
    panels: Any = figure.subplots(1, len(chosen), squeeze=False)[0]
    for axes, pgv, letter in zip(panels, chosen, "ab", strict=False):
        _draw_pair(axes, *loops[record, pgv])
        axes.set_title(f"({letter}) PGV {metres_per_second(pgv)}", loc="left")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=2, borderaxespad=0.4)


def _draw_pair(axes: "Axes", simplified: "Response", precise: "Response") -> None:
    draw_cross(axes)
    for response, colour, dashes, label in (
        (simplified, BLUE, "-", "simplified"),
        (precise, OCHRE, (0, (4, 2)), "precise"),
    ):
        part = shown(response)
        axes.plot(
            quantity("displacement").display(response.displacement[part]),
            quantity("force").display(response.force[part]),
            color=colour,
            linewidth=line_width(response),
            linestyle=dashes,
            label=label,
        )
    calm_ticks(axes, 5, 5)
    axes.set_xlabel(quantity("displacement").label)
    axes.set_ylabel(quantity("force").label)
