"""The curves of an incremental dynamic analysis."""

from typing import TYPE_CHECKING

import numpy as np

from dcfp.present.figures.assessment.axis import axis_label, shown
from dcfp.present.figures.style import (
    BLUE,
    GREY,
    INK,
    PAGE_WIDTH,
    RED,
    calm_ticks,
    legend_above,
    new_axes,
    styled,
)
from dcfp.present.figures.words import millimetres

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

    from dcfp.arrays import FloatArray


@styled
def plot_ida(found: "xarray.Dataset", axes: "Axes | None" = None) -> "Axes":
    """Draw the intensity over the result: each record thin and grey, the quantiles bold, the capacity as a line.

    A hollow mark is where a record is first beyond the displacement capacity.

    Parameters
    ----------
    found
        What `dcfp.study.assessment.ida` returns.
    axes
        Where to draw; by default new axes.
    """
    axes = axes or new_axes(0.62 * PAGE_WIDTH, 3.6)
    name = next(str(one) for one in found.data_vars if f"{one}_quantile" in found.data_vars)
    result = found[name]
    intensity = str(result.dims[1])
    heights = shown(found[intensity])
    capacity = found.attrs.get("displacement_capacity")
    if name == "peak_displacement" and capacity is not None:
        axes.plot(
            [float(capacity)] * 2,
            [0.0, heights[-1]],
            color=RED,
            linewidth=0.9,
            linestyle=(0, (5, 3)),
            label=f"capacity, {millimetres(float(capacity))}",
        )
    _draw_records(axes, shown(result), heights, found["beyond_capacity"].to_numpy())
    _draw_quantiles(axes, found, name, heights)
    axes.set_xlim(left=0.0)
    axes.set_ylim(0.0, 1.07 * heights[-1])  # room for the names of the quantiles
    calm_ticks(axes, 6, 6)
    axes.set_xlabel(axis_label(result))
    axes.set_ylabel(axis_label(found[intensity]))
    legend_above(axes)
    return axes


def _draw_records(axes: "Axes", curves: "FloatArray", heights: "FloatArray", beyond: "np.ndarray") -> None:
    for i, (curve, outside) in enumerate(zip(curves, beyond, strict=True)):
        axes.plot(
            curve,
            heights,
            color=GREY,
            linewidth=0.4,
            alpha=0.8,
            label=f"{len(curves)} records" if i == 0 else None,
            zorder=1,
        )
        if outside.any():
            first = int(np.argmax(outside))
            label = None if beyond[:i].any() else "first beyond the capacity"
            axes.plot(
                curve[first],
                heights[first],
                marker="o",
                markersize=3.2,
                markerfacecolor="white",
                markeredgecolor=INK,
                markeredgewidth=0.6,
                linestyle="none",
                label=label,
                zorder=2,
            )


def _draw_quantiles(axes: "Axes", found: "xarray.Dataset", name: str, heights: "FloatArray") -> None:
    lines = shown(found[name], found[f"{name}_quantile"])
    parts = found["quantile"].to_numpy().tolist()
    for part, line in zip(parts, lines, strict=True):
        middle = part == 0.5
        axes.plot(
            line,
            heights,
            color=BLUE,
            linewidth=1.8 if middle else 1.2,
            linestyle="solid" if middle else (0, (4, 2)),
            label="median" if middle else None,
            zorder=3,
        )
        axes.annotate(
            f"{100.0 * part:g} %",
            (float(line[-1]), float(heights[-1])),
            xytext=(0, 3),
            textcoords="offset points",
            color=BLUE,
            ha="center",
            va="bottom",
        )
