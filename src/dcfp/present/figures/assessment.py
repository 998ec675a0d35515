"""Figures of what a study says: curves of incremental dynamic analysis, fragility, envelopes of property bounds, Sobol indices, and a chart for design."""

from itertools import cycle
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from dcfp.errors import InputError
from dcfp.present.figures import style
from dcfp.present.panels import design
from dcfp.schema.formulas import metres_per_second, millimetres
from dcfp.schema.quantities import NOMENCLATURE
from dcfp.study.assessment.selection import described, shown_value

if TYPE_CHECKING:
    from collections.abc import Sequence

    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.arrays import FloatArray
    from dcfp.inference.design_space import DesignSpace
_LOOKS = ((style.BLUE, "o"), (style.RED, "s"), (style.OCHRE, "^"), (style.INK, "D"))
_MARKERS = ("o", "^", "s", "D", "v", "P", "X", "p", "h", "*")
#: Most panels of a figure.
_MOST = 4
_BARS = (("S1", "first order", style.OCHRE, -0.19), ("ST", "total", style.BLUE, 0.19))
#: Probabilities of the two panels, and how to call them.
_PARTS = ((0.5, "half of the earthquakes"), (0.95, "95 % of the earthquakes"))


def _axis_label(variable: "xarray.DataArray") -> str:
    entry = described(variable)
    symbol = "" if entry.symbol.startswith(r"\mathrm") else f", ${entry.symbol}$"
    unit = f" [{entry.shown.name}]" if entry.shown.has_dimension else ""
    return f"{entry.words}{symbol}{unit}"


def _shown(variable: "xarray.DataArray", values: "xarray.DataArray | None" = None) -> "FloatArray":
    """Return the values of a variable, or others of its unit, as they are shown."""
    numbers = (variable if values is None else values).to_numpy()
    return described(variable).display(np.asarray(numbers, dtype=np.float64))


@style.styled
def plot_ida(found: "xarray.Dataset", axes: "Axes | None" = None) -> "Axes":
    """Draw what `dcfp.study.assessment.ida` returns, on new axes by default: the intensity over the result.

    Each record is thin and grey, the quantiles are bold, and the capacity is a line; a hollow mark is where a record is first beyond it.

    Parameters
    ----------
    found
        What `dcfp.study.assessment.ida` returns.
    axes
        Where to draw; by default new axes.
    """
    axes = axes or style.new_axes(0.62 * style.PAGE_WIDTH, 3.6)
    name = next(str(one) for one in found.data_vars if f"{one}_quantile" in found.data_vars)
    result = found[name]
    intensity = str(result.dims[1])
    heights = _shown(found[intensity])
    capacity = found.attrs.get("displacement_capacity")
    if name == "peak_displacement" and capacity is not None:
        line = [float(capacity)] * 2, [0.0, heights[-1]]
        label = f"capacity, {millimetres(float(capacity))}"
        style.draw_line(axes, *line, style.RED, 0.9, linestyle=style.DASHED, label=label)
    _draw_records(axes, _shown(result), heights, found["beyond_capacity"].to_numpy())
    _draw_quantiles(axes, found, name, heights)
    # room for the names of the quantiles
    ends: dict[str, Any] = {"xlim": (0.0, None), "ylim": (0.0, 1.07 * heights[-1])}
    style.label_axes(axes, _axis_label(result), _axis_label(found[intensity]), 6, 6, **ends)
    style.legend_above(axes)
    return axes


def _draw_records(axes: "Axes", curves: "FloatArray", heights: "FloatArray", beyond: "np.ndarray") -> None:
    hollow = {"markerfacecolor": "white", "markeredgecolor": style.INK, "markeredgewidth": 0.6, "zorder": 2}
    for i, (curve, outside) in enumerate(zip(curves, beyond, strict=True)):
        label = f"{len(curves)} records" if i == 0 else None
        style.draw_line(axes, curve, heights, style.GREY, 0.4, alpha=0.8, label=label, zorder=1)
        if outside.any():
            first = int(np.argmax(outside))
            label = None if beyond[:i].any() else "first beyond the capacity"
            style.draw_marks(axes, curve[first], heights[first], "o", 3.2, style.INK, label=label, **hollow)


def _draw_quantiles(axes: "Axes", found: "xarray.Dataset", name: str, heights: "FloatArray") -> None:
    lines = _shown(found[name], found[f"{name}_quantile"])
    above: dict[str, Any] = {"xytext": (0, 3), "textcoords": "offset points", "ha": "center", "va": "bottom"}
    for part, line in zip(found["quantile"].to_numpy().tolist(), lines, strict=True):
        width, dashes, label = (1.8, "solid", "median") if part == 0.5 else (1.2, (0, (4, 2)), None)
        style.draw_line(axes, line, heights, style.BLUE, width, linestyle=dashes, label=label, zorder=3)
        axes.annotate(f"{100.0 * part:g} %", (float(line[-1]), float(heights[-1])), color=style.BLUE, **above)


@style.styled
def plot_fragility(found: "xarray.Dataset", axes: "Axes | None" = None) -> "Axes":
    """Draw what `dcfp.study.assessment.fragility` returns, on new axes by default: the probability that each capacity is exceeded over the intensity.

    Marks are the parts of the records that are observed to exceed it, bands hold a part of the draws of earthquakes, and a mark with a dotted line is the median.

    Parameters
    ----------
    found
        What `dcfp.study.assessment.fragility` returns.
    axes
        Where to draw; by default new axes.
    """
    axes = axes or style.new_axes(0.62 * style.PAGE_WIDTH, 3.5)
    intensity = str(found.attrs["intensity"])
    grid, points = _shown(found[intensity]), _shown(found[intensity], found[f"{intensity}_of_curve"])
    medians = _shown(found[intensity], found["median"])
    entry = described(found[intensity])
    for place, (colour, marker) in zip(range(found.sizes["capacity"]), cycle(_LOOKS), strict=False):
        one = found.isel(capacity=place)
        name = shown_value(found["capacity"].rename(str(found.attrs["quantity"])), one["capacity"].item())
        label = f"{name}: no fit"
        if np.isfinite(medians[place]):
            beta = float(one["total_dispersion"])
            unit = f" {entry.shown.name}" if entry.shown.has_dimension else ""
            label = rf"{name}: $\theta$ = {medians[place]:.3g}{unit}, $\beta$ = {beta:.2f}"
        low, high = one["probability_bound"].to_numpy()
        axes.fill_between(points, low, high, color=colour, alpha=0.15, linewidth=0.0)
        style.draw_line(axes, points, one["probability"].to_numpy(), colour, 1.3, label=label)
        style.draw_marks(axes, grid, one["fraction"].to_numpy(), marker, 3.2, colour, clip_on=False, zorder=3)
        style.draw_line(axes, [medians[place]] * 2, [0.0, 0.5], colour, 0.7, linestyle=":")
        style.draw_marks(axes, medians[place], 0.5, "+", 7, colour, zorder=4)
    ends: dict[str, Any] = {"xlim": (0.0, float(grid[-1])), "ylim": (0.0, 1.0)}
    words = "probability that the capacity is exceeded"
    style.label_axes(axes, _axis_label(found[intensity]), words, 6, 5, **ends)
    title = rf"$\theta$: median, $\beta$: dispersion; marks: observed in {found.attrs['records']} records;"
    title += f"\nband: {100.0 * found.attrs['confidence']:g} % of draws of earthquakes"
    corner: dict[str, Any] = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.02), "alignment": "left"}
    columns = 2 if found.sizes["capacity"] > 1 else 1
    axes.legend(ncols=columns, title=title, title_fontsize=7.0, **corner)
    return axes


@style.styled
def plot_bounds(found: "xarray.Dataset", part: float | None = None) -> "Figure":
    """Draw what `dcfp.study.assessment.bounds` returns, on a new figure: envelope and nominal line of every result over the intensity.

    A mark on the edge of an envelope says which combination of the properties governs there, full of the largest and hollow of the least.

    Parameters
    ----------
    found
        What `dcfp.study.assessment.bounds` returns.
    part
        Which of its quantiles [-]; by default the first.
    """
    place = 0 if part is None else int(np.flatnonzero(np.isclose(found["quantile"].to_numpy(), part))[0])
    one = found.isel(quantile=place)
    names = str(found.attrs["quantities"]).split(", ")
    looks = dict(zip(_governing(one, names), cycle(_MARKERS), strict=False))
    columns = min(2, len(names))
    rows = -(-len(names) // columns)
    figure = style.new_figure(2.2 * rows + 0.7 + 0.15 * (len(looks) // 2))
    panels: Any = figure.subplots(rows, columns, squeeze=False)
    for axes in panels.flat[len(names) :]:
        axes.set_axis_off()
    for axes, name in zip(panels.flat, names, strict=False):
        _draw_bounds(axes, one, name, looks)
    above: dict[str, Any] = {"loc": "outside upper center", "borderaxespad": 0.3, "ncols": 3}
    title = "marks: which properties govern, full the largest, hollow the least"
    figure.legend(handles=_handles(one, looks), title=title, title_fontsize=7.0, **above)
    return figure


def _governing(one: "xarray.Dataset", names: list[str]) -> list[str]:
    """Return the combinations that govern somewhere, each once."""
    told = [one[f"{name}_{side}_at"].to_numpy().tolist() for name in names for side in ("largest", "least")]
    return list(dict.fromkeys(combination for line in told for combination in line if combination))


def _draw_bounds(axes: "Axes", one: "xarray.Dataset", name: str, looks: dict[str, str]) -> None:
    intensity = str(one.attrs["intensity"])
    x = _shown(one[intensity])
    sides = ("least", "largest", "nominal")
    least, largest, nominal = (_shown(one[name], one[f"{name}_{side}"]) for side in sides)
    axes.fill_between(x, least, largest, color=style.BLUE, alpha=0.15, linewidth=0.0)
    style.draw_line(axes, x, nominal, style.INK, 1.2)
    for side, line in (("least", least), ("largest", largest)):
        style.draw_line(axes, x, line, style.BLUE, 0.7)
        face = "white" if side == "least" else style.BLUE
        told = one[f"{name}_{side}_at"].to_numpy().tolist()
        for at, height, combination in zip(x, line, told, strict=True):
            if combination:  # else nothing has been run there
                style.draw_marks(axes, at, height, looks[combination], 4.0, style.BLUE, markerfacecolor=face)
    axes.set_ylim(bottom=min(0.0, float(np.nanmin(least))))
    style.label_axes(axes, _axis_label(one[intensity]), described(one[name]).label)
    axes.set_title(described(one[name]).words, loc="left")


def _handles(one: "xarray.Dataset", looks: dict[str, str]) -> "list[Line2D | Patch]":
    part = float(one["quantile"])
    of = "median of the records" if part == 0.5 else f"what {100.0 * part:g} % of the records do not exceed"
    look: dict[str, Any] = {"markersize": 4.0, "color": style.BLUE, "linestyle": "none"}
    return [
        Line2D([], [], color=style.INK, linewidth=1.2, label=f"nominal, {one.attrs['nominal']}"),
        Patch(color=style.BLUE, alpha=0.15, linewidth=0.0, label=f"envelope, {of}"),
        *(Line2D([], [], marker=marker, label=name, **look) for name, marker in looks.items()),
    ]


@style.styled
def plot_sensitivity(found: "xarray.Dataset") -> "Figure":
    """Draw what `dcfp.study.assessment.sensitivity` returns, on a new figure: Sobol indices by factor with their intervals.

    A panel for each value of the one factor that is left of the grid, of many for some of them.

    Parameters
    ----------
    found
        What `dcfp.study.assessment.sensitivity` returns.

    Raises
    ------
    InputError
        If several factors are left.
    """
    left = [str(name) for name in found["S1"].dims if name != "factor"]
    if len(left) > 1:
        msg = f"A figure of Sobol indices is over one factor of the grid, and {' and '.join(left)} are left; choose values first."
        raise InputError(msg)
    number = found.sizes[left[0]] if left else 1
    places = np.unique(np.linspace(0, number - 1, min(number, _MOST)).round().astype(int)).tolist()
    width = style.PAGE_WIDTH if len(places) > 1 else 0.55 * style.PAGE_WIDTH
    figure = style.new_figure(1.15 + 0.36 * found.sizes["factor"], width)
    panels: Any = figure.subplots(1, len(places), squeeze=False, sharex=True, sharey=True)
    for axes, place in zip(panels.flat, places, strict=True):
        _draw_indices(axes, found.isel({left[0]: place}) if left else found)
        if left:
            along = found[left[0]]
            symbol = "PGV" if left[0] == "pgv" else described(along).title
            axes.set_title(f"{symbol} {shown_value(along, along.to_numpy()[place])}")
    last = panels.flat[-1]  # all share its limits
    low, high = last.get_xlim()
    last.set_xlim(min(0.0, low), max(1.0, high))
    last.set_xticks([0.0, 0.5, 1.0])
    name = str(found.attrs["quantity"])
    words = NOMENCLATURE[name].words if name in NOMENCLATURE else name.replace("_", " ")
    words = f"{'logarithm of the ' if found.attrs['logarithm'] else ''}{words}"
    figure.supxlabel(f"part of the variance of the {words}", fontsize=7.5, color=style.INK)
    style.legend_outside(panels.flat[0], 2, borderaxespad=0.3)
    return figure


def _draw_indices(axes: "Axes", one: "xarray.Dataset") -> None:
    names = one["factor"].to_numpy().tolist()
    heights = np.arange(len(names), dtype=np.float64)
    for name, words, colour, shift in _BARS:
        values, error = one[name].to_numpy(), one[f"{name}_confidence"].to_numpy()
        look = {"elinewidth": 0.7, "capsize": 1.8, "capthick": 0.7, "ecolor": style.INK}
        axes.barh(heights + shift, values, 0.34, xerr=error, color=colour, label=words, error_kw=look)
    axes.axvline(0.0, color=style.INK, linewidth=0.6)
    axes.set_yticks(heights, names)
    axes.set_ylim(len(names) - 0.45, -0.55)


@style.styled
def plot_design_chart(spaces: "Sequence[DesignSpace]", allowed: float) -> "Figure":
    """Draw lines of equal displacement and of equal force over friction and radius, on a new figure.

    A row for each PGV; left the median of the records, right what 95 % of earthquakes do not exceed, where there are enough records to say so.
    What holds `allowed` [mm] is shaded.
    """
    parts = [one for one in _PARTS if all(one[0] * (space.records + 1) <= space.records for space in spaces)]
    figure = style.new_figure(0.7 + 2.6 * len(spaces))
    axes = figure.subplots(len(spaces), len(parts), squeeze=False, sharex=True, sharey=True)
    for row, space in zip(axes, spaces, strict=True):
        for one, (part, words) in zip(row, parts, strict=True):
            _draw_design(one, space, allowed, part)
            one.set_title(f"PGV {metres_per_second(space.pgv)}, {words}")
        row[0].set_ylabel("radius of each plate [m]")
    for one in axes[-1]:
        one.set_xlabel("reference coefficient of friction")
    words = f"Shaded: {millimetres(allowed)} holds.  Blue: $y_{{max}}$ [mm].  Dashed: force over weight.  {spaces[0].records} records"
    figure.suptitle(words, fontsize=8, color=style.INK)
    return figure


def _draw_design(axes: "Axes", space: "DesignSpace", allowed: float, part: float) -> None:
    panel = design(space, allowed, part)
    x, y = panel.x.display, panel.y.display
    for area in panel.areas:
        axes.fill(x(area[:, 0]), y(area[:, 1]), color=style.BLUE, alpha=0.12, linewidth=0.0)
    for line in panel.lines:
        colour, dashes = style.COLOURS[line.colour], "dashed" if line.dashed else "solid"
        style.draw_line(axes, x(line.x), y(line.y), colour, line.width, linestyle=dashes)
        if line.place is not None and line.level is not None:
            box = {"boxstyle": "square,pad=0.1", "facecolor": "white", "edgecolor": "none", "alpha": 0.7}
            look: dict[str, Any] = {"size": 6.0 if line.dashed else 6.5, "ha": "center", "va": "center"}
            at = float(x(line.x[line.place])), float(y(line.y[line.place]))
            axes.text(*at, f"{line.level[1]:g}", color=colour, bbox=box, **look)
    assert panel.across is not None
    axes.set(xlim=panel.across, ylim=(y(panel.low), y(panel.high)))
