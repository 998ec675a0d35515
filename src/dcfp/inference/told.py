"""What is told of predictions: of forecasts, of comparisons with analyses, of their scatter, and of constants that were refitted."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from dcfp.inference.calibration import Intervals
from dcfp.inference.case import QUANTITIES, Case, Method, Setting, View
from dcfp.inference.case import Quantity as Compared
from dcfp.inference.forecast import Forecast, setting_remarks
from dcfp.inference.intervals import Coverage
from dcfp.inference.statistics import Scatter, ratios
from dcfp.methods import Prediction, Pulses
from dcfp.methods.result import answer_objects
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import M_PER_S, MM, MM_PER_S, MM_PER_S2, NONE, PERCENT, SECOND

#: What a blind method knows, by its basis.
_KNOWS = {"blind": "record", "PGV only": "PGV"}
_ENDS = ("low", "median", "high")

# ----- a prediction, a pulse, a swing, an interval -----

PREDICTIONS = [
    Quantity("dy_mm", "largest change of displacement", MM, decimals=1, name="dy", get="said.displacement_change"),
    Quantity("y_mm", "largest displacement", MM, decimals=1, name="y", head="y_max", get="said.displacement"),
    Quantity("V_dE_mm_s", "equivalent velocity of the energy put in meanwhile", MM_PER_S, decimals=1, name="V_dE", get="said.input_velocity"),
    Quantity("V_dEhr_mm_s", "equivalent velocity of the energy dissipated meanwhile", MM_PER_S, decimals=1, name="V_dEhr", get="said.hysteretic_velocity"),
    Quantity("V_E_mm_s", "equivalent velocity of all the energy put in", MM_PER_S, decimals=1, name="V_E", get="said.total_velocity"),
]  # fmt: skip
PULSES = [
    Quantity("start_s", "peak before", SECOND, get=lambda one: float(one.pulses.starts[one.place])),
    Quantity("peak_s", "its own peak", SECOND, get=lambda one: float(one.pulses.peaks[one.place])),
    Quantity("end_s", "peak after", SECOND, get=lambda one: float(one.pulses.ends[one.place])),
    Quantity("dvg_mm_s", "change of the ground velocity", MM_PER_S, get=lambda one: float(one.pulses.changes[one.place])),
    Quantity("kg_mm_s2", "slope before the peak", MM_PER_S2, get=lambda one: float(one.pulses.mean_accelerations[one.place])),
    Quantity("kg_next_mm_s2", "slope after the peak", MM_PER_S2, get=lambda one: float(one.pulses.next_mean_accelerations[one.place])),
]  # fmt: skip
SWINGS = [
    Quantity("start_s", "start", SECOND, get="start"),
    Quantity("end_s", "end", SECOND, get="end"),
    Quantity("dy_mm", "change of displacement", MM, get="change"),
    Quantity("V_dE_mm_s", "equivalent velocity of the energy put in", MM_PER_S, get="input_velocity"),
    Quantity("V_dEr_mm_s", "the same less that given back", MM_PER_S, get="net_input_velocity"),
    Quantity("V_dEhr_mm_s", "equivalent velocity of the energy dissipated", MM_PER_S, get="hysteretic_velocity"),
]  # fmt: skip


class Said(NamedTuple):
    """A prediction alone."""

    said: Prediction


class Pulse(NamedTuple):
    """One of the pulses of a record, by its place."""

    pulses: Pulses
    place: int


def _one(columns: Sequence[Quantity], thing: Any) -> dict[str, Any]:
    return Table(tuple(columns), [thing]).objects()[0]


def _pulse(pulses: Pulses | None, place: int | None) -> dict[str, Any] | None:
    return None if pulses is None or place is None else _one(PULSES, Pulse(pulses, place))


def _interval(intervals: Intervals | None) -> dict[str, Any] | None:
    if intervals is None:
        return None
    return {
        quantity.key: {"low": one.low, "median": one.median, "high": one.high, "cases": one.cases}
        for quantity, one in intervals.items()
    }


# ----- forecasts -----


class ToldForecast(NamedTuple):
    """What one view says in a forecast; with no view, where other analyses of that PGV lie."""

    forecast: Forecast
    setting: Setting
    view: View | None = None

    @property
    def record(self) -> str | None:
        """Name of the record."""
        return None if self.forecast.motion is None else self.forecast.motion.name

    @property
    def said(self) -> Prediction | None:
        """The prediction."""
        return None if self.view is None else self.forecast.predicted[self.view]

    @property
    def place(self) -> int | None:
        """Place of the governing pulse."""
        return None if self.view is None else self.forecast.governing.get(self.view)

    @property
    def pulse(self) -> str | None:
        """From when to when the governing pulse rises [s]."""
        pulses, place = self.forecast.pulses, self.place
        return (
            None
            if pulses is None or place is None
            else f"{pulses.starts[place]:.2f}–{pulses.peaks[place]:.2f}"
        )

    @property
    def basis(self) -> str:
        """What it knows."""
        return "PGV only" if self.view is None else self.view[1].value

    @property
    def intervals(self) -> Intervals | None:
        """Intervals of the view."""
        return self.forecast.intervals.get(self.view)


def _record(*, printed: bool = True) -> tuple[Quantity, ...]:
    return (
        Quantity("record", "name of the ground motion", head="Record", get="record", printed=printed),
        Quantity("pgv_m_s", "peak ground velocity in m/s", get=lambda one: round(one.forecast.pgv / 1e3, 12), printed=False),
        Quantity("PGV", "peak ground velocity", M_PER_S, decimals=3, get="forecast.pgv", stored=False),
    )  # fmt: skip


def _of_pulse(place: str) -> Quantity:
    """Return when the governing pulse begins, has its peak and ends."""

    def get(one: ToldForecast) -> float | None:
        pulses: Any = one.forecast.pulses
        return None if pulses is None or one.place is None else float(getattr(pulses, place)[one.place])

    name = place.removesuffix("s")
    return Quantity(
        f"pulse_{name}_s",
        f"{name} of the governing pulse",
        SECOND,
        name=f"pulse_{name}",
        get=get,
        printed=False,
    )


def _of_interval(quantity: Compared, end: str) -> Quantity:
    def get(one: ToldForecast) -> float | None:
        found = None if one.intervals is None else one.intervals.get(quantity)
        return None if found is None else getattr(found, end)

    return Quantity(f"{quantity.key}_{end}", f"{end} of {quantity.name}", MM if quantity.unit == "mm" else MM_PER_S, name=f"{quantity.name}_{end}", get=get, printed=False)  # fmt: skip


def _of_said(one: Quantity) -> Quantity:
    """Return a quantity of a prediction for lines that may have none."""

    def get(line: ToldForecast) -> float | None:
        return None if line.said is None else one.of(line)

    return replace(one, get=get)


def forecast_lines(forecasts: Sequence[Forecast], setting: Setting, *, with_others: bool = True) -> Table:
    """Return a line for each record, PGV and method, and for the analyses of others; an interval that was not asked for leaves its cells empty."""
    of_records = forecasts[0].motion is not None
    columns = (
        *_record(printed=of_records),
        Quantity("method", "method", head="Method", get=lambda one: "analyses of other records" if one.view is None else one.view[0].value),
        Quantity("basis", "what it knows", get="basis", printed=False),
        Quantity("knows", "what it knows", head="Knows", get=lambda one: _KNOWS[one.basis], stored=False),
        *map(_of_said, PREDICTIONS),
        Quantity("pulse", "governing pulse", SECOND, head="Pulse", get="pulse", stored=False, printed=of_records),
        *map(_of_pulse, ("starts", "peaks", "ends")),
        *(_of_interval(quantity, end) for quantity in QUANTITIES for end in _ENDS),
    )  # fmt: skip
    lines = [ToldForecast(one, setting, view) for one in forecasts for view in one.predicted]
    others = [ToldForecast(one, setting) for one in forecasts if with_others and None in one.intervals]
    return Table(columns, [*lines, *others])


def interval_lines(forecasts: Sequence[Forecast], setting: Setting) -> Table:
    """Return a line for each view with an interval."""
    heads = {"dy": "dy", "y": "y_max", "V_E": "V_E"}

    def shown(quantity: Compared, end: str) -> Quantity:
        stored = _of_interval(quantity, end)

        def text(one: ToldForecast) -> str | None:
            value = stored.of(one)
            return None if value is None else f"{value:.0f}" if value >= 10.0 else f"{value:.1f}"

        part = {"low": "5 %", "median": "median", "high": "95 %"}[end]
        return Quantity(
            stored.key,
            stored.words,
            stored.unit,
            head=f"{heads[quantity.name]}\n{part}\n[{quantity.unit}]",
            get=text,
        )

    columns = (
        *_record(printed=forecasts[0].motion is not None),
        Quantity("knowing", "what is known", head="Knowing", get=lambda one: "the PGV" if one.view is None else one.view[0].value),
        *(shown(quantity, end) for quantity in QUANTITIES if quantity.name in heads for end in _ENDS),
    )  # fmt: skip
    return Table(columns, [ToldForecast(one, setting, view) for one in forecasts for view in one.intervals])


FORECASTS = [
    *_record(),
    Quantity("friction", "friction law", get="setting.friction.name"),
    Quantity("heating", "heating model", get="setting.heating.name"),
    Quantity("nominal_friction", "nominal coefficient", NONE, get="setting.constants.nominal_friction"),
    Quantity("pulses", "number of pulses", NONE, get=lambda one: None if one.forecast.pulses is None else one.forecast.pulses.count),
    Quantity("predictions", "what the methods say", get=lambda one: [_forecast_of(one.forecast, view) for view in one.forecast.predicted], flat=False),
    Quantity("interval_from_pgv", "where analyses of that PGV lie", get=lambda one: _interval(one.forecast.intervals.get(None)), flat=False),
    Quantity("remarks", "what a reader must know", get="forecast.remarks"),
]  # fmt: skip


def _forecast_of(one: Forecast, view: View) -> dict[str, Any]:
    return {
        "method": view[0].value,
        "basis": view[1].value,
        **_one(PREDICTIONS, Said(one.predicted[view])),
        "pulse": _pulse(one.pulses, one.governing.get(view)),
        "interval": _interval(one.intervals.get(view)),
    }


def forecast_objects(forecasts: Sequence[Forecast], setting: Setting) -> list[dict[str, Any]]:
    """Return an object for each record and PGV, ready for JSON."""
    return Table(tuple(FORECASTS), [ToldForecast(one, setting) for one in forecasts]).objects()


# ----- comparisons -----


class ToldCase(NamedTuple):
    """A comparison, with how its record was predicted."""

    case: Case
    setting: Setting


CASES = [
    Quantity("record", "name of the ground motion", get="case.record"),
    Quantity("event", "earthquake", get="case.event"),
    Quantity("pgv_m_s", "peak ground velocity", M_PER_S, places=12, get="case.pgv"),
    Quantity("friction", "friction law", get="setting.friction.name"),
    Quantity("heating", "heating model", get="setting.heating.name"),
    Quantity("analysis", "what the analysis gives", get=lambda one: _one(PREDICTIONS, Said(one.case.analysed.whole)), flat=False),
    Quantity("governing_swing", "swing of the largest change", get=lambda one: None if one.case.analysed.swing is None else _one(SWINGS, one.case.analysed.swing), flat=False),
    Quantity("governing_pulse", "pulse behind it", get=lambda one: _pulse(one.case.pulses, one.case.analysed.pulse), flat=False),
    Quantity("predictions", "what the methods say", get=lambda one: [_prediction_of(one.case, view) for view in one.case.predicted if view[1].value != "spectrum"], flat=False),
    Quantity("codes", "what the methods of codes say", get=lambda one: answer_objects(one.case.answers.values()), flat=False),
    Quantity("remarks", "what a reader must know", get=lambda one: [*one.case.remarks, *setting_remarks(one.case.pgv, one.setting)]),
]  # fmt: skip


def _prediction_of(case: Case, view: View) -> dict[str, Any]:
    found = {quantity.name: _known(float(ratios([case], view, quantity)[0])) for quantity in QUANTITIES}
    said = _one(PREDICTIONS, Said(case.predicted[view]))
    return {"method": view[0].value, "basis": view[1].value, **said, "ratios": found}


def _known(value: float) -> float | None:
    return value if math.isfinite(value) else None


def case_objects(cases: Sequence[Case], setting: Setting) -> list[dict[str, Any]]:
    """Return an object for each record and PGV, ready for JSON; what is not known is None."""
    return Table(tuple(CASES), [ToldCase(one, setting) for one in cases]).objects()


class CaseLine(NamedTuple):
    """The analysis of a case, or one of the predictions."""

    case: Case
    said: Prediction
    view: View | None = None

    @property
    def verdict(self) -> str:
        """Verdict of a method of a code."""
        name = "" if self.view is None else self.view[0].value
        return self.case.answers[name].verdict if name in self.case.answers else ""


def case_lines(cases: Sequence[Case]) -> Table:
    """Return a line for each record, PGV and method, the analysis among them."""
    columns = (
        *CASES[:2],
        Quantity("pgv_m_s", "peak ground velocity", places=12, get=lambda one: one.case.pgv / 1e3),
        Quantity("method", "method", get=lambda one: "analysis" if one.view is None else one.view[0].value),
        Quantity("basis", "what it knows", get=lambda one: "" if one.view is None else one.view[1].value),
        *PREDICTIONS,
        Quantity("verdict", "verdict of a method of a code", get="verdict"),
    )
    return Table(
        columns,
        [
            line
            for case in cases
            for line in (
                CaseLine(case, case.analysed.whole),
                *(CaseLine(case, said, view) for view, said in case.predicted.items()),
            )
        ],
    )


# ----- scatter, intervals and refitted constants -----


class ToldScatter(NamedTuple):
    """The scatter of a quantity by a view."""

    view: View
    quantity: Compared
    scatter: Scatter
    outside: int | None


SCATTER = [
    Quantity("method", "method", head="Method", get=lambda one: one.view[0].value),
    Quantity("basis", "what it knows", head="Knows", get=lambda one: one.view[1].value),
    Quantity("quantity", "quantity", head="Quantity", get="quantity.name"),
    Quantity("cases", "cases that are measured", NONE, get="scatter.number", printed=False),
    Quantity("without_prediction", "cases without a prediction", NONE, get="scatter.without", printed=False),
    Quantity("share_below_analysis", "share of the cases below the analysis", NONE, get="scatter.below", printed=False),
    Quantity("least", "least ratio", NONE, decimals=2, head="Least\n", get="scatter.least"),
    Quantity("Median", "median ratio", NONE, decimals=2, head="Median\n", get="scatter.median", stored=False),
    Quantity("largest", "largest ratio", NONE, decimals=2, head="Largest\n", get="scatter.largest"),
    Quantity("median", "median ratio", NONE, get="scatter.median", printed=False),
    Quantity("bias", "geometric mean of the ratios", NONE, decimals=2, head="Bias\n", get="scatter.bias"),
    Quantity("dispersion", "standard deviation of their logarithms", NONE, get="scatter.dispersion", printed=False),
    Quantity("Dispersion", "the same, of more than one case", NONE, decimals=3, head="Dispersion\n", get=lambda one: one.scatter.dispersion if one.scatter.number > 1 else None, stored=False),
    Quantity("Below", "share of the cases below the analysis", PERCENT, head="Below\n", get=lambda one: f"{100.0 * one.scatter.below:.0f} %", stored=False),
    Quantity("Cases", "cases that are measured", NONE, head="Cases\n", get="scatter.number", stored=False),
    Quantity("Without", "cases without a prediction", NONE, head="Without\n", get="scatter.without", stored=False),
    Quantity("outside_of_limits", "cases outside of the limits of the method", NONE, get="outside", printed=False),
]  # fmt: skip


def scatter_table(found: dict[tuple[View, Compared], Scatter], cases: Sequence[Case]) -> Table:
    """Return a line for each method, basis and quantity."""
    return Table(
        tuple(SCATTER),
        [
            ToldScatter(view, quantity, one, _outside(cases, view[0]))
            for (view, quantity), one in found.items()
        ],
    )


def _outside(cases: Sequence[Case], method: str) -> int | None:
    """Return in how many cases a method is outside of its limits; None where it is not one of a code, or no limits are known."""
    said = [case.answers[method] for case in cases if method in case.answers]
    return sum(one.valid is False for one in said) if any(one.conditions for one in said) else None


class ToldCoverage(NamedTuple):
    """How often the intervals of a quantity hold what they ought to."""

    method: Method | None
    quantity: Compared
    coverage: Coverage


def _percent(name: str) -> Callable[[ToldCoverage], str]:
    return lambda one: f"{100.0 * getattr(one.coverage, name):.1f} %"


COVERAGE = [
    Quantity("method", "method", get=lambda one: "PGV only" if one.method is None else one.method.value, printed=False),
    Quantity("Interval from", "method", get=lambda one: "the PGV" if one.method is None else one.method.value, stored=False),
    Quantity("quantity", "quantity", head="Quantity", get="quantity.name"),
    Quantity("mean", "part inside", NONE, get="coverage.mean", printed=False),
    Quantity("p05", "5 % of it", NONE, get="coverage.low", printed=False),
    Quantity("p95", "95 % of it", NONE, get="coverage.high", printed=False),
    *(Quantity(head, "part inside", PERCENT, head=f"{head}\n", get=_percent(name), stored=False) for head, name in (("Inside", "mean"), ("5 %", "low"), ("95 %", "high"))),
    Quantity("width", "upper over lower end", NONE, decimals=2, head="Width\n", get="coverage.width"),
    Quantity("splits", "number of splits", NONE, get="coverage.splits", printed=False),
]  # fmt: skip
REFITS = [
    Quantity("method", "method", head="Method", get="method"),
    Quantity("constants_from", "where the constants come from", head="Constants", get="words"),
    Quantity("kg_ave_mm_s2", "kg_ave", MM_PER_S2, decimals=0, head="kg_ave", get="constants.average_slope"),
    Quantity("eps", "eps", NONE, decimals=3, get="constants.fall_ratio"),
    Quantity("zeta", "zeta", NONE, decimals=3, get="constants.change_ratio"),
    Quantity("bias", "geometric mean of the ratios", NONE, decimals=2, head="Bias\n", get="bias"),
    Quantity("dispersion", "standard deviation of their logarithms", NONE, decimals=3, head="Dispersion\n", get="dispersion"),
]  # fmt: skip


def coverage_table(coverages: dict[tuple[View | None, Compared], Coverage]) -> Table:
    """Return a line for each quantity and what its interval knows."""
    return Table(
        tuple(COVERAGE),
        [
            ToldCoverage(None if view is None else view[0], quantity, one)
            for (view, quantity), one in coverages.items()
        ],
    )
