"""The tables of `dcfp test`, `dcfp identify` and `dcfp verify`."""

import math
from collections.abc import Sequence
from itertools import groupby
from typing import TYPE_CHECKING, Any

from rich.console import Console

from dcfp.doors.cli.tables import add_row, grouped, new_table, page, print_labelled, print_remarks

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from rich.table import Table

    from dcfp.analysis.rig import Cycle, Loops, Measurement, Program
    from dcfp.analysis.rig.codes import PropertyFactor
    from dcfp.inference.identification import Identification
    from dcfp.schema.check import Check

_KILO, _MEGA = 1e3, 1e6
#: Of a test with more cycles than this the first few and the last are shown.
_MOST_CYCLES = 4

_NUMBERS: "tuple[tuple[str, Callable[[Cycle], str]], ...]" = (
    ("d+\n[mm]", lambda c: f"{c.largest:.1f}"),
    ("k_eff\n[kN/mm]", lambda c: f"{c.effective_stiffness / _KILO:.3f}"),
    ("b_eff\n[-]", lambda c: f"{c.effective_damping:.3f}"),
    ("k_d\n[kN/mm]", lambda c: _shown(c.post_yield_stiffness / _KILO, ".3f")),
    ("Q_d\n[kN]", lambda c: _shown(c.strength / _KILO, ".0f")),
    ("E\n[kN m]", lambda c: f"{c.energy / _MEGA:.1f}"),
    ("mu_0\n[-]", lambda c: _shown(c.friction, ".4f")),
    ("T_max\n[°C]", lambda c: _shown(c.peak_temperature, ".0f")),
)
_LEGEND = (
    "k_eff, b_eff: effective stiffness and damping; k_d: post-yield stiffness; Q_d, mu_0: force and coefficient of friction at zero"
    " displacement; E: energy of the cycle"
)


def print_tests(program: "Program", loops: "Sequence[Loops]", measured: "Mapping[str, Measurement]") -> None:
    """Print the measures of every cycle, those measured in reality below them, and the remarks."""
    table = new_table(["Test", "Cycle"], ["p\n[N/mm²]", "v_max\n[mm/s]", *(head for head, _ in _NUMBERS)])
    left_out = False
    for test in loops:
        area = test.bearing.slider_area
        shown = _cycles_shown(test.cycles)
        left_out |= len(shown) < len(test.cycles)
        for cycle in shown:
            numbers = [show(cycle) for _, show in _NUMBERS]
            speed = f"{test.test.waveform.peak_velocity:.0f}"
            add_row(table, [test.test.name, str(cycle.number), f"{cycle.load / area:.1f}", speed, *numbers])
        if test.test.name in measured:
            for cycle in _cycles_shown(measured[test.test.name].cycles):
                numbers = [show(cycle) for _, show in _NUMBERS]
                add_row(table, ["  measured", str(cycle.number), f"{cycle.load / area:.1f}", "", *numbers])
    with page() as out:
        print_labelled(out, _labelled(program, loops[0], str(loops[0].heating.name)))
        out.print()
        out.print(table)
        notes = [_LEGEND + ("; cycles between the third and the last are left out" if left_out else "") + "."]
        print_remarks(out, [*notes, *_nominal(program, loops), *_remarks(loops)])


def print_models(
    program: "Program", runs: "Mapping[str, Sequence[Loops]]", measured: "Mapping[str, Measurement]"
) -> None:
    """Print stiffness, damping and energy of every cycle with each model, and the models' energies over that of the first."""
    names = list(runs)
    heads = [
        *(f"k_eff\n{name[:6]}." for name in names),
        *(f"b_eff\n{name[:6]}." for name in names),
        *(f"E\n{name[:6]}." for name in names),
        *(f"E/E_{names[0][0]}\n{name[:6]}." for name in names[1:]),
    ]
    table = new_table(["Test", "Cycle"], heads)
    for tests in zip(*runs.values(), strict=True):
        for cycles in zip(*(_cycles_shown(test.cycles) for test in tests), strict=True):
            add_row(table, [tests[0].test.name, str(cycles[0].number), *_side_by_side(cycles)])
        name = tests[0].test.name
        if name in measured:
            for cycle in _cycles_shown(measured[name].cycles):
                cells = [""] * len(heads)
                for place, (_, show) in zip(
                    (0, len(names), 2 * len(names)), _NUMBERS[1:3] + _NUMBERS[5:6], strict=True
                ):
                    cells[place] = show(cycle)
                add_row(table, ["  measured", str(cycle.number), *cells])
    first = next(iter(runs.values()))
    with page() as out:
        print_labelled(out, _labelled(program, first[0], ", ".join(names)))
        out.print()
        out.print(table)
        last = f"k_eff [kN/mm], b_eff [-] and E [kN m]; E/E_{names[0][0]}: energy over that of the {names[0]} model."
        print_remarks(
            out,
            [
                last,
                *(r for tests in runs.values() for r in _nominal(program, tests)),
                *_remarks([test for tests in runs.values() for test in tests]),
            ],
        )


def print_checks(
    program: "Program",
    loops: "Sequence[Loops]",
    criteria: "Sequence[Check]",
    factors: "Sequence[PropertyFactor]",
) -> None:
    """Print what a code wants and whether it is so, the property modification factors, and the remarks."""
    notes: list[str] = []
    with page() as out:
        print_labelled(out, _labelled(program, loops[0], loops[0].heating.name))
        if criteria:
            out.print()
            out.print(_criteria_table(criteria))
        if factors:
            out.print()
            out.print(_factors_table(factors))
            notes.append(
                "lambda_test as the model predicts it: first and last of the first three cycles at the maximum displacement over their mean"
                " (nominal); after all: last cycle of the endurance tests over the mean of their first three."
            )
        if any(not item.confirmed for item in criteria):
            notes.append(
                "An unconfirmed limit is from memory of the code, whose text could not be read; look it up before relying on it."
            )
        print_remarks(out, [*notes, *_remarks(loops)])


def _criteria_table(criteria: "Sequence[Check]") -> "Table":
    table = new_table(["Code", "Clause", "Test", "What must hold"], ["Found", "Limit"], ["Unit", "Result"])
    for item in criteria:
        limit = f"{'≥' if item.at_least else '≤'} {item.limit:g}"
        verdict = ("ok" if item.passed else "NOT MET") + ("" if item.confirmed else " (unconfirmed limit)")
        words = [item.of, item.source, item.subject, item.name]
        add_row(table, [*words, f"{item.found:.3f}", limit, item.unit, verdict])
    return table


def _factors_table(factors: "Sequence[PropertyFactor]") -> "Table":
    heads = ["nominal", "lambda_max", "lambda_min", "1st/3rd", "after all"]
    table = new_table(["Property"], heads, ["Unit", "Tests"])
    for factor in factors:
        enduring = "" if factor.enduring is None else f"{factor.enduring:.3f}"
        ratios = [f"{value:.3f}" for value in (factor.upper, factor.lower, factor.first_over_third)]
        numbers = [f"{factor.nominal:.4g}", *ratios, enduring]
        add_row(table, [factor.name, *numbers, factor.unit, ", ".join(factor.tests)])
    return table


def _labelled(program: "Program", first: "Loops", heating: str) -> list[tuple[str, str]]:
    bearing = first.bearing
    radii = " + ".join(f"{radius:g}" for radius in bearing.radii)
    source = f" ({program.source})" if program.source else ""
    return [
        ("Program", f"{program.name}{source}"),
        (
            "Bearing",
            f"{bearing.name}: radius {radii} mm, slider {bearing.slider_diameter:g} mm, {bearing.elastic_stiffness / _KILO:g} kN/mm",
        ),
        ("Friction", f"{first.friction_law.name}, reference coefficient {first.friction_law.reference:g}"),
        ("Heating", f"{heating}, from {first.heating.ambient:g} °C"),
    ]


def _cycles_shown(cycles: "Sequence[Cycle]") -> "list[Cycle]":
    if len(cycles) <= _MOST_CYCLES:
        return list(cycles)
    return [*cycles[: _MOST_CYCLES - 1], cycles[-1]]


def _side_by_side(cycles: "Sequence[Cycle]") -> list[str]:
    return [
        *(f"{cycle.effective_stiffness / _KILO:.3f}" for cycle in cycles),
        *(f"{cycle.effective_damping:.3f}" for cycle in cycles),
        *(f"{cycle.energy / _MEGA:.1f}" for cycle in cycles),
        *(f"{cycle.energy / cycles[0].energy:.3f}" for cycle in cycles[1:]),
    ]


def _nominal(program: "Program", loops: "Sequence[Loops]") -> list[str]:
    """Return how the friction of dependency test T01 compares with the nominal coefficient that was measured in it."""
    from dcfp.system.friction.constant import NOMINAL_COEFFICIENT

    test = loops[0]
    if program.citation != "li_2020" or test.test.purpose != "velocity dependency" or len(test.cycles) < 2:
        return []
    found = test.cycles[1].friction
    return [
        f"{test.test.name}, {test.friction_law.name}, {test.heating.name} heating: friction at zero displacement in the second cycle {found:.4f};"
        f" the tests of Li et al. (2020) gave {NOMINAL_COEFFICIENT:g}, from which it is {100.0 * (found / NOMINAL_COEFFICIENT - 1.0):+.0f} % away."
    ]


def _remarks(loops: "Sequence[Loops]") -> list[str]:
    return grouped((test.test.name, remark) for test in loops for remark in test.remarks)


def _shown(value: float, form: str) -> str:
    return "" if math.isnan(value) else format(value, form)


# The tables of `dcfp identify`.


_FORM = (
    "mu = mu_0 gamma alpha beta; gamma = (1 - pressure_floor) (p / reference_pressure)^-pressure_exponent + pressure_floor,"
    " alpha = 1 - speed_drop exp(-speed_rate |v|), beta = exp(-temperature_rate (T - reference_temperature))"
)


def print_identification(found: "Identification") -> None:
    """Print the estimates, what was held and why, the residuals, the predictions and the remarks."""
    bearing = found.bearing
    radii = " + ".join(f"{radius:g}" for radius in bearing.radii)
    with page() as out:
        print_labelled(
            out,
            [
                ("Bearing", f"{bearing.name}: radius {radii} mm, slider {bearing.slider_diameter:g} mm"),
                ("Law", _FORM),
                ("Heating", f"{found.heating.name}, from {found.heating.ambient:g} °C"),
            ],
        )
        _print_estimates(out, found)
        _print_correlation(out, found)
        _print_residuals(out, found)
        _print_predictions(out, found)
        print_remarks(out, [*_notes(found), *found.remarks])


def _print_estimates(out: "Console", found: "Identification") -> None:
    table = new_table(["Fitted"], ["Estimate", "Std. error", "95 % from", "to"], ["Unit"])
    for one in found.estimates:
        numbers = [f"{value:.5g}" for value in (one.value, one.standard_error, one.lower, one.upper)]
        add_row(table, [one.name, *numbers, one.unit or "-"])
    out.print()
    out.print(table)
    table = new_table(["Held"], ["Value"], ["Unit", "Why"])
    for one in found.held:
        add_row(table, [one.name, f"{one.value:.5g}", one.unit or "-", one.reason])
    out.print()
    out.print(table)


def _print_correlation(out: "Console", found: "Identification") -> None:
    if len(found.estimates) < 2:
        return
    table = new_table(["Correlation"], [_head(one.name) for one in found.estimates])
    for one, row in zip(found.estimates, found.correlation.tolist(), strict=True):
        add_row(table, [one.name, *(f"{value:.3f}" for value in row)])
    out.print()
    out.print(table)


def _print_residuals(out: "Console", found: "Identification") -> None:
    table = new_table(
        ["Test"],
        ["p\n[N/mm²]", "v_max\n[mm/s]", "T_max\n[°C]", "used", "left out", "scatter\n[-]", "of mu\n[%]", "mean\n[-]", "lag-1 corr.\n[-]"],
    )  # fmt: skip
    for one in found.residuals:
        numbers = [
            f"{one.pressure:.1f}", f"{one.peak_speed:.0f}", f"{one.peak_temperature:.0f}", f"{one.samples}", f"{one.left_out}",
            f"{one.scatter:.5f}", f"{100.0 * one.relative_scatter:.2f}", f"{one.bias:+.5f}", f"{one.correlation:.2f}",
        ]  # fmt: skip
        add_row(table, [one.name, *numbers])
    out.print()
    out.print(table)


def _print_predictions(out: "Console", found: "Identification") -> None:
    if not found.predictions:
        return
    quantities = (("k_eff\n[kN/mm]", "keff_kN_mm", ".3f"), ("E\n[kN m]", "energy_kN_m", ".1f"), ("mu at 0\n[-]", "friction_at_zero", ".4f"))  # fmt: skip
    heads = [head for name, _, _ in quantities for head in (name, "predicted\n", "ratio\n")]
    table = new_table(["Held out", "Cycle"], heads)
    for prediction in found.predictions:
        for row in prediction.rows():
            cells: list[str] = []
            for _, key, form in quantities:
                for part, shown in (("measured", form), ("predicted", form), ("ratio", ".3f")):
                    value = row[f"{key}_{part}"]
                    cells.append(format(value, shown) if isinstance(value, float) else "")
            add_row(table, [str(row["test"]), str(row["cycle"]), *cells])
    out.print()
    out.print(table)


def _notes(found: "Identification") -> list[str]:
    notes = [
        f"Intervals: leaving out one of {found.blocks} blocks (strokes) after another, so that errors within a stroke may depend on each other."
    ]
    notes += [
        f"{one.name}: the force that was predicted is {100.0 * one.force_error:.1f} % of the largest measured one away from it (root mean square)."
        for one in found.predictions
    ]
    return notes


def _head(name: str) -> str:
    """Return a name in two lines where it is long."""
    return name.replace("_", "\n", 1) if len(name) > 6 else name


# The table of `dcfp verify`.


_VERDICTS = {True: "ok", False: "FAILED", None: "skipped"}


def print_verification(checks: Sequence[Any]) -> None:
    """Print a table for each group of checks, and how many passed, failed and were skipped."""
    verdicts = [check.passed for check in checks]
    with page() as out:
        for group, members in groupby(checks, key=lambda check: check.of):
            _print_group(out, group, list(members))
        out.print(
            f"{verdicts.count(True)} passed, {verdicts.count(False)} failed, {verdicts.count(None)} skipped; "
            "dcfp verify --json has a note on each check"
        )


def _print_group(out: Console, group: str, checks: list[Any]) -> None:
    table = new_table(["Check"], ["Computed", "Expected"], ["Unit", "Difference", "Allowed", "Result"])
    for check in checks:
        cells = [check.name, _shown_of_check(check.found), _shown_of_check(check.expected), check.unit]
        add_row(table, [*cells, check.difference, check.limit, _VERDICTS[check.passed]])
    out.print(group, style="bold")
    out.print(table)
    sources = dict.fromkeys(check.source for check in checks if check.source)
    if sources:
        print_labelled(out, [("Against", "; ".join(sources))])
    print_remarks(
        out, [f"{check.name}: {check.remark}" for check in checks if check.remark and not check.passed]
    )
    out.print()


def _shown_of_check(value: float | None) -> str:
    return "" if value is None else f"{value:.6g}"
