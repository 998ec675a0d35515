"""One analysis on one sheet."""

import re
import textwrap
from typing import TYPE_CHECKING, Any

from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.transforms import blended_transform_factory

from dcfp.present.figures.histories import (
    plot_displacement,
    plot_energies,
    plot_friction,
    plot_temperature,
    plot_velocities,
)
from dcfp.present.figures.loop import ColourQuantity, colour_quantity, colour_range, plot_loop, plot_profile
from dcfp.present.figures.style import (
    INK,
    PAGE_WIDTH,
    RED,
    drawable,
    metres_per_second,
    millimetres,
    number,
    style,
)

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.axes import Axes
    from matplotlib.figure import SubFigure

    from dcfp.analysis import Response

_ROW_HEIGHT = 0.92
_KILO = 1e3
#: Characters in a line of the notes, and lines in a paragraph of them.
_NOTE_WIDTH, _NOTE_LINES = 56, 5


def plot_response(response: "Response") -> Figure:
    """Compose the loop and the histories of one analysis, with its key numbers, on a new figure."""
    height = _ROW_HEIGHT * (5 if response.profiles is None else 6)
    with style():
        figure = Figure(figsize=(PAGE_WIDTH, height + 0.75), layout="constrained")
        halves: Any = figure.subfigures(2, 1, height_ratios=[0.5, height], hspace=0.0)
        sides: Any = halves[1].subfigures(1, 2, width_ratios=[1.0, 1.15], wspace=0.02)
        shows = colour_quantity(response)
        norm = colour_range(response, shows)
        _write_head(halves[0], response)
        _draw_loop(sides[0], response, shows, norm)
        _draw_histories(sides[1], response, norm if shows == "temperature" else None)
    return figure


def _draw_loop(left: "SubFigure", response: "Response", shows: ColourQuantity, norm: Normalize) -> None:
    panels: Any = left.subplots(2, 1, height_ratios=[3.0, 1.15])
    plot_loop(response, panels[0], colour=shows, norm=norm)
    _write_notes(left, panels[1], response)


def _draw_histories(right: "SubFigure", response: "Response", norm: Normalize | None) -> None:
    drawn: list[Callable[[Response, Axes], Axes]] = [
        plot_velocities,
        plot_displacement,
        plot_temperature,
        plot_friction,
        plot_energies,
    ]
    if response.profiles is not None:
        drawn.insert(4, lambda response, axes: plot_profile(response, axes, norm=norm, colour_bar=False))
    panels: Any = right.subplots(len(drawn), 1, sharex=True)
    for draw, axes in zip(drawn, panels, strict=True):
        draw(response, axes)
    for axes in panels[:-1]:
        axes.set_xlabel("")
        axes.tick_params(labelbottom=False)
    right.align_ylabels(list(panels))


def key_numbers(response: "Response") -> str:
    """Return the peaks in one line of mathematics."""
    force = response.peak_force
    return ",  ".join(
        (
            rf"$y_{{\mathrm{{max}}}}$ {millimetres(response.peak_displacement)}",
            rf"$F_{{\mathrm{{max}}}}$ {number(force / _KILO)} kN ({force / response.bearing.vertical_force:.3f} $W$)",
            rf"$T_{{\mathrm{{max}}}}$ {number(response.peak_temperature)} °C",
            rf"$\mu_{{\mathrm{{min}}}}$ {response.least_friction:.3f}",
            rf"$V_E$ {metres_per_second(response.input_velocity)}",
            f"residual {millimetres(response.residual_displacement)}",
        )
    )


def _write_head(head: "SubFigure", response: "Response") -> None:
    motion = response.motion
    origin = ", ".join(word for word in (motion.origin.event, motion.origin.station) if word)
    pgv = f"PGV {metres_per_second(motion.peak_velocity)}"
    title = head.text(0.012, 0.68, f"{drawable(motion.name)},  {pgv}", size=10, weight="bold", va="center")
    title.set_parse_math(False)
    right = head.text(0.988, 0.68, _short(drawable(origin), 60), ha="right", va="center", color="#555555")
    right.set_parse_math(False)
    head.text(0.012, 0.18, key_numbers(response), va="center")


def _write_notes(left: "SubFigure", notes: "Axes", response: "Response") -> None:
    """Write what was analysed below the loop, and what must be known of the result."""
    notes.set_axis_off()
    bearing, law, heating = response.bearing, response.friction_law, response.heating
    radii = " + ".join(f"{radius:g}" for radius in bearing.radii)
    values = (
        f"{drawable(bearing.name)}: radius {radii} mm, slider {bearing.slider_diameter:g} mm, "
        f"{bearing.pressure:g} N/mm², period {bearing.period:.2f} s. Friction {law.name}, "
        f"reference {law.reference:g}. Heating {heating.name}, from {number(heating.ambient)} °C."
    )
    values = re.sub(r"(?<=\d) (?=mm|N/|s\b|°C)", "\u00a0", values)  # a number and its unit stay together
    paragraphs = [(values, INK), *((drawable(remark), RED) for remark in response.remarks)]
    corner = blended_transform_factory(left.transSubfigure, notes.transAxes)
    depth = 0.0
    for text, colour in paragraphs:
        lines = textwrap.wrap(text, _NOTE_WIDTH)[:_NOTE_LINES]
        drawn = notes.annotate(
            "\n".join(lines),
            (0.03, 1.0),
            xycoords=corner,
            xytext=(0.0, -depth),
            textcoords="offset points",
            va="top",
            size=7,
            color=colour,
            annotation_clip=False,
            parse_math=False,
        )
        drawn.set_in_layout(False)
        depth += 9.0 * len(lines) + 3.0


def _short(text: str, most: int) -> str:
    return text if len(text) <= most else text[: most - 1].rstrip() + "…"
