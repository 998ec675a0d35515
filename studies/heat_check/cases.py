"""The load cases, on the paper's model of the plate and on models that lack one of its simplifications."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from motions import AMBIENT, HALF_SIDE, RADIUS, Motion, Outcome, earthquake, friction_at, march, sine
from plate_fe import Array, Patch, Plate, across, along, both_ways, depth, disc, even, strip

MODEL = "half-space, 1-D, square (the paper's)"
CENTRE = "centre of the plate (simplified model)"
PLANAR = "conduction along the sliding, 2-D, square"
ROUND = "round contact, 1-D"
SOLID = "round contact, 3-D"
SHEET = "3 mm sheet on a carbon steel body, 1-D"
THICKNESSES = (30.0, 50.0, 80.0, 100.0)
#: Sheet [mm]; conductivity (50 N/(s degC)) and heat capacity of carbon steel over those of stainless steel.
BODY = (3.0, 3.1, 1.0)
DEEP = 300.0  # [mm], endless within two minutes

Maker = Callable[[float], tuple[Plate, Patch]]


def plate_name(thickness: float, cold: bool) -> str:
    """Return the name of a plate of finite thickness in tables."""
    return f"{thickness:.0f} mm, back {'at ambient' if cold else 'insulated'}"


def square(conducts: bool = False, **line: object) -> Maker:
    """Return a maker of a planar plate with room for a reach [mm], and of the square contact on it."""

    def make(reach: float) -> tuple[Plate, Patch]:
        x = along(both_ways(even(reach, 4.0)), conducts)
        plate = Plate(x, across(), depth(**{"thickness": DEEP, **line}))
        return plate, strip(plate, HALF_SIDE)

    return make


def circle(conducts: bool = True, edge: float = 0.0, **line: object) -> Maker:
    """Return a maker of a plate in 3-D, up to an insulated `edge` [mm], and of the round contact on it."""

    def make(reach: float) -> tuple[Plate, Patch]:
        x = along(both_ways(even(reach, 5.0, edge or None)), conducts)
        y = along(even(RADIUS + 5.0, 5.0, (edge or RADIUS + 100.0) if conducts else None), conducts)
        plate = Plate(x, y, depth(**{"thickness": DEEP, "growth": 1.6, **line}))
        return plate, disc(plate, RADIUS)

    return make


def finite() -> dict[str, Maker]:
    """Return the plates of finite thickness, one-dimensional."""
    return {
        plate_name(thickness, cold): square(thickness=thickness, cold_back=cold)
        for thickness in THICKNESSES
        for cold in (False, True)
    }


def reach_of(motion: Motion) -> float:
    """Return how far from the middle the contact's edge gets, with a margin [mm]."""
    return float(np.abs(motion.position).max()) + RADIUS + 20.0


def motions() -> list[Motion]:
    """Return the load cases with known flux."""
    return [sine("T01", 200.0, 400.0, 4, 600, 0.043), earthquake("NCC", 500.0), earthquake("IVD", 1000.0)]


def known_flux(motion: Motion) -> dict[str, Array]:
    """Return histories of the contact temperature [degC] by plate, all under the motion's flux."""
    makers = {
        MODEL: square(),
        PLANAR: square(conducts=True),
        ROUND: circle(conducts=False),
        SOLID: circle(),
        **finite(),
        SHEET: square(body=BODY),
    }
    histories: dict[str, Array] = {}
    for name, make in makers.items():
        outcome = march(motion, *make(reach_of(motion)))
        histories[name] = outcome.contact
        if name == MODEL:
            histories[CENTRE] = outcome.centre
    return histories


def fed_back(motion: Motion) -> dict[str, Outcome]:
    """Return outcomes by model of the plate and of friction, which now depends on temperature."""
    runs: dict[str, tuple[Maker, str]] = {
        f"{MODEL}, mu(mean T)": (square(), "mean"),
        f"{CENTRE}, mu(T there)": (square(), "centre"),
        f"{PLANAR}, mu(mean T)": (square(conducts=True), "mean"),
        "half-space, 1-D, square, mu(local T)": (square(), "local"),
        f"{SOLID}, mu(mean T)": (circle(), "mean"),
        f"{SOLID}, mu(local T)": (circle(), "local"),
        f"{plate_name(30.0, False)}, mu(mean T)": (square(thickness=30.0), "mean"),
        f"{SHEET}, mu(mean T)": (square(body=BODY), "mean"),
        "the same sheet, round, 3-D, mu(local T)": (circle(body=BODY), "local"),
    }
    free = replace(motion, flux=None)
    return {name: march(free, *make(reach_of(motion)), how) for name, (make, how) in runs.items()}


@dataclass(frozen=True)
class Long:
    """Twenty cycles and an hour of rest: times [s], and contact temperatures [degC] by plate."""

    heating_time: Array
    rest_time: Array
    heating: dict[str, Array]
    rest: dict[str, Array]

    def onset(self, name: str, difference: float) -> float:
        """Return the time [s] when a plate gets off the half-space by more than so much [degC] (or NaN)."""
        time = np.concatenate((self.heating_time, self.heating_time[-1] + self.rest_time))
        gap = np.concatenate((self.heating[name] - self.heating[MODEL], self.rest[name] - self.rest[MODEL]))
        past = np.flatnonzero(np.abs(gap) > difference)
        return float(time[past[0]]) if past.size else np.nan


def long_rest() -> Long:
    """Return 20 cycles of 300 mm at 439 mm/s and an hour of rest, under the flux of the paper's model."""
    free = sine("20 cycles", 300.0, 439.0, 20, 300, None)
    reach = reach_of(free)
    friction = march(free, *square()(reach), "mean").friction
    motion = replace(free, flux=0.5 * friction * 60.0 * free.slip)
    makers = {MODEL: square(thickness=1500.0), **finite()}
    makers[SOLID + ", deep"] = circle(edge=1000.0, thickness=1500.0)
    for thickness in (50.0, 100.0):
        for cold in (False, True):
            name = f"{plate_name(thickness, cold)}, round, 3-D"
            makers[name] = circle(edge=500.0, thickness=thickness, cold_back=cold)
    rest_time = np.geomspace(1.0, 3600.0, 120)
    heating, rest = {}, {}
    for name, make in makers.items():
        plate, patch = make(reach)
        heating[name] = march(motion, plate, patch).contact
        covered = patch.at(0.0)
        means = [(plate.surface(after) * covered).sum() / covered.sum() for after in rest_time]
        rest[name] = AMBIENT + np.array(means)
    return Long(free.time, rest_time, heating, rest)


@dataclass(frozen=True)
class Surface:
    """The surface after T01, with the slider back in the middle; temperatures [degC].

    Attributes
    ----------
    x, y
        Nodes [mm].
    round
        Under a round contact, with conduction in three dimensions, shape (x, y).
    line_x, line
        Nodes [mm] and temperatures under the square contact, one-dimensional.
    mean, diameter, weighted
        Means of `round` over the contact, over its diameter along the sliding, and weighted with the power
        of friction that depends on the local temperature.
    """

    x: Array
    y: Array
    round: Array
    line_x: Array
    line: Array
    mean: float
    diameter: float
    weighted: float


def surface_after() -> Surface:
    """Return the surface after T01 under a friction of 0.043."""
    motion = sine("T01", 200.0, 400.0, 4, 300, 0.043)
    plate, patch = circle()(reach_of(motion))
    march(motion, plate, patch)
    temperatures = AMBIENT + plate.surface()
    covered = patch.at(0.0)
    power = covered * friction_at(400.0, temperatures)
    chord = strip(plate, RADIUS).at(0.0)[:, 0]
    flat, side = square()(reach_of(motion))
    march(motion, flat, side)
    return Surface(
        x=plate.x.nodes,
        y=plate.y.nodes,
        round=temperatures,
        line_x=flat.x.nodes,
        line=AMBIENT + flat.surface()[:, 0],
        mean=float((temperatures * covered).sum() / covered.sum()),
        diameter=float((temperatures[:, 0] * chord).sum() / chord.sum()),
        weighted=float((temperatures * power).sum() / power.sum()),
    )
