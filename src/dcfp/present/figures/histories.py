"""Histories of velocity, displacement, temperature, friction and energies, and how much of them is worth showing."""

from typing import TYPE_CHECKING, TypeAlias, TypeGuard

import numpy as np

from dcfp.present.figures.style import (
    BLUE,
    GREY,
    INK,
    OCHRE,
    PALE,
    RED,
    calm_ticks,
    legend_above,
    millimetres,
    new_axes,
    styled,
)
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from dcfp.analysis import Response
    from dcfp.analysis.rig import Loops
    from dcfp.arrays import FloatArray

    History: TypeAlias = Response | Loops


#: Part of the capacity from which on it is drawn [-].
_NEAR_CAPACITY = 0.6


@styled
def plot_velocities(response: "Response", axes: "Axes | None" = None) -> "Axes":
    """Draw the velocities of the ground and of the structure, with the times of sliding shaded."""
    axes = _history_axes(response, axes)
    part = shown(response)
    time = response.time[part]
    axes.fill_between(
        time,
        0.0,
        1.0,
        where=response.sliding[part] != 0.0,
        step="post",
        transform=axes.get_xaxis_transform(),
        color=PALE,
        linewidth=0.0,
        label="sliding",
        zorder=0,
    )
    width = line_width(response)
    for name, values, colour in (
        ("ground_velocity", response.ground_velocity, GREY),
        ("structure_velocity", response.structure_velocity, BLUE),
    ):
        entry = quantity(name)
        axes.plot(time, entry.display(values[part]), color=colour, linewidth=width, label=f"${entry.symbol}$")
    axes.set_ylabel(quantity("velocity").label)
    largest = max(
        float(np.abs(values).max()) for values in (response.ground_velocity, response.structure_velocity)
    )
    between_equal_limits(axes, float(quantity("velocity").display(largest)))
    legend_above(axes)
    return axes


@styled
def plot_displacement(response: "History", axes: "Axes | None" = None) -> "Axes":
    """Draw the displacement with its peak, and the capacity where the peak comes near it."""
    axes = _history_axes(response, axes)
    part = shown(response)
    displacement = response.displacement[part]
    axes.plot(response.time[part], displacement, color=BLUE, linewidth=line_width(response))
    mark_peak(axes, response.time[part], displacement, millimetres)
    largest = float(np.abs(displacement).max())
    capacity = response.bearing.displacement_capacity
    if capacity is not None and response.peak_displacement > _NEAR_CAPACITY * capacity:
        for side, label in ((capacity, "capacity"), (-capacity, None)):
            axes.axhline(side, color=RED, linewidth=0.7, linestyle=(0, (5, 3)), label=label)
        legend_above(axes)
        largest = max(largest, capacity)
    axes.set_ylabel(quantity("displacement").label)
    between_equal_limits(axes, largest)
    return axes


@styled
def plot_temperature(response: "History", axes: "Axes | None" = None) -> "Axes":
    """Draw the temperature of the contact."""
    axes = _history_axes(response, axes)
    part = shown(response)
    axes.plot(response.time[part], response.temperature[part], color=RED, linewidth=line_width(response))
    axes.set_ylabel(quantity("temperature").label)
    ambient = response.heating.ambient
    if float(np.ptp(response.temperature)) < 1.0:
        axes.set_ylim(ambient - 5.0, ambient + 5.0)
    return axes


@styled
def plot_friction(response: "History", axes: "Axes | None" = None) -> "Axes":
    """Draw the coefficient of friction: at work while it slides, faint where it only has to be overcome."""
    axes = _history_axes(response, axes)
    part = shown(response)
    time, friction = response.time[part], response.friction[part]
    width = line_width(response)
    axes.plot(time, friction, color="#C9C9C9", linewidth=width, label="sticking")
    sliding = np.where(response.sliding[part] != 0.0, friction, np.nan)
    axes.plot(time, sliding, color=OCHRE, linewidth=width, label="sliding")
    axes.set_ylabel(quantity("friction").label)
    axes.set_ylim(0.0, 1.12 * float(friction.max()))
    legend_above(axes)
    return axes


def _history_axes(response: "History", axes: "Axes | None") -> "Axes":
    axes = new_axes(height=1.8) if axes is None else axes
    time = response.time[shown(response)]
    axes.set_xlim(float(time[0]), float(time[-1]))
    axes.set_xlabel(quantity("time").label)
    calm_ticks(axes, 8, 4)
    return axes


def between_equal_limits(axes: "Axes", largest: float) -> None:
    """Put zero in the middle, and room beyond the largest value."""
    axes.axhline(0.0, color=GREY, linewidth=0.4, zorder=0)
    limit = 1.3 * largest if largest > 0.0 else 1.0
    axes.set_ylim(-limit, limit)


def mark_peak(
    axes: "Axes", time: "FloatArray", values: "FloatArray", words: "Callable[[float], str]"
) -> None:
    """Mark the largest value, and write its size beside it."""
    place = int(np.abs(values).argmax())
    peak = float(values[place])
    later = time[place] > time[0] + 0.75 * (time[-1] - time[0])
    axes.plot(time[place], peak, marker="o", markersize=3.0, color=INK, linestyle="none", zorder=4)
    axes.annotate(
        words(abs(peak)),
        (float(time[place]), peak),
        xytext=(-4 if later else 4, 2 if peak < 0.0 else -2),
        textcoords="offset points",
        ha="right" if later else "left",
        va="center",
        bbox={"boxstyle": "square,pad=0.1", "facecolor": "white", "edgecolor": "none", "alpha": 0.8},
        zorder=5,
    )


#: Part of the hysteretic energy, or of the peak velocity of the ground, below which nothing of note happens [-].
_LITTLE = 0.001
_QUIET = 0.05
#: Part of the time at the start that has to be quiet before it is left out [-].
_LONG_START = 0.2


def shown(history: "History") -> slice:
    """Return the samples in which something happens; of a test all of them.

    Those of an analysis end a little after the last thousandth of the hysteretic energy, or after the ground has become quiet where
    nothing slides; a long quiet start is left out.
    """
    samples = int(history.time.size)
    if not _is_response(history):
        return slice(0, samples)
    places = np.flatnonzero(_busy(history))
    if places.size < 2:
        return slice(0, samples)
    first, last = int(places[0]), int(places[-1])
    margin = 2 + (last - first) // 12
    start = max(0, first - margin) if first > _LONG_START * last else 0
    return slice(start, min(samples, last + margin))


def _is_response(history: "History") -> "TypeGuard[Response]":
    return hasattr(history, "motion")


def _busy(response: "Response") -> "NDArray[np.bool_]":
    dissipated = response.energy.hysteretic
    whole = float(dissipated[-1])
    if whole > 0.0:
        return (dissipated > _LITTLE * whole) & (dissipated < (1.0 - _LITTLE) * whole)
    ground = np.abs(response.ground_velocity)
    return ground > _QUIET * float(ground.max())


def line_width(history: "History") -> float:
    """Return the width [pt] at which the waves of a history stay apart."""
    part = shown(history)
    span = float(history.time[part.stop - 1] - history.time[part.start])
    return 0.9 if span < 25.0 else 0.7 if span < 60.0 else 0.5


_PALE_BLUE = "#7FA3CB"


@styled
def plot_energies(response: "Response", axes: "Axes | None" = None) -> "Axes":
    """Draw the hysteretic, strain and kinetic energies on top of each other, and the input energy as a line."""
    axes = new_axes(height=1.8) if axes is None else axes
    part = shown(response)
    time = response.time[part]
    energy = response.energy
    stack = (
        ("hysteretic_energy", energy.hysteretic, OCHRE),
        ("strain_energy", energy.strain, _PALE_BLUE),
        ("kinetic_energy", energy.kinetic, BLUE),
    )
    axes.stackplot(
        time,
        *(quantity(name).display(values[part]) for name, values, _ in stack),
        colors=[colour for _, _, colour in stack],
        labels=[f"${quantity(name).symbol}$" for name, _, _ in stack],
        linewidth=0.0,
    )
    entry = quantity("input_energy")
    width = min(line_width(response), 0.7)
    axes.plot(time, entry.display(energy.input[part]), color=INK, linewidth=width, label=f"${entry.symbol}$")
    axes.set_xlim(float(time[0]), float(time[-1]))
    axes.set_ylim(bottom=min(0.0, float(entry.display(energy.input[part]).min())))
    calm_ticks(axes, 8, 4)
    axes.set_xlabel(quantity("time").label)
    axes.set_ylabel(entry.label)
    legend_above(axes)
    return axes
