"""The pulses of a ground velocity, and what they do to the structure."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from dcfp.present.figures.histories import between_equal_limits
from dcfp.present.figures.style import BLUE, OCHRE, PAGE_WIDTH, RED, drawable, legend_above, style
from dcfp.present.figures.swings import (
    draw_displacement,
    draw_pulses,
    draw_velocities,
    history_width,
    limit_time,
    mark_pulse,
    response_of,
    shade_swing,
    strong_part,
)
from dcfp.present.figures.words import metres_per_second, millimetres
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from dcfp.analysis import Response
    from dcfp.inference import Case
    from dcfp.methods import PulseMarch
    from dcfp.methods.li_2020 import Constants
    from dcfp.methods.pulses import PulsePrediction


def plot_pulses(
    case: "Case",
    march: "PulseMarch | None" = None,
    *,
    response: "Response | None" = None,
    constants: "Constants | None" = None,
) -> Figure:
    """Draw the pulses of one record at one PGV, the velocities and the displacement on a new figure.

    Parameters
    ----------
    case
        What was analysed and predicted.
    march
        March through the pulses with its path, to be drawn over the analysis.
    response
        The analysis; by default the one that the case kept.
    constants
        Of the pulse method; by default those of Li et al. (2020).

    Raises
    ------
    InputError
        If there is no analysis to draw.
    """
    analysis = response_of(case) if response is None else response
    swing = case.analysed.swing
    limits = strong_part(analysis, swing)
    width = history_width(limits)
    with style():
        figure = Figure(figsize=(PAGE_WIDTH, 5.6), layout="constrained")
        panels: Any = figure.subplots(3, 1, sharex=True, height_ratios=[1.25, 1.0, 1.0])
        draw_pulses(panels[0], analysis, case.pulses, width)
        _name_pulses(panels[0], case, *_predicted(case, constants))
        draw_velocities(panels[1], analysis, swing, width)
        draw_displacement(panels[2], analysis, swing, width)
        if swing is not None:
            shade_swing(panels[2], swing)
        if march is not None:
            _draw_march(panels[2], march, float(np.abs(analysis.displacement).max()))
        legend_above(panels[1])
        if march is not None:
            legend_above(panels[2])
        limit_time(list(panels), limits)
        figure.align_ylabels(list(panels))
        title = f"{drawable(case.record)},  PGV {metres_per_second(case.pgv)}"
        figure.suptitle(title, fontsize=8.5, x=0.01, ha="left", weight="bold", parse_math=False)
    return figure


def _predicted(case: "Case", constants: "Constants | None") -> "tuple[PulsePrediction, float]":
    """Return what the method says of each pulse, and |ku| [mm/s2]."""
    from dcfp.methods import li_2020  # late: the package of predictions imports the kernels

    used = li_2020.LI_2020 if constants is None else constants
    return li_2020.predict_from_pulses(case.pulses, used), used.friction_deceleration


def _name_pulses(axes: "Axes", case: "Case", predicted: "PulsePrediction", friction: float) -> None:
    """Shade the pulse that governs by the method, and the one that the analysis found, and say what they are."""
    governs, found = predicted.governing, case.analysed.pulse
    if governs is not None and governs == found:
        marked = [(governs, BLUE, "governs by the pulse method and in the analysis")]
    else:
        marked = [
            (governs, BLUE, "governs by the pulse method"),
            (found, OCHRE, "behind the largest swing of the analysis"),
        ]
    handles: list[Patch] = []
    for number, colour, what in marked:
        if number is None:
            handles.append(Patch(color="none", label=f"{what}: none"))
            continue
        mark_pulse(axes, predicted.pulses, number, colour)
        handles.append(Patch(color=colour, label=f"{what}:  {_words(predicted, number, friction)}"))
    axes.legend(handles=handles, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=1)


def _words(predicted: "PulsePrediction", number: int, friction: float) -> str:
    pulses = predicted.pulses
    change, slope = abs(float(pulses.changes[number])), abs(float(pulses.mean_accelerations[number]))
    moved = float(predicted.displacement_change[number])
    slope_shown = quantity("ground_velocity_slope").display(slope)
    return ",  ".join(
        (
            rf"$|\Delta v_g|$ {metres_per_second(change)}",
            rf"$k_g$ {slope_shown:.2f} m/s²",
            rf"$k_u/k_g$ {friction / slope:.2f}",
            rf"$\Delta y_{{\mathrm{{pre}}}}$ {millimetres(moved)}",
        )
    )


def _draw_march(axes: "Axes", march: "PulseMarch", largest: float) -> None:
    axes.plot(
        march.time,
        march.displacement,
        color=RED,
        linewidth=0.8,
        linestyle=(0, (4, 2)),
        label=rf"pulse march, $\Delta y$ {millimetres(march.prediction.displacement_change)}",
    )
    predicted = float(np.abs(march.displacement).max(initial=0.0))
    between_equal_limits(axes, max(largest, predicted))
