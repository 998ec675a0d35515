"""One result on one sheet: an analysis, a virtual test, or the histories of any other."""

import re
import textwrap
from typing import TYPE_CHECKING, Any

from matplotlib.lines import Line2D
from matplotlib.transforms import blended_transform_factory

from dcfp.present import panels
from dcfp.present.figures.drawing import draw, plot_loop
from dcfp.present.figures.style import BLUE, GREY, INK, RED, draw_line, drawable, new_figure, styled
from dcfp.schema.formulas import metres_per_second, millimetres, typeset
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure, SubFigure

    from dcfp.analysis import Response
    from dcfp.analysis.result import Result
    from dcfp.analysis.rig import Loops, Measurement
    from dcfp.present.panels import Panel

#: Characters in a line of the notes, and lines in a paragraph of them.
_NOTE_WIDTH, _NOTE_LINES = 56, 5


#: Histories that are drawn of a result that has no sheet of its own.
_DRAWN = ("displacement", "force", "friction", "temperature")


def figure_of(result: "Result", **options: Any) -> "Figure":
    """Draw a result on a new figure: the sheet of an analysis or a test, or else its histories one above the other."""
    from dcfp.analysis.response import Response  # late: the analyses import the kernels
    from dcfp.analysis.rig import Loops

    if isinstance(result, Response):
        return plot_response(result, **options)
    return plot_test(result, **options) if isinstance(result, Loops) else _plot_histories(result)


@styled
def _plot_histories(result: "Result") -> "Figure":
    shown = {name: entry for name, entry in result.histories.items() if name in _DRAWN}
    figure = new_figure(1.4 * len(shown) + 0.5)
    axes: Any = figure.subplots(len(shown), 1, sharex=True, squeeze=False)[:, 0]
    for one, name in zip(axes, filter(shown.get, _DRAWN), strict=True):
        draw_line(one, result.time, shown[name].display(shown[name].of(result)), BLUE, 0.6)
        one.set_ylabel(shown[name].label)
    axes[-1].set_xlabel(quantity("time").label)
    figure.suptitle(result.title)
    return figure


@styled
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


@styled
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
        if measured is not None:
            draw_measured(axes, measured)
        plot_loop(loops, axes)
        if measured is not None:
            _make_room(axes, measured)
            axes.legend(handles=[Line2D([], [], color=GREY, label="measured")], loc="upper left")

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
    figure = new_figure(height + rest)
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


def key_numbers(response: "Response") -> str:
    """Return the peaks in one line of mathematics."""
    force = response.peak_force
    return ",  ".join(
        (
            rf"$y_{{\mathrm{{max}}}}$ {millimetres(response.peak_displacement)}",
            rf"$F_{{\mathrm{{max}}}}$ {typeset(force / 1e3)} kN ({force / response.bearing.vertical_force:.3f} $W$)",
            rf"$T_{{\mathrm{{max}}}}$ {typeset(response.peak_temperature)} °C",
            rf"$\mu_{{\mathrm{{min}}}}$ {response.least_friction:.3f}",
            rf"$V_E$ {metres_per_second(response.input_velocity)}",
            f"residual {millimetres(response.residual_displacement)}",
        )
    )


def _response_head(response: "Response") -> tuple[str, str, str]:
    motion = response.motion
    origin = drawable(", ".join(word for word in (motion.origin.event, motion.origin.station) if word))
    title = f"{drawable(motion.name)},  PGV {metres_per_second(motion.peak_velocity)}"
    return title, origin if len(origin) <= 60 else origin[:59].rstrip() + "…", key_numbers(response)


def _write_notes(left: "SubFigure", notes: "Axes", response: "Response") -> None:
    """Write what was analysed below the loop, and what must be known of the result."""
    notes.set_axis_off()
    bearing, law, heating = response.bearing, response.friction_law, response.heating
    radii = " + ".join(f"{radius:g}" for radius in bearing.radii)
    values = (
        f"{drawable(bearing.name)}: radius {radii} mm, slider {bearing.slider_diameter:g} mm, "
        f"{bearing.pressure:g} N/mm², period {bearing.period:.2f} s. Friction {law.name}, "
        f"reference {law.reference:g}. Heating {heating.name}, from {typeset(heating.ambient)} °C."
    )
    values = re.sub(r"(?<=\d) (?=mm|N/|s\b|°C)", "\u00a0", values)  # a number and its unit stay together
    corner = blended_transform_factory(left.transSubfigure, notes.transAxes)
    depth = 0.0
    for text, colour in [(values, INK), *((drawable(remark), RED) for remark in response.remarks)]:
        lines = textwrap.wrap(text, _NOTE_WIDTH)[:_NOTE_LINES]
        place: dict[str, Any] = {"xycoords": corner, "xytext": (0.0, -depth), "textcoords": "offset points"}
        look: dict[str, Any] = {"va": "top", "size": 7, "annotation_clip": False, "parse_math": False}
        drawn = notes.annotate("\n".join(lines), (0.03, 1.0), **place, **look, color=colour)
        drawn.set_in_layout(False)
        depth += 9.0 * len(lines) + 3.0


def draw_measured(axes: "Axes", measured: "Measurement") -> None:
    """Draw measured loops in grey."""
    x, y = (quantity(name).display(getattr(measured, name)) for name in ("displacement", "force"))
    draw_line(axes, x, y, GREY, zorder=1, label="measured")


def _make_room(axes: "Axes", measured: "Measurement") -> None:
    for name, limits, set_limits in (
        ("displacement", axes.get_xlim(), axes.set_xlim),
        ("force", axes.get_ylim(), axes.set_ylim),
    ):
        size = float(abs(quantity(name).display(getattr(measured, name))).max())
        largest = max(limits[1], 1.08 * size)
        set_limits(-largest, largest)


def _test_head(loops: "Loops") -> tuple[str, str, str]:
    law, first, last = loops.friction_law, loops.cycles[0], loops.cycles[-1]
    model = f"{drawable(loops.bearing.name)};  friction {law.name}, reference {law.reference:.3g};  heating {loops.heating.name}"
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
    title = f"{drawable(loops.test.name)},  {loops.test.waveform.kind}"
    return title, model, cycles + ",   ".join(numbers)
