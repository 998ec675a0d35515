"""The pulses of a ground velocity, and what they do to the structure."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from dcfp.errors import InputError
from dcfp.present.figures.drawing import between_equal_limits
from dcfp.present.figures.style import (
    BLUE,
    GREY,
    INK,
    OCHRE,
    PAGE_WIDTH,
    RED,
    calm_ticks,
    drawable,
    legend_above,
    style,
)
from dcfp.present.panels import shown
from dcfp.schema.digits import metres_per_second, millimetres
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from dcfp.analysis import Response
    from dcfp.analysis.swings import Swing
    from dcfp.arrays import FloatArray
    from dcfp.inference import Case
    from dcfp.methods import PulseMarch, Pulses
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


# Pulses of the ground and swings of the structure over time, as Figures 13 and 14 of Li et al. (2020) show
# them.


#: Part of the hysteretic energy before and after the strong part of a response [-].
_WEAK = 0.02
#: How strongly pulses and swings are shaded in each colour [-].
_SHADES = {BLUE: 0.16, OCHRE: 0.3}


def response_of(case: "Case") -> "Response":
    """Return the analysis that a case kept.

    Raises
    ------
    InputError
        If it kept none.
    """
    if case.response is None:
        msg = f"{case.record}: the analysis was not kept; compare with keep_response=True to draw it."
        raise InputError(msg)
    return case.response


def strong_part(response: "Response", swing: "Swing | None") -> tuple[float, float]:
    """Return first and last time [s] of the part in which nearly all of the energy is dissipated, and the swing is."""
    time, dissipated = response.time, response.energy.hysteretic
    whole = float(dissipated[-1])
    part = shown(response)
    if whole == 0.0 or swing is None:
        return float(time[part.start]), float(time[part.stop - 1])
    first, last = np.interp((_WEAK * whole, (1.0 - _WEAK) * whole), dissipated, time)
    first, last = min(float(first), swing.start), max(float(last), swing.end)
    margin = 0.06 * (last - first)
    return max(0.0, first - margin), min(float(time[-1]), last + margin)


def limit_time(panels: "Sequence[Axes]", limits: tuple[float, float]) -> None:
    """Give panels above each other the same times, and only the lowest the name of the axis."""
    for axes in panels:
        axes.set_xlim(*limits)
        calm_ticks(axes, 8, 4)
    panels[-1].set_xlabel(quantity("time").label)


def history_width(limits: tuple[float, float]) -> float:
    """Return the width [pt] at which the waves between two times stay apart."""
    span = limits[1] - limits[0]
    return 0.9 if span < 15.0 else 0.7 if span < 40.0 else 0.5


def draw_pulses(axes: "Axes", response: "Response", pulses: "Pulses", width: float) -> None:
    """Draw the ground velocity and its peaks, joined by straight lines."""
    entry = quantity("ground_velocity")
    velocity = entry.display(response.ground_velocity)
    axes.plot(response.time, velocity, color=GREY, linewidth=width)
    axes.plot(
        pulses.times,
        entry.display(pulses.velocities),
        color=BLUE,
        linewidth=0.6,
        marker="o",
        markersize=2.4,
        zorder=3,
    )
    axes.set_ylabel(entry.label)
    between_equal_limits(axes, float(np.abs(velocity).max()))


def mark_pulse(axes: "Axes", pulses: "Pulses", number: int, colour: str) -> None:
    """Shade the time of a pulse, and draw its lines thick; pulses are counted from zero."""
    places = slice(number, number + 3)
    times = pulses.times[places]
    axes.axvspan(
        float(times[0]), float(times[-1]), color=colour, alpha=_SHADES[colour], linewidth=0.0, zorder=0
    )
    velocities = quantity("ground_velocity").display(pulses.velocities[places])
    axes.plot(times, velocities, color=colour, linewidth=1.2, marker="o", markersize=3.0, zorder=4)


def draw_velocities(axes: "Axes", response: "Response", swing: "Swing | None", width: float) -> None:
    """Draw the velocities of ground and structure; the area between them is the displacement, that of a swing filled."""
    entry = quantity("velocity")
    ground, structure = (
        entry.display(values) for values in (response.ground_velocity, response.structure_velocity)
    )
    for name, values, colour in (("ground_velocity", ground, GREY), ("structure_velocity", structure, BLUE)):
        label = f"${quantity(name).symbol}$"
        axes.plot(response.time, values, color=colour, linewidth=width, label=label)
    if swing is not None:
        time, below, above = during(swing, response.time, ground, structure)
        area = rf"area $=\Delta y=$ {millimetres(abs(swing.change))}"
        axes.fill_between(time, below, above, color=OCHRE, alpha=0.7, linewidth=0.0, label=area)
    axes.set_ylabel(entry.label)
    between_equal_limits(axes, float(max(np.abs(ground).max(), np.abs(structure).max())))


def draw_displacement(axes: "Axes", response: "Response", swing: "Swing | None", width: float) -> None:
    """Draw the displacement, with the change of one swing from peak to peak."""
    axes.plot(response.time, response.displacement, color=BLUE, linewidth=width, label="analysis")
    if swing is not None:
        _draw_change(axes, response, swing)
    axes.set_ylabel(quantity("displacement").label)
    between_equal_limits(axes, float(np.abs(response.displacement).max()))


def shade_swing(axes: "Axes", swing: "Swing") -> None:
    """Shade the time of a swing."""
    axes.axvspan(swing.start, swing.end, color=OCHRE, alpha=_SHADES[OCHRE], linewidth=0.0, zorder=0)


def during(swing: "Swing", time: "FloatArray", *histories: "FloatArray") -> "tuple[FloatArray, ...]":
    """Return time and histories from the start of a swing to its end, both of which lie between samples."""
    inside = (swing.start < time) & (time < swing.end)
    times = np.concatenate(([swing.start], time[inside], [swing.end]))
    return times, *(np.interp(times, time, values) for values in histories)


def _draw_change(axes: "Axes", response: "Response", swing: "Swing") -> None:
    first, last = (
        float(value) for value in np.interp((swing.start, swing.end), response.time, response.displacement)
    )
    mark_change(axes, (swing.start, swing.end), (first, last))
    name_swing(axes, swing, rf"$\Delta y$ {millimetres(abs(swing.change))}")


def mark_change(axes: "Axes", times: tuple[float, float], values: tuple[float, float]) -> None:
    """Mark two points of a history, and with an arrow the difference of their values."""
    (_, end), (first, last) = times, values
    axes.plot(times, values, color=INK, marker="o", markersize=2.6, linestyle="none", zorder=4)
    axes.plot(times, (first, first), color=INK, linewidth=0.5, linestyle=(0, (2, 2)), zorder=3)
    arrow = {"arrowstyle": "<->", "color": INK, "linewidth": 0.7, "shrinkA": 0.0, "shrinkB": 0.0}
    axes.annotate("", (end, last), (end, first), arrowprops=arrow)


def name_swing(axes: "Axes", swing: "Swing", words: str) -> None:
    """Write words at the top of the panel, above a swing."""
    axes.annotate(
        words,
        (0.5 * (swing.start + swing.end), 0.985),
        xycoords=axes.get_xaxis_transform(),
        ha="center",
        va="top",
        annotation_clip=True,
        zorder=5,
    )
