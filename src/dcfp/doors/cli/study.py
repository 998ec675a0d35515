"""``dcfp study``: studies written, planned, run, shown and exported; ``dcfp export`` and ``dcfp report``: a scenario for another program, and as a calculation report."""

import argparse
import sys
import time
from collections.abc import Mapping
from dataclasses import asdict
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dcfp.analysis.batch import available_threads
from dcfp.doors.cli.console import Page, grid, progress, study_progress
from dcfp.doors.cli.outputs import Answer
from dcfp.doors.cli.respond import SCRIPT, answer_of, write_analyses
from dcfp.errors import InputError
from dcfp.present.tables import write_study
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import NONE
from dcfp.study import Plan, Study, open_store, read_study
from dcfp.study.assessment.selection import counts, described, is_number, numbered_cases, response_at
from dcfp.study.assessment.told import store_object, summary_table
from dcfp.study.results import OF_STATIONS, is_in_plane
from dcfp.study.run import run_on_cluster, run_study
from dcfp.study.scenario import Calculation, Scenario, calculate, read_scenario
from dcfp.study.work import project

if TYPE_CHECKING:
    import xarray

_MINUTE, _HOUR = 60.0, 3600.0


def new(chosen: argparse.Namespace) -> Answer:
    """Write a study file to start from."""
    text = files("dcfp.study").joinpath("template.toml").read_text(encoding="utf-8")
    told = f"{chosen.out}: written; dcfp study plan {chosen.out} says how long it takes, dcfp study {chosen.out} runs it."
    return Answer(lambda: {"file": chosen.out}, lambda: Page([told]), lambda part, kind: text)


def plan(chosen: argparse.Namespace) -> Answer:
    """Time some analyses and tell what all of them come to."""
    found = read_study(chosen.study).plan
    threads = chosen.threads or available_threads()
    projected = project(found, threads)
    sizes = " × ".join(f"{size} {name}" for name, size in found.sizes.items())
    lines = [
        ("Study", found.study.title),
        ("Analyses", f"{projected.analyses:,} = {sizes}, in {projected.blocks:,} blocks"),
        (
            "Time",
            f"about {duration(projected.duration)}: {projected.rate:,.0f} analyses/s on {threads} threads, from {projected.tried:,} that were"
            " timed",
        ),
        ("Results", f"{projected.size / 1e6:,.3g} MB before they are compressed"),
    ]
    return Answer(
        lambda: {"dimensions": found.sizes, "threads": threads, **asdict(projected)},
        lambda: Page([lines, grid(_factors(found))]),
    )


def _factors(found: Plan) -> Table:
    def end(of: Any, last: int) -> Any:
        def text(row: tuple[str, Any]) -> str:
            numbers = [value for value in row[1] if not isinstance(value, str)]
            return f"{of(numbers):.6g}" if numbers else str(row[1][last])

        return text

    columns = (
        Quantity("Factor", "name", get=lambda row: row[0]),
        Quantity("Values", "number of values", NONE, head="Values\n", get=lambda row: len(row[1])),
        Quantity("From", "least value", NONE, head="From\n", get=end(min, 0)),
        Quantity("To", "largest value", NONE, head="To\n", get=end(max, -1)),
    )
    return Table(columns, [*found.study.factors.items(), *found.samples.items()])


def duration(seconds: float) -> str:
    """Return a time in the unit that suits it."""
    if seconds < _MINUTE:
        return f"{seconds:.1f} s"
    return f"{seconds / _MINUTE:.1f} min" if seconds < _HOUR else f"{seconds / _HOUR:.1f} h"


def run(chosen: argparse.Namespace) -> Answer:
    """Run the study and show what came of it."""
    study = read_study(chosen.study)
    place = Path(chosen.store if chosen.store is not None else f"{study.name}.zarr")
    began = time.perf_counter()
    dataset = _run(study, place, chosen)
    elapsed = time.perf_counter() - began
    return Answer(
        lambda: {"store": str(place), "elapsed_s": elapsed, **store_object(dataset)},
        lambda: _page(dataset, f"{place}, {elapsed:.1f} s"),
        status=1 if counts(dataset)["failed"] else 0,
    )


def _run(study: Study, place: Path, chosen: argparse.Namespace) -> "xarray.Dataset":
    options: dict[str, Any] = {"resume": chosen.resume, "overwrite": chosen.overwrite}
    try:
        with study_progress(study.plan) as report:
            if chosen.dask is None and chosen.processes is None:
                return run_study(study, place, threads=chosen.threads, report=report, **options)
            return run_on_cluster(
                study, place, address=chosen.dask, processes=chosen.processes, report=report, **options
            )
    except KeyboardInterrupt:
        print(f"dcfp: stopped; {place} keeps what is done, and --resume goes on from it.", file=sys.stderr)
        raise


def show(chosen: argparse.Namespace) -> Answer:
    """Tell what is in a store."""
    dataset = open_store(chosen.store)
    return Answer(lambda: store_object(dataset), lambda: _page(dataset, chosen.store))


def _page(dataset: "xarray.Dataset", place: str) -> Page:
    found = counts(dataset)
    total, done = sum(found.values()), sum(found.values()) - found["not_run"]
    sizes = " × ".join(f"{size} {name}" for name, size in dataset["status"].sizes.items())
    lines = [
        ("Study", str(dataset.attrs["title"])),
        ("Analyses", f"{total:,} = {sizes}" + (f", {done:,} of them done" if done < total else "")),
        ("Store", place),
    ]
    remarks = {
        "beyond_capacity": "of the analyses go beyond the displacement capacity.",
        "still_moving": "of them still move at the end, so that their residual is not final.",
        "failed": "gave no result, and stand as not a number.",
    }
    told = [f"{found[name]:,} {words}" for name, words in remarks.items() if found[name]]
    each = "Each: median and, in brackets, 16 to 84 % of all that is done at the intensity."
    of_stations = [OF_STATIONS] if is_in_plane(dataset) else []
    return Page([lines, grid(summary_table(dataset))], [each, *of_stations, *told])


def histories(chosen: argparse.Namespace) -> Answer:
    """Make the analysis behind one case of a study again."""
    found = read_study(chosen.study).plan
    responses = [response_at(found, values_in(numbered_cases(found), chosen.at))]
    return answer_of(responses)


def export(chosen: argparse.Namespace) -> Answer:
    """Write a store as one file."""
    dataset = open_store(chosen.store)
    return Answer.of_file(chosen.out, lambda part, kind: write_study(part, dataset, kind))


def values_in(dataset: "xarray.Dataset", given: Mapping[str, str]) -> dict[str, float | str]:
    """Return the values of factors in the units of the data set, from those that a user writes."""
    return {name: _value(dataset, name, text) for name, text in given.items()}


def _value(dataset: "xarray.Dataset", name: str, text: str) -> float | str:
    factor = dataset[name] if name in dataset.dims or name in dataset.coords else None
    if factor is not None and not is_number(factor):
        return text
    try:
        number = float(text)
    except ValueError:
        return text  # refused with the values that are there
    return number if factor is None else described(factor).shown.inner(number)


# Scenarios: studies of one bearing.


#: Figures of a case of a report.
_FIGURES = 2


def export_scenario(chosen: argparse.Namespace) -> Answer:
    """Write a scenario as a script for OpenSees, a workbook, or its analyses as data."""
    scenario = read_scenario(chosen.scenario)
    if Path(chosen.out).suffix.lower() == SCRIPT and len(scenario.motions) != 1:
        msg = (
            f"a script is of one record at one intensity, but the scenario has {len(scenario.motions)} analyses;"
            " leave one in it, or write .xlsx."
        )
        raise InputError(msg)
    calculation = _calculated(scenario)
    responses = [one.response for one in calculation.results]
    return Answer.of_file(
        chosen.out,
        lambda part, kind: write_analyses(
            part, kind, responses, lambda: calculation, vertical=scenario.study.vertical
        ),
        {"file": chosen.out, "analyses": calculation.summary},
    )


def report(chosen: argparse.Namespace) -> Answer:
    """Calculate a scenario and write its report."""
    from dcfp.present.report import build_report, check_typst, page_of, pdf_of  # late: it draws figures

    kind = Path(chosen.out or "").suffix.lower()
    if kind == ".pdf":
        check_typst()
    calculation = _calculated(read_scenario(chosen.scenario))
    document = build_report(calculation)

    def data(part: Path, kind: str) -> str | None:
        with progress("figures", _FIGURES * len(calculation.results)) as advance:
            if kind != ".pdf":
                return page_of(document, advance)
            part.write_bytes(pdf_of(document, advance))
            return None

    return Answer.of_file(chosen.out, data, document.numbers)


def _calculated(scenario: Scenario) -> Calculation:
    with progress("analyses", len(scenario.motions)) as advance:
        return calculate(scenario, advance)
