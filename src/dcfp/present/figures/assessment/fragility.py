"""Fragility curves."""

from itertools import cycle
from typing import TYPE_CHECKING

import numpy as np

from dcfp.present.figures.assessment.axis import axis_label, shown
from dcfp.present.figures.style import BLUE, INK, OCHRE, PAGE_WIDTH, RED, calm_ticks, new_axes, styled

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

_LOOKS = ((BLUE, "o"), (RED, "s"), (OCHRE, "^"), (INK, "D"))


@styled
def plot_fragility(found: "xarray.Dataset", axes: "Axes | None" = None) -> "Axes":
    """Draw the probability that each capacity is exceeded over the intensity.

    Marks are the parts of the records that are observed to exceed it, bands hold a part of the draws of earthquakes, and a mark with a dotted line is the median.

    Parameters
    ----------
    found
        What `dcfp.study.assessment.fragility` returns.
    axes
        Where to draw; by default new axes.
    """
    from dcfp.study.assessment.selection import (  # late: the package imports the kernels
        described,
        shown_value,
    )

    axes = axes or new_axes(0.62 * PAGE_WIDTH, 3.5)
    intensity = str(found.attrs["intensity"])
    grid, points = shown(found[intensity]), shown(found[intensity], found[f"{intensity}_of_curve"])
    medians = shown(found[intensity], found["median"])
    entry = described(found[intensity])
    for place, (colour, marker) in zip(range(found.sizes["capacity"]), cycle(_LOOKS), strict=False):
        one = found.isel(capacity=place)
        name = shown_value(found["capacity"].rename(str(found.attrs["quantity"])), one["capacity"].item())
        label = f"{name}: no fit"
        if np.isfinite(medians[place]):
            beta = float(one["total_dispersion"])
            label = (
                f"{name}: " + rf"$\theta$ = {medians[place]:.3g} {entry.shown.name.replace('–', '')}".rstrip()
            )
            label += rf", $\beta$ = {beta:.2f}"
        low, high = one["probability_bound"].to_numpy()
        axes.fill_between(points, low, high, color=colour, alpha=0.15, linewidth=0.0)
        axes.plot(points, one["probability"].to_numpy(), color=colour, linewidth=1.3, label=label)
        axes.plot(
            grid,
            one["fraction"].to_numpy(),
            color=colour,
            marker=marker,
            markersize=3.2,
            linestyle="none",
            clip_on=False,
            zorder=3,
        )
        axes.plot([medians[place]] * 2, [0.0, 0.5], color=colour, linewidth=0.7, linestyle=":")
        axes.plot(medians[place], 0.5, marker="+", markersize=7, color=colour, linestyle="none", zorder=4)
    axes.set_xlim(0.0, float(grid[-1]))
    axes.set_ylim(0.0, 1.0)
    calm_ticks(axes, 6, 5)
    axes.set_xlabel(axis_label(found[intensity]))
    axes.set_ylabel("probability that the capacity is exceeded")
    axes.legend(
        loc="lower left",
        bbox_to_anchor=(0.0, 1.02),
        ncols=2 if found.sizes["capacity"] > 1 else 1,
        title=rf"$\theta$: median, $\beta$: dispersion; marks: observed in {found.attrs['records']} records;"
        f"\nband: {100.0 * found.attrs['confidence']:g} % of draws of earthquakes",
        title_fontsize=7.0,
        alignment="left",
    )
    return axes
