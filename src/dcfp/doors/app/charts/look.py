"""What the charts have in common; colours are names of the style sheet, so that they follow the theme."""

from collections.abc import Sequence
from typing import Any

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
