"""Which friction and which radius hold a displacement: a chart."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from dcfp.present.figures.style import BLUE, GREY, INK, PAGE_WIDTH, RED, style
from dcfp.schema.digits import metres_per_second, millimetres

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from dcfp.arrays import FloatArray
    from dcfp.inference.design_space import DesignSpace

#: Probabilities of the two panels, and how to call them.
_PARTS = ((0.5, "half of the earthquakes"), (0.95, "95 % of the earthquakes"))
#: Displacements [mm] and forces over weight [-] at which lines are drawn.
_DISPLACEMENTS = (25, 50, 75, 100, 150, 200, 300, 400, 500, 600, 800, 1000, 1500, 2000)
_FORCES = (0.04, 0.06, 0.08, 0.1, 0.125, 0.15, 0.2, 0.25, 0.3, 0.4)
#: Height at which the numbers of each stand, apart so that none covers another, and how near to the side a number still fits [-].
_HEIGHT_OF_DISPLACEMENTS, _HEIGHT_OF_FORCES, _SIDE = 0.75, 0.3, 0.03


def plot_design_chart(spaces: "Sequence[DesignSpace]", allowed: float) -> Figure:
    """Draw lines of equal displacement and of equal force over friction and radius, on a new figure.

    A row for each PGV; left the median of the records, right what 95 % of earthquakes do not exceed, where there are enough records to say so.
    What holds `allowed` [mm] is shaded.
    """
    parts = [one for one in _PARTS if all(one[0] * (space.records + 1) <= space.records for space in spaces)]
    with style():
        figure = Figure(figsize=(PAGE_WIDTH, 0.7 + 2.6 * len(spaces)), layout="constrained")
        axes = figure.subplots(len(spaces), len(parts), squeeze=False, sharex=True, sharey=True)
        for row, space in zip(axes, spaces, strict=True):
            for one, (part, words) in zip(row, parts, strict=True):
                _draw(one, space, allowed, part)
                one.set_title(f"PGV {metres_per_second(space.pgv)}, {words}")
            row[0].set_ylabel("radius of each plate [m]")
        for one in axes[-1]:
            one.set_xlabel("reference coefficient of friction")
        figure.suptitle(
            f"Shaded: {millimetres(allowed)} holds.  Blue: $y_{{max}}$ [mm].  Dashed: force over weight.  {spaces[0].records} records",
            fontsize=8,
            color=INK,
        )
    return figure


def _draw(axes: "Axes", space: "DesignSpace", allowed: float, part: float) -> None:
    mu, radius = space.coefficients, space.radii / 1e3
    displacement, force = space.displacement_at(part), space.force_at(part)
    drawing: Any = axes
    drawing.contourf(mu, radius, displacement, levels=[0.0, allowed], colors=[BLUE], alpha=0.12)
    axes.set_xlim(float(mu[0]), float(mu[-1]))
    axes.set_ylim(float(radius[0]), float(radius[-1]))
    others = [level for level in _DISPLACEMENTS if level != allowed]
    at = _HEIGHT_OF_DISPLACEMENTS
    _draw_lines(axes, space, displacement, others, {"colors": BLUE, "linewidths": 0.8}, 6.5, at)
    _draw_lines(axes, space, displacement, [allowed], {"colors": RED, "linewidths": 1.4}, 6.5, at)
    look = {"colors": GREY, "linewidths": 0.7, "linestyles": "dashed"}
    _draw_lines(axes, space, force, _FORCES, look, 6.0, _HEIGHT_OF_FORCES)


def _draw_lines(
    axes: "Axes",
    space: "DesignSpace",
    values: "FloatArray",
    levels: "Sequence[float]",
    look: dict[str, Any],
    size: float,
    height: float,
) -> None:
    """Draw lines of equal values with their numbers near a height of the panel [-], at those levels that are among the values."""
    inside = [level for level in levels if values.min() < level < values.max()]
    if inside:
        drawing: Any = axes
        lines = drawing.contour(space.coefficients, space.radii / 1e3, values, levels=inside, **look)
        places = [place for parts in lines.allsegs if (place := _place(axes, parts, height)) is not None]
        if places:
            drawing.clabel(lines, fmt="%g", fontsize=size, manual=places)


def _place(axes: "Axes", parts: "Sequence[FloatArray]", height: float) -> tuple[float, float] | None:
    """Return the point of a line that is nearest to a height of the panel [-], not at its sides; None where there is none."""
    left, right = axes.get_xlim()
    low, high = axes.get_ylim()
    found: list[tuple[float, float, float]] = []
    for part in parts:
        for (x0, y0), (x1, y1) in zip(part[:-1].tolist(), part[1:].tolist(), strict=True):
            for share in np.linspace(0.0, 1.0, 9).tolist():
                x, y = x0 + share * (x1 - x0), y0 + share * (y1 - y0)
                if _SIDE < (x - left) / (right - left) < 1.0 - _SIDE:
                    found.append((abs((y - low) / (high - low) - height), x, y))
    return min(found)[1:] if found else None
