"""The tables of `dcfp predict` and `dcfp compare`."""

import math
import re
from typing import TYPE_CHECKING

from dcfp.doors.cli.response_table import bearing_line
from dcfp.doors.cli.tables import add_row, grouped, new_table, page, print_labelled, print_remarks
from dcfp.motion.measures import motion_remarks

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import Console

    from dcfp.doors.cli.compare import HeldOut
    from dcfp.inference import Case, Setting
    from dcfp.inference.case import Quantity, View
    from dcfp.inference.forecast import Forecast
    from dcfp.inference.nominal import Nominal
    from dcfp.inference.statistics import Scatter


_NUMBERS = ("dy\n[mm]", "y_max\n[mm]", "V_dE\n[mm/s]", "V_dEhr\n[mm/s]", "V_E\n[mm/s]")
#: Quantities whose intervals are printed, with symbol and unit.
_WITH_INTERVAL = {"dy": ("dy", "mm"), "y": ("y_max", "mm"), "V_E": ("V_E", "mm/s")}
#: What a blind method knows, by its basis.
_KNOWS = {"blind": "record", "PGV only": "PGV"}
_KILO = 1e3
#: What the columns are.
SYMBOLS = (
    "dy: largest change of displacement from one peak to the next; y_max: largest displacement; V_dE, V_dEhr: equivalent velocity sqrt(2E/m) of"
    " the energy put in and dissipated meanwhile; V_E: of all the energy put in."
)


def print_forecasts(forecasts: "Sequence[Forecast]", setting: "Setting", nominal: "Nominal") -> None:
    """Print what was predicted, one row for each method, and the remarks."""
    with page() as out:
        print_labelled(out, labels(setting, nominal))
        out.print()
        if forecasts[0].motion is None:
            _print_from_pgv(out, forecasts)
        else:
            _print_records(out, forecasts)
        _print_intervals(out, forecasts)
        print_remarks(out, [*_remarks(forecasts), *_notes(forecasts)])


def labels(setting: "Setting", nominal: "Nominal") -> list[tuple[str, str]]:
    """Return what stands above the tables: the bearing, its law, and the constants of the methods."""
    constants, friction = setting.constants, setting.friction
    return [
        ("Bearing", bearing_line(setting.bearing)),
        (
            "Friction",
            f"{friction.name}, reference coefficient {friction.reference:g}, heating {setting.heating.name} from {setting.heating.ambient:g} °C;"
            f" nominal coefficient mu_n {nominal.value:.4g} ({nominal.source})",
        ),
        (
            "Constants",
            f"eps {constants.fall_ratio:g}, zeta {constants.change_ratio:g}, kg_ave {constants.average_slope:g} mm/s²;"
            f" pulses where the ground velocity turns back by {setting.threshold:g} PGV,"
            f" for the march by {setting.march_threshold:g} PGV",
        ),
    ]


def _print_from_pgv(out: "Console", forecasts: "Sequence[Forecast]") -> None:
    table = new_table([], ["PGV\n[m/s]", *(_NUMBERS[i] for i in (0, 2, 3))], ["Method"])
    for one in forecasts:
        for (method, _), said in one.predicted.items():
            add_row(
                table,
                [
                    f"{one.pgv / _KILO:g}",
                    f"{said.displacement_change:.1f}",
                    f"{said.input_velocity:.1f}",
                    f"{said.hysteretic_velocity:.1f}",
                    method.value,
                ],
            )
    out.print(table)


def _print_records(out: "Console", forecasts: "Sequence[Forecast]") -> None:
    table = new_table(["Record"], ["PGV\n[m/s]"], ["Method", "Knows"])
    for head in _NUMBERS:
        table.add_column(head, justify="right", no_wrap=True)
    table.add_column("Pulse\n[s]", justify="right", no_wrap=True)
    for one in forecasts:
        name = "" if one.motion is None else one.motion.name
        for row, (view, said) in enumerate(one.predicted.items()):
            method, basis = view
            found = (
                said.displacement_change,
                said.displacement,
                said.input_velocity,
                said.hysteretic_velocity,
                said.total_velocity,
            )
            head = [name, f"{one.pgv / _KILO:.3f}"] if row == 0 else ["", ""]
            add_row(
                table,
                [
                    *head,
                    method.value,
                    _KNOWS[basis.value],
                    *(_number(value) for value in found),
                    _pulse(one, view),
                ],
            )
    out.print(table)


def _number(value: float | None) -> str:
    return "–" if value is None else f"{value:.1f}"


def _pulse(one: "Forecast", view: "View") -> str:
    """Return from when to when the governing pulse rises."""
    place = one.governing.get(view)
    if place is None or one.pulses is None:
        return "–"
    return f"{one.pulses.starts[place]:.2f}–{one.pulses.peaks[place]:.2f}"


def _print_intervals(out: "Console", forecasts: "Sequence[Forecast]") -> None:
    if not any(one.intervals for one in forecasts):
        return
    of_records = forecasts[0].motion is not None
    table = new_table(["Record"] if of_records else [], ["PGV\n[m/s]"], ["Knowing"])
    for symbol, unit in _WITH_INTERVAL.values():
        for end in ("5 %", "median", "95 %"):
            table.add_column(f"{symbol}\n{end}\n[{unit}]", justify="right", no_wrap=True)
    for one in forecasts:
        for row, (view, intervals) in enumerate(one.intervals.items()):
            known = {quantity.name: interval for quantity, interval in intervals.items()}
            cells: list[str] = []
            for name in _WITH_INTERVAL:
                interval = known.get(name)
                ends = () if interval is None else (interval.low, interval.median, interval.high)
                cells += [_short(value) for value in ends] or ["–"] * 3
            names = [one.motion.name if one.motion and row == 0 else ""] if of_records else []
            pgv = f"{one.pgv / _KILO:.3f}" if row == 0 else ""
            add_row(table, [*names, pgv, "the PGV" if view is None else view[0].value, *cells])
    out.print()
    out.print(table)


def _short(value: float) -> str:
    return f"{value:.0f}" if value >= 10.0 else f"{value:.1f}"


def _remarks(forecasts: "Sequence[Forecast]") -> list[str]:
    return grouped(
        (one.motion.name if one.motion else "", remark)
        for one in forecasts
        for remark in (*(motion_remarks(one.motion, with_scale=False) if one.motion else ()), *one.remarks)
    )


def _notes(forecasts: "Sequence[Forecast]") -> list[str]:
    """Return what the columns mean."""
    notes = [SYMBOLS]
    if any(one.motion is not None for one in forecasts):
        notes.append(
            "Pulse: from which peak to which the governing pulse rises. A method without a y_max of its own offers dy for it: of the analyses of"
            " FEMA P-695 dy is the larger in 9 of 10, but a dy predicted too small is not."
        )
    if any(one.intervals for one in forecasts):
        from dcfp.inference.calibration import SET

        notes.append(
            f"Intervals hold 90 % of response history analyses of this bearing: from {SET} at the same PGV."
        )
    return notes


# The tables of `dcfp compare`.


#: Most cases that are printed one by one.
_MOST_ROWS = 40
#: Heads of columns: methods, and what they know.
_SHORT = {"pulse": "pulse", "simplified": "simpl.", "design": "design", "pulse march": "march"}
_SHORT_BASIS = {"blind": "blind", "informed": "informed", "PGV only": "PGV"}

#: Marks of a ratio by whether a case is within the limits of a method, and whether any limits are known.
_MARKS: dict[tuple[bool | None, bool], str] = {
    (False, True): "*",
    (None, True): "?",
    (True, True): " ",
    (True, False): " ",
}
#: A number in a remark, by which two remarks of one kind may differ.
_NUMBER = re.compile(r"\d+(?:\.\d+)?")


def print_cases(
    cases: "Sequence[Case]",
    scatters: "dict[tuple[View, Quantity], Scatter]",
    setting: "Setting",
    nominal: "Nominal",
    held_out: "HeldOut | None",
) -> None:
    """Print ratios of prediction to analysis, case by case where they are few, and their scatter."""
    with page() as out:
        print_labelled(out, labels(setting, nominal))
        if len(cases) <= _MOST_ROWS:
            _print_ratios(out, cases)
            _print_codes(out, cases)
        _print_scatter(out, scatters)
        if held_out is not None:
            _print_held_out(out, held_out)
        print_remarks(out, [*_remarks_on_cases(cases, setting), *_notes_on_cases(cases)])


def _print_ratios(out: "Console", cases: "Sequence[Case]") -> None:
    from dcfp.inference.case import CHANGE, DISPLACEMENT, VIEWS, Basis, Method
    from dcfp.inference.statistics import ratios

    table = new_table(["Record"], ["PGV\n[m/s]", "dy\n[mm]", "y_max\n[mm]"])
    views = [view for view in VIEWS if view[1] is not Basis.SPECTRUM]
    for view in views:
        table.add_column(
            f"{_SHORT[view[0].value]}\n{_SHORT_BASIS[view[1].value]}", justify="right", no_wrap=True
        )
    table.add_column("march\ny_max", justify="right", no_wrap=True)
    for case in cases:
        cells = [_ratio(float(ratios([case], view, CHANGE)[0])) for view in views]
        cells.append(_ratio(float(ratios([case], (Method.MARCH, Basis.BLIND), DISPLACEMENT)[0])))
        whole = case.analysed.whole
        add_row(
            table,
            [
                case.record,
                f"{case.pgv / _KILO:.3f}",
                f"{whole.displacement_change:.1f}",
                f"{whole.bound:.1f}",
                *cells,
            ],
        )
    out.print()
    out.print("dy and y_max of the analysis, dy of each prediction over it, and y_max of the march over it:")
    out.print(table)


def _print_codes(out: "Console", cases: "Sequence[Case]") -> None:
    names = list(dict.fromkeys(name for case in cases for name in case.answers))
    table = new_table(["Record"], ["PGV\n[m/s]", "y_max\n[mm]"])
    for name in names:
        head, _, tail = name.partition(" ")
        table.add_column(f"{head}\n{tail}", justify="right", no_wrap=True)
    for case in cases:
        cells: list[str] = []
        for name in names:
            said = case.answers.get(name)
            if said is None:
                cells.append("–")
                continue
            cells.append(
                f"{_ratio(said.displacement / case.analysed.whole.bound)}{_MARKS[said.valid, bool(said.conditions)]}"
            )
        add_row(table, [case.record, f"{case.pgv / _KILO:.3f}", f"{case.analysed.whole.bound:.1f}", *cells])
    out.print()
    out.print("y_max of the methods of codes, under the record's own spectrum, over that of the analysis:")
    out.print(table)


def _print_scatter(out: "Console", scatters: "dict[tuple[View, Quantity], Scatter]") -> None:
    """Print the measures of all ratios of prediction to analysis."""
    table = new_table(
        ["Method", "Knows", "Quantity"],
        ["Least", "Median", "Largest", "Bias", "Dispersion", "Below", "Cases", "Without"],
    )
    last = None
    for (view, quantity), one in scatters.items():
        head = ["", ""] if view == last else [view[0].value, view[1].value]
        last = view
        dispersion = f"{one.dispersion:.3f}" if one.number > 1 else "–"
        numbers = [_ratio(value) for value in (one.least, one.median, one.largest, one.bias)]
        add_row(
            table,
            [
                *head,
                quantity.name,
                *numbers,
                dispersion,
                f"{100.0 * one.below:.0f} %",
                str(one.number),
                str(one.without),
            ],
        )
    out.print()
    out.print("Prediction over analysis, blind and PGV on the cases in which each of them predicts a motion:")
    out.print(table)


def _print_held_out(out: "Console", held_out: "HeldOut") -> None:
    coverages, refits = held_out
    table = new_table(["Interval from", "Quantity"], ["Inside", "5 %", "95 %", "Width"])
    for (view, quantity), one in coverages.items():
        name = "the PGV" if view is None else view[0].value
        parts = [f"{100.0 * part:.1f} %" for part in (one.mean, one.low, one.high)]
        add_row(table, [name, quantity.name, *parts, f"{one.width:.2f}"])
    out.print()
    out.print(
        "Intervals that ought to hold 90 %, from half of the earthquakes, on the other half (200 random halves):"
    )
    out.print(table)
    table = new_table(
        ["Method", "Constants"], ["kg_ave\n[mm/s²]", "eps\n[-]", "zeta\n[-]", "Bias", "Dispersion"]
    )
    for one in refits:
        constants = one.constants
        numbers = [
            f"{constants.average_slope:.0f}",
            f"{constants.fall_ratio:.3f}",
            f"{constants.change_ratio:.3f}",
        ]
        add_row(table, [one.method.value, one.words, *numbers, f"{one.bias:.2f}", f"{one.dispersion:.3f}"])
    out.print()
    out.print(
        "Constants fitted to all cases; bias and dispersion of dy on held-out halves (20 random halves):"
    )
    out.print(table)


def _remarks_on_cases(cases: "Sequence[Case]", setting: "Setting") -> list[str]:
    """Return what must be known of the analyses, if they are few, and of the methods."""
    from dcfp.inference.forecast import setting_remarks

    of_methods = [remark for case in cases for remark in setting_remarks(case.pgv, setting)]
    of_analyses = [
        (case.record, remark) for case in cases for remark in case.remarks if remark not in of_methods
    ]
    told = grouped(of_analyses) if len(cases) <= _MOST_ROWS else _counted(of_analyses, len(cases))
    return list(dict.fromkeys([*told, *of_methods]))


def _counted(remarks: "Sequence[tuple[str, str]]", cases: int) -> list[str]:
    """Return each kind of remark once, with its first case and the number of cases that have one of its kind."""
    kinds: dict[str, list[str]] = {}
    for record, remark in remarks:
        words = remark.removeprefix(f"{record}: ")
        kinds.setdefault(_NUMBER.sub("#", words), []).append(remark)
    return [f"{len(those)} of {cases} analyses, such as {those[0]}" for those in kinds.values()]


def _notes_on_cases(cases: "Sequence[Case]") -> list[str]:
    from dcfp.inference.statistics import displacement_over_change, scatter

    notes = [
        "blind: the largest of all pulses, from the record alone; informed: the pulse behind the largest swing of the analysis;"
        " a method without a y_max of its own offers dy for it.",
        "Bias: geometric mean; Dispersion: standard deviation of the natural logarithm; Below: share of all cases with a prediction below the"
        " analysis; Without: no pulse was found, or nothing moves by the method, which counts as below and nowhere else.",
        "*: outside of the limits of the method; ?: within those that could be checked; the methods of AIJ state none that are known here."
        f" {_verdicts(cases)}",
        SYMBOLS,
    ]
    over = displacement_over_change(cases)
    if over.size:
        found = scatter(over)
        notes.append(
            f"y_max over dy_max of the analyses: {found.least:.2f} to {found.largest:.2f}, median {found.median:.2f};"
            f" above 1 in {100.0 * float((over > 1.0).mean()):.0f} % of the cases."
        )
    return notes


def _verdicts(cases: "Sequence[Case]") -> str:
    """Return in how many cases each method is outside of its limits."""
    names = dict.fromkeys(name for case in cases for name, said in case.answers.items() if said.conditions)
    outside = {
        name: sum(case.answers[name].valid is False for case in cases if name in case.answers)
        for name in names
    }
    return (
        "; ".join(
            f"{name}: {number} of {len(cases)} cases outside of its limits"
            for name, number in outside.items()
        )
        + "."
    )


def _ratio(value: float) -> str:
    return f"{value:.2f}" if math.isfinite(value) else "–"
