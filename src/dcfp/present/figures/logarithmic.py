"""Numbers on logarithmic axes."""

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.ticker import FormatStrFormatter, LogLocator, NullFormatter

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def plain_numbers(axes: "Axes") -> None:
    """Write the numbers of axes that are logarithmic both ways in full: at 1, 2 and 5, in a short range also between, in a long one at 1."""
    low, high = axes.get_xlim()
    decades = float(np.log10(high / low))
    steps = (1.0, 2.0, 3.0, 5.0, 7.0) if decades < 0.8 else (1.0, 2.0, 5.0) if decades < 2.5 else (1.0,)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=steps, numticks=20))
        axis.set_major_formatter(FormatStrFormatter("%g"))
        axis.set_minor_formatter(NullFormatter())
