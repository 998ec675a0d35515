"""The energy balance over time."""

from typing import TYPE_CHECKING

from dcfp.present.figures.extent import line_width, shown
from dcfp.present.figures.style import BLUE, INK, OCHRE, calm_ticks, legend_above, new_axes, styled
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from dcfp.analysis import Response

_PALE_BLUE = "#7FA3CB"


@styled
def plot_energies(response: "Response", axes: "Axes | None" = None) -> "Axes":
    """Draw the hysteretic, strain and kinetic energies on top of each other, and the input energy as a line."""
    axes = new_axes(height=1.8) if axes is None else axes
    part = shown(response)
    time = response.time[part]
    energy = response.energy
    stack = (
        ("hysteretic_energy", energy.hysteretic, OCHRE),
        ("strain_energy", energy.strain, _PALE_BLUE),
        ("kinetic_energy", energy.kinetic, BLUE),
    )
    axes.stackplot(
        time,
        *(quantity(name).display(values[part]) for name, values, _ in stack),
        colors=[colour for _, _, colour in stack],
        labels=[f"${quantity(name).symbol}$" for name, _, _ in stack],
        linewidth=0.0,
    )
    entry = quantity("input_energy")
    width = min(line_width(response), 0.7)
    axes.plot(time, entry.display(energy.input[part]), color=INK, linewidth=width, label=f"${entry.symbol}$")
    axes.set_xlim(float(time[0]), float(time[-1]))
    axes.set_ylim(bottom=min(0.0, float(entry.display(energy.input[part]).min())))
    calm_ticks(axes, 8, 4)
    axes.set_xlabel(quantity("time").label)
    axes.set_ylabel(entry.label)
    legend_above(axes)
    return axes
