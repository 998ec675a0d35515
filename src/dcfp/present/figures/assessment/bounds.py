"""Envelopes of property bounds."""

from itertools import cycle
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from dcfp.present.figures.assessment.axis import axis_label, shown
from dcfp.present.figures.style import BLUE, INK, PAGE_WIDTH, calm_ticks, style

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

_MARKERS = ("o", "^", "s", "D", "v", "P", "X", "p", "h", "*")


def plot_bounds(found: "xarray.Dataset", part: float | None = None) -> Figure:
    """Draw the envelope and the nominal line of every result over the intensity, on a new figure.

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
    with style():
        height = 2.2 * rows + 0.7 + 0.15 * (len(looks) // 2)
        figure = Figure(figsize=(PAGE_WIDTH, height), layout="constrained")
        panels: Any = figure.subplots(rows, columns, squeeze=False)
        for axes in panels.flat[len(names) :]:
            axes.set_axis_off()
        for axes, name in zip(panels.flat, names, strict=False):
            _draw(axes, one, name, looks)
        figure.legend(
            handles=_handles(found, float(one["quantile"]), looks),
            loc="outside upper center",
            ncols=3,
            borderaxespad=0.3,
            title="marks: which properties govern, full the largest, hollow the least",
            title_fontsize=7.0,
        )
    return figure


def _governing(one: "xarray.Dataset", names: list[str]) -> list[str]:
    """Return the combinations that govern somewhere, each once."""
    told = [one[f"{name}_{side}_at"].to_numpy().tolist() for name in names for side in ("largest", "least")]
    return list(dict.fromkeys(combination for line in told for combination in line if combination))


def _draw(axes: "Axes", one: "xarray.Dataset", name: str, looks: dict[str, str]) -> None:
    from dcfp.study.assessment.selection import described  # late: the package imports the kernels

    intensity = str(one.attrs["intensity"])
    x = shown(one[intensity])
    least, largest, nominal = (
        shown(one[name], one[f"{name}_{side}"]) for side in ("least", "largest", "nominal")
    )
    axes.fill_between(x, least, largest, color=BLUE, alpha=0.15, linewidth=0.0)
    axes.plot(x, nominal, color=INK, linewidth=1.2)
    for side, line in (("least", least), ("largest", largest)):
        axes.plot(x, line, color=BLUE, linewidth=0.7)
        told = one[f"{name}_{side}_at"].to_numpy().tolist()
        for at, height, combination in zip(x, line, told, strict=True):
            if not combination:  # nothing has been run there
                continue
            axes.plot(
                at,
                height,
                marker=looks[combination],
                markersize=4.0,
                color=BLUE,
                markerfacecolor="white" if side == "least" else BLUE,
                linestyle="none",
            )
    axes.set_ylim(bottom=min(0.0, float(np.nanmin(least))))
    calm_ticks(axes)
    axes.set_xlabel(axis_label(one[intensity]))
    axes.set_ylabel(described(one[name]).label)
    axes.set_title(described(one[name]).words, loc="left")


def _handles(found: "xarray.Dataset", part: float, looks: dict[str, str]) -> "list[Line2D | Patch]":
    words = (
        "median of the records" if part == 0.5 else f"what {100.0 * part:g} % of the records do not exceed"
    )
    marks = [
        Line2D([], [], marker=marker, markersize=4.0, color=BLUE, linestyle="none", label=combination)
        for combination, marker in looks.items()
    ]
    return [
        Line2D([], [], color=INK, linewidth=1.2, label=f"nominal, {found.attrs['nominal']}"),
        Patch(color=BLUE, alpha=0.15, linewidth=0.0, label=f"envelope, {words}"),
        *marks,
    ]
