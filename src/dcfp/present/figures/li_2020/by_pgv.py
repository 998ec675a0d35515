"""What grows with the PGV: Figures 11, 25, 26 and 27."""

from typing import TYPE_CHECKING

import numpy as np

from dcfp.present.figures.li_2020.marks import Mark, draw_points
from dcfp.present.figures.style import INK, RED, calm_ticks
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from matplotlib.axes import Axes

    from dcfp.inference import Case
    from dcfp.methods import Prediction
    from dcfp.methods.li_2020 import Constants

#: Line of a prediction.
_DASHED = (0, (5, 2))


def draw_largest_displacement(axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]") -> None:
    """Draw y_max against the PGV: Figure 11."""
    _draw_against_pgv(axes, cases, marks, "peak_displacement", lambda case: case.analysed.whole.bound)


def draw_velocity_change(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", constants: "Constants"
) -> None:
    """Draw |dvg| of the governing pulse against the PGV, with Eq. (29): Figure 25."""

    def change(case: "Case") -> float | None:
        pulse = case.analysed.pulse
        return None if pulse is None else abs(float(case.pulses.changes[pulse]))

    entry = quantity("ground_velocity_change")
    _draw_against_pgv(axes, cases, marks, "ground_velocity_change", change)
    axes.set_ylabel(f"$|{entry.symbol}|$ [{entry.shown.name}]")
    ends = quantity("peak_ground_velocity").display(np.array([0.0, _largest_pgv(cases)]))
    label = rf"$\zeta={constants.change_ratio:.3g}$, Eq. (29)"
    axes.plot(ends, constants.change_ratio * ends, color=INK, linewidth=0.9, linestyle=_DASHED, label=label)
    axes.legend(loc="lower right", borderaxespad=0.7)


def draw_input_velocity(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", constants: "Constants"
) -> None:
    """Draw the largest V_dE against the PGV, with Eq. (31): Figure 26."""
    _draw_with_design(
        axes, cases, marks, constants, "swing_input_velocity", lambda one: one.input_velocity, "Eq. (31)"
    )


def draw_hysteretic_velocity(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", constants: "Constants"
) -> None:
    """Draw the largest V_dEhr against the PGV, with Eq. (32): Figure 26."""
    _draw_with_design(
        axes,
        cases,
        marks,
        constants,
        "swing_hysteretic_velocity",
        lambda one: one.hysteretic_velocity,
        "Eq. (32)",
    )


def draw_displacement_change(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", constants: "Constants"
) -> None:
    """Draw the largest dy against the PGV, with Eq. (33): Figure 27."""
    _draw_with_design(
        axes, cases, marks, constants, "displacement_change", lambda one: one.displacement_change, "Eq. (33)"
    )


def _draw_with_design(
    axes: "Axes",
    cases: "Sequence[Case]",
    marks: "Mapping[str, Mark]",
    constants: "Constants",
    name: str,
    value: "Callable[[Prediction], float]",
    label: str,
) -> None:
    from dcfp.methods.li_2020 import predict_from_pgv  # late: predictions import the kernels

    _draw_against_pgv(axes, cases, marks, name, lambda case: value(case.analysed.whole))
    if not constants.slides_on_average:
        return
    pgvs = np.linspace(0.02, 1.0, 100) * 1.04 * _largest_pgv(cases)
    curve = np.array([value(predict_from_pgv(float(pgv), constants)) for pgv in pgvs])
    axes.plot(
        quantity("peak_ground_velocity").display(pgvs),
        quantity(name).display(curve),
        color=RED,
        linewidth=1.0,
        linestyle=_DASHED,
        label=label,
        zorder=2,
    )
    axes.legend(loc="upper left", borderaxespad=0.7)


def _draw_against_pgv(
    axes: "Axes",
    cases: "Sequence[Case]",
    marks: "Mapping[str, Mark]",
    name: str,
    value: "Callable[[Case], float | None]",
) -> None:
    velocity, entry = quantity("peak_ground_velocity"), quantity(name)

    def point(case: "Case") -> tuple[float, float] | None:
        found = value(case)
        return None if found is None else (velocity.display(case.pgv), entry.display(found))

    draw_points(axes, cases, marks, point)
    calm_ticks(axes, 6, 5)
    axes.set_xlim(0.0, 1.08 * velocity.display(_largest_pgv(cases)))
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel(velocity.label)
    axes.set_ylabel(entry.label)


def _largest_pgv(cases: "Sequence[Case]") -> float:
    return max(case.pgv for case in cases)
