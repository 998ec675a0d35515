"""What the charts have in common; colours are names of the style sheet, so that they follow the theme."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from dcfp.arrays import FloatArray, IntArray
from dcfp.doors.app.elements import Options

INK, MUTED, LINE = "var(--ink)", "var(--muted)", "var(--line)"
BLUE, OCHRE, RED, GREEN, GREY = "var(--blue)", "var(--ochre)", "var(--red)", "var(--green)", "var(--grey)"
_TEXT = 12


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


# Fewer points for the screen, without losing a peak.


#: Parts that a history is divided into; of each part the extremes are drawn.
PARTS = 420


def kept(columns: Sequence[FloatArray], parts: int = PARTS) -> IntArray:
    """Return which samples are enough to draw histories: first and last, and of every part the extremes of each column.

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
        values = column[places]
        chosen += [places[rows, values.argmin(axis=1)], places[rows, values.argmax(axis=1)]]
    return np.unique(np.concatenate(chosen))


def points(x: FloatArray, y: FloatArray, digits: int = 5) -> list[Any]:
    """Return pairs for a chart, rounded to significant digits of the largest value, a gap where a value is not a number."""
    return np.column_stack((_rounded(x, digits), _rounded(y, digits))).tolist()


def _rounded(values: FloatArray, digits: int) -> FloatArray:
    finite = values[np.isfinite(values)]
    largest = float(np.abs(finite).max()) if finite.size else 0.0
    if largest == 0.0:
        return values
    return np.round(values, digits - 1 - int(np.floor(np.log10(largest))))
