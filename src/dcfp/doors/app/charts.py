"""Charts as options of ECharts: panels in the visitor's units, with fewer points but every peak; what every chart looks like is in ``static/chart.js``."""

import base64
import io
from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np

from dcfp.arrays import FloatArray, IntArray
from dcfp.doors.app.elements import Options, Units
from dcfp.doors.app.session import capitalised
from dcfp.present.panels import Line, Panel
from dcfp.schema.quantities import Quantity

#: Height of one of several panels above each other, and the gap between two of them [%], where there are so many.
_ROW_HEIGHT, _GAP, _ROWS = 16.0, 7.4, 4
#: Parts that a history is divided into; of each part the extremes are drawn.
PARTS = 420
#: Distance that is allowed between a path and what is drawn of it, as a part of its extent: half a pixel on a screen [-].
TOLERANCE = 1e-3


def chart(panel: Panel, units: Units, parts: int = PARTS, **more: Any) -> Options:
    """Draw one panel; of a history the extremes of each of some `parts` are drawn."""
    quiet = panel.path or panel.picture is not None
    grid = {"left": 58, "right": 20} if panel.path else {"right": 84} if panel.picture else {}
    options: Options = {
        "grid": grid,
        "xAxis": _x_axis(panel, units),
        "yAxis": _y_axis(panel, units),
        "series": _series(panel, units, _places(panel.lines, parts, path=panel.path)),
        "tooltip": {"show": not quiet},
    }
    if len([line for line in panel.lines if line.words]) > 1:
        options["legend"] = {}
    if panel.areas:
        x, y = units.of(panel.x), units.of(panel.y)
        polygons = [np.column_stack((x.shown(one[:, 0]), y.shown(one[:, 1]))).tolist() for one in panel.areas]
        options["areas"] = [{"points": one, "color": colour_of("blue"), "opacity": 0.14} for one in polygons]
    return options | (_picture(panel, units) if panel.picture else {}) | more


def rows(panels: Sequence[Panel], units: Units) -> Options:
    """Draw panels of histories over the same time above each other."""
    lines = [line for panel in panels for line in panel.lines]
    place = _places(lines, PARTS, path=False)[0]
    scale = _ROWS / len(panels)
    tops = [5.0 + row * scale * (_ROW_HEIGHT + _GAP) for row in range(len(panels))]
    options: Options = {"axisPointer": {"link": [{"xAxisIndex": "all"}]}}
    options |= {key: [] for key in ("grid", "xAxis", "yAxis", "series", "legend")}
    for row, (panel, top) in enumerate(zip(panels, tops, strict=True)):
        options["grid"].append({"top": f"{top:.1f}%", "height": f"{scale * _ROW_HEIGHT:.1f}%"})
        options["xAxis"].append(_x_axis(panel, units, named=panel is panels[-1]) | {"gridIndex": row})
        options["yAxis"].append(_y_axis(panel, units, gridIndex=row, nameGap=13, splitNumber=3))
        places = [place] * len(panel.lines)
        options["series"] += _series(panel, units, places, xAxisIndex=row, yAxisIndex=row)
        if len(panel.lines) > 1:
            words = [line.words for line in panel.lines]
            options["legend"].append({"data": words, "top": f"{max(top - 4.6 * scale, 0.0):.1f}%"})
    return options


def colour_of(name: str) -> str:
    """Return a colour of panels as the style sheet has it, so that it follows the theme."""
    return name if name == "white" else f"var(--{name})"


def label(words: str, one: Quantity, units: Units) -> str:
    """Return the name of an axis: words, and the visitor's unit."""
    return f"{capitalised(words)} [{units.of(one).name}]"


def _x_axis(panel: Panel, units: Units, *, named: bool = True) -> Options:
    name, unit = label(panel.x.words.partition(" of the ")[0], panel.x, units), units.of(panel.x)
    if panel.across is not None:
        low, high = panel.across
        return {"name": name, "min": float(unit.shown(low)), "max": float(unit.shown(high))}
    if panel.path:
        return {"name": name}
    first = min(float(line.x[0]) for line in panel.lines)
    last = max(float(line.x[-1]) for line in panel.lines)
    look = {"show": named, "showMaxLabel": False, "showMinLabel": first == 0.0}
    return {"name": name if named else "", "min": round(first, 3), "max": round(last, 3), "axisLabel": look}


def _y_axis(panel: Panel, units: Units, **more: Any) -> Options:
    unit, found = units.of(panel.y), {"name": label(panel.title, panel.y, units)}
    if panel.limit is not None:
        return found | {"scale": False} | more
    whole = panel.picture is not None or bool(panel.areas)
    ends: Options = {"min": float(unit.shown(panel.low))} if whole or panel.low == 0.0 else {}
    if whole:
        ends["max"] = float(unit.shown(panel.high))
    return found | ends | more


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
        width = {"width": 1.3 if one.width < 1.0 else one.width, "opacity": one.opacity}
        look: Options = {"lineStyle": width | ({"type": "dashed"} if one.dashed else {}), **more}
        if one.opacity < 1.0:
            look["itemStyle"] = {"opacity": one.opacity}
        if i < panel.stacked:
            look |= {"stack": "stack", "areaStyle": {"color": colour_of(one.colour), "opacity": 0.28}}
        if one.marked:
            look |= {"showSymbol": True, "symbol": "circle", "symbolSize": 6}
        if one.level is not None and one.place is not None:
            at = [float(x.shown(one.x[one.place])), float(y.shown(one.y[one.place]))]
            named: Options = {"position": "inside", "backgroundColor": "var(--card)", "padding": [1, 3]}
            named["formatter"] = f"{units.of(one.level[0]).shown(one.level[1]):.4g}"
            named["color"] = colour_of(one.colour)
            look["markPoint"] = {"data": [{"coord": at}], "symbolSize": 1, "label": named}
        if i == 0:
            look |= _of_first(panel, units)
        data = points(x.shown(one.x[place]), y.shown(one.y[place]))
        found.append(line(one.words or panel.title, data, one.colour, **look))
    return found


def _of_first(panel: Panel, units: Units) -> Options:
    """Return what a panel shows beside its first line: the capacity, when the bearing slides, and the largest value with its number."""
    x, y, one = units.of(panel.x), units.of(panel.y), panel.lines[0]
    found: Options = {}
    if panel.capacity is not None:
        # where the displacement is along the horizontal axis, so is the capacity
        along, side = ("xAxis", x) if panel.path else ("yAxis", y)
        shown = float(side.shown(panel.capacity))
        found |= level((-shown, shown), along, "capacity")
    if panel.limit is not None:
        found |= level((float(y.shown(panel.limit)),), "yAxis", "allowed", width=2, type="solid")
    if panel.sliding is not None:
        edges = np.flatnonzero(np.diff(panel.sliding, prepend=False, append=False))
        ends = x.shown(one.x)[np.minimum(edges, one.x.size - 1)].reshape(-1, 2).tolist()
        found["markArea"] = {"data": [[{"xAxis": first}, {"xAxis": last}] for first, last in ends]}
    if panel.peak:
        top = int(np.abs(one.y).argmax())
        words = f"{panel.y.written(abs(one.y[top]), y, 0 if y.size > 0.5 else 1)} {y.name}"
        at = [float(x.shown(one.x[top])), float(y.shown(one.y[top]))]
        found["markPoint"] = {"data": [{"coord": at}], "label": {"formatter": words}}
    return found


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
            "right": 8, "top": "middle", "itemHeight": 120, "itemWidth": 12, "calculable": False,
        },
        "pictures": [{"url": image_of(shares), "x": one.x[inside][[0, -1]].tolist(), "y": y.tolist()}],
    }  # fmt: skip


def image_of(shares: FloatArray) -> str:
    """Return shares from 0 to 1, shape (rows, columns), as an image in the colours of temperatures: the address of a PNG."""
    from matplotlib import image  # late: Matplotlib takes long to import

    from dcfp.present.figures import style

    stream = io.BytesIO()
    writer: Any = image
    writer.imsave(
        stream, style.colours_of("temperature")(np.clip(shares, 0.0, 1.0), bytes=True), format="png"
    )
    return f"data:image/png;base64,{base64.b64encode(stream.getvalue()).decode()}"


@cache
def warm_colours() -> list[str]:
    """Return the colours of temperatures."""
    from matplotlib.colors import to_hex  # late: Matplotlib takes long to import

    from dcfp.present.figures import style

    return [to_hex(colour) for colour in style.colours_of("temperature")(np.linspace(0.0, 1.0, 64))]


def line(name: str, data: list[Any], colour: str, **more: Any) -> Options:
    """Return a line without marks."""
    return {"name": name, "data": data, "color": colour_of(colour), **more}


def level(values: Sequence[float], along: str, words: str, colour: str = "red", **look: Any) -> Options:
    """Return straight lines at values of an axis, ``"xAxis"`` or ``"yAxis"``, as an entry of a line."""
    tone = colour_of(colour)
    return {
        "markLine": {
            "lineStyle": {"color": tone, **look},
            "label": {"formatter": words, "color": tone},
            "data": [{along: value} for value in values],
        }
    }


def kept(columns: Sequence[FloatArray], parts: int = PARTS) -> IntArray:
    """Return which samples are enough to draw histories of the same length: first and last, and of every part the extremes of each column.

    Parameters
    ----------
    columns
        Histories of the same length.
    parts
        Into which they are divided.
    """
    size = int(columns[0].size)
    if size <= 2 * parts:
        return np.arange(size, dtype=np.intp)
    starts = np.linspace(0, size, parts + 1).astype(np.intp)[:-1]
    ends = np.append(starts[1:], size)
    width = int((ends - starts).max())
    # a row for each part, the last sample of a shorter one twice
    places = np.minimum(starts[:, None] + np.arange(width)[None, :], ends[:, None] - 1)
    rows = np.arange(parts)
    chosen = [np.array([0, size - 1], dtype=np.intp)]
    for column in columns:
        values = np.nan_to_num(column)[places]
        chosen += [places[rows, values.argmin(axis=1)], places[rows, values.argmax(axis=1)]]
    return np.unique(np.concatenate(chosen))


def kept_of_path(x: FloatArray, y: FloatArray, tolerance: float = TOLERANCE) -> IntArray:
    """Return which points are enough to draw a path, such as a loop: its turning points, and between them what no chord passes near enough.

    The rule is that of Douglas and Peucker (1973), for all chords at once; thinned along time, a loop would become chords with invented tips.

    Parameters
    ----------
    x, y
        Coordinates of the points in their order.
    tolerance
        Distance from the path that is allowed to what is drawn, as a part of its extent along each axis [-].
    """
    spans = [float(np.ptp(values)) or 1.0 for values in (x, y)]
    path = np.column_stack([values / span for values, span in zip((x, y), spans, strict=True)])
    ends = np.array([0, path.shape[0] - 1], dtype=np.intp)
    chosen = np.unique(np.concatenate([ends, *(turning_points(one, tolerance) for one in path.T)]))
    starts, stops = chosen[:-1], chosen[1:]
    while starts.size:
        places, distances = _farthest(path, starts, stops)
        far = distances > tolerance
        chosen = np.concatenate((chosen, places[far]))
        starts, stops = (
            np.concatenate((starts[far], places[far])),
            np.concatenate((places[far], stops[far])),
        )
    return np.sort(chosen)


def turning_points(values: FloatArray, least: float) -> IntArray:
    """Return the samples at which a history turns and from which it comes back by more than `least`."""
    slopes = np.sign(np.diff(values))
    moving = np.flatnonzero(slopes)
    turns = moving[1:][np.diff(slopes[moving]) != 0.0]
    found, farthest = [0], 0
    for place in [*turns.tolist(), values.size - 1]:
        away, on = values[farthest] - values[found[-1]], values[place] - values[farthest]
        if away * on >= 0.0:
            farthest = place
        elif abs(on) > least:
            found.append(farthest)
            farthest = place
    return np.array(found[1:], dtype=np.intp)


def _farthest(path: FloatArray, starts: IntArray, stops: IntArray) -> tuple[IntArray, FloatArray]:
    """Return for each chord from one point of a path to a later one which point between is farthest from it, and how far."""
    lengths = stops - starts
    chord_of, first = np.repeat(np.arange(starts.size), lengths), np.cumsum(lengths) - lengths
    places = np.arange(chord_of.size) + (starts - first)[chord_of]
    chords = path[stops] - path[starts]
    squares = np.maximum((chords**2).sum(axis=1), np.finfo(float).tiny)
    along = path[places] - path[starts][chord_of]
    share = np.clip((along * chords[chord_of]).sum(axis=1) / squares[chord_of], 0.0, 1.0)
    distance = np.hypot(*(along - share[:, None] * chords[chord_of]).T)
    largest = np.maximum.reduceat(distance, first)
    best = np.flatnonzero(distance == largest[chord_of])
    return places[best[np.searchsorted(chord_of[best], np.arange(starts.size))]], largest


def points(x: FloatArray, y: FloatArray, digits: int = 5) -> list[Any]:
    """Return pairs for a chart, rounded to significant digits of the largest value, a gap where a value is not a number."""
    return np.column_stack((_rounded(x, digits), _rounded(y, digits))).tolist()


def _rounded(values: FloatArray, digits: int) -> FloatArray:
    finite = values[np.isfinite(values)]
    largest = float(np.abs(finite).max()) if finite.size else 0.0
    if largest == 0.0:
        return values
    return np.round(values, digits - 1 - int(np.floor(np.log10(largest))))
