"""Virtual tests in the plane drawn: paths, forces, and the temperature of the plates under the path of the slider."""

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.colors import Normalize

from dcfp.present.figures import style
from dcfp.present.figures.drawing import colour_shows
from dcfp.present.figures.plane import draw_directions, plot_orbit
from dcfp.schema.formulas import true_minus, typeset
from dcfp.schema.quantities import quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.analysis.rig import PlaneLoops, Program

#: Points of a circle, and room around the contact on a picture of a plate, over the radius of the slider [-].
_CIRCLE, _ROOM = np.linspace(0.0, 2.0 * math.pi, 181), 1.12


@style.styled
def plot_plate(
    loops: "PlaneLoops", axes: "Axes | None" = None, *, plate: int = 0, at: str = "hottest", norm: Normalize | None = None, colour_bar: bool = True
) -> "Axes":  # fmt: skip
    """Draw the temperature of a plate's surface as a picture, with the path of the slider's middle on it and the edge of the contact.

    Parameters
    ----------
    loops
        A test in the plane with the precise heating model.
    axes
        Where to draw; by default on a new figure.
    plate
        Which plate, where they are different.
    at
        ``"hottest"`` for the moment in which a point of the plates is hottest, or ``"end"``.
    norm
        Range of the colours, when several figures share one.
    colour_bar
        Whether a scale of the colours is drawn beside the axes.

    Raises
    ------
    ValueError
        If the test has no field.
    """
    field = loops.hottest_field if at == "hottest" else loops.field
    if field is None:
        msg = f"{loops.name}: the temperature of the plates needs the precise heating model."
        raise ValueError(msg)
    axes = style.new_axes(height=3.0) if axes is None else axes
    entry, position = quantity("plate_temperature"), field.position
    values = field.temperature[plate]
    scale = norm or Normalize(float(values.min()), float(values.max()))
    drawn = axes.pcolormesh(position, position, values, cmap=style.colours_of("temperature"), norm=scale, shading="nearest", rasterized=True)  # fmt: skip
    share = loops.bearing.shares[0] if plate == 0 else loops.bearing.shares[-1]
    so_far = loops.time <= field.time - loops.begins + 1e-9
    x, y = share * loops.displacement_vectors[so_far].T
    style.draw_line(axes, x, y, "white", 0.6)
    radius = 0.5 * loops.bearing.slider_diameter
    style.draw_line(axes, x[-1] + radius * np.cos(_CIRCLE), y[-1] + radius * np.sin(_CIRCLE), "white", 0.6, linestyle=style.DASHED)  # fmt: skip
    reach = share * loops.peak_displacement + _ROOM * radius
    axes.set_xlim(-reach, reach)
    axes.set_ylim(-reach, reach)
    axes.set_aspect("equal")
    unit = quantity("plate_position").shown.name
    style.label_axes(axes, f"$x$ [{unit}]", f"$y$ [{unit}]", 5, 5)
    if colour_bar:
        style.colour_bar_beside(axes, drawn, entry.label)
    return axes


@style.styled
def plot_plane_test(loops: "PlaneLoops") -> "Figure":
    """Compose the paths of displacement and force, the plates at their hottest and the histories of one test in the plane on a new figure."""
    figure = style.new_figure(6.6 if loops.hottest_field is not None else 4.4)
    rows = 3 if loops.hottest_field is not None else 2
    sides: Any = figure.subfigures(1, 2, width_ratios=(1.0, 1.2))
    left: Any = sides[0].subplots(rows, 1)
    plot_orbit(loops, left[0])
    plot_orbit(loops, left[1], of="force", colour_bar=False)
    if loops.hottest_field is not None:
        plot_plate(loops, left[2])
    right: Any = sides[1].subplots(4, 1, sharex=True, height_ratios=(1.0, 1.5, 1.0, 1.0))
    draw_directions(right[0], loops, "velocity")
    draw_directions(right[1], loops, "force")
    force = loops.histories["force"]
    style.draw_line(right[1], loops.time, force.display(loops.force), style.INK, 0.8, label="resultant")
    style.legend_above(right[1])
    temperature, friction = loops.histories["temperature"], loops.histories["friction"]
    style.draw_line(right[2], loops.time, loops.temperature, style.RED, 0.8, label="mean of the contact")
    if loops.field is not None:
        style.draw_line(right[2], loops.time, loops.point_temperature, style.OCHRE, 0.8, label="hottest point so far")  # fmt: skip
        style.legend_above(right[2])
    right[2].set_ylabel(temperature.label)
    style.draw_line(right[3], loops.time, loops.friction, style.BLUE, 0.7)
    right[3].set_ylabel(friction.label)
    right[3].set_xlabel(quantity("time").label)
    right[3].set_xlim(float(loops.time[0]), float(loops.time[-1]))
    style.write_title(figure, f"{style.drawable(loops.name, 40)}:  {_numbers(loops)}")
    return figure


def _numbers(loops: "PlaneLoops") -> str:
    """Return what the laps of a test did, from the first to the last."""
    ends = loops.laps if len(loops.laps) < 2 else (loops.laps[0], loops.laps[-1])
    work = " → ".join(typeset(one.energy / 1e6) for one in ends)
    friction = " → ".join(typeset(one.friction, 4) for one in ends)
    words = f"lap 1 → {ends[-1].number}:  " if len(ends) > 1 else ""
    return true_minus(f"{words}work {work} kN m,  mean coefficient {friction},  contact up to {typeset(loops.peak_temperature)} °C")  # fmt: skip


@style.styled
def plot_plane_program(program: "Program", loops: "Sequence[PlaneLoops]") -> "Figure":
    """Draw tests in the plane on a new figure: the sheet of one, or of several a row each with its path, its force and its plates at their hottest.

    Parameters
    ----------
    program
        What was run.
    loops
        Its tests; of several models each.
    """
    if len(loops) == 1:
        return plot_plane_test(loops[0])
    columns = 3 if any(one.hottest_field is not None for one in loops) else 2
    figure = style.new_figure(0.5 + 2.25 * len(loops))
    axes: Any = figure.subplots(len(loops), columns, squeeze=False)
    shows = colour_shows(loops)
    histories = [getattr(one, shows) for one in loops]
    norm = Normalize(min(float(one.min()) for one in histories), max(float(one.max()) for one in histories))
    fields = [one.hottest_field for one in loops if one.hottest_field is not None]
    hot = Normalize(min(float(one.temperature.min()) for one in fields), max(float(one.temperature.max()) for one in fields)) if fields else None  # fmt: skip
    several = len({one.heating.name for one in loops}) > 1
    for row, one in zip(axes, loops, strict=True):
        shared = norm if shows == colour_shows([one]) == "temperature" else None
        plot_orbit(one, row[0], norm=shared, colour_bar=False)
        plot_orbit(one, row[1], of="force", norm=shared)
        if one.hottest_field is not None:
            plot_plate(one, row[2], norm=hot)
        elif columns == 3:
            row[2].set_axis_off()
        model = f", {one.heating.name} heating" if several else ""
        row[0].set_title(f"{style.drawable(one.name, 30)}{model}", loc="left", fontsize="small")
        row[1].set_title(_short(one), loc="left", fontsize="small")
    style.write_title(figure, f"{program.name},  {loops[0].friction_law.name}" + ("" if several else f",  {loops[0].heating.name} heating"))  # fmt: skip
    return figure


def _short(loops: "PlaneLoops") -> str:
    last = loops.laps[-1]
    return f"lap {last.number}:  {typeset(last.energy / 1e6)} kN m,  µ {typeset(last.friction, 4)}"
