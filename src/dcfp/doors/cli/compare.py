"""Predictions against response history analysis, for any set of records and PGVs."""

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from dcfp.doors.cli import inputs, options
from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Parser
from dcfp.errors import InputError

if TYPE_CHECKING:
    from dcfp.inference import Case, Setting
    from dcfp.inference.case import Quantity, View
    from dcfp.inference.held_out import Refit
    from dcfp.inference.intervals import Coverage
    from dcfp.motion.ground_motion import GroundMotion

    HeldOut: TypeAlias = tuple[dict[tuple[View | None, Quantity], Coverage], list[Refit]]


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    options.add_records(
        parser,
        "+",
        "name of a record or a file, FILE::COMPONENT; or of a set: P695 (100 components), P695-FF, P695-NF",
    )
    parser.add_argument(
        "--held-out",
        action="store_true",
        help="also constants and intervals from half of the earthquakes, judged on the other half",
    )
    options.add_treatment(parser)
    inputs.add_method(parser)
    options.add_bearing(parser)
    options.add_output(parser, "every prediction and analysis as CSV (.csv)")


def run(chosen: argparse.Namespace) -> int:
    """Analyse and predict every record at every PGV."""
    inputs.record_names(chosen)
    if chosen.held_out and chosen.pgv is None:
        msg = "--held-out compares records at the same PGV; say which with --pgv, for example --pgv 0.25 0.5 0.75 1.0."
        raise InputError(msg)
    outputs = Outputs.checked(chosen, inputs.input_files(chosen), (".csv",))
    # late, so that a slip in the command is answered at once
    from dcfp.doors.cli.predict_table import print_cases
    from dcfp.inference.statistics import scatters

    setting, nominal = inputs.setting(chosen, inputs.model(chosen))
    cases = _compare(chosen, setting)
    held_out = _held_out(cases, len(chosen.pgv), setting) if chosen.held_out else None
    _write(cases, setting, outputs)
    if chosen.json:
        print(json.dumps(_document(cases, setting, held_out), indent=2, allow_nan=False))
    else:
        print_cases(cases, scatters(cases), setting, nominal, held_out)
    return 0


def _compare(chosen: argparse.Namespace, setting: "Setting") -> "list[Case]":
    from dcfp.doors.cli.progress import progress
    from dcfp.inference import compare
    from dcfp.motion.measures import refuse_a_drift

    motions = inputs.scaled(_different(inputs.load_motions(chosen)), chosen.pgv)
    for motion in motions:
        refuse_a_drift(motion)
    cases: list[Case] = []
    with progress("comparisons", len(motions)) as advance:
        for motion in motions:
            cases.append(
                compare(
                    motion, setting, codes=True, keep_response=chosen.plot is not None and len(motions) == 1
                )
            )
            advance()
    return cases


def _different(motions: "list[GroundMotion]") -> "list[GroundMotion]":
    """Return the motions without those that are there twice, under whatever name: a case must not count twice."""
    found = {motion.digest: motion for motion in reversed(motions)}
    return list(reversed(found.values()))


def _held_out(cases: "list[Case]", pgvs: int, setting: "Setting") -> "HeldOut":
    from dcfp.inference.held_out import check_enough, coverages, refits

    # the motions follow each other record by record, at all PGVs each
    groups = [cases[first::pgvs] for first in range(pgvs)]
    check_enough(groups)
    return coverages(groups), refits(cases, setting.constants)


def _document(cases: "list[Case]", setting: "Setting", held_out: "HeldOut | None") -> dict[str, Any]:
    from dcfp.inference.statistics import scatters
    from dcfp.present.tables.comparisons import case_objects, held_out_object, scatter_objects

    return {
        "cases": case_objects(cases, setting),
        "scatter": scatter_objects(scatters(cases), cases),
        "held_out": None if held_out is None else held_out_object(*held_out),
    }


def _write(cases: "list[Case]", setting: "Setting", outputs: Outputs) -> None:
    def data(part: Path, kind: str) -> None:
        from dcfp.present.tables.comparisons import cases_csv

        del kind
        part.write_text(cases_csv(cases), encoding="utf-8")

    def figure(part: Path, form: str) -> None:
        from dcfp.present.figures import plot_comparison, save_figure  # late: Matplotlib takes long to import

        if len(cases) == 1:
            from dcfp.doors.cli.predict import pulse_figure

            save_figure(pulse_figure(cases[0], setting), part, form)
        else:
            save_figure(plot_comparison(cases), part, form)

    outputs.write_with(data, figure)
