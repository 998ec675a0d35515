"""Isolated buildings drawn: the plan with the paths of its bearings and their temperatures, profiles over the height, and spectra of the floors."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from dcfp.present.figures import style
from dcfp.schema.formulas import metres_per_second, millimetres
from dcfp.schema.quantities import quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.analysis.plan import PlanResponse
    from dcfp.arrays import FloatArray
    from dcfp.methods.spectra.of_floors import FloorSpectra

#: Part of the distance between bearings that the longest path may take.
_REACH = 0.42


@style.styled
def plot_plan(
    response: "PlanResponse", axes: "Axes | None" = None, *, norm: Normalize | None = None, colour_bar: bool = True
) -> "Axes":  # fmt: skip
    """Draw the plan: slab, centre of mass, and every bearing with its path, magnified and in the colour of its highest temperature; a cross marks a bearing that lifts off.

    Parameters
    ----------
    response
        Of the building.
    axes
        Where to draw; by default on a new figure.
    norm
        Range of the colours, when several plans share one.
    colour_bar
        Whether a scale of the colours is drawn beside the axes.
    """
    axes = style.new_axes(height=3.2) if axes is None else axes
    plan, places = response.plan, response.plan.places / 1e3
    norm = _norm([response]) if norm is None else norm
    colours: Any = style.colours_of("temperature")
    outline = np.vstack((plan.corners, plan.corners[:1])) / 1e3
    style.draw_line(axes, outline[:, 0], outline[:, 1], style.GREY, 0.8)
    furthest = float(response.peak_bearing_displacement.max())
    magnified = _magnification(places, furthest)
    paths = magnified * response.bearing_displacement / 1e3
    for i, ((x, y), hot) in enumerate(zip(places.tolist(), response.peak_temperature.tolist(), strict=True)):
        colour = colours(norm(hot))
        style.draw_line(axes, x + paths[:, i, 0], y + paths[:, i, 1], colour, 0.4)
    style.draw_marks(axes, places[:, 0], places[:, 1], "s", 2.5, style.INK)
    lifted = response.uplift_time > 0.0
    if lifted.any():
        style.draw_marks(axes, places[lifted, 0], places[lifted, 1], "x", 7.0, style.RED, label="lifts off")
    centre = [[one / 1e3] for one in plan.mass_centre]
    style.draw_marks(axes, centre[0], centre[1], "P", 6.0, style.BLUE, label="centre of mass")
    style.legend_above(axes)
    axes.set_aspect("equal")
    axes.margins(0.06)
    style.label_axes(axes, "x [m]", "y [m]", 6, 5)
    axes.set_title(f"paths {magnified:.3g} times", fontsize="small", loc="left")
    if colour_bar:
        style.colour_bar_beside(axes, ScalarMappable(norm, colours), quantity("peak_temperature").label)
    return axes


def _norm(responses: "Sequence[PlanResponse]") -> Normalize:
    coldest = min(one.heating.ambient for response in responses for one in response.plan.systems)
    hottest = max(float(one.peak_temperature.max()) for one in responses)
    return Normalize(coldest, max(hottest, coldest + 1.0))


def _magnification(places: "FloatArray", furthest: float) -> float:
    """Return how many times longer than they are paths are drawn, so that those of neighbours hardly touch: a round number."""
    if len(places) < 2 or furthest <= 0.0:
        return 1.0
    away = np.linalg.norm(places[:, np.newaxis] - places, axis=2)
    nearest = float(np.min(away + np.eye(len(places)) * away.max()))
    most = _REACH * nearest / (furthest / 1e3)
    decade = 10.0 ** np.floor(np.log10(most))
    return float(max(step * decade for step in (1.0, 2.0, 5.0) if step * decade <= most))


@style.styled
def plot_plan_response(response: "PlanResponse") -> "Figure":
    """Compose plan, histories and, of a building with storeys, profiles over the height on a new figure."""
    storeys = bool(response.plan.storeys)
    figure = style.new_figure(7.6 if storeys else 5.2)
    parts: Any = figure.subfigures(
        2 if storeys else 1, 1, height_ratios=(1.0, 0.62) if storeys else None, squeeze=False
    )[:, 0]
    left, right = parts[0].subfigures(1, 2, width_ratios=(1.25, 1.0))
    plot_plan(response, left.subplots())
    _draw_histories(right.subplots(4, 1, sharex=True), response)
    if storeys:
        plot_profiles(response, parts[1].subplots(1, 4, sharey=True))
    name = style.drawable(response.motion.name, 36)
    ratio = "" if response.corner_ratio is None else f", corner {response.corner_ratio:.3f} times"
    style.write_title(
        figure,
        f"{style.drawable(response.plan.name, 30)}: {name}, PGV {metres_per_second(response.motion.peak_velocity)}, largest displacement of the centre {millimetres(response.peak_displacement)}{ratio}",
    )
    return figure


def _draw_histories(panels: Any, response: "PlanResponse") -> None:
    time = response.time
    for direction, values, colour in zip(
        "xy", response.slab_motion.T[:2], (style.BLUE, style.OCHRE), strict=True
    ):
        style.draw_line(panels[0], time, values, colour, 0.6, label=f"direction {direction}")
    style.draw_line(panels[1], time, 1e3 * response.rotation, style.INK, 0.6)
    load = quantity("load").display(response.bearing_load)
    panels[2].fill_between(
        time, load.min(axis=1), load.max(axis=1), color=style.COLOURS["sky"], linewidth=0.0
    )
    hottest = response.bearing_temperature
    panels[3].fill_between(
        time, hottest.min(axis=1), hottest.max(axis=1), color=style.RED, alpha=0.5, linewidth=0.0
    )
    style.legend_above(panels[0])
    labels = (
        "centre $y$ [mm]",
        r"rotation $\theta$ [mrad]",
        "all bearings $N$ [kN]",
        "all bearings $T$ [°C]",
    )
    speed = np.hypot(response.slab_velocity[:, 0], response.slab_velocity[:, 1])
    moving = np.flatnonzero(speed > 0.01 * speed.max())
    last = float(time[min(int(1.1 * moving.max(initial=1)), len(time) - 1)])
    for panel, label in zip(panels, labels, strict=True):
        style.label_axes(panel, "", label, 5, 4, xlim=(0.0, last))
    panels[-1].set_xlabel(quantity("time").label)


@style.styled
def plot_profiles(response: "PlanResponse", panels: Any = None) -> Any:
    """Draw floor accelerations, drifts, shears and overturning moments over the height; axes are made where none are given, and returned."""
    from dcfp.analysis.plan.quantities import level_peaks  # late: the analyses import the kernels

    if panels is None:
        panels = style.new_figure(2.8).subplots(1, 4, sharey=True)
    levels = level_peaks(response)
    heights = [one.height / 1e3 for one in levels]
    above = levels[1:]
    ratio = all(one.drift_ratio is not None for one in above)
    drifts = [100.0 * (one.drift_ratio or 0.0) if ratio else one.drift or 0.0 for one in above]
    corner = [100.0 * (one.corner_drift_ratio or 0.0) for one in above] if ratio else []
    dots: dict[str, Any] = {"marker": "o", "markersize": 2.5}
    for values, colour, label in (
        ([one.acceleration for one in levels], style.BLUE, "centre"),
        ([one.corner_acceleration for one in levels], style.OCHRE, "corner"),
    ):
        style.draw_line(panels[0], [one / 1e3 for one in values], heights, colour, 1.0, label=label, **dots)
    for values, colour in ((drifts, style.BLUE), (corner, style.OCHRE)):
        if values:
            # a drift is that of a whole storey
            panels[1].stairs(values, heights, orientation="horizontal", baseline=None, color=colour)
    panels[2].stairs(
        [one.shear / 1e6 for one in above], heights, orientation="horizontal", baseline=None, color=style.BLUE
    )
    style.draw_marks(
        panels[2], [levels[0].shear / 1e6], [0.0], "o", 4.0, style.RED, label="base shear", clip_on=False
    )
    style.draw_line(panels[3], [one.overturning / 1e9 for one in levels], heights, style.BLUE, 1.0, **dots)
    drift = "drift over height [%]" if ratio else "drift [mm]"
    for panel, label in zip(panels, ("$a$ [m/s²]", drift, "shear [MN]", "overturning [MN m]"), strict=True):
        style.label_axes(panel, label, "", 4, 6)
        panel.set_xlim(0.0, None)
    panels[0].set_ylabel("height above the slab [m]")
    for panel in (panels[0], panels[2]):
        panel.legend(loc="best", fontsize="x-small")
    panels[0].set_title(f"damping {response.damping_words}", fontsize="small", loc="left")
    return panels


@style.styled
def plot_plans(responses: "Sequence[PlanResponse]") -> "Figure":
    """Draw the plans of several analyses side by side, with one scale of colours."""
    columns = min(3, len(responses))
    rows = -(-len(responses) // columns)
    figure = style.new_figure(0.4 + 2.2 * rows)
    axes: Any = figure.subplots(rows, columns, squeeze=False)
    norm = _norm(responses)
    for one, response in zip(axes.flat, responses, strict=False):
        plot_plan(response, one, norm=norm, colour_bar=False)
        one.get_legend().set_visible(False)
        words = f"{style.drawable(response.motion.name, 24)}, {millimetres(response.peak_displacement)}, corner {millimetres(response.peak_corner_displacement)}"
        one.set_title(words, fontsize="small")
    for one in axes.flat[len(responses) :]:
        one.set_visible(False)
    drawn = ScalarMappable(norm, style.colours_of("temperature"))
    style.finish_colour_bar(
        figure.colorbar(drawn, ax=axes, fraction=0.02, aspect=12 * rows), quantity("peak_temperature").label
    )
    return figure


@style.styled
def plot_floor_spectra(spectra: "FloorSpectra") -> "Figure":
    """Draw the spectra of every level over the period, both directions thin, and the broadened larger one."""
    levels = len(spectra.heights)
    columns = min(3, levels)
    rows = -(-levels // columns)
    figure = style.new_figure(0.5 + 1.7 * rows)
    axes: Any = figure.subplots(rows, columns, squeeze=False, sharex=True, sharey=True)
    wide = spectra.broadened
    for level, one in enumerate(axes.flat[:levels]):
        for direction, values, colour in zip(
            "xy", spectra.acceleration[level], (style.BLUE, style.OCHRE), strict=True
        ):
            style.draw_line(one, spectra.periods, values / 1e3, colour, 0.7, label=f"direction {direction}")
        style.draw_line(
            one,
            spectra.periods,
            wide[level] / 1e3,
            style.INK,
            0.9,
            label=f"larger, broadened by {100.0 * spectra.broadening:g} %",
        )
        one.set_xscale("log")
        one.set_title(
            "slab" if level == 0 else f"floor {level}, {spectra.heights[level] / 1e3:g} m",
            fontsize="small",
            loc="left",
        )
    for one in axes.flat[levels:]:
        one.set_visible(False)
    for one in axes[:, 0]:
        one.set_ylabel("$S_a$ [m/s²]")
    for one in axes.flat[max(levels - columns, 0) : levels]:
        one.set_xlabel("$T$ [s]")
        one.xaxis.set_tick_params(labelbottom=True)
        one.set_xticks((0.1, 1.0, 10.0), ["0.1", "1", "10"])
    axes.flat[0].set_ylim(0.0, None)
    style.legend_outside(axes.flat[0], 3, "lower center")
    style.write_title(figure, f"{style.drawable(spectra.name, 60)}, damping {100.0 * spectra.damping:g} %")
    return figure
