"""One result drawn: its panels, each on axes that are given or made, and the sheets of an analysis and of a virtual test."""

import re
import textwrap
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D
from matplotlib.transforms import blended_transform_factory

from dcfp.present import panels
from dcfp.present.figures import style
from dcfp.schema.formulas import metres_per_second, millimetres, typeset
from dcfp.schema.quantities import quantity

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure, SubFigure

    from dcfp.analysis import Response
    from dcfp.analysis.result import Result
    from dcfp.analysis.rig import Loops, Measurement
    from dcfp.arrays import FloatArray
    from dcfp.present.panels import History, Panel

#: Colours that are told apart.
_LEVELS = 100
#: Number of pieces above which a line of changing colour is drawn as an image in a PDF or an SVG.
_MANY = 6000
#: Characters in a line of the notes of a sheet, and lines in a paragraph of them; characters of where a record comes from.
_NOTE_WIDTH, _NOTE_LINES, _ORIGIN_WIDTH = 56, 5, 60
#: Histories that are drawn of a result that has no sheet of its own.
_DRAWN = ("displacement", "force", "friction", "temperature")


def draw(panel: "Panel", axes: "Axes", norm: Normalize | None = None) -> Any:
    """Draw a panel of histories, and return what its picture is drawn with, if it has one."""
    shown, first, picture = panel.y.display, panel.lines[0], None
    axes.set_xlim(float(first.x[0]), float(first.x[-1]))
    style.label_axes(axes, panel.x.label, panel.y.label, 8, 4)
    if panel.picture is not None:
        one = panel.picture
        scale = norm or Normalize(*one.ends)
        picture = axes.pcolormesh(one.x, one.y, one.values, cmap=style.colours_of("temperature"), norm=scale, shading="nearest", rasterized=True)  # fmt: skip
    if panel.sliding is not None:
        look: dict[str, Any] = {"color": style.PALE, "linewidth": 0.0, "label": "sliding", "zorder": 0}
        axes.fill_between(first.x, 0.0, 1.0, where=panel.sliding, step="post", transform=axes.get_xaxis_transform(), **look)  # fmt: skip
    stack = panel.lines[: panel.stacked]
    if stack:
        colours, labels = [style.COLOURS[line.colour] for line in stack], [line.label for line in stack]
        heights = [shown(line.y) for line in stack]
        axes.stackplot(first.x, *heights, colors=colours, labels=labels, linewidth=0.0)
    for line in panel.lines[panel.stacked :]:
        label = line.label or None
        style.draw_line(axes, line.x, shown(line.y), style.COLOURS[line.colour], line.width, label=label)
    if panel.peak:
        mark_peak(axes, first.x, first.y, millimetres(float(np.abs(first.y).max())))
    if panel.capacity is not None:
        for side, label in ((panel.capacity, "capacity"), (-panel.capacity, None)):
            axes.axhline(side, color=style.RED, linewidth=0.7, linestyle=style.DASHED, label=label)
    if panel.middle is not None:
        between_equal_limits(axes, shown(panel.middle))
    if panel.low is not None:
        axes.set_ylim(shown(panel.low), None if panel.high is None else shown(panel.high))
    if axes.get_legend_handles_labels()[1]:
        style.legend_above(axes)
    return picture


def _plot(describe: "Callable[[Any], Panel]") -> "Callable[..., Axes]":
    """Return the function that draws a panel of an analysis or a test on given axes, or on a new figure."""

    @style.styled
    def plot(response: "History", axes: "Axes | None" = None) -> "Axes":
        axes = style.new_axes(height=1.8) if axes is None else axes
        draw(describe(response), axes)
        return axes

    plot.__name__ = plot.__qualname__ = f"plot_{describe.__name__}"
    words = describe.__doc__ or ""
    plot.__doc__ = f"Draw: {words[:1].lower()}{words[1:]}"
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
    pieces, colours = _pieces(path, getattr(response, shows)[panels.shown(response)], scale)
    drawn = LineCollection(
        pieces,
        array=colours,
        cmap=style.colours_of(shows),
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


def colour_shows(histories: "Sequence[Any]") -> str:
    """Return what the colours of loops show best: the temperature where any of them heats up, else the time."""
    return "temperature" if any(panels.warms(one) for one in histories) else "time"


def draw_cross(axes: "Axes") -> None:
    """Draw thin lines through zero."""
    axes.axhline(0.0, color=style.GREY, linewidth=0.4, zorder=0)
    axes.axvline(0.0, color=style.GREY, linewidth=0.4, zorder=0)


def between_equal_limits(axes: "Axes", *drawn: "FloatArray | float") -> None:
    """Put zero in the middle, and room beyond the largest value that is drawn."""
    axes.axhline(0.0, color=style.GREY, linewidth=0.4, zorder=0)
    limit = 1.3 * max(float(np.max(np.abs(values), initial=0.0)) for values in drawn) or 1.0
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


def draw_measured(axes: "Axes", measured: "Measurement") -> tuple[float, float]:
    """Draw measured loops in grey, and return how far they reach along both axes."""
    x, y = (quantity(name).display(getattr(measured, name)) for name in ("displacement", "force"))
    style.draw_line(axes, x, y, style.GREY, zorder=1, label="measured")
    return float(np.abs(x).max()), float(np.abs(y).max())


def figure_of(result: "Result", **options: Any) -> "Figure":
    """Draw a result on a new figure: the sheet of an analysis or a test, or else its histories one above the other."""
    from dcfp.analysis.plan import PlanResponse  # late: the analyses import the kernels
    from dcfp.analysis.plane_response import PlaneResponse
    from dcfp.analysis.response import Response
    from dcfp.analysis.rig import Loops, PlaneLoops

    if isinstance(result, Response):
        return plot_response(result, **options)
    if isinstance(result, PlaneResponse):
        from dcfp.present.figures.plane import plot_plane_response  # late: it draws with what is here

        return plot_plane_response(result, **options)
    if isinstance(result, PlanResponse):
        from dcfp.present.figures.plan import plot_plan_response  # late: it draws with what is here

        return plot_plan_response(result, **options)
    if isinstance(result, PlaneLoops):
        from dcfp.present.figures.plane_tests import plot_plane_test  # late: it draws with what is here

        return plot_plane_test(result, **options)
    return plot_test(result, **options) if isinstance(result, Loops) else _plot_histories(result)


@style.styled
def _plot_histories(result: "Result") -> "Figure":
    shown = [result.histories[name] for name in _DRAWN if name in result.histories]
    figure = style.new_figure(1.4 * len(shown) + 0.5)
    axes: Any = figure.subplots(len(shown), 1, sharex=True, squeeze=False)[:, 0]
    for one, entry in zip(axes, shown, strict=True):
        style.draw_line(one, result.time, entry.display(entry.of(result)), style.BLUE, 0.6)
        one.set_ylabel(entry.label)
    axes[-1].set_xlabel(quantity("time").label)
    figure.suptitle(result.title)
    return figure


@style.styled
def plot_response(response: "Response") -> "Figure":
    """Compose the loop and the histories of one analysis, with its key numbers, on a new figure."""
    described = (panels.velocities, panels.displacement, panels.temperature, panels.friction)
    drawn = [describe(response) for describe in described]
    drawn += [panels.profile(response)] if response.profiles is not None else []

    def left(side: "SubFigure") -> None:
        axes: Any = side.subplots(2, 1, height_ratios=[3.0, 1.15])
        plot_loop(response, axes[0])
        _write_notes(side, axes[1], response)

    return _sheet(_response_head(response), left, [*drawn, panels.energies(response)], (0.92, 0.75, 1.15))


@style.styled
def plot_test(loops: "Loops", measured: "Measurement | None" = None) -> "Figure":
    """Compose the loops and the histories of one test, with the measures of its first and last cycle, on a new figure.

    Parameters
    ----------
    loops
        The test.
    measured
        What was measured in reality, drawn in grey below it.
    """
    drawn = [panels.displacement(loops), panels.temperature(loops), panels.friction(loops)]
    drawn += [panels.profile(loops)] if loops.profiles is not None else []

    def left(side: "SubFigure") -> None:
        axes: Any = side.subplots()
        reach, height = (0.0, 0.0) if measured is None else draw_measured(axes, measured)
        plot_loop(loops, axes)
        if measured is not None:
            right, top = max(axes.get_xlim()[1], 1.08 * reach), max(axes.get_ylim()[1], 1.08 * height)
            axes.set(xlim=(-right, right), ylim=(-top, top))
            axes.legend(handles=[Line2D([], [], color=style.GREY, label="measured")], loc="upper left")

    return _sheet(_test_head(loops), left, drawn, (1.05, 0.6, 1.1))


def _sheet(
    head: tuple[str, str, str],
    left: "Callable[[SubFigure], None]",
    drawn: "Sequence[Panel]",
    shape: tuple[float, float, float],
) -> "Figure":
    """Compose a head of two lines, what is left below it, and panels over the same time; `shape` is the height of a panel and of the rest, and the width of the panels over that of the rest."""
    row, rest, ratio = shape
    height = row * max(len(drawn), 3)
    figure = style.new_figure(height + rest)
    halves: Any = figure.subfigures(2, 1, height_ratios=[0.5, height], hspace=0.0)
    sides: Any = halves[1].subfigures(1, 2, width_ratios=[1.0, ratio], wspace=0.02)
    title, origin, numbers = head
    halves[0].text(0.012, 0.68, title, va="center", size=10, weight="bold", parse_math=False)
    halves[0].text(0.988, 0.68, origin, va="center", ha="right", color="#555555", parse_math=False)
    halves[0].text(0.012, 0.18, numbers, va="center")
    left(sides[0])
    axes: Any = sides[1].subplots(len(drawn), 1, sharex=True)
    for panel, one in zip(drawn, axes, strict=True):
        draw(panel, one)
    for one in axes[:-1]:
        one.set_xlabel("")
        one.tick_params(labelbottom=False)
    sides[1].align_ylabels(list(axes))
    return figure


def _response_head(response: "Response") -> tuple[str, str, str]:
    """Return the title, where the record comes from, and the peaks in one line of mathematics."""
    motion, force = response.motion, response.peak_force
    title = f"{style.drawable(motion.name)},  PGV {metres_per_second(motion.peak_velocity)}"
    origin = ", ".join(word for word in (motion.origin.event, motion.origin.station) if word)
    peaks = (
        rf"$y_{{\mathrm{{max}}}}$ {millimetres(response.peak_displacement)}",
        rf"$F_{{\mathrm{{max}}}}$ {typeset(force / 1e3)} kN ({force / response.bearing.vertical_force:.3f} $W$)",
        rf"$T_{{\mathrm{{max}}}}$ {typeset(response.peak_temperature)} °C",
        rf"$\mu_{{\mathrm{{min}}}}$ {response.least_friction:.3f}",
        rf"$V_E$ {metres_per_second(response.input_velocity)}",
        f"residual {millimetres(response.residual_displacement)}",
    )
    return title, style.drawable(origin, _ORIGIN_WIDTH), ",  ".join(peaks)


def _write_notes(left: "SubFigure", notes: "Axes", response: "Response") -> None:
    """Write what was analysed below the loop, and what must be known of the result."""
    notes.set_axis_off()
    bearing, law, heating = response.bearing, response.friction_law, response.heating
    radii = " + ".join(f"{radius:g}" for radius in bearing.radii)
    values = (
        f"{style.drawable(bearing.name)}: radius {radii} mm, slider {bearing.slider_diameter:g} mm, "
        f"{bearing.pressure:g} N/mm², period {bearing.period:.2f} s. Friction {law.name}, "
        f"reference {law.reference:g}. Heating {heating.name}, from {typeset(heating.ambient)} °C."
    )
    values = re.sub(r"(?<=\d) (?=mm|N/|s\b|°C)", "\u00a0", values)  # a number and its unit stay together
    corner = blended_transform_factory(left.transSubfigure, notes.transAxes)
    depth = 0.0
    for text, colour in [
        (values, style.INK),
        *((style.drawable(remark), style.RED) for remark in response.remarks),
    ]:
        lines = textwrap.wrap(text, _NOTE_WIDTH)[:_NOTE_LINES]
        place: dict[str, Any] = {"xycoords": corner, "xytext": (0.0, -depth), "textcoords": "offset points"}
        look: dict[str, Any] = {"va": "top", "size": 7, "annotation_clip": False, "parse_math": False}
        drawn = notes.annotate("\n".join(lines), (0.03, 1.0), **place, **look, color=colour)
        drawn.set_in_layout(False)
        depth += 9.0 * len(lines) + 3.0


def _test_head(loops: "Loops") -> tuple[str, str, str]:
    law, first, last = loops.friction_law, loops.cycles[0], loops.cycles[-1]
    model = f"{style.drawable(loops.bearing.name)};  friction {law.name}, reference {law.reference:.3g};  heating {loops.heating.name}"
    ends = (first, last) if last.number > 1 else (first,)
    numbers: list[str] = []
    for symbol, name, size, decimals, unit in (
        (r"$k_{\mathrm{eff}}$", "effective_stiffness", 1e3, 2, "kN/mm"),
        (r"$\beta_{\mathrm{eff}}$", "effective_damping", 1.0, 3, ""),
        (r"$E$", "energy", 1e6, 0, "kN m"),
        (r"$T_{\mathrm{max}}$", "peak_temperature", 1.0, 0, "°C"),
    ):
        values = [typeset(getattr(one, name) / size, decimals) for one in ends]
        numbers.append(f"{symbol} {' → '.join(values)} {unit}".rstrip())
    cycles = f"cycle 1 → {last.number}:   " if last.number > 1 else "cycle 1:   "
    title = f"{style.drawable(loops.test.name)},  {loops.test.waveform.kind}"
    return title, model, cycles + ",   ".join(numbers)
