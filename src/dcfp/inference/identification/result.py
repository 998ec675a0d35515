"""What an identification gives: constants with their intervals, tests that were held out beside the law, and a bearing file."""

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any, cast

import numpy as np
import tomli_w

from dcfp.analysis.rig import Cycle, Program, Recorded, RigTest, VerticalLoad, run_program
from dcfp.analysis.rig.measures import ForceHistory, cycles_of
from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.inference.identification.fit import CONFIDENCE, PARAMETERS, ResidualStatistics, unit_of
from dcfp.inference.identification.friction_history import FrictionHistory
from dcfp.schema.notebook import card, told
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table, csv_text
from dcfp.schema.units import DEGC, KN_M, KN_PER_MM, MM_PER_S, N_PER_MM2, NONE, PERCENT
from dcfp.system import System, UserFriction
from dcfp.system.friction import FittedFriction


@dataclass(frozen=True)
class Constant:
    """A constant of the law or of the plates, in its own unit."""

    name: str
    value: float

    @property
    def unit(self) -> str:
        """Its unit, empty for a number."""
        return unit_of(self.name)


@dataclass(frozen=True)
class Estimate(Constant):
    """A constant that was fitted, with its standard error and its 95 % interval, by leaving out strokes."""

    standard_error: float
    lower: float
    upper: float

    @property
    def words(self) -> str:
        """What it is."""
        return PARAMETERS[self.name].words


@dataclass(frozen=True)
class Held(Constant):
    """A constant that was not fitted, and why."""

    reason: str


#: What is told of an estimate, of a constant that was held, and of what the law leaves unexplained of a test; each number in its own unit.
ESTIMATES = [
    Quantity("name", "parameter", head="Fitted", get="name"),
    Quantity("unit", "its unit", get="unit", printed=False),
    Quantity("words", "what it is", get="words", printed=False),
    Quantity("value", "estimate", NONE, digits=5, head="Estimate\n", get="value"),
    Quantity("standard_error", "standard error", NONE, digits=5, head="Std. error\n", get="standard_error"),
    Quantity("lower", "lower end of the interval", NONE, digits=5, head="95 % from\n", get="lower"),
    Quantity("upper", "upper end of the interval", NONE, digits=5, head="to\n", get="upper"),
    Quantity("Unit", "its unit", get=lambda one: one.unit or "-", stored=False),
]
HELD = [
    Quantity("name", "constant", head="Held", get="name"),
    Quantity("unit", "its unit", get="unit", printed=False),
    Quantity("value", "value", NONE, digits=5, head="Value\n", get="value"),
    Quantity("Unit", "its unit", get=lambda one: one.unit or "-", stored=False),
    Quantity("reason", "why it was not fitted", head="Why", get="reason"),
]
RESIDUALS = [
    Quantity("name", "test", head="Test", get="name"),
    Quantity("pressure", "mean pressure", N_PER_MM2, decimals=1, head="p", get="pressure"),
    Quantity("peak_speed", "largest speed", MM_PER_S, decimals=0, head="v_max", get="peak_speed"),
    Quantity("peak_temperature", "highest temperature", DEGC, decimals=0, head="T_max", get="peak_temperature"),
    Quantity("samples", "samples that were used", NONE, head="used\n", get="samples"),
    Quantity("left_out", "samples that were not", NONE, head="left out\n", get="left_out"),
    Quantity("scatter", "root mean square of measured less fitted", NONE, decimals=5, get="scatter"),
    Quantity("relative_scatter", "the same over the mean coefficient", NONE, PERCENT, 2, head="of mu", get="relative_scatter"),
    Quantity("bias", "mean of measured less fitted", NONE, decimals=5, head="mean", get="bias", signed=True),
    Quantity("correlation", "correlation of each residual with the next", NONE, decimals=2, head="lag-1 corr.", get="correlation"),
    Quantity("speed_window", "length of the filter of the speed", NONE, get="speed_window", printed=False),
    Quantity("load_window", "length of the filter of the load", NONE, get="load_window", printed=False),
]  # fmt: skip
#: What is compared of each cycle of a test that was held out.
COMPARED = [
    Quantity("keff_kN_mm", "effective stiffness", KN_PER_MM, decimals=3, head="k_eff", get="effective_stiffness"),
    Quantity("energy_kN_m", "energy per cycle", KN_M, decimals=1, head="E", get="energy"),
    Quantity("friction_at_zero", "coefficient at zero displacement", NONE, decimals=4, head="mu at 0", get="friction"),
]  # fmt: skip


@dataclass(frozen=True, eq=False)
class Prediction:
    """A test that was held out, beside force [N], coefficient [-] and temperature [degC] by the law found without it."""

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


def predicted_table(predictions: Sequence[Prediction]) -> Table:
    """Return a line for each cycle of the tests that were held out: each measure as it was measured, as it is predicted, and their ratio."""
    rows: list[dict[str, Any]] = []
    for one in predictions:
        for number, (measured, predicted) in enumerate(zip(one.measured, one.predicted, strict=True), 1):
            row: dict[str, Any] = {"test": one.name, "cycle": number, "force_error": one.force_error}
            for measure in COMPARED:
                before, after = measure.of(measured), measure.of(predicted)
                row[f"{measure.key}_measured"], row[f"{measure.key}_predicted"] = before, after
                first, last = measure.datum(measured), measure.datum(predicted)
                row[f"{measure.key}_ratio"] = last / first if first and last is not None else math.nan
            rows.append(row)
    columns = [
        Quantity("test", "name of the test", head="Held out"),
        Quantity("cycle", "number of the cycle", NONE, head="Cycle\n"),
        Quantity("force_error", "difference of the forces over the largest", NONE, printed=False),
    ]
    for one in COMPARED:
        columns += [
            replace(one, key=f"{one.key}_measured", get=None),
            replace(one, key=f"{one.key}_predicted", head="predicted\n", get=None),
            Quantity(f"{one.key}_ratio", "predicted over measured", NONE, decimals=3, head="ratio\n"),
        ]
    return Table(tuple(columns), rows)


def predict(history: FrictionHistory, system: System) -> Prediction:
    """Drive the bearing along the motion of a test, under its load, both without their noise.

    The cycles of both are between the times at which the measured displacement passes zero.
    """
    measurement = history.measurement
    test = RigTest(
        history.name,
        Recorded(measurement.time, history.displacement),
        VerticalLoad(tuple(history.load.tolist()), tuple(measurement.time.tolist()), is_pressure=False),
    )
    # what was measured did not go beyond the plate
    free = replace(system, bearing=replace(system.bearing, displacement_capacity=None))
    (loops,) = run_program(Program("held out", (test,)), free)
    motion, bounds = (measurement.time, history.displacement), measurement.cycle_times
    return Prediction(
        history=history,
        force=loops.force,
        friction=loops.friction,
        temperature=loops.temperature,
        measured=cycles_of(ForceHistory(*motion, measurement.force, history.load, bounds)),
        predicted=cycles_of(ForceHistory(*motion, loops.force, history.load, bounds)),
    )


@dataclass(frozen=True, eq=False)
class Identification:
    """A law of friction from measured tests.

    Attributes
    ----------
    system
        The bearing that was tested, with the estimates in its law and heating model.
    estimates, held
        Parameters that were fitted, and constants that were not.
    correlation
        Of the estimates, in their order, shape (parameters, parameters).
    blocks
        Number of blocks of samples that the intervals come from.
    histories, temperatures, residuals
        Of the tests that were fitted, the temperature of the contact with the conductivity that was found
        [degC].
    predictions
        Of the tests that were held out.
    remarks
        What must be known of the result.
    """

    system: System
    estimates: tuple[Estimate, ...]
    held: tuple[Held, ...]
    correlation: FloatArray
    blocks: int
    histories: tuple[FrictionHistory, ...]
    temperatures: tuple[FloatArray, ...]
    residuals: tuple[ResidualStatistics, ...]
    predictions: tuple[Prediction, ...]
    remarks: tuple[str, ...]

    @property
    def law(self) -> FittedFriction:
        """Law that was found."""
        return cast("FittedFriction", self.system.friction)

    def fitted(self, test: int) -> FloatArray:
        """Return the coefficient of the law along a test [-]."""
        history = self.histories[test]
        return self.law.coefficient(history.pressure, history.speed, self.temperatures[test])

    def estimate(self, name: str) -> Estimate:
        """Return one estimate by its name."""
        return next(one for one in self.estimates if one.name == name)

    def summary(self) -> dict[str, object]:
        """Return what JSON holds."""
        heating, names = self.system.heating, [one.name for one in self.estimates]
        return {
            "estimates": Table(tuple(ESTIMATES), self.estimates).objects(),
            "held": Table(tuple(HELD), self.held).objects(),
            "confidence": CONFIDENCE,
            "blocks": self.blocks,
            "correlation": {
                name: dict(zip(names, row, strict=True))
                for name, row in zip(names, np.asarray(self.correlation).tolist(), strict=True)
            },
            "residuals": Table(tuple(RESIDUALS), self.residuals).objects(),
            "predictions": predicted_table(self.predictions).objects(),
            "bearing": asdict(self.system.bearing),
            "friction": {"law": self.law.name, **asdict(self.law)},
            "heating": {"model": heating.name, **asdict(heating)},
            "remarks": list(self.remarks),
        }

    def csv(self) -> str:
        """Return a line for each constant, fitted or held."""
        names = ("value", "standard_error", "lower", "upper", "reason", "words")
        return csv_text(
            ("name", "unit", *names[:4], "held", "words"),
            (
                (one.name, one.unit or "-", *(getattr(one, name, None) for name in names))
                for one in (*self.estimates, *self.held)
            ),
        )

    def _repr_html_(self) -> str:
        rows = Table(tuple(ESTIMATES), self.estimates).objects()
        return card(f"Friction law of {self.system.bearing.name}", rows=rows, remarks=self.remarks)


def bearing_file(system: System, notes: tuple[str, ...] = ()) -> str:
    """Return the text of a bearing file that `read_bearing` reads back, with lines of comment at its head.

    The numbers are the same, but for the elastic stiffness, whose last digit may change: the file has it in kN/mm.

    Raises
    ------
    InputError
        If the law is a function of its own, which a file cannot hold.
    """
    law = system.friction
    if isinstance(law, UserFriction):
        msg = f"The law {law.label!r} is a function, which a bearing file cannot hold; give one of the laws that have a name."
        raise InputError(msg)
    lines = [f"# {' '.join(note.split())}" for note in notes]
    return "\n".join([*lines, tomli_w.dumps(system.to_table())])
