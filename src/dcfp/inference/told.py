"""What is told of predictions: of forecasts, of comparisons with analyses, of their scatter, and of constants that were refitted."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from dcfp.inference.calibration import Intervals
from dcfp.inference.case import Case
from dcfp.inference.forecast import Forecast
from dcfp.inference.intervals import Coverage
from dcfp.inference.statistics import Scatter, ratios
from dcfp.methods import Prediction, Pulses
from dcfp.methods.code import code_objects
from dcfp.methods.method import Information, Variant
from dcfp.methods.prediction import Methods
from dcfp.methods.pulses import PREDICTION_QUANTITIES
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import M_PER_S, MM, MM_PER_S, MM_PER_S2, NONE, PERCENT, SECOND

_ENDS = ("low", "median", "high")

# ----- a prediction, a pulse, a swing, an interval -----

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


class Pulse(NamedTuple):
    """One of the pulses of a record, by its place."""

    pulses: Pulses
    place: int


def _one(columns: Sequence[Quantity], thing: Any) -> dict[str, Any]:
    return Table(tuple(columns), [thing]).objects()[0]


def _said(prediction: Prediction) -> dict[str, Any]:
    return _one(tuple(PREDICTION_QUANTITIES.values()), prediction)


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
    """What one method says in a forecast; with none, where other analyses of that PGV lie."""

    forecast: Forecast
    methods: Methods
    variant: Variant | None = None

    @property
    def record(self) -> str | None:
        """Name of the record."""
        return None if self.forecast.motion is None else self.forecast.motion.name

    @property
    def said(self) -> Prediction | None:
        """The prediction."""
        return None if self.variant is None else self.forecast.predicted[self.variant]

    @property
    def place(self) -> int | None:
        """Place of the governing pulse."""
        return None if self.variant is None else self.forecast.governing.get(self.variant)

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
        return (Information.PGV if self.variant is None else self.variant.information).value

    @property
    def intervals(self) -> Intervals | None:
        """Intervals of the method."""
        return self.forecast.intervals.get(self.variant)


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


def _of_interval(quantity: Quantity, end: str) -> Quantity:
    def get(one: ToldForecast) -> float | None:
        found = None if one.intervals is None else one.intervals.get(quantity)
        return None if found is None else getattr(found, end)

    return Quantity(f"{quantity.key}_{end}", f"{end} of {quantity.title}", quantity.unit, name=f"{quantity.title}_{end}", get=get, printed=False)  # fmt: skip


def _of_said(one: Quantity) -> Quantity:
    """Return a quantity of a prediction for lines that may have none."""

    def get(line: Any) -> float | None:
        return None if line.said is None else one.of(line.said)

    return replace(one, get=get)


def forecast_lines(forecasts: Sequence[Forecast], methods: Methods, *, with_others: bool = True) -> Table:
    """Return a line for each record, PGV and method, and for the analyses of others; an interval that was not asked for leaves its cells empty."""
    of_records = forecasts[0].motion is not None
    columns = (
        *_record(printed=of_records),
        Quantity("method", "method", head="Method", get=lambda one: "analyses of other records" if one.variant is None else one.variant.method),
        Quantity("basis", "what it knows", get="basis", printed=False),
        Quantity("knows", "what it knows", head="Knows", get=lambda one: Information(one.basis).words, stored=False),
        *map(_of_said, PREDICTION_QUANTITIES.values()),
        Quantity("pulse", "governing pulse", SECOND, head="Pulse", get="pulse", stored=False, printed=of_records),
        *map(_of_pulse, ("starts", "peaks", "ends")),
        *(_of_interval(quantity, end) for quantity in PREDICTION_QUANTITIES.values() for end in _ENDS),
    )  # fmt: skip
    lines = [ToldForecast(one, methods, variant) for one in forecasts for variant in one.predicted]
    others = [ToldForecast(one, methods) for one in forecasts if with_others and None in one.intervals]
    return Table(columns, [*lines, *others])


def interval_lines(forecasts: Sequence[Forecast], methods: Methods) -> Table:
    """Return a line for each method with an interval."""
    heads = {"dy": "dy", "y": "y_max", "V_E": "V_E"}

    def shown(quantity: Quantity, end: str) -> Quantity:
        stored = _of_interval(quantity, end)

        def text(one: ToldForecast) -> str | None:
            value = stored.of(one)
            return None if value is None else f"{value:.0f}" if value >= 10.0 else f"{value:.1f}"

        part = {"low": "5 %", "median": "median", "high": "95 %"}[end]
        return Quantity(
            stored.key,
            stored.words,
            stored.unit,
            head=f"{heads[quantity.title]}\n{part}\n[{quantity.unit.name}]",
            get=text,
        )

    columns = (
        *_record(printed=forecasts[0].motion is not None),
        Quantity("knowing", "what is known", head="Knowing", get=lambda one: "the PGV" if one.variant is None else one.variant.method),
        *(shown(quantity, end) for quantity in PREDICTION_QUANTITIES.values() if quantity.title in heads for end in _ENDS),
    )  # fmt: skip
    return Table(
        columns, [ToldForecast(one, methods, variant) for one in forecasts for variant in one.intervals]
    )


FORECASTS = [
    *_record(),
    Quantity("friction", "friction law", get="methods.system.friction.name"),
    Quantity("heating", "heating model", get="methods.system.heating.name"),
    Quantity("nominal_friction", "nominal coefficient", NONE, get="methods.constants.nominal_friction"),
    Quantity("pulses", "number of pulses", NONE, get=lambda one: None if one.forecast.pulses is None else one.forecast.pulses.count),
    Quantity("predictions", "what the methods say", get=lambda one: [_forecast_of(one.forecast, variant) for variant in one.forecast.predicted], flat=False),
    Quantity("interval_from_pgv", "where analyses of that PGV lie", get=lambda one: _interval(one.forecast.intervals.get(None)), flat=False),
    Quantity("remarks", "what a reader must know", get="forecast.remarks"),
]  # fmt: skip


def _forecast_of(one: Forecast, variant: Variant) -> dict[str, Any]:
    return {
        **_named(variant),
        **_said(one.predicted[variant]),
        "pulse": _pulse(one.pulses, one.governing.get(variant)),
        "interval": _interval(one.intervals.get(variant)),
    }


def forecast_objects(forecasts: Sequence[Forecast], methods: Methods) -> list[dict[str, Any]]:
    """Return an object for each record and PGV, ready for JSON."""
    return Table(tuple(FORECASTS), [ToldForecast(one, methods) for one in forecasts]).objects()


# ----- comparisons -----


class ToldCase(NamedTuple):
    """A comparison, with how its record was predicted."""

    case: Case
    methods: Methods


CASES = [
    Quantity("record", "name of the ground motion", get="case.record"),
    Quantity("event", "earthquake", get="case.event"),
    Quantity("pgv_m_s", "peak ground velocity", M_PER_S, places=12, get="case.pgv"),
    Quantity("friction", "friction law", get="methods.system.friction.name"),
    Quantity("heating", "heating model", get="methods.system.heating.name"),
    Quantity("analysis", "what the analysis gives", get=lambda one: _said(one.case.analysed.whole), flat=False),
    Quantity("governing_swing", "swing of the largest change", get=lambda one: None if one.case.analysed.swing is None else _one(SWINGS, one.case.analysed.swing), flat=False),
    Quantity("governing_pulse", "pulse behind it", get=lambda one: _pulse(one.case.pulses, one.case.analysed.pulse), flat=False),
    Quantity("predictions", "what the methods say", get=lambda one: [_prediction_of(one.case, variant) for variant in one.case.predicted if variant.method not in one.case.codes], flat=False),
    Quantity("codes", "what the methods of codes say", get=lambda one: code_objects(one.case.codes.values()), flat=False),
    Quantity("remarks", "what a reader must know", get=lambda one: [*one.case.remarks, *one.methods.remarks(one.case.pgv)]),
]  # fmt: skip


def _prediction_of(case: Case, variant: Variant) -> dict[str, Any]:
    found = {
        one.title: _known(float(ratios([case], variant, one)[0])) for one in PREDICTION_QUANTITIES.values()
    }
    return {**_named(variant), **_said(case.predicted[variant]), "ratios": found}


def _named(variant: Variant) -> dict[str, str]:
    return {"method": variant.method, "basis": variant.information.value}


def _known(value: float) -> float | None:
    return value if math.isfinite(value) else None


def case_objects(cases: Sequence[Case], methods: Methods) -> list[dict[str, Any]]:
    """Return an object for each record and PGV, ready for JSON; what is not known is None."""
    return Table(tuple(CASES), [ToldCase(one, methods) for one in cases]).objects()


class CaseLine(NamedTuple):
    """The analysis of a case, or one of the predictions."""

    case: Case
    said: Prediction
    variant: Variant | None = None

    @property
    def verdict(self) -> str:
        """Verdict of a method of a code."""
        name = "" if self.variant is None else self.variant.method
        return self.case.codes[name].verdict if name in self.case.codes else ""


def case_lines(cases: Sequence[Case]) -> Table:
    """Return a line for each record, PGV and method, the analysis among them."""
    columns = (
        *CASES[:2],
        Quantity("pgv_m_s", "peak ground velocity", places=12, get=lambda one: one.case.pgv / 1e3),
        Quantity(
            "method", "method", get=lambda one: "analysis" if one.variant is None else one.variant.method
        ),
        Quantity(
            "basis",
            "what it knows",
            get=lambda one: "" if one.variant is None else one.variant.information.value,
        ),
        *map(_of_said, PREDICTION_QUANTITIES.values()),
        Quantity("verdict", "verdict of a method of a code", get="verdict"),
    )
    return Table(
        columns,
        [
            line
            for case in cases
            for line in (
                CaseLine(case, case.analysed.whole),
                *(CaseLine(case, said, variant) for variant, said in case.predicted.items()),
            )
        ],
    )


# ----- scatter, intervals and refitted constants -----


class ToldScatter(NamedTuple):
    """The scatter of a quantity by a method with what it knows."""

    variant: Variant
    quantity: Quantity
    scatter: Scatter
    outside: int | None


SCATTER = [
    Quantity("method", "method", head="Method", get=lambda one: one.variant.method),
    Quantity("basis", "what it knows", head="Knows", get=lambda one: one.variant.information.value),
    Quantity("quantity", "quantity", head="Quantity", get="quantity.title"),
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


def scatter_table(found: dict[tuple[Variant, Quantity], Scatter], cases: Sequence[Case]) -> Table:
    """Return a line for each method, basis and quantity."""
    return Table(
        tuple(SCATTER),
        [
            ToldScatter(variant, quantity, one, _outside(cases, variant.method))
            for (variant, quantity), one in found.items()
        ],
    )


def _outside(cases: Sequence[Case], method: str) -> int | None:
    """Return in how many cases a method is outside of its limits; None where it is not one of a code, or no limits are known."""
    results = [case.codes[method] for case in cases if method in case.codes]
    return sum(one.valid is False for one in results) if any(one.conditions for one in results) else None


class ToldCoverage(NamedTuple):
    """How often the intervals of a quantity hold what they ought to."""

    method: str | None
    quantity: Quantity
    coverage: Coverage


def _percent(name: str) -> Callable[[ToldCoverage], str]:
    return lambda one: f"{100.0 * getattr(one.coverage, name):.1f} %"


COVERAGE = [
    Quantity("method", "method", get=lambda one: "PGV only" if one.method is None else one.method, printed=False),
    Quantity("Interval from", "method", get=lambda one: "the PGV" if one.method is None else one.method, stored=False),
    Quantity("quantity", "quantity", head="Quantity", get="quantity.title"),
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


def coverage_table(coverages: dict[tuple[Variant | None, Quantity], Coverage]) -> Table:
    """Return a line for each quantity and what its interval knows."""
    return Table(
        tuple(COVERAGE),
        [
            ToldCoverage(None if variant is None else variant.method, quantity, one)
            for (variant, quantity), one in coverages.items()
        ],
    )
