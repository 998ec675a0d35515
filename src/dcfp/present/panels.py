"""Panels: what is drawn of histories, tests and pulses, described once; the figures and the page draw the same descriptions."""

from dataclasses import dataclass, replace
from itertools import cycle
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.schema.nomenclature import quantity
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import METRE, MM, NONE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dcfp.analysis import Response
    from dcfp.analysis.rig import Loops
    from dcfp.inference.design_space import DesignSpace
    from dcfp.methods import Pulses

    #: What has a displacement, a force, friction and temperature over time.
    History: TypeAlias = Response | Loops

#: Colours by the names that figures and the page have shades for.
BLUE, OCHRE, RED, GREEN, GREY, INK = "blue", "ochre", "red", "green", "grey", "ink"
SKY, SILVER = "sky", "silver"
#: Colours of several tests or records, in their order.
SERIES = (BLUE, OCHRE, RED, GREEN, GREY)

#: Part of the capacity from which on it is drawn [-].
_NEAR_CAPACITY = 0.6
#: Part of the hysteretic energy, or of the peak velocity of the ground, below which nothing of note happens [-].
_LITTLE, _QUIET = 0.001, 0.05
#: Part of the time at the start that has to be quiet before it is left out [-].
_LONG_START = 0.2
#: Rise of the temperature, relative to the highest one, that is shown at least [-].
_COOL = 0.01
#: Displacements [mm] and forces over the weight [-] at which a design chart has lines, and the part of its height at which they are named.
_LEVELS = (25.0, 50.0, 75.0, 100.0, 150.0, 200.0, 300.0, 400.0, 500.0, 600.0, 800.0, 1000.0, 1500.0, 2000.0)
_FORCES = (0.04, 0.06, 0.08, 0.1, 0.125, 0.15, 0.2, 0.25, 0.3, 0.4)
_NAMED, _FORCES_NAMED, _SIDE = 0.75, 0.3, 0.03
_MU = Quantity("mu", "reference coefficient of friction", NONE)
_RADIUS = Quantity("radius", "radius of each plate", MM, METRE)
_TIME, _DISPLACEMENT, _FORCE = quantity("time"), quantity("displacement"), quantity("force")


@dataclass(frozen=True, eq=False)
class Line:
    """A line of a panel.

    Attributes
    ----------
    x, y
        In the units of the package; a gap where a value is not a number.
    colour
        Its name.
    words
        In a legend; empty for none.
    symbol
        The same in mathematics, for a legend where there is little room.
    width
        [pt].
    dashed, marked
        Whether it is dashed, and whether each of its points is marked.
    opacity
        [-].
    level
        Of a line of equal values, what they are and the value.
    place
        Number of the point at which that is written; None where it is not.
    """

    x: FloatArray
    y: FloatArray
    colour: str
    words: str = ""
    symbol: str = ""
    width: float = 0.9
    dashed: bool = False
    marked: bool = False
    opacity: float = 1.0
    level: tuple[Quantity, float] | None = None
    place: int | None = None

    @property
    def label(self) -> str:
        """What a small legend says of it."""
        return f"${self.symbol}$" if self.symbol else self.words


@dataclass(frozen=True, eq=False)
class Picture:
    """Values on a grid, in colours.

    Attributes
    ----------
    shows
        What they are.
    x, y
        Coordinates of the columns and the rows.
    values
        Shape (rows, columns).
    ends
        Values of the first and the last colour.
    """

    shows: Quantity
    x: FloatArray
    y: FloatArray
    values: FloatArray
    ends: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Panel:
    """One pair of axes and what is drawn on it, in the units of the package.

    Attributes
    ----------
    words
        What stands along the vertical axis, in words.
    x, y
        What the axes show.
    lines
        What is drawn, the lowest first.
    stacked
        How many of the first lines stand on top of each other, filled.
    path
        Whether the lines are paths in a plane, such as loops, and not histories.
    across
        Ends of the horizontal axis of paths, where they are not those of the lines.
    low, high
        Ends of the vertical axis where they are not those of the lines.
    middle
        Whether zero is in the middle, with a thin line.
    capacity
        Displacement capacity, where the peak comes near it.
    sliding
        Where along the first line the bearing slides.
    peak
        Whether the largest value of the first line is written beside it.
    picture, areas
        Below the lines: an image, and polygons that are filled, each with points in its rows.
    limit
        What the values are not to exceed.
    """

    words: str
    x: Quantity
    y: Quantity
    lines: tuple[Line, ...]
    stacked: int = 0
    path: bool = False
    across: tuple[float, float] | None = None
    low: float | None = None
    high: float | None = None
    middle: bool = False
    capacity: float | None = None
    sliding: Any = None
    peak: bool = False
    picture: Picture | None = None
    areas: tuple[FloatArray, ...] = ()
    limit: float | None = None


def equal_limits(largest: float, shown: Quantity) -> dict[str, Any]:
    """Return limits with zero in the middle, and room beyond the largest value."""
    limit = 1.3 * largest if largest > 0.0 else shown.shown.inner(1.0)
    return {"low": -limit, "high": limit, "middle": True}


# How much of a history is worth showing, and how.


def shown(history: "History") -> slice:
    """Return the samples in which something happens; of a test all of them.

    Those of an analysis end a little after the last thousandth of the hysteretic energy, or after the ground has become quiet where
    nothing slides; a long quiet start is left out.
    """
    samples = int(history.time.size)
    places = np.flatnonzero(_busy(history)) if hasattr(history, "motion") else np.empty(0)
    if places.size < 2:
        return slice(0, samples)
    first, last = int(places[0]), int(places[-1])
    margin = 2 + (last - first) // 12
    start = max(0, first - margin) if first > _LONG_START * last else 0
    return slice(start, min(samples, last + margin))


def _busy(response: Any) -> Any:
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


def values_of(history: "History", name: str) -> FloatArray:
    """Return a history of an analysis or a test by its name in the nomenclature, in the units of the package."""
    energy = getattr(history, "energy", None)
    if name.endswith("_energy") and energy is not None:
        return getattr(energy, name.removesuffix("_energy"))
    return getattr(history, name)


def _line(history: "History", name: str, colour: str, words: str = "", **more: Any) -> Line:
    part = shown(history)
    symbol = quantity(name).symbol if words else ""
    look: dict[str, Any] = {"symbol": symbol, "width": line_width(history), **more}
    return Line(history.time[part], values_of(history, name)[part], colour, words, **look)


# Panels of one analysis or test.


def velocities(response: "Response") -> Panel:
    """Velocities of the ground and of the structure, with the times of sliding shaded."""
    names = ("ground_velocity", "structure_velocity")
    lines = (
        _line(response, names[0], GREY, "ground"),
        _line(response, names[1], BLUE, "structure"),
    )
    largest = max(float(np.abs(values_of(response, name)).max()) for name in names)
    along = quantity("velocity")
    sliding = response.sliding[shown(response)] != 0.0
    return Panel("velocity", _TIME, along, lines, sliding=sliding, **equal_limits(largest, along))


def displacement(history: "History") -> Panel:
    """Displacement with its peak, and the capacity where the peak comes near it."""
    line = _line(history, "displacement", BLUE)
    capacity = _near_capacity(history)
    largest = max(float(np.abs(line.y).max()), capacity or 0.0)
    return Panel("displacement", _TIME, _DISPLACEMENT, (line,), capacity=capacity, peak=True, **equal_limits(largest, _DISPLACEMENT))  # fmt: skip


def _near_capacity(history: "History") -> float | None:
    capacity = history.bearing.displacement_capacity
    near = capacity is not None and history.peak_displacement > _NEAR_CAPACITY * capacity
    return capacity if near else None


def temperature(history: "History") -> Panel:
    """Temperature of the contact."""
    ambient = history.heating.ambient
    flat = float(np.ptp(history.temperature)) < 1.0
    ends: dict[str, Any] = {"low": ambient - 5.0, "high": ambient + 5.0} if flat else {}
    along = quantity("temperature")
    return Panel(along.words, _TIME, along, (_line(history, "temperature", RED),), **ends)


def friction(history: "History") -> Panel:
    """Coefficient of friction: at work while it slides, faint where it only has to be overcome."""
    part = shown(history)
    sticking = _line(history, "friction", SILVER, "sticking", symbol="")
    values = np.where(history.sliding[part] != 0.0, sticking.y, np.nan)
    sliding = replace(sticking, y=values, colour=OCHRE, words="sliding")
    along = quantity("friction")
    return Panel(along.words, _TIME, along, (sticking, sliding), low=0.0, high=1.12 * float(sticking.y.max()))


def energies(response: "Response") -> Panel:
    """Hysteretic, strain and kinetic energies on top of each other, and the input energy as a line."""
    total = _line(response, "input_energy", INK, "input", width=min(line_width(response), 0.7))
    parts = (
        _line(response, "hysteretic_energy", OCHRE, "friction"),
        _line(response, "strain_energy", SKY, "elastic"),
        _line(response, "kinetic_energy", BLUE, "kinetic"),
    )
    low = min(0.0, float(total.y.min()))
    return Panel("energy", _TIME, quantity("input_energy"), (*parts, total), stacked=len(parts), low=low)


def loop(history: "History") -> Panel:
    """Force against displacement."""
    part = shown(history)
    line = Line(history.displacement[part], history.force[part], BLUE, width=line_width(history))
    return Panel("force", _DISPLACEMENT, _FORCE, (line,), path=True, capacity=_near_capacity(history))


def profile(history: "History", plate: int = 0) -> Panel:
    """Temperature along a plate over time, with the path of the slider's centre.

    Raises
    ------
    InputError
        If the analysis kept no profiles.
    """
    profiles = history.profiles
    if profiles is None:
        msg = "There are no profiles; analyse with the precise heating model and keep=Keep(profiles=200)."
        raise InputError(msg)
    part = shown(history)
    path = Line(
        history.time[part], history.bearing.shares[plate] * history.displacement[part], "white", width=0.4
    )
    values = profiles.temperature[:, plate, :]
    rise = values.max(axis=0) - history.heating.ambient
    warm = profiles.position[rise > _COOL * max(float(rise.max()), 1e-9)]
    reach = 1.1 * float(np.abs(warm).max()) if warm.size else 0.0
    low, high = (-reach, reach) if warm.size else (float(profiles.position[0]), float(profiles.position[-1]))
    ends = colour_ends(history, "temperature")
    picture = Picture(quantity("plate_temperature"), profiles.time, profiles.position, values.T, ends)
    along = quantity("plate_position")
    return Panel(along.words, _TIME, along, (path,), low=low, high=high, picture=picture)


def warms(history: "History") -> bool:
    """Whether the contact becomes so warm that colours show its temperature rather than the time."""
    return float(history.temperature.max()) - history.heating.ambient > 1.0


def colour_ends(history: "History", shows: str) -> tuple[float, float]:
    """Return the ends of the colours of a loop, ``"temperature"`` or ``"time"``, which the temperature of the plates shares."""
    if shows == "time":
        time = history.time[shown(history)]
        return float(time[0]), float(time[-1])
    highest = float(history.temperature.max())
    if history.profiles is not None:
        highest = max(highest, float(history.profiles.temperature.max()))
    ambient = history.heating.ambient
    return min(ambient, float(history.temperature.min())), max(highest, ambient + 1.0)


# Panels of pulses, and of several tests.


def pulses(response: "Response", found: "Pulses", governing: int | None) -> Panel:
    """Ground velocity with its pulses, and the one that governs."""
    ground = _line(response, "ground_velocity", GREY, "ground velocity")
    inside = (found.times >= ground.x[0]) & (found.times <= ground.x[-1])
    lines = [
        ground,
        Line(found.times[inside], found.velocities[inside], BLUE, "pulses", dashed=True, marked=True),
    ]
    if governing is not None:
        whole = slice(governing, governing + 3)
        lines.append(Line(found.times[whole], found.velocities[whole], RED, "governing pulse", width=2.4))
    along = quantity("ground_velocity")
    return Panel("velocity", _TIME, along, tuple(lines))


def loops(tests: "Sequence[Loops]") -> Panel:
    """Force against displacement of several tests."""
    lines = tuple(
        Line(test.displacement, test.force, colour, test.test.name)
        for test, colour in zip(tests, cycle(SERIES), strict=False)
    )
    return Panel("force", _DISPLACEMENT, _FORCE, lines, path=True)


def temperatures(tests: "Sequence[Loops]") -> Panel:
    """Temperature of the contact over the time of each of several tests."""
    lines = tuple(
        Line(test.time, test.temperature, colour, test.test.name)
        for test, colour in zip(tests, cycle(SERIES), strict=False)
    )
    along = quantity("temperature")
    return Panel(along.words, _TIME, along, lines)


# Panels of a design chart.


def design(space: "DesignSpace", allowed: float, part: float) -> Panel:
    """Lines of equal displacement and of equal force over the weight, over friction and radius; where `allowed` [mm] holds with a probability of `part` [-] it is filled."""
    from contourpy import FillType, contour_generator  # late: it comes with Matplotlib

    displacement, lines = space.displacement_at(part), list[Line]()
    for level in _LEVELS:
        if abs(level - allowed) > 1e-9:
            lines += _contours(space, displacement, _DISPLACEMENT, level, BLUE)
    for level in _FORCES:
        ratio = quantity("force_ratio")
        lines += _contours(
            space, space.force_at(part), ratio, level, GREY, _FORCES_NAMED, dashed=True, width=0.7
        )
    lines += _contours(space, displacement, _DISPLACEMENT, allowed, RED, width=1.4)
    filled = contour_generator(space.coefficients, space.radii, displacement, fill_type=FillType.OuterCode)
    areas = tuple(np.asarray(one) for one in filled.filled(-np.inf, allowed)[0] if one is not None)
    ends: dict[str, Any] = {"low": float(space.radii[0]), "high": float(space.radii[-1])}
    return Panel(
        _RADIUS.words, _MU, _RADIUS, tuple(lines), path=True, across=_across(space), **ends, areas=areas
    )


def _across(space: "DesignSpace") -> tuple[float, float]:
    return float(space.coefficients[0]), float(space.coefficients[-1])


def _contours(
    space: "DesignSpace",
    values: FloatArray,
    one: Quantity,
    level: float,
    colour: str,
    height: float = _NAMED,
    **look: Any,
) -> list[Line]:
    """Return the lines of one value; it is written at the point, not at the sides, that is nearest to a part of the height."""
    from contourpy import contour_generator

    if not float(values.min()) < level < float(values.max()):
        return []
    (left, right), (low, high) = _across(space), space.radii[[0, -1]].tolist()
    drawn: dict[str, Any] = {"width": 0.8, **look}
    found: list[Line] = []
    away: list[FloatArray] = []
    for path in contour_generator(space.coefficients, space.radii, values).lines(level):
        x, y = (_refined(np.asarray(path)[:, column]) for column in (0, 1))
        inside = np.abs((x - left) / (right - left) - 0.5) < 0.5 - _SIDE
        away.append(np.where(inside, np.abs((y - low) / (high - low) - height), np.inf))
        found.append(Line(x, y, colour, level=(one, level), **drawn))
    nearest = min(range(len(found)), key=lambda i: float(away[i].min()))
    if np.isfinite(away[nearest].min()):
        found[nearest] = replace(found[nearest], place=int(away[nearest].argmin()))
    return found


def _refined(values: FloatArray, parts: int = 8) -> FloatArray:
    """Return the values along a path at points between its own too."""
    at = np.arange(parts * (values.size - 1) + 1) / parts
    return np.interp(at, np.arange(values.size), values)


def design_curves(space: "DesignSpace", allowed: float, part: float) -> Panel:
    """Displacement against friction, a line for each radius, the strongest the smallest, and what is allowed."""
    shades = np.linspace(1.0, 0.35, space.radii.size).tolist()
    rows = zip(space.radii.tolist(), space.displacement_at(part), shades, strict=True)
    lines = tuple(
        Line(space.coefficients, values, BLUE, f"{radius / 1e3:g} m", width=1.6, opacity=shade)
        for radius, values, shade in rows
    )
    ends: dict[str, Any] = {"across": _across(space), "limit": allowed}
    return Panel("displacement", _MU, _DISPLACEMENT, lines, path=True, **ends)
