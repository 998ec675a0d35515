"""One virtual test on one sheet."""

from typing import TYPE_CHECKING, Any

from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from dcfp.present.figures.histories import plot_displacement, plot_friction, plot_temperature
from dcfp.present.figures.loop import colour_quantity, colour_range, plot_loop
from dcfp.present.figures.profile import plot_profile
from dcfp.present.figures.style import GREY, PAGE_WIDTH, drawable, style
from dcfp.present.figures.words import number
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.axes import Axes

    from dcfp.analysis.rig import Loops, Measurement

_ROW_HEIGHT = 1.05
_KILO, _MEGA = 1e3, 1e6


def plot_test(loops: "Loops", measured: "Measurement | None" = None) -> Figure:
    """Compose the loops and the histories of one test, with the measures of its first and last cycle, on a new figure.

    Parameters
    ----------
    loops
        The test.
    measured
        What was measured in reality, drawn in grey below it.
    """
    drawn: list[Callable[[Loops, Axes], Axes]] = [plot_displacement, plot_temperature, plot_friction]
    with style():
        shows = colour_quantity(loops)
        norm = colour_range(loops, shows)
        if loops.profiles is not None:
            shared = norm if shows == "temperature" else None
            drawn.append(lambda test, axes: plot_profile(test, axes, norm=shared, colour_bar=False))
        height = _ROW_HEIGHT * max(len(drawn), 3)
        figure = Figure(figsize=(PAGE_WIDTH, height + 0.6), layout="constrained")
        halves: Any = figure.subfigures(2, 1, height_ratios=[0.5, height], hspace=0.0)
        sides: Any = halves[1].subfigures(1, 2, width_ratios=[1.0, 1.1], wspace=0.02)
        _write_head(halves[0], loops)
        left = sides[0].subplots()
        if measured is not None:
            draw_measured(left, measured)
        plot_loop(loops, left, colour=shows, norm=norm)
        if measured is not None:
            _make_room(left, measured)
            left.legend(handles=[Line2D([], [], color=GREY, label="measured")], loc="upper left")
        panels: Any = sides[1].subplots(len(drawn), 1, sharex=True)
        for draw, axes in zip(drawn, panels, strict=True):
            draw(loops, axes)
        for axes in panels[:-1]:
            axes.set_xlabel("")
            axes.tick_params(labelbottom=False)
        sides[1].align_ylabels(list(panels))
    return figure


def draw_measured(axes: "Axes", measured: "Measurement") -> None:
    """Draw measured loops in grey."""
    axes.plot(
        quantity("displacement").display(measured.displacement),
        quantity("force").display(measured.force),
        color=GREY,
        linewidth=0.7,
        zorder=1,
        label="measured",
    )


def _make_room(axes: "Axes", measured: "Measurement") -> None:
    for values, name, limits, set_limits in (
        (measured.displacement, "displacement", axes.get_xlim(), axes.set_xlim),
        (measured.force, "force", axes.get_ylim(), axes.set_ylim),
    ):
        largest = max(limits[1], 1.08 * float(abs(quantity(name).display(values)).max()))
        set_limits(-largest, largest)


def _write_head(head: Any, loops: "Loops") -> None:
    test, bearing = loops.test, loops.bearing
    words = f"{drawable(test.name)},  {test.waveform.kind}"
    title = head.text(0.012, 0.68, words, size=10, weight="bold", va="center")
    title.set_parse_math(False)
    model = (
        f"{drawable(bearing.name)};  friction {loops.friction_law.name}, reference {loops.friction_law.reference:.3g};"
        f"  heating {loops.heating.name}"
    )
    right = head.text(0.988, 0.68, model, ha="right", va="center", color="#555555")
    right.set_parse_math(False)
    first, last = loops.cycles[0], loops.cycles[-1]
    pairs = [
        (
            r"$k_{\mathrm{eff}}$",
            first.effective_stiffness / _KILO,
            last.effective_stiffness / _KILO,
            2,
            "kN/mm",
        ),
        (r"$\beta_{\mathrm{eff}}$", first.effective_damping, last.effective_damping, 3, ""),
        (r"$E$", first.energy / _MEGA, last.energy / _MEGA, 0, "kN m"),
        (r"$T_{\mathrm{max}}$", first.peak_temperature, last.peak_temperature, 0, "°C"),
    ]
    cycles = f"cycle 1 → {last.number}:   " if last.number > 1 else "cycle 1:   "
    numbers = ",   ".join(
        f"{symbol} {number(one, decimals)}"
        + (f" → {number(other, decimals)}" if last.number > 1 else "")
        + f" {unit}".rstrip()
        for symbol, one, other, decimals, unit in pairs
    )
    head.text(0.012, 0.18, cycles + numbers, va="center")
