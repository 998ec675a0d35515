"""``dcfp compare``: predictions against response history analysis."""

import argparse
import math
import re
from collections.abc import Sequence
from functools import partial
from typing import Any, TypeAlias

from dcfp.analysis.integration import usual_heating
from dcfp.doors.cli import compare_plane, inputs
from dcfp.doors.cli.console import Block, Page, each, grid, grouped
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.doors.cli.predict import SYMBOLS, labels, methods_of, pulse_figure
from dcfp.inference import Case, Methods, compare
from dcfp.inference.coverage import Coverage
from dcfp.inference.refit import Refit, check_enough, coverages, refits
from dcfp.inference.statistics import displacement_over_change, ratios, scatter, scatters
from dcfp.inference.told import REFITS, case_lines, case_objects, coverage_table, scatter_table
from dcfp.methods.method import Variant, variants
from dcfp.methods.prediction import prediction_methods
from dcfp.methods.pulses import CHANGE, DISPLACEMENT
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import stations_of
from dcfp.schema.quantities import NOTHING, Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import M_PER_S, MM, NONE

HeldOut: TypeAlias = tuple[dict[tuple[Variant | None, Quantity], Coverage], list[Refit]]

#: Most cases that are printed one by one.
_MOST_ROWS = 40
#: Marks of a ratio by whether a case is within the limits of a method, and whether any limits are known.
_MARKS: dict[tuple[bool | None, bool], str] = {(False, True): "*", (None, True): "?"}
#: Which case a row is of, and what the analysis gives.
_OF_CASE = (
    Quantity("record", "name of the ground motion", head="Record", get="record"),
    Quantity("pgv", "peak ground velocity", M_PER_S, decimals=3, head="PGV", get="pgv"),
)
_LARGEST = Quantity("y_max", "largest displacement", MM, decimals=1, get="analysed.whole.bound")
#: A number in a remark, by which two remarks of one kind may differ.
_NUMBER = re.compile(r"\d+(?:\.\d+)?")


def run(chosen: argparse.Namespace) -> Answer:
    """Analyse and predict every record at every PGV."""
    loaded = list({one.digest: one for one in reversed(inputs.load_records(chosen))}.values())[::-1]
    # a case must not count twice, under whatever name
    if stations := stations_of(loaded):
        methods, friction = methods_of(chosen, inputs.system(chosen, usual_heating(stations)))
        return compare_plane.run(chosen, stations, methods, labels(methods, friction))
    methods, friction = methods_of(chosen, inputs.system(chosen))
    motions = inputs.scaled([one for one in loaded if isinstance(one, GroundMotion)], chosen.pgv)
    keep = chosen.plot is not None and len(motions) == 1
    cases = each(
        "comparisons", motions, lambda motion: compare(motion, methods, codes=True, keep_response=keep)
    )
    found: HeldOut | None = None
    if chosen.held_out:
        # the motions follow each other record by record, at all PGVs each
        groups = [cases[first :: len(chosen.pgv)] for first in range(len(chosen.pgv))]
        check_enough(groups)
        found = coverages(groups, methods), refits(cases, methods.constants)
    table = scatter_table(scatters(cases), cases)

    def document() -> dict[str, Any]:
        judged = None if found is None else {
            "coverage": coverage_table(found[0]).objects(),
            "refits": Table(tuple(REFITS), found[1]).objects(),
        }  # fmt: skip
        return {"cases": case_objects(cases, methods), "scatter": table.objects(), "held_out": judged}

    def page() -> Page:
        blocks: list[Block] = [labels(methods, friction)]
        if len(cases) <= _MOST_ROWS:
            blocks += [_ratios(cases), _codes(cases)]
        words = (
            "Prediction over analysis, blind and PGV on the cases in which each of them predicts a motion:"
        )
        blocks.append((words, grid(table, repeated=2)))
        if found is not None:
            words = "Intervals that ought to hold 90 %, from half of the earthquakes, on the other half (200 random halves):"
            blocks.append((words, grid(coverage_table(found[0]))))
            words = "Constants fitted to all cases; bias and dispersion of dy on held-out halves (20 random halves):"
            blocks.append((words, grid(Table(tuple(REFITS), found[1]))))
        return Page(blocks, [*_remarks(cases, methods), *_notes(cases)])

    alone = len(cases) == 1
    figure = partial(pulse_figure, cases[0], methods) if alone else drawn("plot_comparison", cases)
    return Answer(document, page, lambda part, kind: case_lines(cases).csv(), figure)


def _ratios(cases: Sequence[Case]) -> Block:
    """Return ratios of prediction to analysis, case by case."""

    def column(variant: Variant, quantity: Quantity, word: str) -> Quantity:
        head = f"{known[variant.method].head or variant.method}\n{word}"

        def get(case: Case) -> float:
            return float(ratios([case], variant, quantity)[0])

        return Quantity(head, "ratio", NONE, decimals=2, head=head, get=get)

    def has_own(variant: Variant) -> bool:
        said = [case.predicted[variant] for case in cases if variant in case.predicted]
        return any(one.displacement is not None for one in said)

    known = prediction_methods()
    told = [one for one in variants() if one.method in known]
    columns = (
        *_OF_CASE,
        Quantity("dy", "change of displacement", MM, decimals=1, get="analysed.whole.displacement_change"),
        _LARGEST,
        *(column(one, CHANGE, one.information.value.removesuffix(" only")) for one in told),
        *(column(one, DISPLACEMENT, "y_max") for one in told if has_own(one)),
    )
    words = "dy and y_max of the analysis, dy of each prediction over it, and y_max of the march over it:"
    return words, grid(Table(columns, cases))


def _codes(cases: Sequence[Case]) -> Block:
    """Return ratios of the methods of codes to the analysis, with the marks of their verdicts."""

    def column(name: str) -> Quantity:
        def get(case: Case) -> str | None:
            said = case.codes.get(name)
            if said is None:
                return None
            ratio = said.displacement / case.analysed.whole.bound
            shown = f"{ratio:.2f}" if math.isfinite(ratio) else NOTHING
            return f"{shown}{_MARKS.get((said.valid, bool(said.conditions)), ' ')}"

        head, _, tail = name.partition(" ")
        return Quantity(name, "ratio", NONE, head=f"{head}\n{tail}", get=get)

    columns = (
        *_OF_CASE,
        _LARGEST,
        *map(column, dict.fromkeys(name for case in cases for name in case.codes)),
    )
    words = "y_max of the methods of codes, under the record's own spectrum, over that of the analysis:"
    return words, grid(Table(columns, cases))


def _remarks(cases: Sequence[Case], methods: Methods) -> list[str]:
    """Return what must be known of the analyses, if they are few, and of the methods."""
    of_methods = [remark for case in cases for remark in methods.remarks(case.pgv)]
    of_analyses = [
        (case.record, remark) for case in cases for remark in case.remarks if remark not in of_methods
    ]
    told = grouped(of_analyses) if len(cases) <= _MOST_ROWS else _counted(of_analyses, len(cases))
    return [*told, *of_methods]


def _counted(remarks: Sequence[tuple[str, str]], cases: int) -> list[str]:
    """Return each kind of remark once, with its first case and the number of cases that have one of its kind."""
    kinds: dict[str, list[str]] = {}
    for record, remark in remarks:
        words = remark.removeprefix(f"{record}: ")
        kinds.setdefault(_NUMBER.sub("#", words), []).append(remark)
    return [f"{len(those)} of {cases} analyses, such as {those[0]}" for those in kinds.values()]


def _notes(cases: Sequence[Case]) -> list[str]:
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


def _verdicts(cases: Sequence[Case]) -> str:
    """Return in how many cases each method is outside of its limits."""
    names = dict.fromkeys(name for case in cases for name, said in case.codes.items() if said.conditions)
    told = [
        f"{name}: {sum(case.codes[name].valid is False for case in cases if name in case.codes)} of {len(cases)} cases outside of its limits"
        for name in names
    ]
    return f"{'; '.join(told)}."
