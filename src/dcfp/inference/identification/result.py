"""What an identification gives, and its bearing, friction law and heating model as a bearing file."""

from dataclasses import asdict, dataclass
from typing import cast

import numpy as np
import tomli_w

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.inference.identification.friction_history import FrictionHistory
from dcfp.inference.identification.intervals import CONFIDENCE
from dcfp.inference.identification.predict import Prediction
from dcfp.schema.notebook import card
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table, csv_text
from dcfp.schema.units import DEGC, MM_PER_S, N_PER_MM2, NONE, PERCENT
from dcfp.system import Bearing, Heating, System, UserFriction
from dcfp.system.friction import FittedFriction


@dataclass(frozen=True)
class Estimate:
    """A parameter that was fitted, in its own unit.

    Attributes
    ----------
    name, unit, words
        Of the parameter; the unit of a number is empty.
    value
        Where the sum of weighted squares is least.
    standard_error
        By leaving out strokes; see `jackknife`.
    lower, upper
        Ends of the 95 % interval.
    """

    name: str
    unit: str
    words: str
    value: float
    standard_error: float
    lower: float
    upper: float


@dataclass(frozen=True)
class Held:
    """A constant that was not fitted, in its own unit, and why."""

    name: str
    unit: str
    value: float
    reason: str


@dataclass(frozen=True)
class ResidualStatistics:
    """What the law leaves unexplained of one test.

    Attributes
    ----------
    name
        Of the test.
    samples, left_out
        Number of samples that were used, and that were not.
    scatter, bias
        Root mean square and mean of measured less fitted [-].
    relative_scatter
        Root mean square over the mean coefficient [-].
    correlation
        Of each residual with the next [-].
    pressure, peak_speed, peak_temperature
        Mean, largest and largest of the samples used [N/mm2, mm/s, degC].
    speed_window, load_window
        Length of the filters [samples].
    """

    name: str
    samples: int
    left_out: int
    scatter: float
    bias: float
    relative_scatter: float
    correlation: float
    pressure: float
    peak_speed: float
    peak_temperature: float
    speed_window: int
    load_window: int


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
]  # fmt: skip
HELD = [
    Quantity("name", "constant", head="Held", get="name"),
    Quantity("unit", "its unit", get="unit", printed=False),
    Quantity("value", "value", NONE, digits=5, head="Value\n", get="value"),
    Quantity("Unit", "its unit", get=lambda one: one.unit or "-", stored=False),
    Quantity("reason", "why it was not fitted", head="Why", get="reason"),
]
RESIDUALS = [
    Quantity("name", "test", head="Test", get="name"),
    Quantity("p", "mean pressure", N_PER_MM2, decimals=1, get="pressure", stored=False),
    Quantity("v_max", "largest speed", MM_PER_S, decimals=0, get="peak_speed", stored=False),
    Quantity("T_max", "highest temperature", DEGC, decimals=0, get="peak_temperature", stored=False),
    Quantity("samples", "samples that were used", NONE, head="used\n", get="samples"),
    Quantity("left_out", "samples that were not", NONE, head="left out\n", get="left_out"),
    Quantity("scatter", "root mean square of measured less fitted", NONE, decimals=5, get="scatter"),
    Quantity("of mu", "the same over the mean coefficient", NONE, PERCENT, 2, get="relative_scatter", stored=False),
    Quantity("bias", "mean of measured less fitted", NONE, decimals=5, head="mean", get="bias", signed=True),
    Quantity("relative_scatter", "root mean square over the mean coefficient", NONE, get="relative_scatter", printed=False),
    Quantity("correlation", "correlation of each residual with the next", NONE, decimals=2, head="lag-1 corr.", get="correlation"),
    Quantity("pressure", "mean pressure", N_PER_MM2, get="pressure", printed=False),
    Quantity("peak_speed", "largest speed", MM_PER_S, get="peak_speed", printed=False),
    Quantity("peak_temperature", "highest temperature", DEGC, get="peak_temperature", printed=False),
    Quantity("speed_window", "length of the filter of the speed", NONE, get="speed_window", printed=False),
    Quantity("load_window", "length of the filter of the load", NONE, get="load_window", printed=False),
]  # fmt: skip


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
    histories
        Of the tests that were fitted.
    temperatures
        Of the contact in each of them, with the conductivity that was found [degC].
    residuals
        For each of them.
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
    def bearing(self) -> Bearing:
        """Bearing that was tested."""
        return self.system.bearing

    @property
    def law(self) -> FittedFriction:
        """Law that was found."""
        return cast("FittedFriction", self.system.friction)

    @property
    def heating(self) -> Heating:
        """Heating model that it goes with."""
        return self.system.heating

    def fitted(self, test: int) -> FloatArray:
        """Return the coefficient of the law along a test [-]."""
        history = self.histories[test]
        return self.law.coefficient(history.pressure, history.speed, self.temperatures[test])

    def estimate(self, name: str) -> Estimate:
        """Return one estimate by its name."""
        return next(one for one in self.estimates if one.name == name)

    def summary(self) -> dict[str, object]:
        """Return what JSON holds."""
        return {
            "estimates": Table(tuple(ESTIMATES), self.estimates).objects(),
            "held": Table(tuple(HELD), self.held).objects(),
            "confidence": CONFIDENCE,
            "blocks": self.blocks,
            "correlation": {
                one.name: dict(zip((other.name for other in self.estimates), row, strict=True))
                for one, row in zip(self.estimates, np.asarray(self.correlation).tolist(), strict=True)
            },
            "residuals": Table(tuple(RESIDUALS), self.residuals).objects(),
            "predictions": [row for one in self.predictions for row in one.rows()],
            "bearing": asdict(self.bearing),
            "friction": {"law": self.law.name, **asdict(self.law)},
            "heating": {"model": self.heating.name, **asdict(self.heating)},
            "remarks": list(self.remarks),
        }

    def csv(self) -> str:
        """Return a line for each constant, fitted or held."""
        heads = ("name", "unit", "value", "standard_error", "lower", "upper", "held", "words")
        rows = [
            (one.name, one.unit or "-", one.value, one.standard_error, one.lower, one.upper, None, one.words)
            for one in self.estimates
        ]
        held = [
            (one.name, one.unit or "-", one.value, None, None, None, one.reason, None) for one in self.held
        ]
        return csv_text(heads, [*rows, *held])

    def _repr_html_(self) -> str:
        rows = [
            {
                "constant": one.name,
                "unit": one.unit,
                "value": one.value,
                "95 % from": one.lower,
                "to": one.upper,
            }
            for one in self.estimates
        ]
        return card(f"Friction law of {self.bearing.name}", rows=rows, remarks=self.remarks)


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
