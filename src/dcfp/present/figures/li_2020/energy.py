"""How much of a pulse's energy comes in, and how much of that is absorbed: Figures 19 and 20."""

from typing import TYPE_CHECKING

import numpy as np

from dcfp.present.figures.li_2020.marks import Mark, draw_points
from dcfp.present.figures.style import BLUE, INK, OCHRE, RED, calm_ticks
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes

    from dcfp.inference import Case
    from dcfp.methods.li_2020 import Constants

#: Values of eps that Figure 19 compares [-], with their colours and lines.
_FALL_RATIOS = ((0.1, OCHRE, (0, (1.5, 1.5))), (0.25, INK, "-"), (0.5, BLUE, (0, (5, 2))))


def draw_absorbed_ratio(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", constants: "Constants"
) -> None:
    """Draw V_dEhr / V_dE of the analyses against ku/kg of the governing pulse, with Eq. (27): Figure 19."""
    # late: predictions import the kernels
    from dcfp.methods.li_2020.simplified_method import absorbed_velocity_ratio

    def point(case: "Case") -> tuple[float, float] | None:
        pulse, swing = case.analysed.pulse, case.analysed.governing
        if pulse is None or swing.input_velocity == 0.0:
            return None
        slope = abs(float(case.pulses.mean_accelerations[pulse]))
        return constants.friction_deceleration / slope, swing.hysteretic_velocity / swing.input_velocity

    draw_points(axes, cases, marks, point)
    points = [place for place in map(point, cases) if place is not None]
    across = 1.06 * max([1.1, *(x for x, _ in points)])
    ratio = np.linspace(0.0, across, 400)
    for eps, colour, dashes in _FALL_RATIOS:
        label = rf"$\varepsilon={eps:g}$"
        curve = absorbed_velocity_ratio(ratio, eps)
        axes.plot(ratio, curve, color=colour, linewidth=0.9, linestyle=dashes, label=label, zorder=2)
    calm_ticks(axes, 6, 6)
    axes.set_xlim(0.0, across)
    axes.set_ylim(0.0, 1.08 * max([1.0, *(y for _, y in points)]))
    axes.set_xlabel(quantity("slope_ratio").label)
    put_in, absorbed = quantity("swing_input_velocity").symbol, quantity("swing_hysteretic_velocity").symbol
    axes.set_ylabel(f"${absorbed}\\,/\\,{put_in}$")
    axes.legend(loc="lower right", borderaxespad=0.7)


def draw_input_over_change(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", constants: "Constants"
) -> None:
    """Draw V_dE of the analyses against |dvg| of the governing pulse, with Eq. (28): Figure 20."""
    from dcfp.methods.li_2020.simplified_method import input_velocity

    change, put_in = quantity("ground_velocity_change"), quantity("swing_input_velocity")

    def point(case: "Case") -> tuple[float, float] | None:
        pulse = case.analysed.pulse
        if pulse is None:
            return None
        across = change.display(abs(float(case.pulses.changes[pulse])))
        return across, put_in.display(case.analysed.governing.input_velocity)

    draw_points(axes, cases, marks, point)
    points = [place for place in map(point, cases) if place is not None]
    across = 1.06 * (max((x for x, _ in points), default=0.0) or 1.0)
    if constants.slides_on_average:
        ends = change.shown.inner(np.array([0.0, across]))
        line = input_velocity(ends, constants.friction_deceleration, constants.average_slope)
        label = rf"Eq. (28), $k_{{g,\mathrm{{ave}}}}={constants.average_slope:.0f}$ mm/s²"
        axes.plot(
            [0.0, across], put_in.display(line), color=RED, linewidth=1.0, linestyle=(0, (5, 2)), label=label
        )
        axes.legend(loc="lower right", borderaxespad=0.7)
    calm_ticks(axes, 6, 5)
    axes.set_xlim(0.0, across)
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel(f"$|{change.symbol}|$ [{change.shown.name}]")
    axes.set_ylabel(put_in.label)
