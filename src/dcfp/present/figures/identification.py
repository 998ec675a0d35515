"""A law of friction beside the tests that it was fitted to."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.present.figures import style
from dcfp.schema.formulas import typeset
from dcfp.schema.quantities import quantity

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.arrays import FloatArray
    from dcfp.inference.identification import FrictionHistory, Identification
    from dcfp.inference.identification.result import Estimate

_COLUMNS = 3
#: Tests that are drawn over time; of more, the first.
_MOST_TESTS = 12
_LONGEST_NAME = 16
#: Intervals that are written in one line; more take two.
_IN_ONE_LINE = 2
#: Dots in one panel, and groups of them whose mean is drawn.
_MOST_DOTS, _GROUPS = 4000, 15
_SPEED, _PRESSURE = "relative speed of the plates $|v|$ [mm/s]", "pressure $p$ [N/mm²]"


@style.styled
def plot_identification(found: "Identification") -> "Figure":
    """Draw the coefficient of each test over time, the factors of the law, and what is left, on a new figure.

    Points of a factor are measured coefficients over mu_0 and the two other factors, as in Figures 3 and 4 of Li et al. (2020).
    """
    drawn = _drawn(found)
    columns = min(len(drawn), _COLUMNS)
    rows = math.ceil(len(drawn) / columns)
    heights = [0.64, 1.25 * rows + 0.1, 1.95, 1.6]
    figure = style.new_figure(sum(heights))
    parts: Any = figure.subfigures(4, 1, height_ratios=heights, hspace=0.0)
    head, histories, factors, residuals = parts
    _write_head(head, found)
    panels: Any = histories.subplots(rows, columns, squeeze=False, sharey=True)
    _draw_histories(drawn, list(panels.flat), columns)
    place: dict[str, Any] = {"loc": "center right", "bbox_to_anchor": (0.985, 0.7), "ncols": 2}
    head.legend(*panels.flat[0].get_legend_handles_labels(), markerscale=5.0, **place)
    _draw_factors(found, list(factors.subplots(1, 3)))
    _draw_residuals(found, list(residuals.subplots(1, 2, sharey=True)))
    return figure


@dataclass(frozen=True)
class _Drawn:
    """A test over time: what was measured, and what the law gives."""

    history: "FrictionHistory"
    law: "FloatArray"
    temperature: "FloatArray"
    held_out: bool


def _drawn(found: "Identification") -> list[_Drawn]:
    """Return those that were held out, and the first that were fitted."""
    held = [_Drawn(one.history, one.friction, one.temperature, True) for one in found.predictions]
    pairs = enumerate(zip(found.histories, found.temperatures, strict=True))
    fitted = [_Drawn(history, found.fitted(i), heat, False) for i, (history, heat) in pairs]
    return [*fitted[: max(_MOST_TESTS - len(held), _COLUMNS)], *held[:_MOST_TESTS]]


def _write_head(head: Any, found: "Identification") -> None:
    count = len(found.histories)
    words = f"{found.system.bearing.name}: friction from {count} test{'' if count == 1 else 's'}"
    head.text(0.012, 0.7, style.drawable(words), size=10, weight="bold", va="center", parse_math=False)
    intervals = [_interval(one) for one in found.estimates]
    first = math.ceil(len(intervals) / 2) if len(intervals) > _IN_ONE_LINE else len(intervals)
    lines = [",  ".join(part) for part in (intervals[:first], intervals[first:]) if part]
    head.text(0.012, 0.24, "95 % intervals:  " + ",\n".join(lines), va="center", size=6.5)


def _interval(one: "Estimate") -> str:
    from dcfp.inference.identification import PARAMETERS  # late: it imports the kernels

    symbol = PARAMETERS[one.name].symbol
    named = "" if one.name == "mu_0" else f"{one.name.replace('_', ' ')} "
    decimals = min(5, max(0, 1 - math.floor(math.log10(max(one.upper - one.lower, 1e-12)))))
    unit = {"": "", "1/degC": "/°C", "N/(s degC)": " N/(s °C)"}.get(one.unit, f" {one.unit}")
    return f"{named}${symbol}$ {typeset(one.lower, decimals)} to {typeset(one.upper, decimals)}{unit}"


def _draw_histories(drawn: list[_Drawn], panels: "Sequence[Axes]", columns: int) -> None:
    ends: list[tuple[float, float]] = []
    for axes in panels[len(drawn) :]:
        axes.set_axis_off()
    for i, (axes, test) in enumerate(zip(panels, drawn, strict=False)):
        used = test.history.used
        _dots(axes, test.history.time[used], test.history.coefficient[used], size=1.8)
        line = np.where(used, test.law, np.nan)
        colour = style.RED if test.held_out else style.BLUE
        style.draw_line(axes, test.history.time, line, colour, 0.7, label="law")
        low, high = np.quantile(test.history.coefficient[used], (0.005, 0.995))
        # the first peak is narrow, but the law must not leave the panel there
        law = test.law[used]
        ends.append((min(float(low), float(law.min())), max(float(high), float(law.max()))))
        _title_of(test, axes)
        style.calm_ticks(axes)
        if i % columns == 0:
            axes.set_ylabel(quantity("friction").label)
        if i + columns >= len(drawn):
            axes.set_xlabel(quantity("time").label)
    low, high = min(low for low, _ in ends), max(high for _, high in ends)
    margin = 0.1 * (high - low)
    panels[0].set_ylim(max(0.0, low - margin), high + margin)


def _title_of(test: _Drawn, axes: "Axes") -> None:
    history, used = test.history, test.history.used
    name = style.drawable(history.name, _LONGEST_NAME)
    pressure, speed = float(history.pressure[used].mean()), float(history.speed[used].max())
    words = f"{name}{' (held out)' if test.held_out else ''}: {pressure:.0f} N/mm², {speed:.0f} mm/s"
    if not test.held_out:
        words += f", to {float(test.temperature.max()):.0f} °C"
    colour = style.RED if test.held_out else style.INK
    axes.set_title(words, loc="left", size=6.5, color=colour, parse_math=False)


def _draw_factors(found: "Identification", panels: "Sequence[Axes]") -> None:
    law, (coefficient, *places) = found.law, _samples(found)
    temperature = quantity("temperature").label
    described = (
        (law.pressure_factor, r"$\gamma$", _PRESSURE, {"pressure_exponent", "pressure_floor"}),
        (law.velocity_factor, r"$\alpha$", _SPEED, {"speed_drop", "speed_rate"}),
        (law.temperature_factor, r"$\beta$", temperature, {"temperature_rate", "conductivity"}),
    )
    factors = [factor(at) for (factor, *_), at in zip(described, places, strict=True)]
    fitted = {one.name for one in found.estimates}
    # velocity, pressure, temperature, as in the paper
    for axes, number in zip(panels, (1, 0, 2), strict=True):
        factor, symbol, label, names = described[number]
        others = np.prod([one for i, one in enumerate(factors) if i != number], axis=0)
        values = coefficient / (law.reference * others)
        _draw_factor(axes, places[number], values, factor)
        style.label_axes(axes, label, symbol, 5)
        if not fitted & names:
            axes.set_title("not fitted", loc="left", size=6.5, color=style.RED)
    panels[0].legend(loc="lower right", markerscale=1.0)


def _draw_factor(
    axes: "Axes", places: "FloatArray", values: "FloatArray", factor: "Callable[[FloatArray], FloatArray]"
) -> None:
    _dots(axes, places, values, name=None)
    first, last = float(places.min()), float(places.max())
    # what hardly differs is not drawn as if it did
    margin = max(0.04 * (last - first), 0.5 * (0.2 * last - (last - first)))
    along = np.linspace(max(first - margin, 1e-3), last + margin, 200)
    style.draw_line(axes, along, factor(along), style.BLUE, 1.1, label="law", zorder=3)
    _means(axes, places, values, (float(along[0]), float(along[-1])))
    low, high = np.quantile(values, (0.002, 0.998))
    room = 0.15 * float(high - low)
    axes.set(xlim=(along[0], along[-1]), ylim=(max(0.0, float(low) - room), float(high) + room))


def _draw_residuals(found: "Identification", panels: "Sequence[Axes]") -> None:
    coefficient, pressure, speed, temperature = _samples(found)
    residual = coefficient - found.law.coefficient(pressure, speed, temperature)
    reach = 1.3 * float(np.quantile(np.abs(residual), 0.997))
    known = ((speed, _SPEED), (temperature, quantity("temperature").label))
    for axes, (places, label) in zip(panels, known, strict=True):
        axes.axhline(0.0, color=style.BLUE, linewidth=0.9, zorder=2)
        _dots(axes, places, residual, name=None)
        _means(axes, places, residual, (float(places.min()), float(places.max())))
        style.label_axes(axes, label, "", ylim=(-reach, reach))
    panels[0].set_ylabel(r"$\mu$ measured − fitted")


def _samples(found: "Identification") -> "list[FloatArray]":
    """Return coefficient, pressure, speed and temperature of all samples that were used."""
    names = ("coefficient", "pressure", "speed")
    used = [history.used for history in found.histories]
    return [
        *(np.concatenate([getattr(one, name)[one.used] for one in found.histories]) for name in names),
        np.concatenate([one[part] for one, part in zip(found.temperatures, used, strict=True)]),
    ]


def _dots(
    axes: "Axes", places: "FloatArray", values: "FloatArray", name: str | None = "measured", size: float = 1.2
) -> None:
    every = slice(None, None, max(1, places.size // _MOST_DOTS))
    look: dict[str, Any] = {"markeredgewidth": 0.0, "alpha": 0.6, "rasterized": True, "zorder": 1}
    style.draw_marks(axes, places[every], values[every], ".", size, style.GREY, label=name, **look)


def _means(axes: "Axes", places: "FloatArray", values: "FloatArray", reach: tuple[float, float]) -> None:
    """Draw the means of groups of samples that are near each other; the groups divide `reach`."""
    order = np.argsort(places)
    # groups of equal width rather than equal number, so that a fast test shows as much as a slow one
    edges = np.linspace(*reach, _GROUPS + 1)[1:-1]
    groups = [part for part in np.split(order, np.searchsorted(places[order], edges)) if part.size >= 10]
    at, means = ([float(one[part].mean()) for part in groups] for one in (places, values))
    look: dict[str, Any] = {"markeredgecolor": style.INK, "markeredgewidth": 0.4, "zorder": 4}
    style.draw_marks(axes, at, means, "o", 3.0, style.OCHRE, **look, label="mean of neighbours")
