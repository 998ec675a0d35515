"""Predictions: against what was analysed, of several records beside each other, and from the PGV alone."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.lines import Line2D

from dcfp.errors import InputError
from dcfp.present.figures import style
from dcfp.schema.formulas import metres_per_second, typeset
from dcfp.schema.quantities import quantity

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.arrays import FloatArray
    from dcfp.inference import Case
    from dcfp.inference.forecast import Forecast
    from dcfp.inference.statistics import Scatter
    from dcfp.methods import Prediction
    from dcfp.methods.method import Variant
    from dcfp.schema.quantities import Quantity

#: Limits of the axes beyond the data [-].
_ROOM = 1.35
#: Numbers of cases up to which marks are large, and from which on they are small.
_FEW, _MANY = 20, 200
#: The method whose intervals are drawn, beside those from the PGV alone.
_WITH_INTERVAL = "pulse march"
#: Edge of a band of intervals.
_EDGE = "#C5D0DC"
#: Heights of a row and of what is around the rows, and the largest of a figure, in which rows get narrower and lose their names [in].
_ROW, _FRAME, _TALLEST = 0.21, 1.1, 11.0
#: Quantities of the panels, with what they are called in the nomenclature and of a prediction.
DRAWN = {
    "dy": ("displacement_change", "displacement_change"),
    "V_dE": ("swing_input_velocity", "input_velocity"),
    "V_dEhr": ("swing_hysteretic_velocity", "hysteretic_velocity"),
}


@dataclass(frozen=True)
class _Drawn:
    """What a panel shows: a quantity, and the methods that are compared in it."""

    name: str
    quantity: "Quantity"
    variants: "tuple[Variant, ...]"
    of_codes: bool = False


@style.styled
def plot_comparison(cases: "Sequence[Case]") -> "Figure":
    """Draw what every blind method predicts against what the analysis gives, on a new figure.

    A legend names the methods with their bias, the geometric mean of prediction over analysis, and their dispersion, the
    standard deviation of its natural logarithm; cases in which a method predicts nothing lie as hollow marks on the lower
    edge, and are counted. Where the methods of codes were asked, a panel of their own shows their y_max; a case outside of the limits of a
    method is hollow there.

    Parameters
    ----------
    cases
        What was analysed and predicted.

    Raises
    ------
    InputError
        If there is no case.
    """
    if not cases:
        msg = "There is nothing to compare; give at least one case."
        raise InputError(msg)
    drawn = _drawn(cases)
    rows = (len(drawn) + 1) // 2
    figure = style.new_figure(3.95 * rows)
    panels: Any = figure.subplots(rows, 2)
    for axes in panels.flat[len(drawn) :]:
        axes.set_axis_off()
    for axes, one in zip(panels.flat, drawn, strict=False):
        _draw_panel(axes, cases, one)
    return figure


def _drawn(cases: "Sequence[Case]") -> list[_Drawn]:
    """Return the panels: each quantity that more than one method predicts, and y_max by the codes where they were asked."""
    from dcfp.methods.method import Information, variants  # late: the package imports the kernels
    from dcfp.methods.prediction import prediction_methods
    from dcfp.methods.pulses import DISPLACEMENT, PREDICTION_QUANTITIES, value_of

    compared = [one for one in variants() if one.information is not Information.INFORMED]
    blind = tuple(one for one in compared if one.method in prediction_methods())
    codes = tuple(one for one in compared if one.method not in prediction_methods())

    def predicts(variant: "Variant", which: "Quantity") -> bool:
        said = (case.predicted[variant] for case in cases if variant in case.predicted)
        return any(np.isfinite(value_of(one, which)) for one in said)

    told = {
        name: which
        for name, which in PREDICTION_QUANTITIES.items()
        if sum(predicts(variant, which) for variant in blind) > 1
    }
    drawn = [_Drawn(name, which, blind) for name, which in (told or PREDICTION_QUANTITIES).items()]
    if any(case.codes for case in cases):
        name = next(name for name, one in PREDICTION_QUANTITIES.items() if one is DISPLACEMENT)
        drawn.append(_Drawn(name, DISPLACEMENT, codes, of_codes=True))
    return drawn


def _draw_panel(axes: "Axes", cases: "Sequence[Case]", drawn: _Drawn) -> None:
    from dcfp.methods.pulses import NOTHING, value_of

    which, entry, known = drawn.quantity, quantity(drawn.name), style.looks()
    few = len(cases) <= _FEW
    size = 4.5 if few else 3.0 if len(cases) <= _MANY else 2.2
    analysed = entry.display(np.array([value_of(case.analysed.whole, which) for case in cases]))
    predicted = [
        entry.display(np.array([value_of(case.predicted.get(variant, NOTHING), which) for case in cases]))
        for variant in drawn.variants
    ]
    low, high = _limits(analysed, predicted)
    ends = np.array([low, high])
    axes.fill_between(ends, 0.5 * ends, 2.0 * ends, color=style.PALE, linewidth=0.0, zorder=0)
    style.draw_line(axes, ends, ends, style.INK, zorder=1)
    full: dict[str, Any] = {"markeredgewidth": 0.0, "alpha": 0.9 if few else 0.6}
    unfilled: dict[str, Any] = {"markerfacecolor": "none", "markeredgewidth": 0.5, "alpha": 0.8}
    for variant, values in zip(drawn.variants, predicted, strict=True):
        look, edge = known[variant.method], np.full_like(values, low)
        codes = [case.codes.get(variant.method) for case in cases]
        outside = np.array([code is not None and code.valid is False for code in codes])
        inside = (analysed > 0.0) & ~outside
        for there, heights, more, how in (
            (inside & (values > 0.0), values, 0.0, full),
            (inside & (values == 0.0), edge, 1.5, style.HOLLOW),
            (outside & np.isfinite(analysed + values), values, 0.0, unfilled),
        ):
            if there.any():
                mark = look.marker, look.scale * (size + more), look.colour
                style.draw_marks(axes, analysed[there], heights[there], *mark, zorder=look.order, **how)
    style.calm_ticks(axes)
    axes.set(xscale="log", yscale="log", xlim=(low, high), ylim=(low, high), box_aspect=1.0)
    x, y = (f"${entry.symbol}$ {how} [{entry.shown.name}]" for how in ("analysed", "predicted"))
    axes.set(xlabel=x, ylabel=y)
    style.plain_numbers(axes)
    _add_legend(axes, cases, drawn)


def _limits(analysed: "FloatArray", predicted: "Sequence[FloatArray]") -> tuple[float, float]:
    """Return the limits that both axes share, round the values above zero."""
    values = np.concatenate((analysed, *predicted))
    good = values[np.isfinite(values) & (values > 0.0)]
    if good.size == 0:
        return 0.1, 10.0
    return float(good.min()) / _ROOM, float(good.max()) * _ROOM


def _add_legend(axes: "Axes", cases: "Sequence[Case]", drawn: _Drawn) -> None:
    from dcfp.inference.statistics import scatters

    found, known = scatters(cases), style.looks()
    handles: list[Line2D] = []
    for variant in drawn.variants:
        if (variant, drawn.quantity) in found:
            look = known[variant.method]
            mark: Any = {"marker": look.marker, "markersize": 4.0 * look.scale, "color": look.colour}
            label = f"{variant.method}: {_words(found[variant, drawn.quantity])}"
            handles.append(Line2D([], [], **mark, linestyle="none", label=label))
    title = "bias, dispersion" if len(cases) > 1 else "predicted / analysed"
    title += "; hollow: outside of its limits" if drawn.of_codes else ""
    how: dict[str, Any] = {"title_fontsize": 7.0, "alignment": "left", "handlelength": 0.8}
    place: dict[str, Any] = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.01)}
    axes.legend(handles=handles, title=title, ncols=1 if drawn.of_codes else 2, **place, **how)


def _words(measures: "Scatter") -> str:
    if not measures.number:
        return "none"
    dispersion = f", {typeset(measures.dispersion, 2)}" if measures.number > 1 else ""
    without = f" ({measures.without} none)" if measures.without else ""
    return f"{typeset(measures.bias, 2)}{dispersion}{without}"


@style.styled
def plot_forecasts(forecasts: "Sequence[Forecast]") -> "Figure":
    """Draw dy of every method, and y_max of the march, a row for each record and PGV, on a new figure; intervals where there are any."""
    height = _FRAME + _ROW * len(forecasts)
    few = height <= _TALLEST
    figure = style.new_figure(min(height, _TALLEST))
    change, displacement = figure.subplots(1, 2, sharey=True)
    _draw_forecasts(change, forecasts, "dy")
    _draw_forecasts(displacement, forecasts, "y")
    change.set_xlabel(f"{quantity('displacement_change').label}, largest")
    displacement.set_xlabel(f"{quantity('displacement').label}, largest")
    names = [
        f"{style.drawable(one.motion.name) if one.motion else ''}  {metres_per_second(one.pgv)}"
        for one in forecasts
    ]
    change.set_yticks(np.arange(len(forecasts)) if few else [], names if few else [], parse_math=False)
    change.invert_yaxis()
    style.legend_outside(change, 6)
    return figure


def _draw_forecasts(axes: "Axes", forecasts: "Sequence[Forecast]", shown: str) -> None:
    name = "displacement_change" if shown == "dy" else "displacement"
    said = [(place, *told) for place, one in enumerate(forecasts) for told in one.predicted.items()]
    for method, look in style.looks().items():
        known = [
            (getattr(one, name), place)
            for place, variant, one in said
            if variant.method == method and (getattr(one, name) or 0.0) > 0.0
        ]
        if known:
            mark = look.marker, 3.5 * look.scale, look.colour
            x, y = zip(*known, strict=True)
            style.draw_marks(axes, x, y, *mark, markeredgewidth=0.0, label=method)
    _draw_intervals(axes, forecasts, shown)
    axes.set_xscale("log")
    axes.grid(visible=True, axis="y", linewidth=0.3, color="#DDDDDD")


def _draw_intervals(axes: "Axes", forecasts: "Sequence[Forecast]", shown: str) -> None:
    from dcfp.inference.forecast import BY_SPECTRUM  # late: it loads the kernels

    if not any(one.intervals for one in forecasts):
        return
    drawn = {
        "": ("90 %, from the PGV", style.GREY, -0.36),
        BY_SPECTRUM.method: ("90 %, from PGV and spectrum", style.INK, -0.24),
        _WITH_INTERVAL: ("90 %, from the march", style.looks()[_WITH_INTERVAL].colour, 0.3),
    }
    for words, colour, _ in drawn.values():
        style.draw_line(axes, [], [], colour, 1.0, label=words)
    for place, one in enumerate(forecasts):
        for variant, intervals in one.intervals.items():
            name = "" if variant is None else variant.method
            if name not in drawn:
                continue
            _, colour, shift = drawn[name]
            for kind, interval in intervals.items():
                if kind.name == shown:
                    style.draw_line(axes, [interval.low, interval.high], [place + shift] * 2, colour, 1.0)


@style.styled
def plot_pgv_prediction(
    pgvs: "Sequence[float]",
    predictions: "Sequence[Prediction]",
    intervals: "Mapping[str, Sequence[tuple[float, float, float]]] | None" = None,
) -> "Figure":
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
    given = np.asarray(pgvs, dtype=np.float64)
    order, along = np.argsort(given), quantity("peak_ground_velocity")
    velocity = along.display(given[order])
    figure = style.new_figure(2.7)
    panels: Any = figure.subplots(1, 3)
    for axes, (key, (name, attribute)) in zip(panels, DRAWN.items(), strict=True):
        entry = quantity(name)
        if intervals is not None and key in intervals:
            limits = entry.display(np.asarray(intervals[key], dtype=np.float64)[order])
            _draw_interval(axes, velocity, limits)
        values = entry.display(np.array([getattr(one, attribute) for one in predictions], dtype=np.float64))
        look: dict[str, Any] = {"marker": "o", "markersize": 3.0, "label": "design method", "zorder": 4}
        style.draw_line(axes, velocity, values[order], style.BLUE, 1.1, **look)
        if velocity.size == 1:
            axes.set_xlim(0.5 * float(velocity[0]), 1.5 * float(velocity[0]))
        style.label_axes(axes, along.label, entry.label, 5, 5, ylim=(0.0, None))
    style.legend_outside(panels[0], 3, "upper right", borderaxespad=0.4)
    return figure


def _draw_interval(axes: "Axes", velocity: "FloatArray", limits: "FloatArray") -> None:
    low, median, high = limits.T
    band, middle = "5 to 95 % of the analyses", "their median"
    if velocity.size == 1:
        look: dict[str, Any] = {"label": band, "solid_capstyle": "butt", "zorder": 1}
        style.draw_line(axes, [velocity[0]] * 2, [low[0], high[0]], _EDGE, 6.0, **look)
        style.draw_marks(axes, velocity, median, "_", 9.0, style.INK, label=middle)
        return
    axes.fill_between(velocity, low, high, color=style.PALE, linewidth=0.0, label=band, zorder=0)
    for side in (low, high):
        style.draw_line(axes, velocity, side, _EDGE, 0.6, zorder=1)
    style.draw_line(axes, velocity, median, style.INK, 0.9, linestyle=(0, (4, 2)), label=middle, zorder=3)
