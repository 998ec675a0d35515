"""What is told of predictions: of forecasts, of comparisons with analyses, of their scatter, and of constants that were refitted."""

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from typing import Any, NamedTuple

from dcfp.inference.case import Case
from dcfp.inference.coverage import Coverage
from dcfp.inference.forecast import BY_SPECTRUM, Forecast
from dcfp.inference.statistics import Scatter, ratios
from dcfp.methods import Prediction, Pulses
from dcfp.methods.code import code_objects
from dcfp.methods.method import Information, Variant
from dcfp.methods.prediction import Methods
from dcfp.methods.pulses import PREDICTION_QUANTITIES
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import M_PER_S, MM, MM_PER_S, MM_PER_S2, NONE, PERCENT, SECOND

#: Ends of an interval, and what they are called.
ENDS = {"low": "5 %", "median": "median", "high": "95 %"}


#: Of all pulses; one of them is told.
PULSES = [
    Quantity("start_s", "peak before", SECOND, get="starts"),
    Quantity("peak_s", "its own peak", SECOND, get="peaks"),
    Quantity("end_s", "peak after", SECOND, get="ends"),
    Quantity("dvg_mm_s", "change of the ground velocity", MM_PER_S, get="changes"),
    Quantity("kg_mm_s2", "slope before the peak", MM_PER_S2, get="mean_accelerations"),
    Quantity("kg_next_mm_s2", "slope after the peak", MM_PER_S2, get="next_mean_accelerations"),
]
SWINGS = [
    Quantity("start_s", "start", SECOND, get="start"),
    Quantity("end_s", "end", SECOND, get="end"),
    Quantity("dy_mm", "change of displacement", MM, get="change"),
    Quantity("V_dE_mm_s", "equivalent velocity of the energy put in", MM_PER_S, get="input_velocity"),
    Quantity("V_dEr_mm_s", "the same less that given back", MM_PER_S, get="net_input_velocity"),
    Quantity("V_dEhr_mm_s", "equivalent velocity of the energy dissipated", MM_PER_S, get="hysteretic_velocity"),
]  # fmt: skip


class Told(NamedTuple):
    """A forecast or a case, how it was predicted, and the method of a line, if it is of one."""

    of: Any
    methods: Methods | None = None
    variant: Variant | None = None

    @property
    def said(self) -> Prediction | None:
        """The prediction, or what the analysis gives."""
        if self.variant is None:
            return self.of.analysed.whole if isinstance(self.of, Case) else None
        return self.of.predicted.get(self.variant)

    @property
    def place(self) -> int | None:
        """Place of the governing pulse of a forecast."""
        return None if self.variant is None else self.of.governing.get(self.variant)

    @property
    def pulse(self) -> str | None:
        """From when to when the governing pulse of a forecast rises [s]."""
        found = _pulse(self.of.pulses, self.place)
        return None if found is None else f"{found['start_s']:.2f}–{found['peak_s']:.2f}"

    @property
    def nodes(self) -> int | None:
        """Number of nodes that the method of a forecast knows."""
        return None if self.variant is None else self.of.nodes.get(self.variant)

    @property
    def information(self) -> Information:
        """What a forecast knows."""
        return Information.PGV if self.variant is None else self.variant.information

    @property
    def verdict(self) -> str:
        """Verdict of a method of a code on a case."""
        codes = self.of.codes
        return codes[self.variant.method].verdict if self.variant and self.variant.method in codes else ""


def _objects(columns: Sequence[Quantity], results: Sequence[Any]) -> list[dict[str, Any]]:
    return Table(tuple(columns), results).objects()


def _pulse(pulses: Pulses | None, place: int | None) -> dict[str, Any] | None:
    if pulses is None or place is None:
        return None
    return {one.key: one.datum(pulses)[place] for one in PULSES}


def _interval(of: Forecast, variant: Variant | None) -> dict[str, Any] | None:
    intervals = of.intervals.get(variant)
    return None if intervals is None else {one.key: asdict(found) for one, found in intervals.items()}


def _prediction(of: Forecast | Case, variant: Variant) -> dict[str, Any]:
    """Return what one method says, with what it knows."""
    (said,) = _objects(tuple(PREDICTION_QUANTITIES.values()), [of.predicted[variant]])
    return {"method": variant.method, "basis": variant.information.value, **said}


def _of_said(one: Quantity) -> Quantity:
    """Return a quantity of a prediction for lines that may have none."""

    def get(line: Told) -> float | None:
        return None if line.said is None else one.of(line.said)

    return replace(one, get=get)


def _record(*, printed: bool = True) -> tuple[Quantity, ...]:
    return (
        Quantity("record", "name of the ground motion", head="Record", get=lambda one: None if one.of.motion is None else one.of.motion.name, printed=printed),
        Quantity("pgv_m_s", "peak ground velocity in m/s", get=lambda one: round(one.of.pgv / 1e3, 12), printed=False),
        Quantity("PGV", "peak ground velocity", M_PER_S, decimals=3, get="of.pgv", stored=False),
    )  # fmt: skip


def _of_pulse(time: Quantity) -> Quantity:
    """Return when the governing pulse begins, has its peak or ends."""

    def get(one: Told) -> float | None:
        found = _pulse(one.of.pulses, one.place)
        return None if found is None else found[time.key]

    name = time.key.removesuffix("_s")
    words = f"{name} of the governing pulse"
    return replace(time, key=f"pulse_{time.key}", words=words, name=f"pulse_{name}", get=get, printed=False)


def _of_interval(quantity: Quantity, end: str) -> Quantity:
    def get(one: Told) -> float | None:
        found = one.of.intervals.get(one.variant, {}).get(quantity)
        return None if found is None else getattr(found, end)

    return Quantity(f"{quantity.key}_{end}", f"{end} of {quantity.title}", quantity.unit, name=f"{quantity.title}_{end}", get=get, printed=False)  # fmt: skip


def forecast_lines(forecasts: Sequence[Forecast], methods: Methods, *, with_others: bool = True) -> Table:
    """Return a line for each record, PGV and method, and for the analyses of others; an interval that was not asked for leaves its cells empty."""
    of_records = forecasts[0].motion is not None
    columns = (
        *_record(printed=of_records),
        Quantity("method", "method", head="Method", get=lambda one: "analyses of other records" if one.variant is None else one.variant.method),
        Quantity("basis", "what it knows", get="information", printed=False),
        Quantity("knows", "what it knows", head="Knows", get="information.words", stored=False),
        *map(_of_said, PREDICTION_QUANTITIES.values()),
        Quantity("pulse", "governing pulse", SECOND, head="Pulse", get="pulse", stored=False, printed=of_records),
        Quantity("nodes", "number of nodes of the ground velocity", NONE, decimals=0, head="Nodes", get="nodes", printed=of_records),
        *map(_of_pulse, PULSES[:3]),
        *(_of_interval(quantity, end) for quantity in PREDICTION_QUANTITIES.values() for end in ENDS),
    )  # fmt: skip
    lines = [Told(one, methods, variant) for one in forecasts for variant in one.predicted]
    others = [
        Told(one, methods, variant)
        for one in forecasts
        for variant in (None, BY_SPECTRUM)
        if with_others and variant in one.intervals
    ]
    return Table(columns, [*lines, *others])


def interval_lines(forecasts: Sequence[Forecast], methods: Methods) -> Table:
    """Return a line for each method with an interval."""
    heads = {"dy": "dy", "y": "y_max", "V_E": "V_E"}

    def shown(quantity: Quantity, end: str) -> Quantity:
        stored = _of_interval(quantity, end)

        def text(one: Told) -> str | None:
            value = stored.of(one)
            return None if value is None else f"{value:.0f}" if value >= 10.0 else f"{value:.1f}"

        head = f"{heads[quantity.title]}\n{ENDS[end]}\n[{quantity.unit.name}]"
        return replace(stored, name="", head=head, get=text, printed=True)

    columns = (
        *_record(printed=forecasts[0].motion is not None),
        Quantity("knowing", "what is known", head="Knowing", get=lambda one: "the PGV" if one.variant is None else one.variant.method),
        *(shown(quantity, end) for quantity in PREDICTION_QUANTITIES.values() if quantity.title in heads for end in ENDS),
    )  # fmt: skip
    return Table(columns, [Told(one, methods, variant) for one in forecasts for variant in one.intervals])


_SYSTEM = (
    Quantity("friction", "friction law", get="methods.system.friction.name"),
    Quantity("heating", "heating model", get="methods.system.heating.name"),
)
FORECASTS = [
    *_record(),
    *_SYSTEM,
    Quantity("nominal_friction", "nominal coefficient", NONE, get="methods.constants.nominal_friction"),
    Quantity("pulses", "number of pulses", NONE, get=lambda one: None if one.of.pulses is None else one.of.pulses.count),
    Quantity("predictions", "what the methods say", get=lambda one: [_forecast_of(one.of, variant) for variant in one.of.predicted], flat=False),
    Quantity("interval_from_pgv", "where analyses of that PGV lie", get=lambda one: _interval(one.of, None), flat=False),
    Quantity("interval_from_spectrum", "where those of that PGV and spectrum lie", get=lambda one: _interval(one.of, BY_SPECTRUM), flat=False),
    Quantity("remarks", "what a reader must know", get="of.remarks"),
]  # fmt: skip


def _forecast_of(one: Forecast, variant: Variant) -> dict[str, Any]:
    pulse = _pulse(one.pulses, one.governing.get(variant))
    return _prediction(one, variant) | {
        "pulse": pulse,
        "nodes": one.nodes.get(variant),
        "interval": _interval(one, variant),
    }


def forecast_objects(forecasts: Sequence[Forecast], methods: Methods) -> list[dict[str, Any]]:
    """Return an object for each record and PGV, ready for JSON."""
    return _objects(FORECASTS, [Told(one, methods) for one in forecasts])


CASES = [
    Quantity("record", "name of the ground motion", get="of.record"),
    Quantity("event", "earthquake", get="of.event"),
    Quantity("pgv_m_s", "peak ground velocity", M_PER_S, places=12, get="of.pgv"),
    *_SYSTEM,
    Quantity("analysis", "what the analysis gives", get=lambda one: _objects(tuple(PREDICTION_QUANTITIES.values()), [one.said])[0], flat=False),
    Quantity("governing_swing", "swing of the largest change", get=lambda one: None if one.of.analysed.swing is None else _objects(SWINGS, [one.of.analysed.swing])[0], flat=False),
    Quantity("governing_pulse", "pulse behind it", get=lambda one: _pulse(one.of.pulses, one.of.analysed.pulse), flat=False),
    Quantity("predictions", "what the methods say", get=lambda one: [_prediction_of(one.of, variant) for variant in one.of.predicted if variant.method not in one.of.codes], flat=False),
    Quantity("codes", "what the methods of codes say", get=lambda one: code_objects(one.of.codes.values()), flat=False),
    Quantity("remarks", "what a reader must know", get=lambda one: [*one.of.remarks, *one.methods.remarks(one.of.pgv)]),
]  # fmt: skip


def _prediction_of(case: Case, variant: Variant) -> dict[str, Any]:
    found = {one.title: float(ratios([case], variant, one)[0]) for one in PREDICTION_QUANTITIES.values()}
    known = {name: ratio if math.isfinite(ratio) else None for name, ratio in found.items()}
    return _prediction(case, variant) | {"ratios": known}


def case_objects(cases: Sequence[Case], methods: Methods) -> list[dict[str, Any]]:
    """Return an object for each record and PGV, ready for JSON; what is not known is None."""
    return _objects(CASES, [Told(one, methods) for one in cases])


def case_lines(cases: Sequence[Case]) -> Table:
    """Return a line for each record, PGV and method, the analysis among them."""
    columns = (
        *CASES[:2],
        Quantity("pgv_m_s", "peak ground velocity", places=12, get=lambda one: one.of.pgv / 1e3),
        Quantity("method", "method", get=lambda one: "analysis" if one.variant is None else one.variant.method),
        Quantity("basis", "what it knows", get=lambda one: "" if one.variant is None else one.variant.information),
        *map(_of_said, PREDICTION_QUANTITIES.values()),
        Quantity("verdict", "verdict of a method of a code", get="verdict"),
    )  # fmt: skip
    return Table(
        columns, [Told(case, None, variant) for case in cases for variant in (None, *case.predicted)]
    )


class Measured(NamedTuple):
    """What is measured of a quantity by a method with what it knows; of a coverage without one from the PGV alone."""

    variant: Variant | None
    quantity: Quantity
    found: Any
    outside: int | None = None


SCATTER = [
    Quantity("method", "method", head="Method", get="variant.method"),
    Quantity("basis", "what it knows", head="Knows", get="variant.information"),
    Quantity("quantity", "quantity", head="Quantity", get="quantity.title"),
    Quantity("share_below_analysis", "share of the cases below the analysis", NONE, get="found.below", printed=False),
    Quantity("least", "least ratio", NONE, decimals=2, head="Least\n", get="found.least"),
    Quantity("median", "median ratio", NONE, decimals=2, head="Median\n", get="found.median"),
    Quantity("largest", "largest ratio", NONE, decimals=2, head="Largest\n", get="found.largest"),
    Quantity("bias", "geometric mean of the ratios", NONE, decimals=2, head="Bias\n", get="found.bias"),
    Quantity("dispersion", "standard deviation of their logarithms", NONE, get="found.dispersion", printed=False),
    Quantity("Dispersion", "the same, of more than one case", NONE, decimals=3, head="Dispersion\n", get=lambda one: one.found.dispersion if one.found.number > 1 else None, stored=False),
    Quantity("Below", "share of the cases below the analysis", PERCENT, head="Below\n", get=lambda one: f"{100.0 * one.found.below:.0f} %", stored=False),
    Quantity("cases", "cases that are measured", NONE, head="Cases\n", get="found.number"),
    Quantity("without_prediction", "cases without a prediction", NONE, head="Without\n", get="found.without"),
    Quantity("outside_of_limits", "cases outside of the limits of the method", NONE, get="outside", printed=False),
]  # fmt: skip


def scatter_table(found: dict[tuple[Variant, Quantity], Scatter], cases: Sequence[Case]) -> Table:
    """Return a line for each method, basis and quantity."""
    rows = [Measured(*key, one, _outside(cases, key[0].method)) for key, one in found.items()]
    return Table(tuple(SCATTER), rows)


def _outside(cases: Sequence[Case], method: str) -> int | None:
    """Return in how many cases a method is outside of its limits; None where it is not one of a code, or no limits are known."""
    results = [case.codes[method] for case in cases if method in case.codes]
    return sum(one.valid is False for one in results) if any(one.conditions for one in results) else None


def _percent(name: str) -> Callable[[Measured], str]:
    return lambda one: f"{100.0 * getattr(one.found, name):.1f} %"


COVERAGE = [
    Quantity("method", "method", get=lambda one: "PGV only" if one.variant is None else one.variant.method, printed=False),
    Quantity("Interval from", "method", get=lambda one: "the PGV" if one.variant is None else one.variant.method, stored=False),
    Quantity("quantity", "quantity", head="Quantity", get="quantity.title"),
    Quantity("mean", "part inside", NONE, get="found.mean", printed=False),
    Quantity("p05", "5 % of it", NONE, get="found.low", printed=False),
    Quantity("p95", "95 % of it", NONE, get="found.high", printed=False),
    *(Quantity(head, "part inside", PERCENT, head=f"{head}\n", get=_percent(name), stored=False) for head, name in (("Inside", "mean"), ("5 %", "low"), ("95 %", "high"))),
    Quantity("width", "upper over lower end", NONE, decimals=2, head="Width\n", get="found.width"),
    Quantity("splits", "number of splits", NONE, get="found.splits", printed=False),
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
    rows = [Measured(*key, one) for key, one in coverages.items()]
    return Table(tuple(COVERAGE), rows)
