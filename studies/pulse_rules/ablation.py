"""What each part of the march contributes, and what its nodes, steps and time do."""

import timeit
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
import own_march
from cases import PGVS
from numpy.typing import NDArray

from dcfp import ConstantFriction, Li2020, NoHeating, SimplifiedHeating, respond
from dcfp import system as model
from dcfp.analysis import Response
from dcfp.inference.statistics import Scatter, scatter
from dcfp.methods import Nodes, Prediction, Pulses, find_nodes, march_through_pulses
from dcfp.methods.li_2020 import LI_2020, predict_from_pulses
from dcfp.system import LI_2020 as BEARING
from dcfp.system.plates import system_constants

TOLERANCES = (0.02, 0.03, 0.05, 0.075, 0.1, 0.12, 0.15, 0.2)
PARTS = (1, 2, 4, 8, 24)
CONSTANT = ConstantFriction(LI_2020.nominal_friction)
#: No pull: plates of a kilometre.
FLAT = replace(BEARING, radii=(1e6, 1e6))

System = Callable[[Pulses], Prediction]


def own(cosine: bool, spring: bool) -> Callable[[Pulses | Nodes], Prediction]:
    """Return the study's own march with constant friction."""
    structure = system_constants(model.System(BEARING, CONSTANT))
    friction = LI_2020.nominal_friction * structure.gravity
    choice = own_march.Choice(cosine, friction, structure.restoring if spring else 0.0)
    return lambda ground: own_march.march(ground, choice)


#: From the pulse method to the march, a step at a time, between the peaks of pulses.
LADDER: dict[str, System] = {
    "pulse method, each pulse by itself": lambda pulses: predict_from_pulses(pulses).largest,
    "straight legs, one after the other, mu_n, no spring": own(cosine=False, spring=False),
    "spring (a)": own(cosine=False, spring=True),
    "speed, at 20 °C": lambda pulses: (
        march_through_pulses(pulses, friction=Li2020(), heating=NoHeating()).prediction
    ),
    "and heat": lambda pulses: march_through_pulses(pulses).prediction,
    "half cosines in place of straight legs, spring (a), mu_n": own(cosine=True, spring=True),
}
#: The same between nodes, and the march without one of its parts.
BETWEEN_NODES: dict[str, Callable[[Response], Prediction]] = {
    "nodes of 0.1 PGV in place of peaks": lambda one: (
        march_through_pulses(find_nodes(one.motion, fitted=False)).prediction
    ),
    "fitted by least squares: the march": lambda one: march_through_pulses(one.motion).prediction,
    "the march without spring (a)": lambda one: march_through_pulses(one.motion, FLAT).prediction,
}
LAWS = {
    "the record itself, mu_n": (CONSTANT, NoHeating()),
    "the record itself, speed": (Li2020(), NoHeating()),
}


@dataclass(frozen=True)
class Row:
    """Ratios to the full analysis.

    Attributes
    ----------
    change, displacement, energy
        Of dy, y and V_dE, all cases.
    by_pgv
        Dispersion of dy at each PGV.
    without
        Cases in which nothing was predicted to move.
    """

    change: Scatter
    displacement: Scatter
    energy: Scatter
    by_pgv: tuple[float, ...]
    without: int


def row(
    said: Sequence[Prediction],
    responses: Sequence[Response],
    inputs: Sequence[float],
    counted: NDArray[np.bool_] | None = None,
) -> Row:
    """Return the ratios of predictions to analyses, of which `inputs` are V_dE [mm/s], of the cases that are `counted`."""
    counted = np.ones(len(said), dtype=np.bool_) if counted is None else counted
    changes = np.array([one.displacement_change for one in said])
    ratios = changes / [r.peak_change for r in responses]
    places = np.array([one.bound for one in said]) / [r.peak_displacement for r in responses]
    energies = np.array([one.input_velocity for one in said]) / np.array(inputs)
    groups = zip(np.split(ratios, len(PGVS)), np.split(counted, len(PGVS)), strict=True)
    return Row(
        scatter(ratios[counted]),
        scatter(places[counted]),
        scatter(energies[counted]),
        tuple(scatter(group[there]).dispersion for group, there in groups),
        int((changes == 0.0).sum()),
    )


def ladder(
    pulses: Sequence[Pulses], responses: Sequence[Response], inputs: Sequence[float]
) -> dict[str, Row]:
    """Return the table of contributions for pulses of one threshold, and between nodes, of the cases that every row moves."""
    said = {name: [model(one) for one in pulses] for name, model in LADDER.items()}
    said |= {name: [model(one) for one in responses] for name, model in BETWEEN_NODES.items()}
    changes = np.array([[one.displacement_change for one in some] for some in said.values()])
    counted = (changes > 0.0).all(axis=0)
    return {name: row(some, responses, inputs, counted) for name, some in said.items()}


def records_themselves(responses: Sequence[Response], inputs: Sequence[float]) -> dict[str, Row]:
    """Return rows of analyses of the whole record with simpler friction."""
    found: dict[str, Row] = {}
    for name, (friction, heating) in LAWS.items():
        simpler = [respond(one.motion, friction=friction, heating=heating) for one in responses]
        said = [Prediction(one.peak_change, 1.0, 1.0, one.peak_displacement) for one in simpler]
        found[name] = row(said, responses, inputs)
    return found


def own_against_package(nodes: Sequence[Nodes], parts: int) -> tuple[float, float]:
    """Return mean and largest |ln| of the study's march over the package's, dy, constant friction."""
    model = own(cosine=False, spring=True)
    found = np.log(
        [
            model(one).displacement_change
            / march_through_pulses(
                one, friction=CONSTANT, heating=NoHeating(), parts=parts
            ).prediction.displacement_change
            for one in nodes
        ]
    )
    return float(found.mean()), float(np.abs(found).max())


@dataclass(frozen=True)
class Fineness:
    """The march with one tolerance and number of steps in a leg; median number of nodes, mean time of the march alone [us]; dispersion of V_E."""

    row: Row
    nodes: float
    microseconds: float
    total: Scatter


def fineness(
    tolerance: float, parts: int, responses: Sequence[Response], inputs: Sequence[float]
) -> Fineness:
    """March with a tolerance and a number of steps in a leg, the best of three times."""
    nodes = [find_nodes(one.motion, tolerance) for one in responses]
    said: list[Prediction] = []

    def run() -> None:
        said[:] = [
            march_through_pulses(one, heating=SimplifiedHeating(), parts=parts).prediction for one in nodes
        ]

    seconds = min(timeit.repeat(run, number=1, repeat=3)) / len(nodes)
    totals = np.array([one.total_velocity for one in said]) / [one.input_velocity for one in responses]
    return Fineness(
        row(said, responses, inputs),
        float(np.median([one.count for one in nodes])),
        1e6 * seconds,
        scatter(totals),
    )


def call_times(responses: Sequence[Response]) -> dict[str, float]:
    """Return mean times [s] of whole calls from Python: analysis, nodes, march; the best of three rounds."""
    motions = [one.motion for one in responses]
    nodes = [find_nodes(motion) for motion in motions]
    calls = {
        "analysis": lambda: [respond(motion) for motion in motions],
        "nodes": lambda: [find_nodes(motion) for motion in motions],
        "march": lambda: [march_through_pulses(one) for one in nodes],
    }
    return {name: min(timeit.repeat(call, number=1, repeat=3)) / len(motions) for name, call in calls.items()}
