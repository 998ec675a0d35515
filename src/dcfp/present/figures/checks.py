"""Checks: how much of what is allowed each of them takes."""

from itertools import groupby
from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.present.figures.style import BLUE, GREY, INK, RED, drawable, new_figure, styled
from dcfp.schema.formulas import true_minus

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.schema.check import Check

_LINE_HEIGHT = 0.135
#: Lines that a group's name takes, with the space above it.
_HEAD = 1.7
#: Least and largest ratio that the axis reaches [-].
_LEAST, _LARGEST = 1e-6, 1e4


@styled
def plot_checks(checks: "Sequence[Check]") -> "Figure":
    """Draw the difference of each check over what is allowed as a bar, in groups, on a new figure."""
    groups = [(name, list(members)) for name, members in groupby(checks, key=lambda check: check.of)]
    lines = len(checks) + _HEAD * len(groups)
    figure = new_figure(0.75 + _LINE_HEIGHT * lines)
    axes = figure.add_subplot()
    axes.set(xscale="log", xlim=_reach(checks))
    line = 0.0
    for name, members in groups:
        line += _HEAD
        _write(axes, drawable(name), line - 1.0, weight="bold")
        for check in members:
            _draw_check(axes, check, line)
            line += 1.0
    axes.set_ylim(line - 0.3, -0.2)
    axes.axvline(1.0, color=INK, linewidth=0.8, zorder=3)
    axes.grid(axis="x", color="#DDDDDD", linewidth=0.4)
    axes.set_axisbelow(True)
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)
    axes.tick_params(axis="x", which="minor", length=0.0)
    axes.set_xlabel("|difference| / allowed")
    verdicts = [check.passed for check in checks]
    failed = verdicts.count(False)
    words = f"{verdicts.count(True)} passed, {failed} failed, {verdicts.count(None)} skipped"
    axes.set_title(words, loc="left", color=RED if failed else INK)
    axes.set_title("difference of allowed", loc="right", size=6.5)
    return figure


def _reach(checks: "Sequence[Check]") -> tuple[float, float]:
    ratios = [check.ratio for check in checks if check.ratio]
    least, largest = max(_LEAST, min([0.1, *ratios])), min(_LARGEST, max([1.0, *ratios]))
    return float(10.0 ** np.floor(np.log10(0.999 * least))), 3.0 * largest


def _write(axes: "Axes", words: str, line: float, *, right: bool = False, **look: Any) -> None:
    shift, side = (5.0, "left") if right else (-5.0, "right")
    place: dict[str, Any] = {"xycoords": axes.get_yaxis_transform(), "textcoords": "offset points"}
    place |= {"xytext": (shift, 0.0), "ha": side, "va": "center", "parse_math": False}
    axes.annotate(words, (float(right), line), **place, **look)


def _draw_check(axes: "Axes", check: "Check", line: float) -> None:
    first, last = axes.get_xlim()
    failed = check.passed is False
    ratio = check.ratio if check.passed is not None else 0.0
    reach = last if ratio is None else min(max(ratio, first), last)
    axes.barh(line, reach - first, left=first, height=0.66, color=RED if failed else BLUE)
    colour = RED if failed else INK if check.passed else GREY
    _write(axes, drawable(check.name), line, color=colour, size=6.5)
    _write(axes, _numbers(check), line, right=True, color=colour, size=6.5)


def _numbers(check: "Check") -> str:
    if check.passed is None:
        return "skipped"
    if check.ratio == 0.0 and check.found != check.expected:
        return true_minus(f"{check.difference}, better")
    return true_minus(f"{check.difference} of {check.limit}")
