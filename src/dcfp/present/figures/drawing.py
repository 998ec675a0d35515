"""Panels drawn by Matplotlib: histories, energies, loops, and the temperature along a plate."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize

from dcfp.present import panels
from dcfp.present.figures import style
from dcfp.schema.formulas import millimetres
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.axes import Axes

    from dcfp.arrays import FloatArray
    from dcfp.present.panels import History, Panel

#: Colours that are told apart.
_LEVELS = 100
#: Number of pieces above which a line of changing colour is drawn as an image in a PDF or an SVG.
_MANY = 6000


def draw(panel: "Panel", axes: "Axes", norm: Normalize | None = None) -> Any:
    """Draw a panel of histories, and return what its picture is drawn with, if it has one."""
    shown, first = panel.y.display, panel.lines[0]
    axes.set_xlim(float(first.x[0]), float(first.x[-1]))
    style.label_axes(axes, panel.x.label, panel.y.label, 8, 4)
    picture = _draw_picture(axes, panel, norm)
    if panel.sliding is not None:
        look: dict[str, Any] = {"color": style.PALE, "linewidth": 0.0, "label": "sliding", "zorder": 0}
        axes.fill_between(first.x, 0.0, 1.0, where=panel.sliding, step="post", transform=axes.get_xaxis_transform(), **look)  # fmt: skip
    stack = panel.lines[: panel.stacked]
    if stack:
        colours, labels = [style.COLOURS[line.colour] for line in stack], [line.label for line in stack]
        axes.stackplot(
            first.x, *(shown(line.y) for line in stack), colors=colours, labels=labels, linewidth=0.0
        )
    for line in panel.lines[panel.stacked :]:
        label = line.label or None
        style.draw_line(axes, line.x, shown(line.y), style.COLOURS[line.colour], line.width, label=label)
    if panel.peak:
        mark_peak(axes, first.x, first.y, millimetres(float(np.abs(first.y).max())))
    if panel.capacity is not None:
        for side, label in ((panel.capacity, "capacity"), (-panel.capacity, None)):
            axes.axhline(side, color=style.RED, linewidth=0.7, linestyle=style.DASHED, label=label)
    if panel.middle:
        axes.axhline(0.0, color=style.GREY, linewidth=0.4, zorder=0)
    if panel.low is not None:
        axes.set_ylim(shown(panel.low), None if panel.high is None else shown(panel.high))
    if axes.get_legend_handles_labels()[1]:
        style.legend_above(axes)
    return picture


def _draw_picture(axes: "Axes", panel: "Panel", norm: Normalize | None) -> Any:
    one = panel.picture
    if one is None:
        return None
    scale = norm or Normalize(*one.ends)
    return axes.pcolormesh(one.x, one.y, one.values, cmap=style.warm_colours(), norm=scale, shading="nearest", rasterized=True)  # fmt: skip


def _plot(describe: "Callable[[Any], Panel]") -> "Callable[..., Axes]":
    """Return the function that draws a panel of an analysis or a test on given axes, or on a new figure."""

    @style.styled
    def plot(response: "History", axes: "Axes | None" = None) -> "Axes":
        axes = style.new_axes(height=1.8) if axes is None else axes
        draw(describe(response), axes)
        return axes

    plot.__name__ = plot.__qualname__ = f"plot_{describe.__name__}"
    plot.__doc__ = f"Draw: {(describe.__doc__ or '')[:1].lower()}{(describe.__doc__ or '')[1:]}"
    return plot


plot_velocities = _plot(panels.velocities)
plot_displacement = _plot(panels.displacement)
plot_temperature = _plot(panels.temperature)
plot_friction = _plot(panels.friction)
plot_energies = _plot(panels.energies)


@style.styled
def plot_loop(
    response: "History",
    axes: "Axes | None" = None,
    *,
    colour: str | None = None,
    norm: Normalize | None = None,
    colour_bar: bool = True,
    thin: float = 1.0,
) -> "Axes":
    """Draw the force against the displacement.

    Parameters
    ----------
    response
        The analysis or test.
    axes
        Where to draw; by default on a new figure.
    colour
        What the colour of the line shows, ``"temperature"`` or ``"time"``; by default the temperature, or the time where nothing heats up.
    norm
        Range of the colours, when several figures share one.
    colour_bar
        Whether a scale of the colours is drawn beside the axes.
    thin
        Factor on the width of the line, for small axes [-].
    """
    axes = style.new_axes() if axes is None else axes
    panel = panels.loop(response)
    (line,) = panel.lines
    shows = colour or colour_shows([response])
    scale = norm or Normalize(*panels.colour_ends(response, shows))
    path = np.column_stack((panel.x.display(line.x), panel.y.display(line.y)))
    pieces, colours = _pieces(path, panels.values_of(response, shows)[panels.shown(response)], scale)
    drawn = LineCollection(
        pieces,
        array=colours,
        cmap=colours_of(shows),
        norm=scale,
        linewidths=thin * line.width,
        capstyle="round",
        rasterized=len(pieces) > _MANY,
    )
    draw_cross(axes)
    axes.add_collection(drawn)
    reach, height = (1.08 * max(float(one), 1e-6) for one in np.abs(path).max(axis=0))
    axes.set_xlim(-reach, reach)
    axes.set_ylim(-height, height)
    style.label_axes(axes, panel.x.label, panel.y.label, 5, 6)
    if colour_bar:
        style.colour_bar_beside(axes, drawn, quantity(shows).label)
    return axes


def _pieces(
    path: "FloatArray", values: "FloatArray", scale: Normalize
) -> "tuple[list[FloatArray], FloatArray]":
    """Cut a loop where its colour changes visibly; return the pieces and the value that colours each."""
    middle = 0.5 * (values[:-1] + values[1:])
    levels = np.floor(_LEVELS * np.asarray(scale(middle)))
    starts = np.concatenate(([0], np.flatnonzero(np.diff(levels)) + 1))
    stops = np.append(starts[1:], middle.size)
    pieces = [path[start : stop + 1] for start, stop in zip(starts, stops, strict=True)]
    return pieces, middle[starts]


def colour_shows(histories: "list[Any]") -> str:
    """Return what the colours of loops show best: the temperature where any of them heats up, else the time."""
    return "temperature" if any(panels.warms(one) for one in histories) else "time"


def colours_of(shows: str) -> Any:
    """Return the colours of the temperature or of the time."""
    return style.warm_colours() if shows == "temperature" else style.time_colours()


@style.styled
def plot_profile(
    response: "History",
    axes: "Axes | None" = None,
    *,
    plate: int = 0,
    norm: Normalize | None = None,
    colour_bar: bool = True,
) -> "Axes":
    """Draw the temperature along a plate as an image over time, with the path of the slider's centre.

    Parameters
    ----------
    response
        An analysis or test with the precise heating model that kept profiles.
    axes
        Where to draw; by default on a new figure.
    plate
        Which plate, where they are different.
    norm
        Range of the colours, when several figures share one.
    colour_bar
        Whether a scale of the colours is drawn beside the axes.

    Raises
    ------
    InputError
        If the analysis kept no profiles.
    """
    panel = panels.profile(response, plate)
    axes = style.new_axes(height=1.8) if axes is None else axes
    drawn = draw(panel, axes, norm)
    if colour_bar and panel.picture is not None:
        style.colour_bar_beside(axes, drawn, panel.picture.shows.label)
    return axes


# What other figures draw too.


def draw_cross(axes: "Axes") -> None:
    """Draw thin lines through zero."""
    axes.axhline(0.0, color=style.GREY, linewidth=0.4, zorder=0)
    axes.axvline(0.0, color=style.GREY, linewidth=0.4, zorder=0)


def between_equal_limits(axes: "Axes", *drawn: "FloatArray") -> None:
    """Put zero in the middle, and room beyond the largest value that is drawn."""
    axes.axhline(0.0, color=style.GREY, linewidth=0.4, zorder=0)
    largest = max(float(np.abs(values).max(initial=0.0)) for values in drawn)
    limit = 1.3 * largest if largest > 0.0 else 1.0
    axes.set_ylim(-limit, limit)


def mark_peak(axes: "Axes", time: "FloatArray", values: "FloatArray", words: str) -> None:
    """Mark the largest value, and write words beside it."""
    place = int(np.abs(values).argmax())
    peak = float(values[place])
    later = time[place] > time[0] + 0.75 * (time[-1] - time[0])
    style.draw_marks(axes, time[place], peak, "o", 3.0, style.INK, zorder=4)
    beside: dict[str, Any] = {
        "xytext": (-4 if later else 4, 2 if peak < 0.0 else -2),
        "textcoords": "offset points",
    }
    box = {"boxstyle": "square,pad=0.1", "facecolor": "white", "edgecolor": "none", "alpha": 0.8}
    side = "right" if later else "left"
    axes.annotate(words, (float(time[place]), peak), **beside, ha=side, va="center", bbox=box, zorder=5)
