"""The figure of a test program: a sheet of one test, the loops of many tests, or the dependencies of friction after Figures 3, 4 and 7 of Li et al. (2020)."""

from itertools import cycle
from typing import TYPE_CHECKING, Any, NamedTuple, TypeGuard

import numpy as np

from dcfp.errors import InputError
from dcfp.present.figures import style
from dcfp.present.figures.drawing import draw_cross
from dcfp.present.figures.overviews import LINES, draw_model, name_models, plot_tests
from dcfp.present.figures.sheets import draw_measured, plot_test
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.analysis.rig import Loops, Measurement, Program


def plot_program(
    program: "Program", runs: "Mapping[str, Sequence[Loops]]", measured: "Mapping[str, Measurement]"
) -> "Figure":
    """Draw what fits the program, on a new figure.

    Parameters
    ----------
    program
        What was run.
    runs
        Its tests by the name of the model.
    measured
        Measured tests by the name of the test that they belong to.
    """
    first = next(iter(runs.values()))
    if len(runs) == 1 and len(first) == 1:
        return plot_test(first[0], measured.get(first[0].test.name))
    if dependency_tests(program) is not None:
        return plot_dependency(program, runs, measured)
    return plot_tests(program, runs, measured)


class DependencyTests(NamedTuple):
    """Places of the tests in a program that show what friction depends on."""

    velocity: int
    pressures: tuple[int, ...]


def dependency_tests(program: "Program") -> DependencyTests | None:
    """Return which tests of a program are for the velocity and which for the pressure; None where either is missing."""
    velocity = [i for i, test in enumerate(program.tests) if test.purpose == "velocity dependency"]
    pressures = [i for i, test in enumerate(program.tests) if test.purpose == "pressure dependency"]
    return DependencyTests(velocity[0], tuple(pressures)) if velocity and len(pressures) > 1 else None


@style.styled
def plot_dependency(
    program: "Program", runs: "Mapping[str, Sequence[Loops]]", measured: "Mapping[str, Measurement]"
) -> "Figure":
    """Draw the factors of pressure and velocity, the friction at zero displacement over time, and the loops of the fast test.

    Parameters
    ----------
    program
        With tests for ``velocity dependency`` and ``pressure dependency``.
    runs
        Its tests by the name of the model.
    measured
        Measured tests by the name of the test that they belong to.
    """
    places = dependency_tests(program)
    if places is None:
        msg = f"{program.name} has no tests for both 'velocity dependency' and 'pressure dependency'."
        raise InputError(msg)
    drawn = _Dependency(places, runs, measured)
    figure = style.new_figure(5.4)
    axes: Any = figure.subplots(2, 2)
    drawn.pressure(axes[0, 0])
    drawn.velocity(axes[0, 1])
    drawn.friction(axes[1, 0])
    drawn.loops(axes[1, 1])
    first = drawn.first[0]
    title = (
        f"{style.drawable(program.name)},  {style.drawable(first.bearing.name)},  {first.friction_law.name}"
    )
    style.write_title(figure, title)
    name_models(figure, list(runs), with_measured=bool(measured))
    return figure


class _Dependency:
    """What the panels of the dependencies have in common; `places` are those of the tests in the program."""

    def __init__(
        self,
        places: DependencyTests,
        runs: "Mapping[str, Sequence[Loops]]",
        measured: "Mapping[str, Measurement]",
    ) -> None:
        self.places, self.runs, self.measured = places, runs, measured
        self.first = next(iter(runs.values()))
        self.law = self.first[0].friction_law
        #: Histories of every model and of the measured tests, with their colours.
        self.all: list[tuple[Sequence[Loops | Measurement | None], str]] = [
            (loops, colour) for loops, (colour, _) in zip(runs.values(), cycle(LINES), strict=False)
        ]
        if measured:
            self.all.append(([measured.get(test.test.name) for test in self.first], style.GREY))

    def pressure(self, axes: "Axes") -> None:
        """Draw the factor of the pressure."""
        pressures = [float(test.load.mean()) / test.bearing.slider_area for test in self.first]
        slow = self.places.pressures
        middle = sorted(slow, key=lambda i: pressures[i])[len(slow) // 2]
        sigma = np.linspace(0.5 * min(pressures), 1.25 * max(pressures), 200)
        curve = self.law.pressure_factor(sigma) / self.law.pressure_factor(pressures[middle])
        style.draw_line(axes, sigma, curve, style.INK, 1.0, label=r"$\gamma$ of the law")
        self._points(axes, pressures, slow, middle, 2)
        axes.set_ylim(0.0, 1.15 * float(curve.max()))
        label = rf"$\mu\,/\,\mu$ at {pressures[middle]:.0f} N/mm²"
        style.label_axes(axes, "pressure on the slider [N/mm²]", label, 6, 5)
        axes.set_title("(a) pressure: slow tests, reduced by their heat", loc="left")
        axes.legend(loc="lower left")

    def velocity(self, axes: "Axes") -> None:
        """Draw the factor of the velocity."""
        fast, law = self.places.velocity, self.law
        speeds = [test.test.waveform.peak_velocity for test in self.first]
        share = min(self.first[0].bearing.shares) if law.speed_is_of_surface else 1.0
        speed = np.linspace(0.0, 1.1 * speeds[fast], 300)
        curve = law.velocity_factor(speed * share) / law.velocity_factor(speeds[fast] * share)
        style.draw_line(axes, speed, curve, style.INK, 1.0, label=r"$\alpha$ of the law")
        pressure = float(self.first[fast].load[0])
        same = [i for i in self.places.pressures if abs(float(self.first[i].load[0]) / pressure - 1.0) < 0.01]
        self._points(axes, speeds, (fast, *same), fast, 1)
        label = rf"$\mu\,/\,\mu$ at {speeds[fast]:.0f} mm/s"
        style.label_axes(axes, "relative velocity [mm/s]", label, 6, 5, ylim=(0.0, 1.3))
        axes.set_title("(b) velocity: first cycle, reduced by its heat", loc="left")
        axes.legend(loc="lower right")

    def _points(
        self, axes: "Axes", at: "Sequence[float]", chosen: "Sequence[int]", reference: int, number: int
    ) -> None:
        """Draw the friction of chosen tests in a cycle over that of the reference test."""
        for histories, colour in self.all:
            base = histories[reference]
            if base is None:
                continue
            scale = _friction_in(base, number)
            for i, one in enumerate(histories):
                if one is not None and i in chosen:
                    style.draw_marks(
                        axes, at[i], _friction_in(one, number) / scale, "o", 4, colour, alpha=0.85
                    )

    def friction(self, axes: "Axes") -> None:
        """Draw the friction at zero displacement over time."""
        for histories, colour in self.all:
            fast = histories[self.places.velocity]
            if fast is not None:
                crossings = fast.crossings
                friction = np.abs(crossings[:, 1]) / crossings[:, 2]
                style.draw_line(axes, crossings[:, 0], friction, colour, 0.7, marker="o", markersize=3.5)
        # late: the package of bearings imports the kernels
        from dcfp.system.friction.constant import NOMINAL_COEFFICIENT

        axes.axhline(NOMINAL_COEFFICIENT, color=style.RED, linewidth=0.7, linestyle=style.DASHED)
        look: dict[str, Any] = {"color": style.RED, "ha": "right", "va": "bottom"}
        words = r"$\mu_n = 0.043$, tests of Li et al."
        axes.text(0.985, 1.08 * NOMINAL_COEFFICIENT, words, transform=axes.get_yaxis_transform(), **look)
        ends: dict[str, Any] = {"xlim": (0.0, None), "ylim": (0.0, 1.25 * self.law.reference)}
        style.label_axes(axes, quantity("time").label, r"$\mu$ at zero displacement", 6, 5, **ends)
        name = self.first[self.places.velocity].test.name
        axes.set_title(f"(c) {name}: friction at zero displacement", loc="left")

    def loops(self, axes: "Axes") -> None:
        """Draw the loops of the fast test."""
        tests = [loops[self.places.velocity] for loops in self.runs.values()]
        name = tests[0].test.name
        if name in self.measured:
            draw_measured(axes, self.measured[name])
        for test, look in zip(tests, cycle(LINES), strict=False):
            draw_model(axes, test, look, slice(None), 0.8)
        _mark_second_cycle(axes, tests[0])
        draw_cross(axes)
        style.label_axes(axes, quantity("displacement").label, quantity("force").label, 5, 5)
        axes.set_title(f"(d) {name}: loops, c and d in the second cycle", loc="left")


def _friction_in(history: "Loops | Measurement", number: int) -> float:
    """Return the friction at zero displacement in a cycle, or in the last there is; where the temperature is known, as if it were cold."""
    place = min(number, len(history.cycles)) - 1
    friction = history.cycles[place].friction
    if not _is_loops(history):
        return friction
    first, last = history.cycle_times[place], history.cycle_times[place + 1]
    times = history.crossings[:, 0]
    inside = times[(times > 0.99 * first) & (times < first + 0.98 * (last - first))]
    heat = history.friction_law.temperature_factor(np.interp(inside, history.time, history.temperature))
    return friction / float(np.mean(heat))


def _is_loops(history: "Loops | Measurement") -> "TypeGuard[Loops]":
    return hasattr(history, "friction_law")


def _mark_second_cycle(axes: "Axes", test: "Loops") -> None:
    """Mark the points at zero displacement from which the nominal coefficient is taken."""
    if test.cycle_times.size < 3:
        return
    times, forces = test.crossings[:, 0], quantity("force").display(test.crossings[:, 1])
    first, last = test.cycle_times[1:3] - 1e-9 * test.time[-1]
    for height, letter in zip(forces[(times >= first) & (times < last)].tolist(), "cd", strict=False):
        style.draw_marks(axes, 0.0, height, "o", 4, style.INK, zorder=4)
        beside = (4, 4 if height > 0.0 else -9)
        axes.annotate(letter, (0.0, height), xytext=beside, textcoords="offset points", weight="bold")
