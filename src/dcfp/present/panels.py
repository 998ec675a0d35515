"""Panels: what is drawn of histories, tests and pulses, described once; the figures and the page draw the same descriptions."""

from dataclasses import dataclass, replace
from itertools import cycle
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from contourpy import FillType, contour_generator

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.schema.quantities import Quantity, quantity
from dcfp.schema.units import METRE, MM, NONE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dcfp.analysis import Response
    from dcfp.analysis.plane_response import PlaneResponse
    from dcfp.analysis.response import RigidResponse
    from dcfp.analysis.rig import Loops
    from dcfp.inference.design_space import DesignSpace
    from dcfp.methods import Pulses

    #: What has a displacement, a force, friction and temperature over time.
    History: TypeAlias = RigidResponse | Loops

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
_TIME, _DISPLACEMENT = quantity("time"), quantity("displacement")


@dataclass(frozen=True, eq=False)
class Line:
    """A line of a panel, in the units of the package, with a gap where a value is not a number.

    Its colour has a name; a legend says its words, or where there is little room its symbol; its width is in pt. Of a line of equal values
    `level` says what they are and the value, which is written at the point of number `place`, if there is one.
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
    """Values on a grid of shape (rows, columns) in colours, the first and the last of which stand for the `ends`."""

    shows: Quantity
    x: FloatArray
    y: FloatArray
    values: FloatArray
    ends: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Panel:
    """One pair of axes and what is drawn on it, in the units of the package; over time unless `x` is something else.

    Attributes
    ----------
    lines
        What is drawn, the lowest first.
    words
        What stands along the vertical axis; by default the words of the quantity.
    stacked
        How many of the first lines stand on top of each other, filled.
    across
        Ends of the horizontal axis of paths, where they are not those of the lines.
    low, high
        Ends of the vertical axis, where they are not those of the lines.
    middle
        Largest value of an axis with zero in its middle.
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

    y: Quantity
    lines: tuple[Line, ...]
    words: str = ""
    x: Quantity = _TIME
    stacked: int = 0
    across: tuple[float, float] | None = None
    low: float | None = None
    high: float | None = None
    middle: float | None = None
    capacity: float | None = None
    sliding: Any = None
    peak: bool = False
    picture: Picture | None = None
    areas: tuple[FloatArray, ...] = ()
    limit: float | None = None

    @property
    def title(self) -> str:
        """What stands along the vertical axis, in words."""
        return self.words or self.y.words

    @property
    def path(self) -> bool:
        """Whether the lines are paths in a plane, such as loops, and not histories."""
        return self.x is not _TIME


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


def _width(time: FloatArray) -> float:
    """Return the width [pt] at which the waves of a history stay apart."""
    span = float(time[-1] - time[0])
    return 0.9 if span < 25.0 else 0.7 if span < 60.0 else 0.5


def _line(history: "History", name: str, colour: str, words: str = "", **more: Any) -> Line:
    """Draw one of the histories of a result by its name; `more` are other fields of a line."""
    part, one = shown(history), history.histories[name]
    time = history.time[part]
    look: dict[str, Any] = {"symbol": one.symbol if words else "", "width": _width(time), **more}
    return Line(time, one.of(history)[part], colour, words, **look)


# Panels of one analysis or test.


def velocities(response: "Response") -> Panel:
    """Velocities of the ground and of the structure, with the times of sliding shaded."""
    lines = (
        _line(response, "ground_velocity", GREY, "ground"),
        _line(response, "structure_velocity", BLUE, "structure"),
    )
    largest = max(float(np.abs(one).max()) for one in (response.ground_velocity, response.structure_velocity))
    sliding = response.sliding[shown(response)] != 0.0
    return Panel(quantity("velocity"), lines, "velocity", sliding=sliding, middle=largest)


def directions(response: "PlaneResponse", name: str) -> Panel:
    """Both components of a history in the plane and, where it has one, their resultant."""
    components = (
        _line(response, f"{name}_x", BLUE, "direction x"),
        _line(response, f"{name}_y", OCHRE, "direction y"),
    )
    resultant = (_line(response, name, INK, "resultant"),) if name in response.histories else ()
    largest = max(float(np.abs(line.y).max()) for line in (*components, *resultant))
    return Panel(quantity(name), (*components, *resultant), middle=largest)


def displacement(history: "History") -> Panel:
    """Displacement with its peak, and the capacity where the peak comes near it."""
    line, capacity = _line(history, "displacement", BLUE), _near_capacity(history)
    largest = max(float(np.abs(line.y).max()), capacity or 0.0)
    return Panel(_DISPLACEMENT, (line,), "displacement", capacity=capacity, peak=True, middle=largest)


def _near_capacity(history: "History") -> float | None:
    capacity = history.bearing.displacement_capacity
    near = capacity is not None and history.peak_displacement > _NEAR_CAPACITY * capacity
    return capacity if near else None


def temperature(history: "History") -> Panel:
    """Temperature of the contact."""
    ambient = history.heating.ambient
    flat = float(np.ptp(history.temperature)) < 1.0
    ends: dict[str, Any] = {"low": ambient - 5.0, "high": ambient + 5.0} if flat else {}
    return Panel(quantity("temperature"), (_line(history, "temperature", RED),), **ends)


def friction(history: "History") -> Panel:
    """Coefficient of friction: at work while it slides, faint where it only has to be overcome."""
    part = shown(history)
    sticking = _line(history, "friction", SILVER, "sticking", symbol="")
    values = np.where(history.sliding[part] != 0.0, sticking.y, np.nan)
    sliding = replace(sticking, y=values, colour=OCHRE, words="sliding")
    return Panel(quantity("friction"), (sticking, sliding), low=0.0, high=1.12 * float(sticking.y.max()))


def energies(response: "RigidResponse") -> Panel:
    """Hysteretic, strain and kinetic energies on top of each other, and the input energy as a line."""
    total = _line(response, "input_energy", INK, "input")
    total = replace(total, width=min(total.width, 0.7))
    parts = (
        _line(response, "hysteretic_energy", OCHRE, "friction"),
        _line(response, "strain_energy", SKY, "elastic"),
        _line(response, "kinetic_energy", BLUE, "kinetic"),
    )
    low = min(0.0, float(total.y.min()))
    return Panel(quantity("input_energy"), (*parts, total), "energy", stacked=len(parts), low=low)


def loop(history: "History") -> Panel:
    """Force against displacement."""
    part = shown(history)
    line = Line(history.displacement[part], history.force[part], BLUE, width=_width(history.time[part]))
    return Panel(quantity("force"), (line,), "force", _DISPLACEMENT, capacity=_near_capacity(history))


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
    centre = history.bearing.shares[plate] * history.displacement[part]
    path = Line(history.time[part], centre, "white", width=0.4)
    values = profiles.temperature[:, plate, :]
    rise = values.max(axis=0) - history.heating.ambient
    warm = profiles.position[rise > _COOL * max(float(rise.max()), 1e-9)]
    reach = 1.1 * float(np.abs(warm).max()) if warm.size else 0.0
    low, high = (-reach, reach) if warm.size else (float(profiles.position[0]), float(profiles.position[-1]))
    ends = colour_ends(history, "temperature")
    picture = Picture(quantity("plate_temperature"), profiles.time, profiles.position, values.T, ends)
    return Panel(quantity("plate_position"), (path,), low=low, high=high, picture=picture)


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
    return Panel(quantity("ground_velocity"), tuple(lines), "velocity")


def of_tests(tests: "Sequence[Loops]", up: str, across: str = "time", words: str = "") -> Panel:
    """One history of several tests against another, such as force against displacement, by their names."""
    lines = tuple(
        Line(getattr(test, across), getattr(test, up), colour, test.test.name)
        for test, colour in zip(tests, cycle(SERIES), strict=False)
    )
    return Panel(quantity(up), lines, words, quantity(across))


def design(space: "DesignSpace", allowed: float, part: float) -> Panel:
    """Lines of equal displacement and of equal force over the weight, over friction and radius; where `allowed` [mm] holds with a probability of `part` [-] it is filled."""
    displacement, lines = space.displacement_at(part), list[Line]()
    for level in _LEVELS:
        if abs(level - allowed) > 1e-9:
            lines += _contours(space, displacement, _DISPLACEMENT, level, BLUE)
    look: dict[str, Any] = {"height": _FORCES_NAMED, "dashed": True, "width": 0.7}
    for level in _FORCES:
        lines += _contours(space, space.force_at(part), quantity("force_ratio"), level, GREY, **look)
    lines += _contours(space, displacement, _DISPLACEMENT, allowed, RED, width=1.4)
    filled = contour_generator(space.coefficients, space.radii, displacement, fill_type=FillType.OuterCode)
    areas = tuple(np.asarray(one) for one in filled.filled(-np.inf, allowed)[0] if one is not None)
    ends: dict[str, Any] = {"low": float(space.radii[0]), "high": float(space.radii[-1])}
    return Panel(_RADIUS, tuple(lines), x=_MU, across=_across(space), **ends, areas=areas)


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
    return Panel(_DISPLACEMENT, lines, "displacement", _MU, across=_across(space), limit=allowed)
