"""The pulses of a ground velocity, and what they do to the structure, as Figures 13 and 14 of Li et al. (2020) show them."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.patches import Patch

from dcfp.errors import InputError
from dcfp.present.figures import style
from dcfp.present.figures.drawing import between_equal_limits
from dcfp.present.panels import shown
from dcfp.schema.formulas import metres_per_second, millimetres
from dcfp.schema.quantities import quantity

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.analysis import Response
    from dcfp.analysis.swings import Swing
    from dcfp.arrays import FloatArray
    from dcfp.inference import Case
    from dcfp.methods import PulseMarch, Pulses
    from dcfp.methods.li_2020 import Constants
    from dcfp.methods.pulses import PulsePrediction

#: Part of the hysteretic energy before and after the strong part of a response [-].
_WEAK = 0.02
#: How strongly pulses and swings are shaded in each colour [-].
_SHADES = {style.BLUE: 0.16, style.OCHRE: 0.3}


@style.styled
def plot_pulses(
    case: "Case",
    march: "PulseMarch | None" = None,
    *,
    response: "Response | None" = None,
    constants: "Constants | None" = None,
) -> "Figure":
    """Draw the pulses of one record at one PGV, the velocities and the displacement on a new figure.

    Parameters
    ----------
    case
        What was analysed and predicted.
    march
        March through the pulses with its path, to be drawn over the analysis.
    response
        The analysis; by default the one that the case kept.
    constants
        Of the pulse method; by default those of Li et al. (2020).

    Raises
    ------
    InputError
        If there is no analysis to draw.
    """
    part = StrongPart.of(case, response)
    figure = style.new_figure(5.6)
    panels: Any = figure.subplots(3, 1, sharex=True, height_ratios=[1.25, 1.0, 1.0])
    part.draw_pulses(panels[0], case.pulses)
    _name_pulses(panels[0], case, constants)
    part.draw_velocities(panels[1])
    part.draw_displacement(panels[2])
    part.shade(panels[2])
    style.legend_above(panels[1])
    if march is not None:
        label = rf"pulse march, $\Delta y$ {millimetres(march.prediction.displacement_change)}"
        look: dict[str, Any] = {"linestyle": (0, (4, 2)), "label": label}
        style.draw_line(panels[2], march.time, march.displacement, style.RED, 0.8, **look)
        between_equal_limits(panels[2], part.response.displacement, march.displacement)
        style.legend_above(panels[2])
    part.limit_time(list(panels))
    title = f"{style.drawable(case.record)},  PGV {metres_per_second(case.pgv)}"
    style.write_title(figure, title, weight="bold")
    return figure


def _name_pulses(axes: "Axes", case: "Case", constants: "Constants | None") -> None:
    """Shade the pulse that governs by the method, and the one that the analysis found, and say what they are."""
    from dcfp.methods import li_2020  # late: the package of predictions imports the kernels

    used = li_2020.LI_2020 if constants is None else constants
    predicted = li_2020.predict_from_pulses(case.pulses, used)
    governs, found = predicted.governing, case.analysed.pulse
    both = governs is not None and governs == found
    marked = [(governs, style.BLUE, f"governs by the pulse method{' and in the analysis' if both else ''}")]
    if not both:
        marked.append((found, style.OCHRE, "behind the largest swing of the analysis"))
    handles: list[Patch] = []
    for number, colour, what in marked:
        if number is None:
            handles.append(Patch(color="none", label=f"{what}: none"))
            continue
        mark_pulse(axes, predicted.pulses, number, colour)
        words = _words(predicted, number, used.friction_deceleration)
        handles.append(Patch(color=colour, label=f"{what}:  {words}"))
    axes.legend(handles=handles, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=1)


def _words(predicted: "PulsePrediction", number: int, friction: float) -> str:
    pulses, moved = predicted.pulses, float(predicted.displacement_change[number])
    change, slope = abs(float(pulses.changes[number])), abs(float(pulses.mean_accelerations[number]))
    words = (
        rf"$|\Delta v_g|$ {metres_per_second(change)}",
        rf"$k_g$ {quantity('ground_velocity_slope').display(slope):.2f} m/s²",
        rf"$k_u/k_g$ {friction / slope:.2f}",
        rf"$\Delta y_{{\mathrm{{pre}}}}$ {millimetres(moved)}",
    )
    return ",  ".join(words)


def mark_pulse(axes: "Axes", pulses: "Pulses", number: int, colour: str) -> None:
    """Shade the time of a pulse, and draw its lines thick; pulses are counted from zero."""
    places = slice(number, number + 3)
    times = pulses.times[places]
    _shade(axes, float(times[0]), float(times[-1]), colour)
    velocities = quantity("ground_velocity").display(pulses.velocities[places])
    style.draw_line(axes, times, velocities, colour, 1.2, marker="o", markersize=3.0, zorder=4)


def _shade(axes: "Axes", start: float, end: float, colour: str) -> None:
    axes.axvspan(start, end, color=colour, alpha=_SHADES[colour], linewidth=0.0, zorder=0)


def response_of(case: "Case") -> "Response":
    """Return the analysis that a case kept.

    Raises
    ------
    InputError
        If it kept none.
    """
    if case.response is None:
        msg = f"{case.record}: the analysis was not kept; compare with keep_response=True to draw it."
        raise InputError(msg)
    return case.response


@dataclass(frozen=True, eq=False)
class StrongPart:
    """The part of an analysis in which nearly all of the energy is dissipated, from its first to its last time [s], and its largest swing; None where it never turns."""

    response: "Response"
    swing: "Swing | None"
    limits: tuple[float, float]

    @classmethod
    def of(cls, case: "Case", response: "Response | None" = None) -> "StrongPart":
        """Return the strong part of an analysis, by default of the one that the case kept."""
        response, swing = response_of(case) if response is None else response, case.analysed.swing
        time, dissipated = response.time, response.energy.hysteretic
        whole = float(dissipated[-1])
        if whole == 0.0 or swing is None:
            part = shown(response)
            return cls(response, swing, (float(time[part.start]), float(time[part.stop - 1])))
        first, last = np.interp((_WEAK * whole, (1.0 - _WEAK) * whole), dissipated, time)
        first, last = min(float(first), swing.start), max(float(last), swing.end)
        margin = 0.06 * (last - first)
        return cls(response, swing, (max(0.0, first - margin), min(float(time[-1]), last + margin)))

    def draw(
        self, axes: "Axes", along: str, colours: "Mapping[str, str]", words: str = "", *, middle: bool = True
    ) -> "list[FloatArray]":
        """Draw histories by their names in a width at which their waves stay apart, with zero in the middle; return their values as they are shown."""
        span = self.limits[1] - self.limits[0]
        width = 0.9 if span < 15.0 else 0.7 if span < 40.0 else 0.5
        drawn: list[FloatArray] = []
        for name, colour in colours.items():
            entry = self.response.histories[name]
            drawn.append(entry.display(entry.of(self.response)))
            label = words or f"${entry.symbol}$"
            style.draw_line(axes, self.response.time, drawn[-1], colour, width, label=label)
        axes.set_ylabel(quantity(along).label)
        if middle:
            between_equal_limits(axes, *drawn)
        return drawn

    def draw_pulses(self, axes: "Axes", pulses: "Pulses") -> None:
        """Draw the ground velocity and its peaks, joined by straight lines."""
        self.draw(axes, "ground_velocity", {"ground_velocity": style.GREY})
        peaks = quantity("ground_velocity").display(pulses.velocities)
        style.draw_line(axes, pulses.times, peaks, style.BLUE, 0.6, marker="o", markersize=2.4, zorder=3)

    def draw_velocities(self, axes: "Axes") -> None:
        """Draw the velocities of ground and structure; the area between them is the displacement, that of the swing filled."""
        drawn = self.draw(axes, "velocity", {"ground_velocity": style.GREY, "structure_velocity": style.BLUE})
        self._fill(axes, *drawn)

    def draw_relative_velocity(self, axes: "Axes") -> None:
        """Draw the relative velocity; the area below it is the displacement, that of the swing filled."""
        (velocity,) = self.draw(axes, "velocity", {"velocity": style.BLUE})
        self._fill(axes, np.zeros_like(velocity), velocity)

    def draw_displacement(self, axes: "Axes") -> None:
        """Draw the displacement, with the change of the swing from peak to peak."""
        (displacement,) = self.draw(axes, "displacement", {"displacement": style.BLUE}, "analysis")
        if self.swing is not None:
            time, inside = self._during(displacement)
            _mark_change(axes, time[[0, -1]].tolist(), inside[[0, -1]].tolist())
            self._name_swing(axes, rf"$\Delta y$ {millimetres(abs(self.swing.change))}")

    def draw_energy(self, axes: "Axes") -> None:
        """Draw hysteretic and input energy, with what is put in from the start of the swing to its largest."""
        names = {"hysteretic_energy": style.GREY, "input_energy": style.INK}
        _, energy = self.draw(axes, "input_energy", names, middle=False)
        if self.swing is not None:
            time, inside = self._during(energy)
            ends = [0, int(inside.argmax())]
            _mark_change(axes, time[ends].tolist(), inside[ends].tolist())
            symbol = quantity("swing_input_velocity").symbol
            self._name_swing(axes, rf"$\Delta E$:  ${symbol}$ {metres_per_second(self.swing.input_velocity)}")
        lowest = min(0.0, float(energy.min()))
        axes.set_ylim(lowest, max(1.25 * float(energy.max()), lowest + 1e-3))
        axes.legend(loc="upper left", borderaxespad=0.7)

    def _fill(self, axes: "Axes", below: "FloatArray", above: "FloatArray") -> None:
        if self.swing is not None:
            area = rf"area $=\Delta y=$ {millimetres(abs(self.swing.change))}"
            time, low, high = self._during(below, above)
            axes.fill_between(time, low, high, color=style.OCHRE, alpha=0.7, linewidth=0.0, label=area)

    def _during(self, *histories: "FloatArray") -> "tuple[FloatArray, ...]":
        """Return time and histories from the start of the swing to its end, both of which lie between samples."""
        time, swing = self.response.time, self.swing
        assert swing is not None
        inside = (swing.start < time) & (time < swing.end)
        times = np.concatenate(([swing.start], time[inside], [swing.end]))
        return times, *(np.interp(times, time, values) for values in histories)

    def shade(self, axes: "Axes") -> None:
        """Shade the time of the swing."""
        if self.swing is not None:
            _shade(axes, self.swing.start, self.swing.end, style.OCHRE)

    def _name_swing(self, axes: "Axes", words: str) -> None:
        assert self.swing is not None
        place = (0.5 * (self.swing.start + self.swing.end), 0.985)
        look: dict[str, Any] = {"ha": "center", "va": "top", "annotation_clip": True, "zorder": 5}
        axes.annotate(words, place, xycoords=axes.get_xaxis_transform(), **look)

    def limit_time(self, panels: "Sequence[Axes]") -> None:
        """Give panels above each other the same times, and only the lowest the name of the axis."""
        for axes in panels:
            axes.set_xlim(*self.limits)
            style.calm_ticks(axes, 8, 4)
        panels[-1].set_xlabel(quantity("time").label)
        figure: Any = panels[0].get_figure()
        figure.align_ylabels(list(panels))


def _mark_change(axes: "Axes", times: list[float], values: list[float]) -> None:
    """Mark two points of a history, and with an arrow the difference of their values."""
    (_, end), (first, last) = times, values
    style.draw_marks(axes, times, values, "o", 2.6, style.INK, zorder=4)
    style.draw_line(axes, times, (first, first), style.INK, 0.5, linestyle=(0, (2, 2)), zorder=3)
    arrow = {"arrowstyle": "<->", "color": style.INK, "linewidth": 0.7, "shrinkA": 0.0, "shrinkB": 0.0}
    axes.annotate("", (end, last), (end, first), arrowprops=arrow)
