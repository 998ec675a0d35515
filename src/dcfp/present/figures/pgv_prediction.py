"""What the PGV alone tells, with how far the analyses of a set of records lie apart."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from dcfp.present.figures.predicted import ENTRIES
from dcfp.present.figures.style import BLUE, INK, PAGE_WIDTH, PALE, calm_ticks, style
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes

    from dcfp.arrays import FloatArray
    from dcfp.methods import Prediction

#: Quantities of the panels.
DRAWN = ("dy", "V_dE", "V_dEhr")


def plot_pgv_prediction(
    pgvs: "Sequence[float]",
    predictions: "Sequence[Prediction]",
    intervals: "Mapping[str, Sequence[tuple[float, float, float]]] | None" = None,
) -> Figure:
    """Draw the change of displacement and the two energies of the design method against the PGV, on a new figure.

    Parameters
    ----------
    pgvs
        [mm/s], in any order.
    predictions
        What the method says of each.
    intervals
        5 %, median and 95 % of the analyses of a set of records at each PGV, in mm or mm/s, by the name of the quantity: ``"dy"``,
        ``"V_dE"``, ``"V_dEhr"``.
    """
    order = np.argsort(np.asarray(pgvs, dtype=np.float64))
    velocity = quantity("peak_ground_velocity").display(np.asarray(pgvs, dtype=np.float64)[order])
    with style():
        figure = Figure(figsize=(PAGE_WIDTH, 2.7), layout="constrained")
        panels: Any = figure.subplots(1, 3)
        for axes, key, values in zip(panels, DRAWN, _values(predictions), strict=True):
            entry = quantity(ENTRIES[key])
            if intervals is not None and key in intervals:
                _draw_interval(
                    axes, velocity, entry.display(np.asarray(intervals[key], dtype=np.float64)[order])
                )
            axes.plot(
                velocity,
                entry.display(values[order]),
                color=BLUE,
                linewidth=1.1,
                marker="o",
                markersize=3.0,
                label="design method",
                zorder=4,
            )
            _finish(axes, velocity, entry.label)
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside upper right", ncols=3, borderaxespad=0.4)
    return figure


def _values(predictions: "Sequence[Prediction]") -> "tuple[FloatArray, ...]":
    rows = [(one.displacement_change, one.input_velocity, one.hysteretic_velocity) for one in predictions]
    return tuple(np.array(rows, dtype=np.float64).reshape(-1, 3).T)


def _draw_interval(axes: "Axes", velocity: "FloatArray", limits: "FloatArray") -> None:
    low, median, high = limits.T
    band, middle = "5 to 95 % of the analyses", "their median"
    if velocity.size == 1:
        axes.plot([velocity[0]] * 2, [low[0], high[0]], color="#C5D0DC", linewidth=6.0, label=band,
                  solid_capstyle="butt", zorder=1)  # fmt: skip
        axes.plot(velocity, median, color=INK, marker="_", markersize=9.0, linestyle="none", label=middle)
        return
    axes.fill_between(velocity, low, high, color=PALE, linewidth=0.0, label=band, zorder=0)
    for side in (low, high):
        axes.plot(velocity, side, color="#C5D0DC", linewidth=0.6, zorder=1)
    axes.plot(velocity, median, color=INK, linewidth=0.9, linestyle=(0, (4, 2)), label=middle, zorder=3)


def _finish(axes: "Axes", velocity: "FloatArray", label: str) -> None:
    calm_ticks(axes, 5, 5)
    if velocity.size == 1:
        axes.set_xlim(0.5 * float(velocity[0]), 1.5 * float(velocity[0]))
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel(quantity("peak_ground_velocity").label)
    axes.set_ylabel(label)
