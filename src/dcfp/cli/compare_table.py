"""The tables of `dcfp compare`."""

import math
from typing import TYPE_CHECKING

from dcfp.cli.predict_table import labels
from dcfp.cli.remarks import grouped
from dcfp.cli.tables import add_row, new_table, page, print_labelled, print_remarks

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import Console

    from dcfp.cli.compare import HeldOut
    from dcfp.comparison import Case, Setting
    from dcfp.comparison.case import View
    from dcfp.comparison.nominal import Nominal
    from dcfp.comparison.quantities import Quantity
    from dcfp.comparison.statistics import Scatter

#: Most cases that are printed one by one.
MOST_ROWS = 40
_KILO = 1e3


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
        if len(cases) <= MOST_ROWS:
            _print_ratios(out, cases)
        print_scatter(out, scatters)
        if held_out is not None:
            _print_held_out(out, held_out)
        print_remarks(out, [*remarks_of(cases, setting), *_notes(cases)])


def _print_ratios(out: "Console", cases: "Sequence[Case]") -> None:
    from dcfp.comparison.case import VIEWS
    from dcfp.comparison.quantities import CHANGE, DISPLACEMENT
    from dcfp.comparison.statistics import ratios

    table = new_table(["Record"], ["PGV\n[m/s]", "dy\n[mm]", "y_max\n[mm]"])
    for view in VIEWS:
        table.add_column(
            f"{_SHORT[view[0].value]}\n{_SHORT_BASIS[view[1].value]}", justify="right", no_wrap=True
        )
    table.add_column("march\ny/y", justify="right", no_wrap=True)
    for case in cases:
        cells = [_ratio(float(ratios([case], view, CHANGE)[0])) for view in VIEWS]
        cells.append(_ratio(float(ratios([case], VIEWS[-1], DISPLACEMENT)[0])))
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
    out.print("dy and y_max of the analysis, and dy of each prediction over it:")
    out.print(table)


_SHORT = {"pulse": "pulse", "simplified": "simpl.", "design": "design", "pulse march": "march"}
_SHORT_BASIS = {"blind": "blind", "informed": "informed", "PGV only": "PGV"}


def print_scatter(out: "Console", scatters: "dict[tuple[View, Quantity], Scatter]") -> None:
    """Print the measures of all ratios of prediction to analysis."""
    table = new_table(
        ["Method", "Knows", "Quantity"],
        ["Least", "Median", "Largest", "Bias", "Dispersion", "Cases", "Without"],
    )
    last = None
    for (view, quantity), one in scatters.items():
        head = ["", ""] if view == last else [view[0].value, view[1].value]
        last = view
        numbers = [_ratio(value) for value in (one.least, one.median, one.largest, one.bias)]
        add_row(
            table,
            [*head, quantity.name, *numbers, f"{one.dispersion:.3f}", str(one.number), str(one.without)],
        )
    out.print()
    out.print("Prediction over analysis:")
    out.print(table)


def _print_held_out(out: "Console", held_out: "HeldOut") -> None:
    coverages, refits = held_out
    table = new_table(["Interval from", "Quantity"], ["Inside", "5 %", "95 %", "Width"])
    for (view, quantity), one in coverages.items():
        name = "the PGV" if view is None else view[0].value
        parts = [f"{100.0 * part:.1f} %" for part in (one.mean, one.low, one.high)]
        add_row(table, [name, quantity.name, *parts, f"{one.width:.2f}"])
    out.print()
    out.print("Intervals that ought to hold 90 %, from half of the earthquakes, on the other half:")
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
    out.print("Constants fitted to all cases; bias and dispersion of dy on held-out halves:")
    out.print(table)


def remarks_of(cases: "Sequence[Case]", setting: "Setting") -> list[str]:
    """Return what must be known of the analyses, if they are few, and of the methods."""
    from dcfp.comparison.forecast import setting_remarks

    of_methods = [remark for case in cases for remark in setting_remarks(case.pgv, setting)]
    of_analyses = (
        [(case.record, remark) for case in cases for remark in case.remarks]
        if len(cases) <= MOST_ROWS
        else []
    )
    return list(dict.fromkeys([*grouped(of_analyses), *of_methods]))


def _notes(cases: "Sequence[Case]") -> list[str]:
    from dcfp.comparison.statistics import displacement_over_change

    notes = [
        "blind: the largest of all pulses, from the record alone; informed: the pulse behind the largest swing of the analysis;"
        " a method without a y_max of its own offers dy for it.",
        "Bias: geometric mean; Dispersion: standard deviation of the natural logarithm; Without: no pulse was found, or nothing"
        " moves by the method, and none of the measures counts it.",
    ]
    over = displacement_over_change(cases)
    if over.size:
        notes.append(
            f"y_max over dy_max of the analyses: {over.min():.2f} to {over.max():.2f}, median {sorted(over)[over.size // 2]:.2f};"
            f" above 1 in {100.0 * float((over > 1.0).mean()):.0f} % of the cases."
        )
    return notes


def _ratio(value: float) -> str:
    return f"{value:.2f}" if math.isfinite(value) else "–"
