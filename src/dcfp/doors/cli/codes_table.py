"""The tables of `dcfp codes`."""

from typing import TYPE_CHECKING

from dcfp.doors.cli.response_table import bearing_line
from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import Console
    from rich.table import Table

    from dcfp.doors.cli.inputs import System
    from dcfp.inference.nominal import Nominal
    from dcfp.methods.panel import Panel
    from dcfp.methods.result import Answer

#: Most records whose broken conditions are named one by one.
_FEW = 8
_KILO = 1e3


def print_panels(panels: "Sequence[Panel]", model: "System", nominal: "Nominal", *, details: bool) -> None:
    """Print a row for each method, below the analysis where there is one, and which conditions are not met."""
    pendulum = panels[0].pendulum
    with page() as out:
        print_labelled(
            out,
            [
                ("Bearing", bearing_line(model.bearing)),
                (
                    "Friction",
                    f"methods: mu {nominal.value:.4g} ({nominal.source}), at most {pendulum.rest:.0f} mm at rest;"
                    f" analysis: {model.friction.name}, heating {model.heating.name}",
                ),
            ],
        )
        out.print()
        _print_answers(out, panels)
        if details:
            for panel in panels:
                _print_details(out, panel)
        print_remarks(out, _remarks(panels, model))


def _print_answers(out: "Console", panels: "Sequence[Panel]") -> None:
    of_records = panels[0].displacement is not None
    table = new_table(
        ["Record" if of_records else "Spectrum"],
        ["PGV\n[m/s]"] if of_records else [],
        ["Method"],
    )
    for head in (
        "D\n[mm]",
        "V_b/W\n[-]",
        "T_eff\n[s]",
        "beta_eff\n[%]",
        *(["D over\nanalysis"] if of_records else []),
    ):
        table.add_column(head, justify="right", no_wrap=True)
    table.add_column("Verdict")
    for panel in panels:
        rows = [_answer_cells(said, panel.displacement) for said in panel.answers.values()]
        if panel.displacement is not None and panel.base_shear is not None:
            rows.insert(
                0, ["analysis", f"{panel.displacement:.1f}", f"{panel.base_shear:.3f}", "–", "–", "1.00", ""]
            )
        rows += [
            [name, "–", "–", "–", "–", *(["–"] if of_records else []), "no solution"]
            for name in panel.missing
        ]
        for place, cells in enumerate(rows):
            head = [panel.name if place == 0 else ""]
            if of_records:
                head.append("" if place or panel.pgv is None else f"{panel.pgv / _KILO:.3f}")
            add_row(table, [*head, *cells])
    out.print(table)


def _answer_cells(said: "Answer", analysed: float | None) -> list[str]:
    cells = [
        said.method,
        f"{said.displacement:.1f}",
        f"{said.base_shear:.3f}",
        "–" if said.period is None else f"{said.period:.2f}",
        "–" if said.damping is None else f"{100.0 * said.damping:.1f}",
    ]
    if analysed is not None:
        cells.append(f"{said.displacement / analysed:.2f}" if analysed > 0.0 else "–")
    return [*cells, said.verdict]


def _print_details(out: "Console", panel: "Panel") -> None:
    for said in panel.answers.values():
        for words, table in (("", _conditions(said)), (", iteration", _rounds(said))):
            if table.row_count:
                out.print()
                out.print(f"{panel.name}, {said.method}{words}:")
                out.print(table)


def _conditions(said: "Answer") -> "Table":
    table = new_table(["Condition"], [], ["Found", "Limit", "Where", "Verdict"])
    for one in said.conditions:
        where = one.source if one.confirmed else f"{one.source}, unconfirmed"
        add_row(table, [one.name, one.found_words, one.limit_words, where, one.verdict.value])
    return table


def _rounds(said: "Answer") -> "Table":
    """Return the rounds up to the one from which on no printed digit changes."""
    table = new_table([], ["Round", "D\n[mm]", "T_eff\n[s]", "beta_eff\n[%]", "Reduction\n[-]"])
    before: list[str] = []
    for number, step in enumerate(said.steps, 1):
        cells = [
            f"{step.displacement:.2f}",
            f"{step.period:.3f}",
            f"{100.0 * step.damping:.2f}",
            f"{step.reduction:.4f}",
        ]
        if cells == before:
            break
        add_row(table, [str(number), *cells])
        before = cells
    return table


def _remarks(panels: "Sequence[Panel]", model: "System") -> list[str]:
    from dcfp.methods.panel import capacity_remarks
    from dcfp.schema.check import Verdict

    remarks: list[str] = []
    every = [(panel, said) for panel in panels for said in panel.answers.values()]
    if len(panels) <= _FEW:
        remarks += [
            remark for panel in panels for remark in (*panel.remarks, *capacity_remarks(panel, model.bearing))
        ]
        for panel, said in every:
            who = f"{panel.name}, {said.method}" if len(panels) > 1 else said.method
            broken = [
                f"{one.name} {one.found_words}, {one.limit_words}"
                for one in said.conditions
                if one.verdict is Verdict.NOT_MET
            ]
            remarks += [f"{who}, not met: {'; '.join(broken)}."] if broken else []
            remarks += [f"{who}: {remark}" for remark in said.remarks]
    unconfirmed = {said.method: said.unconfirmed for _, said in every if said.unconfirmed}
    remarks += [f"{name}, unconfirmed: {'; '.join(what)}." for name, what in unconfirmed.items()]
    conditions = [one for _, said in every for one in said.conditions]
    if any(not one.confirmed for one in conditions):
        remarks.append("Some conditions could not be read in the codes themselves; --details says which.")
    if any(one.verdict is Verdict.NOT_KNOWN for one in conditions):
        remarks.append(
            "Not known: what the building and the site are like (--fixed-base-period, --height, --site-class, --plan, --fault-distance), and what"
            " was not looked at."
        )
    return remarks
