"""Predictions of several records beside each other; what the PGV alone tells, with how far the analyses of a set of records lie apart."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from dcfp.present.figures.style import (
    BLUE,
    ENTRIES,
    GREY,
    INK,
    PAGE_WIDTH,
    PALE,
    calm_ticks,
    drawable,
    looks,
    style,
)
from dcfp.schema.digits import metres_per_second
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes

    from dcfp.arrays import FloatArray
    from dcfp.inference.forecast import Forecast
    from dcfp.methods import Prediction


#: The method whose intervals are drawn, beside those from the PGV alone.
_WITH_INTERVAL = "pulse march"
#: Heights of a row and of what is around the rows, and the largest of a figure, in which rows get narrower and lose their names [in].
_ROW, _FRAME, _TALLEST = 0.21, 1.1, 11.0


def plot_forecasts(forecasts: "Sequence[Forecast]") -> Figure:
    """Draw dy of every method, and y_max of the march, a row for each record and PGV, on a new figure; intervals where there are any."""
    height = _FRAME + _ROW * len(forecasts)
    few = height <= _TALLEST
    with style():
        figure = Figure(figsize=(PAGE_WIDTH, min(height, _TALLEST)), layout="constrained")
        change, displacement = figure.subplots(1, 2, sharey=True)
        _draw(change, forecasts, "dy")
        _draw(displacement, forecasts, "y")
        change.set_xlabel(f"{quantity('displacement_change').label}, largest")
        displacement.set_xlabel(f"{quantity('displacement').label}, largest")
        names = [f"{drawable(_name(one))}  {metres_per_second(one.pgv)}" for one in forecasts]
        change.set_yticks(np.arange(len(forecasts)) if few else [], names if few else [], parse_math=False)
        change.invert_yaxis()
        figure.legend(*change.get_legend_handles_labels(), loc="outside upper center", ncols=6)
    return figure


def _name(one: "Forecast") -> str:
    return "" if one.motion is None else one.motion.name


def _draw(axes: "Axes", forecasts: "Sequence[Forecast]", shown: str) -> None:
    for method, look in looks().items():
        places: list[int] = []
        values: list[float] = []
        for place, one in enumerate(forecasts):
            for variant, said in one.predicted.items():
                value = said.displacement_change if shown == "dy" else said.displacement
                if variant.method == method and value is not None and value > 0.0:
                    places.append(place)
                    values.append(value)
        if values:
            axes.plot(
                values,
                places,
                look.marker,
                color=look.colour,
                markersize=3.5 * look.scale,
                markeredgewidth=0.0,
                label=method,
            )
    _draw_intervals(axes, forecasts, shown)
    axes.set_xscale("log")
    axes.grid(visible=True, axis="y", linewidth=0.3, color="#DDDDDD")


def _draw_intervals(axes: "Axes", forecasts: "Sequence[Forecast]", shown: str) -> None:
    own = looks()[_WITH_INTERVAL].colour
    for words, colour in (("90 %, from the PGV", GREY), ("90 %, from the march", own)):
        if any(one.intervals for one in forecasts):
            axes.plot([], [], color=colour, linewidth=1.0, label=words)
    for place, one in enumerate(forecasts):
        for variant, intervals in one.intervals.items():
            if variant is not None and variant.method != _WITH_INTERVAL:
                continue
            colour, shift = (GREY, -0.3) if variant is None else (own, 0.3)
            for kind, interval in intervals.items():
                if kind.name == shown:
                    axes.plot([interval.low, interval.high], [place + shift] * 2, color=colour, linewidth=1.0)


# What the PGV alone tells, with how far the analyses of a set of records lie apart.


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
