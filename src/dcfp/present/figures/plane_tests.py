"""Virtual tests in the plane drawn: paths, forces, and the temperature of the plates under the path of the slider."""

from typing import TYPE_CHECKING, Any

from dcfp.present.figures import style
from dcfp.present.figures.plane import draw_directions, plot_orbit
from dcfp.present.figures.plane_field import heat_scale, plot_field
from dcfp.schema.formulas import true_minus, typeset
from dcfp.schema.quantities import quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from dcfp.analysis.rig import PlaneLoops, Program


@style.styled
def plot_plane_test(loops: "PlaneLoops") -> "Figure":
    """Compose the paths of displacement and force, the plates at their hottest and the histories of one test in the plane on a new figure."""
    figure = style.new_figure(6.6 if loops.fields is not None else 4.4)
    rows = 3 if loops.fields is not None else 2
    sides: Any = figure.subfigures(1, 2, width_ratios=(1.0, 1.2))
    left: Any = sides[0].subplots(rows, 1)
    norm = heat_scale([loops])
    plot_orbit(loops, left[0], norm=norm)
    plot_orbit(loops, left[1], of="force", norm=norm, colour_bar=False)
    if loops.fields is not None:
        plot_field(loops, axes=left[2], norm=norm)
    right: Any = sides[1].subplots(4, 1, sharex=True, height_ratios=(1.0, 1.5, 1.0, 1.0))
    draw_directions(right[0], loops, "velocity")
    draw_directions(right[1], loops, "force")
    force = loops.histories["force"]
    style.draw_line(right[1], loops.time, force.display(loops.force), style.INK, 0.8, label="resultant")
    style.legend_above(right[1])
    temperature, friction = loops.histories["temperature"], loops.histories["friction"]
    style.draw_line(right[2], loops.time, loops.temperature, style.RED, 0.8, label="mean of the contact")
    if loops.fields is not None:
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
    columns = 3 if any(one.fields is not None for one in loops) else 2
    figure = style.new_figure(0.5 + 2.25 * len(loops))
    axes: Any = figure.subplots(len(loops), columns, squeeze=False)
    norm = heat_scale(loops)
    several = len({one.heating.name for one in loops}) > 1
    for row, one in zip(axes, loops, strict=True):
        plot_orbit(one, row[0], norm=norm, colour_bar=False)
        plot_orbit(one, row[1], of="force", norm=norm, colour_bar=one.fields is None)
        if one.fields is not None:
            plot_field(one, axes=row[2], norm=norm)
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
