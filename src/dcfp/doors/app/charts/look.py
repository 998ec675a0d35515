"""Charts as options of ECharts: panels drawn in the visitor's units; colours are names of the style sheet, so that they follow the theme."""

import base64
import io
from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.doors.app.elements import Options
from dcfp.doors.app.thinning import kept, kept_of_path, points
from dcfp.doors.app.units import Units
from dcfp.present.panels import Line, Panel
from dcfp.schema.quantities import Quantity

INK, MUTED, LINE = "var(--ink)", "var(--muted)", "var(--line)"
BLUE, OCHRE, RED, GREEN, GREY = "var(--blue)", "var(--ochre)", "var(--red)", "var(--green)", "var(--grey)"
_TEXT = 12
#: Colours of a scale.
_COLOURS = 64
#: Height of one of several panels above each other, and the gap between two of them [%].
_ROW_HEIGHT, _GAP = 16.0, 7.4


# Panels.


def chart(panel: Panel, units: Units, parts: int = 420, **more: Any) -> Options:
    """Draw one panel; of a history the extremes of each of some `parts` are drawn."""
    legend_wanted = len([line for line in panel.lines if line.words]) > 1
    grid = {"left": 58 if panel.path else 52, "right": 20 if panel.path else 16, "top": 34, "bottom": 42}
    options = simple(
        _x_axis(panel, units), _y_axis(panel, units), _series(panel, units, _places(panel.lines, parts, path=panel.path)),
        **({"tooltip": {"show": False}} if panel.path or panel.picture else {}),
        grid=grid | ({"right": 84} if panel.picture else {}),
        **({"legend": legend()} if legend_wanted else {}),
    )  # fmt: skip
    return options | (_picture(panel, units) if panel.picture else {}) | more


def rows(panels: Sequence[Panel], units: Units) -> Options:
    """Draw panels of histories over the same time above each other."""
    lines = [line for panel in panels for line in panel.lines]
    place = _places(lines, 420, path=False)[0]
    tops = [5.0 + row * (_ROW_HEIGHT + _GAP) for row in range(len(panels))]
    last = len(panels) - 1
    return {
        "grid": [{"left": 52, "right": 16, "top": f"{top:.1f}%", "height": f"{_ROW_HEIGHT}%"} for top in tops],
        "xAxis": [_x_axis(panel, units, named=row == last) | {"gridIndex": row} for row, panel in enumerate(panels)],
        "yAxis": [_y_axis(panel, units, gridIndex=row, nameGap=13, splitNumber=3) for row, panel in enumerate(panels)],
        "axisPointer": {"link": [{"xAxisIndex": "all"}]},
        "animation": False,
        "series": [
            one
            for row, panel in enumerate(panels)
            for one in _series(panel, units, [place] * len(panel.lines), xAxisIndex=row, yAxisIndex=row)
        ],
        "tooltip": tooltip(),
        "legend": [
            legend([line.words for line in panel.lines], top=f"{max(top - 4.6, 0.0):.1f}%")
            for panel, top in zip(panels, tops, strict=True)
            if len(panel.lines) > 1
        ],
    }  # fmt: skip


def label(words: str, one: Quantity, units: Units) -> str:
    """Return the name of an axis: words, and the visitor's unit."""
    return f"{words[:1].upper()}{words[1:]} [{units.of(one).name}]"


def _x_axis(panel: Panel, units: Units, *, named: bool = True) -> Options:
    name = label(panel.x.words.partition(" of ")[0], panel.x, units)
    if panel.path:
        return axis(name, "x")
    first = min(float(line.x[0]) for line in panel.lines)
    ends = {"min": round(first, 3), "max": round(max(float(line.x[-1]) for line in panel.lines), 3)}
    look = {
        "show": named,
        "color": MUTED,
        "fontSize": _TEXT,
        "hideOverlap": True,
        "showMaxLabel": False,
        "showMinLabel": first == 0.0,
    }
    return axis(name if named else "", "x", **ends, axisLabel=look)


def _y_axis(panel: Panel, units: Units, **more: Any) -> Options:
    unit = units.of(panel.y)
    ends: dict[str, float] = {}
    if panel.picture or panel.low == 0.0:
        ends["min"] = float(unit.shown(panel.low))
    if panel.picture:
        ends["max"] = float(unit.shown(panel.high))
    return axis(label(panel.words, panel.y, units), "y", **ends, **more)


def _places(lines: Sequence[Line], parts: int, *, path: bool) -> list[Any]:
    """Return which points are enough to draw each line; histories over the same time have the same ones."""
    if path:
        return [kept_of_path(line.x, line.y) for line in lines]
    size = lines[0].x.size
    together = kept([line.y for line in lines if line.x.size == size], parts)
    return [together if line.x.size == size else kept((line.y,), parts) for line in lines]


def _series(panel: Panel, units: Units, places: Sequence[Any], **more: Any) -> list[Options]:
    x, y = units.of(panel.x), units.of(panel.y)
    found: list[Options] = []
    for i, (one, place) in enumerate(zip(panel.lines, places, strict=True)):
        colour = one.colour if one.colour == "white" else f"var(--{one.colour})"
        data = points(x.shown(one.x[place]), y.shown(one.y[place]))
        width = {
            "width": 1.3 if one.width < 1.0 else one.width,
            "color": colour,
            **({"type": "dashed"} if one.dashed else {}),
        }
        look: Options = {"lineStyle": width, **more}
        if i < panel.stacked:
            look |= {"stack": "stack", "areaStyle": {"color": colour, "opacity": 0.28}}
        if one.marked:
            look |= {"showSymbol": True, "symbol": "circle", "symbolSize": 6}
        if panel.capacity is not None and i == 0:
            # where the displacement is along the horizontal axis, so is the capacity
            along, side = ("xAxis", x) if panel.path else ("yAxis", y)
            shown = float(side.shown(panel.capacity))
            look |= level((-shown, shown), along, "capacity")
        if panel.sliding is not None and i == 0:
            look |= _spans(x.shown(one.x), panel.sliding)
        if panel.peak and i == 0:
            top = int(np.abs(one.y).argmax())
            look |= _named_point(
                float(x.shown(one.x[top])),
                float(y.shown(one.y[top])),
                panel.y.written(abs(one.y[top]), y, 0 if y.size > 0.5 else 1) + f" {y.name}",
            )
        found.append(line(one.words or panel.words, data, colour, **look))
    return found


def _spans(x: FloatArray, where: Any) -> Options:
    """Return the parts of an axis where something holds, shaded, as an entry of a line."""
    edges = np.flatnonzero(np.diff(where, prepend=False, append=False))
    spans = [
        [{"xAxis": float(x[first])}, {"xAxis": float(x[min(last, x.size - 1)])}]
        for first, last in edges.reshape(-1, 2)
    ]
    return {
        "markArea": {"silent": True, "animation": False, "itemStyle": {"color": "var(--pale)"}, "data": spans}
    }


def _named_point(x: float, y: float, words: str) -> Options:
    """Return a point with words beside it, as an entry of a line."""
    look = {
        "show": True,
        "formatter": words,
        "color": INK,
        "fontSize": 11,
        "position": "right",
        "distance": 6,
    }
    data = [{"coord": [x, y], "symbolSize": 5, "label": look}]
    return {
        "markPoint": {
            "symbol": "circle",
            "silent": True,
            "animation": False,
            "itemStyle": {"color": INK},
            "data": data,
        }
    }


def _picture(panel: Panel, units: Units) -> Options:
    one = panel.picture
    assert one is not None
    unit, (low, high) = units.of(one.shows), one.ends
    first, last = panel.lines[0].x[[0, -1]]
    inside = (one.x >= first) & (one.x <= last)
    shares = np.flipud((one.values[:, inside] - low) / (high - low))
    y = units.of(panel.y).shown(one.y[[0, -1]])
    return {
        "visualMap": {
            "type": "continuous", "seriesIndex": [], "min": float(unit.shown(low)), "max": float(unit.shown(high)),
            "inRange": {"color": warm_colours()},
            "text": [f"{unit.shown(end):.0f} {unit.name}" for end in (high, low)],
            "textStyle": {"color": MUTED, "fontSize": _TEXT},
            "right": 8, "top": "middle", "itemHeight": 120, "itemWidth": 12, "calculable": False,
        },
        "pictures": [{"url": picture(shares), "x": one.x[inside][[0, -1]].tolist(), "y": y.tolist()}],
    }  # fmt: skip


def picture(shares: FloatArray) -> str:
    """Return shares from 0 to 1, shape (rows, columns), as an image in the colours of temperatures: the address of a PNG."""
    from matplotlib import image  # late: Matplotlib takes long to import

    from dcfp.present.figures import style

    stream = io.BytesIO()
    writer: Any = image
    writer.imsave(stream, style.warm_colours()(np.clip(shares, 0.0, 1.0), bytes=True), format="png")
    return f"data:image/png;base64,{base64.b64encode(stream.getvalue()).decode()}"


@cache
def warm_colours() -> list[str]:
    """Return the colours of temperatures."""
    from matplotlib.colors import to_hex  # late: Matplotlib takes long to import

    from dcfp.present.figures import style

    return [to_hex(style.warm_colours()(i / (_COLOURS - 1.0))) for i in range(_COLOURS)]


# What every chart is made of.


def axis(name: str, place: str = "", **more: Any) -> Options:
    """Return an axis of numbers with a name and unit; `place` is ``"x"`` or ``"y"``."""
    middle: Options = {"nameLocation": "middle", "nameGap": 26} if place == "x" else {}
    # the ends of an axis are where its data end, seldom at a round number
    ends: Options = {"showMinLabel": "min" not in more, "showMaxLabel": "max" not in more}
    side: Options = {
        "nameTextStyle": {"align": "left", "color": MUTED, "fontSize": _TEXT, "padding": [0, 0, 0, -36]}
    }
    return {
        "type": "value",
        "name": name,
        "scale": True,
        "nameTextStyle": {"color": MUTED, "fontSize": _TEXT},
        "axisLabel": {"color": MUTED, "fontSize": _TEXT, "hideOverlap": True, **ends},
        "axisLine": {"show": place == "x", "lineStyle": {"color": MUTED}, "onZero": False},
        "axisTick": {"show": place == "x", "lineStyle": {"color": MUTED}},
        "splitLine": {"show": place == "y", "lineStyle": {"color": LINE}},
        "splitNumber": 4,
        **middle,
        **(side if place == "y" else {}),
        **more,
    }  # fmt: skip


def line(name: str, data: list[Any], colour: str, **more: Any) -> Options:
    """Return a line without marks."""
    return {
        "type": "line",
        "name": name,
        "data": data,
        "showSymbol": False,
        "symbol": "none",
        "animation": False,
        "lineStyle": {"width": 1.3, "color": colour},
        "itemStyle": {"color": colour},
        "emphasis": {"disabled": True},
        "z": 3,
        **more,
    }


def mark(name: str, data: list[Any], colour: str, **more: Any) -> Options:
    """Return points."""
    return {
        "type": "scatter",
        "name": name,
        "data": data,
        "animation": False,
        "symbolSize": 6,
        "itemStyle": {"color": colour},
        "z": 5,
        **more,
    }


def level(values: Sequence[float], along: str, words: str, colour: str = RED) -> Options:
    """Return straight lines at values of an axis, ``"xAxis"`` or ``"yAxis"``, as an entry of a line."""
    return {
        "markLine": {
            "silent": True,
            "symbol": "none",
            "animation": False,
            "lineStyle": {"color": colour, "type": "dashed", "width": 1},
            "label": {"formatter": words, "color": colour, "fontSize": 11, "position": "insideEndTop"},
            "data": [{along: value} for value in values],
        }
    }


def legend(names: Sequence[str] | None = None, **more: Any) -> Options:
    """Return a legend at the top right."""
    return {
        "show": True,
        "top": 0,
        "right": 4,
        "itemWidth": 16,
        "itemHeight": 8,
        "itemGap": 12,
        "textStyle": {"color": MUTED, "fontSize": _TEXT},
        **({} if names is None else {"data": list(names)}),
        **more,
    }


def tooltip() -> Options:
    """Return what is shown beside the pointer."""
    return {
        "trigger": "axis",
        "confine": True,
        "transitionDuration": 0,
        "backgroundColor": "var(--card)",
        "borderColor": "var(--faint)",
        "textStyle": {"color": INK, "fontSize": _TEXT},
        "axisPointer": {"lineStyle": {"color": MUTED}, "label": {"show": False}},
    }


def simple(x: Options, y: Options, series: list[Options], **more: Any) -> Options:
    """Return a chart with one pair of axes."""
    return {
        "animation": False,
        "grid": {"left": 52, "right": 16, "top": 34, "bottom": 42},
        "xAxis": x,
        "yAxis": y,
        "series": series,
        "tooltip": tooltip(),
        **more,
    }
