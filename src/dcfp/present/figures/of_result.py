"""The figure of a result, whatever it is of."""

from typing import TYPE_CHECKING, Any

from matplotlib.figure import Figure

from dcfp.present.figures.sheets import plot_response, plot_test
from dcfp.present.figures.style import BLUE, PAGE_WIDTH, style

if TYPE_CHECKING:
    from dcfp.analysis.result import Result

#: Histories that are drawn of a result that has no sheet of its own.
_DRAWN = ("displacement", "force", "friction", "temperature")


def figure_of(result: "Result", **options: Any) -> Figure:
    """Draw a result on a new figure: the sheet of an analysis or a test, or else its histories one above the other."""
    from dcfp.analysis.response import Response  # late: the analyses import the kernels
    from dcfp.analysis.rig import Loops

    if isinstance(result, Response):
        return plot_response(result, **options)
    if isinstance(result, Loops):
        return plot_test(result, **options)
    names = [name for name in _DRAWN if name in result.histories]
    with style():
        figure = Figure(figsize=(PAGE_WIDTH, 1.4 * len(names) + 0.5), layout="constrained")
        panels: Any = figure.subplots(len(names), 1, sharex=True, squeeze=False)
        for axes, name in zip(panels.flat, names, strict=True):
            entry = result.histories[name]
            axes.plot(result.time, entry.display(entry.of(result)), color=BLUE, linewidth=0.6)
            axes.set_ylabel(entry.label)
        panels.flat[-1].set_xlabel("$t$ [s]")
        figure.suptitle(result.title)
    return figure
