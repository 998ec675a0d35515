"""Which friction and which radius hold a displacement at a PGV: analyses of a record set over a grid of bearings."""

import math
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dcfp.analysis.batch import GroundSet, Lanes, available_threads, respond_in_batch
from dcfp.analysis.response import FAILED
from dcfp.arrays import FloatArray
from dcfp.errors import AnalysisError, InputError
from dcfp.inference.earthquake import event_of
from dcfp.methods.li_2020 import friction_that_holds
from dcfp.methods.li_2020.constants import Constants
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import M_PER_S, MM, NONE
from dcfp.system import System

#: Grid that is looked at unless another is given: radius of each plate [mm] and reference coefficient [-].
RADII = np.array([1500.0, 2250.0, 3000.0, 4500.0, 6000.0])
COEFFICIENTS = np.array([0.02, 0.03, 0.04, 0.05, 0.06, 0.075, 0.09, 0.105, 0.125, 0.15])
#: Probabilities for which the least coefficient is given [-].
PARTS = (0.5, 0.95)
#: Key of the nominal coefficient by the design method.
_NOMINAL = "nominal_friction_design_method"
#: Draws of earthquakes by which it is said how sure a coefficient is, and where their random numbers start.
_DRAWS, _SEED = 100, 33


@dataclass(frozen=True, eq=False)
class DesignSpace:
    """Displacement and force of every record over a grid of bearings, at one PGV [mm/s].

    Attributes
    ----------
    radii, coefficients
        Effective radius of each plate [mm], shape (r,), and reference coefficient of the friction law [-],
        shape (c,).
    displacement, force
        y_max of every record [mm], and its largest force over the weight [-], shape (r, c, records).
    events
        The earthquake of each record.
    """

    pgv: float
    radii: FloatArray
    coefficients: FloatArray
    displacement: FloatArray
    force: FloatArray
    events: tuple[str, ...]

    @property
    def records(self) -> int:
        """Number of records analysed for each bearing."""
        return self.displacement.shape[2]

    def displacement_at(self, part: float) -> FloatArray:
        """Return the y_max [mm] that another earthquake of this PGV does not exceed with a probability of `part` [-], shape (r, c)."""
        return _quantiles(self.displacement, part)

    def force_at(self, part: float) -> FloatArray:
        """Return the force over the weight [-] in the same sense, shape (r, c)."""
        return _quantiles(self.force, part)

    def holding(self, allowed: float, part: float) -> tuple[FloatArray, FloatArray]:
        """Return for each radius the least coefficient that holds `allowed` [mm] with a probability of `part` [-], and the force over the weight.

        Between the bearings of the grid both are straight lines; where its last is not enough, both are not a
        number.
        """
        least = self._least(self.displacement, allowed, part)
        force = np.empty(least.size)
        for i, line in enumerate(self.force_at(part)):
            force[i] = np.interp(least[i], self.coefficients, line)
        return least, force

    def spread(self, allowed: float, part: float) -> tuple[float, float]:
        """Return 5 and 95 % of the least coefficient [-], mean of the radii, had other earthquakes been in the set.

        Whole earthquakes are drawn with replacement; where no coefficient of the grid is enough, its largest
        counts.
        """
        numbers = np.random.default_rng(_SEED)
        names = sorted(set(self.events))
        members = [[i for i, event in enumerate(self.events) if event == name] for name in names]
        found: list[float] = []
        for _ in range(_DRAWS):
            places: list[int] = numbers.integers(len(names), size=len(names)).tolist()
            drawn = [i for place in places for i in members[place]]
            least = self._least(self.displacement[:, :, drawn], allowed, part)
            found.append(float(np.where(np.isnan(least), self.coefficients[-1], least).mean()))
        low, high = np.quantile(found, [0.05, 0.95])
        return float(low), float(high)

    def _least(self, displacement: FloatArray, allowed: float, part: float) -> FloatArray:
        lines = _quantiles(displacement, part)
        return np.array([_crossing(self.coefficients, line, allowed) for line in lines])


def _quantiles(values: FloatArray, part: float) -> FloatArray:
    """Return what the next value does not exceed with a probability of `part`, along the last axis; see `quantile`."""
    number = values.shape[-1]
    if part * (number + 1) > number:
        msg = f"What {100.0 * part:g} % of earthquakes do not exceed needs more than {number} records."
        raise InputError(msg)
    rank = max(part * (number + 1) - 1.0, 0.0)
    ordered = np.sort(values, axis=-1)
    low = min(int(rank), number - 2) if number > 1 else 0
    share = rank - low
    return (1.0 - share) * ordered[..., low] + share * ordered[..., min(low + 1, number - 1)]


def survey(
    motions: Sequence[GroundMotion],
    pgv: float,
    system: System,
    radii: FloatArray = RADII,
    coefficients: FloatArray = COEFFICIENTS,
    report: Callable[[], None] | None = None,
) -> DesignSpace:
    """Analyse every motion at a PGV [mm/s] on every bearing of a grid.

    Parameters
    ----------
    system
        The bearing whose radii are varied, equal on all plates, and the law whose reference coefficient is.
    radii, coefficients
        As in `DesignSpace`, increasing.
    report
        Called after each radius.

    Raises
    ------
    InputError
        If the friction law has no reference coefficient to vary.
    AnalysisError
        If an analysis cannot be finished.
    """
    grounds = GroundSet.of(motions)
    scales = np.array([[pgv / motion.peak_velocity] for motion in motions])
    laws = [system.friction.with_reference(coefficient) for coefficient in coefficients.tolist()]

    def analyse(radius: float) -> dict[str, Any]:
        plates = (radius,) * len(system.bearing.radii)
        bearing = replace(system.bearing, radii=plates, displacement_capacity=None, capacity_note="")
        models = [System(bearing, law, system.heating) for law in laws]
        peaks = respond_in_batch(grounds, Lanes.grid(len(motions), scales, models))
        if (peaks["status"] == FAILED).any():
            msg = f"An analysis with a radius of {radius:g} mm cannot be finished; look at the friction law {system.friction.title}."
            raise AnalysisError(msg)
        return peaks

    displacement = np.empty((radii.size, coefficients.size, len(motions)))
    force = np.empty_like(displacement)
    with ThreadPoolExecutor(available_threads()) as pool:
        for i, peaks in enumerate(pool.map(analyse, radii.tolist())):
            displacement[i] = peaks["peak_displacement"].reshape(len(motions), -1).T
            force[i] = peaks["force_ratio"].reshape(len(motions), -1).T
            if report is not None:
                report()
    return DesignSpace(pgv, radii, coefficients, displacement, force, tuple(map(event_of, motions)))


def _crossing(coefficients: FloatArray, displacement: FloatArray, allowed: float) -> float:
    """Return where the displacement falls to what is allowed for good [-]."""
    above = np.flatnonzero(displacement > allowed)
    if above.size == 0:
        return float(coefficients[0])
    last = int(above[-1])
    if last + 1 == coefficients.size:
        return math.nan
    share = (displacement[last] - allowed) / (displacement[last] - displacement[last + 1])
    return float(coefficients[last] + share * (coefficients[last + 1] - coefficients[last]))


def held_table(
    spaces: Sequence[DesignSpace],
    allowed: float,
    parts: Sequence[float] = PARTS,
    constants: Constants | None = None,
) -> Table:
    """Return a line for each PGV and radius: which coefficients hold a displacement [mm] with the probabilities of `parts` [-].

    With the constants of the design method its nominal coefficient stands beside them, and how sure they are.
    """
    of_design = constants is not None
    lines: list[dict[str, Any]] = []
    for space in spaces:
        grid_least = float(space.coefficients[0])
        line: dict[str, Any] = {"pgv_m_s": space.pgv, "allowed_mm": allowed, "least_of_the_grid": grid_least}
        if of_design:
            line["spread_low"], line["spread_high"] = space.spread(allowed, parts[-1])
            line[_NOMINAL] = line["mu_n"] = friction_that_holds(allowed, space.pgv, constants)
        found = {part: space.holding(allowed, part) for part in parts}
        for i, radius in enumerate(space.radii.tolist()):
            own = line | {"radius_mm": radius}
            for part, (coefficients, forces) in found.items():
                least, percent = float(coefficients[i]), f"{100 * part:g}"
                own[f"least_coefficient_{percent}_percent"] = least
                own[f"mu_{percent}"] = (
                    None if math.isnan(least) else f"{'≤ ' if least == grid_least else ''}{least:.3f}"
                )
                own[f"force_over_weight_{percent}_percent"] = float(forces[i])
            lines.append(own)
    columns = [
        Quantity("pgv_m_s", "peak ground velocity", M_PER_S, head="PGV", printed=of_design),
        Quantity("allowed_mm", "displacement that is to hold", MM, printed=False, stored=of_design),
        Quantity("radius_mm", "effective radius of each plate", MM, decimals=0, head="Radius"),
        Quantity(_NOMINAL, "nominal coefficient by the design method", NONE, printed=False, stored=of_design),
        Quantity("least_of_the_grid", "least coefficient of the grid", NONE, printed=False, stored=of_design),
        Quantity("spread_low", "5 % of the least coefficient", NONE, printed=False, stored=of_design),
        Quantity("spread_high", "95 % of the least coefficient", NONE, printed=False, stored=of_design),
        *(one for part in parts for one in _of_part(part)),
        Quantity("mu_n", "nominal coefficient by the design method", NONE, decimals=3, head="mu_n, Eq. (33)", stored=False, printed=of_design),
    ]  # fmt: skip
    return Table(tuple(columns), lines)


def _of_part(part: float) -> tuple[Quantity, ...]:
    """Return the least coefficient and the force that go with a probability."""
    words, percent = "half" if part == 0.5 else f"{100 * part:g} %", f"{100 * part:g}"
    return (
        Quantity(f"least_coefficient_{percent}_percent", "least reference coefficient", NONE, printed=False),
        Quantity(f"mu_{percent}", "least reference coefficient", NONE, head=f"mu, {words}", stored=False),
        Quantity(f"force_over_weight_{percent}_percent", "force over the weight", NONE, decimals=3, head=f"F/W, {words}"),
    )  # fmt: skip
