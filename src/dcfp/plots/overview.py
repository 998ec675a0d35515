"""Several analyses beside each other."""

import math
from typing import TYPE_CHECKING, Any

from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from dcfp.nomenclature import quantity
from dcfp.plots.loop import ColourQuantity, colour_quantity, colour_range, plot_loop
from dcfp.plots.style import INK, PAGE_WIDTH, RED, calm_ticks, drawable, style, time_colours, warm_colours
from dcfp.plots.words import metres_per_second, millimetres, number

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from matplotlib.axes import Axes

    from dcfp.response import Response

#: Most panels in a row.
_COLUMNS = 5


def plot_overview(responses: "Sequence[Response]") -> Figure:
    """Draw the loops of several analyses to the same scales, on a new figure.

    Records are rows and PGVs columns where every record was analysed at the same PGVs; otherwise the panels
    follow each other, each with its own title.
    """
    grid = _grid(responses)
    columns = len(grid[0])
    width = PAGE_WIDTH
    panel = (width - 0.9) / max(columns, 3)
    with style():
        figure = Figure(
            figsize=(min(width, panel * columns + 0.9), 0.62 + len(grid) * (0.85 * panel + 0.1)),
            layout="constrained",
        )
        axes = figure.subplots(len(grid), columns, sharex=True, sharey=True, squeeze=False)
        warm = any(colour_quantity(response) == "temperature" for response in responses)
        shows: ColourQuantity = "temperature" if warm else "time"
        norm = _shared_range(responses, shows)
        for panels, row in zip(axes, grid, strict=True):
            for one, response in zip(panels, row, strict=True):
                if response is None:
                    one.set_axis_off()
                else:
                    _draw_panel(one, response, shows, norm)
        _name_panels(axes, grid)
        _share_limits(axes, responses)
        _add_scale(figure, axes, shows, norm)
        figure.supxlabel(quantity("displacement").label, fontsize=8)
        figure.supylabel(quantity("force").label, fontsize=8)
    return figure


def _grid(responses: "Sequence[Response]") -> "list[list[Response | None]]":
    """Return rows of analyses: one row for each record if all have the same PGVs, else rows of a few."""
    records: dict[str, list[Response]] = {}
    for response in responses:
        records.setdefault(response.motion.name, []).append(response)
    velocities = [[_pgv(response) for response in row] for row in records.values()]
    if all(row == velocities[0] for row in velocities) and 1 < len(velocities[0]) <= 2 * _COLUMNS:
        return [list(row) for row in records.values()]
    columns = min(_COLUMNS, math.ceil(math.sqrt(len(responses))))
    filled: list[Response | None] = [*responses, *([None] * (-len(responses) % columns))]
    return [filled[first : first + columns] for first in range(0, len(filled), columns)]


def _pgv(response: "Response") -> str:
    return metres_per_second(response.motion.peak_velocity)


def _is_table(grid: "list[list[Response | None]]") -> bool:
    return all(len({r.motion.name if r else "" for r in row}) == 1 for row in grid) and len(grid[0]) > 1


def _draw_panel(axes: "Axes", response: "Response", shows: ColourQuantity, norm: Normalize) -> None:
    plot_loop(response, axes, colour=shows, norm=norm, colour_bar=False, thin=0.7)
    axes.set_xlabel("")
    axes.set_ylabel("")
    numbers = f"{millimetres(response.peak_displacement)}\n{number(response.peak_temperature)} °C"
    beyond = response.status.value == "beyond capacity"
    axes.text(
        0.03,
        0.98,
        numbers,
        transform=axes.transAxes,
        va="top",
        color=RED if beyond else INK,
        bbox={"boxstyle": "square,pad=0.05", "facecolor": "white", "edgecolor": "none", "alpha": 0.85},
    )


def _name_panels(axes: "np.ndarray", grid: "list[list[Response | None]]") -> None:
    if _is_table(grid):
        for one, response in zip(axes[0], grid[0], strict=True):
            if response is not None:
                one.set_title(f"PGV {_pgv(response)}")
        for one, row in zip(axes[:, 0], grid, strict=True):
            if row[0] is not None:
                one.set_ylabel(drawable(row[0].motion.name), weight="bold", parse_math=False)
        return
    for one, response in zip(axes.flat, [entry for row in grid for entry in row], strict=True):
        if response is not None:
            one.set_title(f"{drawable(response.motion.name)}, {_pgv(response)}", parse_math=False)


def _share_limits(axes: "np.ndarray", responses: "Sequence[Response]") -> None:
    reach = 1.06 * max(response.peak_displacement for response in responses)
    height = 1.1 * quantity("force").factor * max(response.peak_force for response in responses)
    first = axes[0, 0]
    first.set_xlim(-reach, reach)
    first.set_ylim(-height, height)
    calm_ticks(first, 4, 5)
    capacity = responses[0].bearing.displacement_capacity
    for one in axes.flat:
        if capacity is not None and capacity < reach and one.axison:
            for side in (-capacity, capacity):
                one.axvline(side, color=RED, linewidth=0.5, linestyle=(0, (5, 3)), zorder=0)


def _shared_range(responses: "Sequence[Response]", shows: ColourQuantity) -> Normalize:
    ranges = [colour_range(response, shows) for response in responses]
    return Normalize(min(float(r.vmin or 0.0) for r in ranges), max(float(r.vmax or 0.0) for r in ranges))


def _add_scale(figure: Figure, axes: "np.ndarray", shows: ColourQuantity, norm: Normalize) -> None:
    colours = warm_colours() if shows == "temperature" else time_colours()
    bar: Any = figure.colorbar(
        ScalarMappable(norm, colours), ax=axes, pad=0.015, aspect=18 * len(axes), fraction=0.03
    )
    bar.set_label(quantity(shows).label)
    bar.outline.set_visible(False)
