"""``dcfp codes``: displacement and base shear by the methods of codes, from records or a design spectrum."""

import argparse
from collections.abc import Sequence

from dcfp.doors.cli import inputs
from dcfp.doors.cli.console import Block, Page, each, grid
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.doors.cli.predict import nominal
from dcfp.methods.code import ROUNDS, Bounds, CodeResult, Structure
from dcfp.methods.code_comparison import (
    CODE_COMPARISONS,
    CodeComparison,
    codes_under_record,
    codes_under_set,
    codes_under_spectrum,
    line_quantities,
    lines_of,
)
from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.schema.check import COLUMNS, Verdict
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import NONE
from dcfp.system import System

#: Most records whose broken conditions are named one by one.
_FEW = 8


def run(chosen: argparse.Namespace) -> Answer:
    """Ask every method under every record or the spectrum."""
    system = inputs.system(chosen)
    friction = nominal(chosen, system)
    rest = PendulumWithFriction(system.bearing.effective_radius, friction.value).rest
    comparisons = _compared(chosen, system, friction.value)
    lines = [
        ("Bearing", str(system.bearing)),
        (
            "Friction",
            f"methods: mu {friction.value:.4g} ({friction.source}), at most {rest:.0f} mm at rest;"
            f" analysis: {system.friction.name}, heating {system.heating.name}",
        ),
    ]

    def page() -> Page:
        of_records = comparisons[0].displacement is not None
        told = [one for comparison in comparisons for one in lines_of(comparison, missing=True)]
        table = Table(line_quantities(of_records=of_records), told)
        details = (
            [block for comparison in comparisons for block in _details(comparison)] if chosen.details else []
        )
        remarks = _remarks(comparisons, system, details=chosen.details)
        return Page([lines, grid(table, repeated=2 if of_records else 1), *details], remarks)

    return Answer(
        lambda: Table(tuple(CODE_COMPARISONS), comparisons).objects(),
        page,
        lambda part, kind: Table(
            line_quantities(), [one for comparison in comparisons for one in lines_of(comparison)]
        ).csv(),
        drawn("motions.plot_codes", comparisons),
    )


def _compared(chosen: argparse.Namespace, system: System, friction: float) -> list[CodeComparison]:
    structure = Structure(**inputs.given(chosen, Structure))
    bounds = None if chosen.bounds is None else Bounds(*chosen.bounds, source="as given")
    spectrum = inputs.spectrum(chosen)
    if spectrum is not None:
        pendulum = PendulumWithFriction(system.bearing.effective_radius, friction)
        return [codes_under_spectrum(spectrum, pendulum, structure, bounds)]
    comparisons = each(
        "records",
        inputs.motions(chosen),
        lambda motion: codes_under_record(motion, system, friction, structure, bounds),
    )
    if chosen.of_set is not None:
        return [codes_under_set(comparisons, chosen.of_set or None, bounds)]
    return comparisons


def _details(comparison: CodeComparison) -> list[Block]:
    """Return every condition of a comparison's answers, and every round of their iterations."""
    found: list[Block] = []
    for said in comparison.results.values():
        name = f"{comparison.name}, {said.method}"
        if said.conditions:
            found.append((f"{name}:", grid(Table(tuple(COLUMNS), said.conditions))))
        if said.steps:
            found.append((f"{name}, iteration:", grid(_rounds(said))))
    return found


def _rounds(said: CodeResult) -> Table:
    """Return the rounds up to the one from which on no printed digit changes."""
    number = Quantity(
        "round", "number of the round", NONE, head="Round\n", get=lambda one: said.steps.index(one) + 1
    )
    table = Table((number, *ROUNDS), said.steps)
    cells = table.cells()
    count = next((i for i in range(1, len(cells)) if cells[i][1:] == cells[i - 1][1:]), len(cells))
    return Table(table.columns, said.steps[:count])


def _remarks(comparisons: Sequence[CodeComparison], system: System, *, details: bool) -> list[str]:
    every = [(comparison, said) for comparison in comparisons for said in comparison.results.values()]
    remarks: list[str] = []
    if len(comparisons) <= _FEW:
        remarks += [
            one
            for comparison in comparisons
            for one in (*comparison.remarks, *comparison.capacity_remarks(system.bearing))
        ]
        for comparison, said in every:
            who = f"{comparison.name}, {said.method}" if len(comparisons) > 1 else said.method
            broken = [
                f"{one.name} {one.found}, {one.limit}"
                for one in said.conditions
                if one.verdict is Verdict.NOT_MET
            ]
            remarks += [f"{who}, not met: {'; '.join(broken)}."] if broken else []
            remarks += [f"{who}: {remark}" for remark in said.remarks]
    unconfirmed = {said.method: said.unconfirmed for _, said in every if said.unconfirmed}
    remarks += [f"{name}, unconfirmed: {'; '.join(what)}." for name, what in unconfirmed.items()]
    conditions = [one for _, said in every for one in said.conditions]
    if any(not one.confirmed for one in conditions):
        which = "they are marked above" if details else "--details says which"
        remarks.append(f"Some conditions could not be read in the codes themselves; {which}.")
    if any(one.verdict is Verdict.NOT_KNOWN for one in conditions):
        remarks.append(
            "Not known: what the building and the site are like (--fixed-base-period, --height, --site-class, --plan, --fault-distance), and what"
            " was not looked at."
        )
    return remarks
