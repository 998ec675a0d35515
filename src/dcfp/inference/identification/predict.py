"""Tests that were held out, predicted by the law that was found without them."""

import itertools
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from dcfp.analysis.rig import Cycle, Program, Recorded, RigTest, VerticalLoad, run_program
from dcfp.analysis.rig.measures import measured_cycles
from dcfp.arrays import FloatArray
from dcfp.inference.identification.friction_history import FrictionHistory
from dcfp.schema.notebook import card, with_units
from dcfp.system import Bearing, FrictionLaw, Heating

#: What is compared of each cycle, its unit, and where it is found.
_MEASURES: tuple[tuple[str, Callable[[Cycle], float]], ...] = (
    ("keff_kN_mm", lambda cycle: cycle.effective_stiffness / 1e3),
    ("energy_kN_m", lambda cycle: cycle.energy / 1e6),
    ("friction_at_zero", lambda cycle: cycle.friction),
)


@dataclass(frozen=True, eq=False)
class _PredictedHistory:
    """The motion and the load that were measured, and the force by the law."""

    time: FloatArray
    displacement: FloatArray
    force: FloatArray
    load: FloatArray
    cycle_times: FloatArray


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

    def rows(self) -> list[dict[str, str | float | None]]:
        """Return for each cycle its measures: measured, predicted and the ratio of predicted to measured."""
        return [
            {
                "test": self.name,
                "cycle": number,
                "force_error": self.force_error,
                **_compared(measured, predicted),
            }
            for number, (measured, predicted) in enumerate(
                zip(self.measured, self.predicted, strict=True), start=1
            )
        ]

    def _repr_html_(self) -> str:
        rows = [with_units(row) for row in self.rows()]
        return card(f"Test {self.name} by the law", {"force_error": self.force_error}, rows=rows)


def _compared(measured: Cycle, predicted: Cycle) -> dict[str, float | None]:
    pairs = {name: (of(measured), of(predicted)) for name, of in _MEASURES}
    values = itertools.chain.from_iterable(
        ((f"{name}_measured", m), (f"{name}_predicted", p), (f"{name}_ratio", p / m if m else np.nan))
        for name, (m, p) in pairs.items()
    )
    return {name: float(value) if np.isfinite(value) else None for name, value in values}


def predict(history: FrictionHistory, bearing: Bearing, law: FrictionLaw, heating: Heating) -> Prediction:
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
    (loops,) = run_program(
        Program("held out", (test,)), replace(bearing, displacement_capacity=None), law, heating
    )
    bounds = measurement.cycle_times
    motion = (measurement.time, history.displacement)
    return Prediction(
        history=history,
        force=loops.force,
        friction=loops.friction,
        temperature=loops.temperature,
        measured=measured_cycles(_PredictedHistory(*motion, measurement.force, history.load, bounds)),
        predicted=measured_cycles(_PredictedHistory(*motion, loops.force, history.load, bounds)),
    )
