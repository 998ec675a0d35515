"""Analyses in the plane drawn: the orbit of the isolation layer, and the histories of both directions and their resultant."""

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize

from dcfp.present.figures import style
from dcfp.present.figures.drawing import between_equal_limits, draw_cross
from dcfp.present.figures.plane_field import heat_scale, plot_field
from dcfp.schema.formulas import metres_per_second, millimetres
from dcfp.schema.quantities import Quantity, quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.analysis.plane_response import PlaneResponse
    from dcfp.analysis.rig import PlaneLoops
    from dcfp.arrays import FloatArray

#: Parts of the friction's work between which a force is in colour.
_STRONG = (0.05, 0.95)


@style.styled
def plot_orbit(
    response: "PlaneResponse | PlaneLoops", axes: "Axes | None" = None, *, of: str = "displacement", between: tuple[float, float] = (0.0, 1.0),
    norm: Normalize | None = None, colour_bar: bool = True,
) -> "Axes":  # fmt: skip
    """Draw the path of the isolation layer in the plane, coloured by the temperature of the contact, or by the time where nothing heats up.

    Parameters
    ----------
    response
        The analysis, or the test in the plane.
    axes
        Where to draw; by default on a new figure.
    of
        ``"displacement"``, or ``"force"`` for the path of the horizontal force.
    between
        Parts of the friction's work [-] between which the path is in colour; it is pale before and after, where a force hardly slides and would fill its circle.
    norm
        Range of the colours, when several figures share one.
    colour_bar
        Whether a scale of the colours is drawn beside the axes.
    """
    axes = style.new_axes(height=3.2) if axes is None else axes
    x, y = (response.histories[f"{of}_{name}"] for name in ("x", "y"))
    last = _last_shown(response)
    path = np.column_stack([one.display(one.of(response)) for one in (x, y)])[:last]
    shows = "temperature" if np.ptp(response.temperature) > 0.0 else "time"
    values: FloatArray = getattr(response, shows)[:last]
    work = response.histories["hysteretic_energy"].of(response)[:last]
    shown = (work >= between[0] * work[-1]) & (work <= between[1] * work[-1])
    drawn = LineCollection(
        list(np.stack((path[:-1], path[1:]), axis=1)[shown[:-1]]),
        array=0.5 * (values[:-1] + values[1:])[shown[:-1]],
        cmap=style.colours_of(shows),
        norm=(norm if shows == "temperature" else None)
        or Normalize(float(values.min()), float(values.max())),
        linewidths=min(0.8, max(0.3, 40.0 / math.sqrt(max(shown.sum(), 1)))),
        capstyle="round",
        rasterized=len(path) > 6000,
    )
    draw_cross(axes)
    if not shown.all():
        style.draw_line(axes, path[:, 0], path[:, 1], style.COLOURS["silver"], 0.25, zorder=1.0)
    axes.add_collection(drawn)
    reach = 1.08 * max(float(np.abs(path).max()), 1e-6)
    capacity = response.bearing.displacement_capacity
    if of == "displacement":
        peak = response.peak_displacement
        style.draw_circle(axes, 0.0, 0.0, peak, style.GREY, 0.6)
        reach = max(reach, 1.08 * peak)
        if capacity is not None and capacity < reach:
            style.draw_circle(axes, 0.0, 0.0, capacity, style.RED, 0.7)
    axes.set_xlim(-reach, reach)
    axes.set_ylim(-reach, reach)
    axes.set_aspect("equal")
    style.label_axes(axes, f"direction x,  {x.label}", f"direction y,  {y.label}", 5, 5)
    if colour_bar:
        style.colour_bar_beside(axes, drawn, quantity(shows).label)
    return axes


def _last_shown(response: Any) -> int:
    """Return the number of samples up to a little after the last sliding: what follows is a weak elastic oscillation."""
    last = int(np.flatnonzero(response.sliding).max(initial=0))
    return min(len(response.time), max(last + last // 10, 2) + 1)


@style.styled
def plot_plane_response(response: "PlaneResponse") -> "Figure":
    """Compose orbits and histories of one analysis in the plane on a new figure, and the plate at its hottest where its temperature was kept."""
    has_field = response.fields is not None
    figure = style.new_figure(7.8 if has_field else 6.4)
    sides: Any = figure.subfigures(1, 2, width_ratios=(1.0, 1.15), wspace=0.04)
    left, right = sides
    upper, lower, *third = left.subplots(3 if has_field else 2, 1)
    norm = heat_scale([response])
    plot_orbit(response, upper, norm=norm)
    plot_orbit(response, lower, of="force", between=_STRONG, norm=norm, colour_bar=False)
    lower.set_title("in colour: 5 to 95 % of the friction's work", fontsize="small", loc="left")
    if third:
        plot_field(response, axes=third[0], norm=norm)
    axes: Any = right.subplots(5, 1, sharex=True, height_ratios=(1.0, 1.4, 1.0, 1.0, 1.0))
    quantities, known = response.histories, response.time
    draw_directions(axes[0], response, "ground_velocity")
    draw_directions(axes[1], response, "displacement")
    entry = quantities["displacement"]
    style.draw_line(axes[1], known, entry.display(response.displacement), style.INK, 0.8, label="resultant")
    style.legend_above(axes[1])
    for one, name in zip(axes[2:4], ("temperature", "friction"), strict=True):
        entry = quantities[name]
        style.draw_line(
            one,
            known,
            entry.display(entry.of(response)),
            style.RED if name == "temperature" else style.BLUE,
            0.7,
        )
        one.set_ylabel(entry.label)
    for name, colour in (("input_energy", style.INK), ("hysteretic_energy", style.OCHRE)):
        entry = quantities[name]
        style.draw_line(
            axes[4], known, entry.display(entry.of(response)), colour, 0.8, label=f"${entry.symbol}$"
        )
    axes[4].set_ylabel(f"$E$ [{entry.shown.name}]")
    style.legend_above(axes[4])
    axes[-1].set_xlabel(quantity("time").label)
    axes[-1].set_xlim(float(known[0]), float(known[_last_shown(response) - 1]))
    figure.suptitle(_head(response))
    return figure


def draw_directions(axes: "Axes", response: "PlaneResponse | PlaneLoops", name: str) -> None:
    """Draw both components of a history, with the same room to either side."""
    entries: list[Quantity] = [response.histories[f"{name}_{direction}"] for direction in ("x", "y")]
    drawn = [entry.display(entry.of(response)) for entry in entries]
    for direction, entry, values, colour in zip(
        ("x", "y"), entries, drawn, (style.BLUE, style.OCHRE), strict=True
    ):
        label = f"direction {direction}, ${entry.symbol}$"
        style.draw_line(axes, response.time, values, colour, 0.6, label=label)
    between_equal_limits(axes, *drawn)
    entry = quantity(name)
    axes.set_ylabel(entry.label)
    style.legend_above(axes)


def _head(response: "PlaneResponse") -> str:
    name = style.drawable(response.motion.name, 36)
    return f"{name}, PGV {metres_per_second(response.motion.peak_velocity)}, largest displacement {millimetres(response.peak_displacement)}"


@style.styled
def plot_orbits(responses: "Sequence[PlaneResponse]") -> "Figure":
    """Draw the orbits of several analyses side by side, with one scale of colours where anything heats up."""
    columns = min(4, len(responses))
    rows = math.ceil(len(responses) / columns)
    figure = style.new_figure(0.4 + 1.9 * rows)
    axes: Any = figure.subplots(rows, columns, squeeze=False)
    coldest, hottest = (float(end([end(one.temperature) for one in responses])) for end in (np.min, np.max))
    norm = Normalize(coldest, hottest) if hottest > coldest else None
    for place, (one, response) in enumerate(zip(axes.flat, responses, strict=False)):
        plot_orbit(response, one, norm=norm, colour_bar=False)
        one.set_title(
            f"{style.drawable(response.motion.name, 24)}\n{metres_per_second(response.motion.peak_velocity)}, {millimetres(response.peak_displacement)}",
            fontsize="small",
        )
        style.calm_ticks(one, 3, 3)
        if place % columns:
            one.set_ylabel("")
        if place + columns < len(responses):
            one.set_xlabel("")
    for one in axes.flat[len(responses) :]:
        one.set_visible(False)
    if norm is not None:
        drawn = ScalarMappable(norm, style.colours_of("temperature"))
        style.finish_colour_bar(figure.colorbar(drawn, ax=axes, fraction=0.02, aspect=12 * rows), quantity("temperature").label)  # fmt: skip
    return figure
