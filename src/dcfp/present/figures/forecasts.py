"""Predictions of several records beside each other."""

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from dcfp.present.figures.style import BLUE, GREY, OCHRE, PAGE_WIDTH, RED, drawable, style
from dcfp.present.figures.words import metres_per_second
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from dcfp.inference.forecast import Forecast

#: Mark and colour of each method, in the order of the legend.
_MARKS = {
    "pulse": ("o", BLUE),
    "simplified": ("s", OCHRE),
    "design": ("|", GREY),
    "pulse march": ("D", RED),
}
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
    for method, (mark, colour) in _MARKS.items():
        places: list[int] = []
        values: list[float] = []
        for place, one in enumerate(forecasts):
            for view, said in one.predicted.items():
                value = said.displacement_change if shown == "dy" else said.displacement
                if view[0].value == method and value is not None and value > 0.0:
                    places.append(place)
                    values.append(value)
        if values:
            axes.plot(values, places, mark, color=colour, markersize=3.5, markeredgewidth=1.2, label=method)
    _draw_intervals(axes, forecasts, shown)
    axes.set_xscale("log")
    axes.grid(visible=True, axis="y", linewidth=0.3, color="#DDDDDD")


def _draw_intervals(axes: "Axes", forecasts: "Sequence[Forecast]", shown: str) -> None:
    for words, colour in (("90 %, from the PGV", GREY), ("90 %, from the march", _MARKS[_WITH_INTERVAL][1])):
        if any(one.intervals for one in forecasts):
            axes.plot([], [], color=colour, linewidth=1.0, label=words)
    for place, one in enumerate(forecasts):
        for view, intervals in one.intervals.items():
            if view is not None and view[0].value != _WITH_INTERVAL:
                continue
            colour, shift = (GREY, -0.3) if view is None else (_MARKS[_WITH_INTERVAL][1], 0.3)
            for kind, interval in intervals.items():
                if kind.name == shown:
                    axes.plot([interval.low, interval.high], [place + shift] * 2, color=colour, linewidth=1.0)
