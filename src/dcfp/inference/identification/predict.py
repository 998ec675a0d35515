"""Tests that were held out, predicted by the law that was found without them."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from dcfp.analysis.rig import Cycle, Program, Recorded, RigTest, VerticalLoad, run_program
from dcfp.analysis.rig.measures import ForceHistory, measured_cycles
from dcfp.arrays import FloatArray
from dcfp.inference.identification.friction_history import FrictionHistory
from dcfp.schema.notebook import card, told
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import KN_M, KN_PER_MM, NONE
from dcfp.system import System

#: What is compared of each cycle.
COMPARED = [
    Quantity(
        "keff_kN_mm", "effective stiffness", KN_PER_MM, decimals=3, head="k_eff", get="effective_stiffness"
    ),
    Quantity("energy_kN_m", "energy per cycle", KN_M, decimals=1, head="E", get="energy"),
    Quantity(
        "friction_at_zero",
        "coefficient at zero displacement",
        NONE,
        decimals=4,
        head="mu at 0",
        get="friction",
    ),
]


@dataclass(frozen=True, eq=False)
class Prediction:
    """A test by the law, beside what was measured.

    Attributes
    ----------
    history
        What was measured.
    force
        Horizontal force by the law [N].
    friction, temperature
        Coefficient [-] and temperature of the contact [degC] by the law.
    measured, predicted
        Measures of each cycle.
    """

    history: FrictionHistory
    force: FloatArray
    friction: FloatArray
    temperature: FloatArray
    measured: tuple[Cycle, ...]
    predicted: tuple[Cycle, ...]

    @property
    def name(self) -> str:
        """Name of the test."""
        return self.history.name

    @property
    def force_error(self) -> float:
        """Root mean square of the difference of the forces over the largest measured one [-]."""
        measured = self.history.measurement.force
        return float(np.sqrt(np.mean((self.force - measured) ** 2)) / np.abs(measured).max())

    def rows(self) -> list[dict[str, Any]]:
        """Return for each cycle its measures: measured, predicted and the ratio of predicted to measured."""
        return predicted_table([self]).objects()

    def _repr_html_(self) -> str:
        table = predicted_table([self])
        rows = [told(table.columns, row) for row in table.results]
        return card(f"Test {self.name} by the law", {"force_error": self.force_error}, rows=rows)


class PredictedCycle(NamedTuple):
    """A cycle that was measured, and the same by the law."""

    of: Prediction
    number: int
    measured: Cycle
    predicted: Cycle


def predicted_table(predictions: Sequence[Prediction]) -> Table:
    """Return a line for each cycle of the tests that were held out."""
    cycles = [
        PredictedCycle(one, number, *pair)
        for one in predictions
        for number, pair in enumerate(zip(one.measured, one.predicted, strict=True), 1)
    ]
    columns = (
        Quantity("test", "name of the test", head="Held out", get="of.name"),
        Quantity("cycle", "number of the cycle", NONE, head="Cycle\n", get="number"),
        Quantity(
            "force_error",
            "difference of the forces over the largest",
            NONE,
            get="of.force_error",
            printed=False,
        ),
        *(column for one in COMPARED for column in _beside(one)),
    )
    return Table(columns, cycles)


def _beside(one: Quantity) -> tuple[Quantity, ...]:
    """Return a measure as it was measured, as it is predicted, and the ratio of the latter to the former."""

    def measured(cycle: PredictedCycle) -> float:
        return one.of(cycle.measured)

    def predicted(cycle: PredictedCycle) -> float:
        return one.of(cycle.predicted)

    def ratio(cycle: PredictedCycle) -> float:
        before, after = one.datum(cycle.measured), one.datum(cycle.predicted)
        return after / before if before and after is not None else math.nan

    return (
        replace(one, key=f"{one.key}_measured", get=measured),
        replace(one, key=f"{one.key}_predicted", head="predicted\n", get=predicted),
        Quantity(f"{one.key}_ratio", "predicted over measured", NONE, decimals=3, head="ratio\n", get=ratio),
    )


def predict(history: FrictionHistory, system: System) -> Prediction:
    """Drive the bearing along the motion of a test, under its load, both without their noise.

    The cycles of both are taken between the same times, those at which the measured displacement passes zero; the force that was measured is as it is.
    """
    measurement = history.measurement
    test = RigTest(
        history.name,
        Recorded(measurement.time, history.displacement, history.name),
        VerticalLoad(tuple(history.load.tolist()), tuple(measurement.time.tolist()), is_pressure=False),
    )
    # what was measured did not go beyond the plate
    free = replace(system, bearing=replace(system.bearing, displacement_capacity=None))
    (loops,) = run_program(Program("held out", (test,)), free)
    bounds = measurement.cycle_times
    motion = (measurement.time, history.displacement)
    return Prediction(
        history=history,
        force=loops.force,
        friction=loops.friction,
        temperature=loops.temperature,
        measured=measured_cycles(ForceHistory(*motion, measurement.force, history.load, bounds)),
        predicted=measured_cycles(ForceHistory(*motion, loops.force, history.load, bounds)),
    )
