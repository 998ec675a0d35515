"""One record at one PGV over time: Figures 13, 14 and 15."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from dcfp.present.figures.histories import between_equal_limits
from dcfp.present.figures.style import BLUE, GREY, INK, OCHRE, PAGE_WIDTH, legend_above
from dcfp.present.figures.swings import (
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
from dcfp.present.figures.words import metres_per_second, millimetres
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
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
