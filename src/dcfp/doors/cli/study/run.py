"""Run a study, or what is left of it: every combination of its factors, into a store."""

import argparse
import json
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dcfp.doors.cli.parser import Parser, whole_number
from dcfp.errors import InputError

if TYPE_CHECKING:
    import xarray

    from dcfp.study import Study


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    parser.add_argument("study", metavar="STUDY.toml", help="study file; dcfp study new writes one")
    parser.add_argument(
        "--out",
        metavar="STORE",
        help="folder of the store; by default that of the study file, as .zarr, here",
    )
    parser.add_argument("--resume", action="store_true", help="go on with a store that is there")
    parser.add_argument("--overwrite", action="store_true", help="replace a store that is there")
    add_machine(parser)
    parser.add_argument("--json", action="store_true", help="one JSON document on standard output")


def add_machine(parser: Parser) -> None:
    """Add where the analyses run."""
    group = parser.add_argument_group("machine")
    group.add_argument(
        "--threads",
        type=whole_number(1, 1024),
        metavar="N",
        help="analyses at the same time; by default one for each processor",
    )
    group.add_argument(
        "--dask", metavar="ADDRESS", help="Dask scheduler whose workers run the analyses, tcp://HOST:PORT"
    )
    group.add_argument(
        "--processes", type=whole_number(1, 1024), metavar="N", help="Dask workers to start on this machine"
    )


def run(chosen: argparse.Namespace) -> int:
    """Run the study and show what came of it."""
    _check(chosen)
    from dcfp.doors.cli.study.summary import counts, print_summary, summary_object
    from dcfp.study import read_study

    study = read_study(chosen.study)
    place = Path(chosen.out if chosen.out is not None else f"{study.name}.zarr")
    began = time.perf_counter()
    done: list[int] = []
    dataset = _run(study, place, chosen, done)
    elapsed = time.perf_counter() - began
    if chosen.json:
        document = {"store": str(place), "elapsed_s": elapsed, **summary_object(dataset)}
        print(json.dumps(document, indent=2, allow_nan=False))
    else:
        print_summary(dataset, str(place), elapsed)
    return 1 if counts(dataset)["failed"] else 0


def _check(chosen: argparse.Namespace) -> None:
    if chosen.resume and chosen.overwrite:
        msg = "--resume goes on with a store and --overwrite replaces it; give one of the two."
        raise InputError(msg)
    places = [name for name in ("threads", "dask", "processes") if getattr(chosen, name) is not None]
    if len(places) > 1:
        msg = f"--{places[0]} and --{places[1]} say where the analyses run in two ways; give one."
        raise InputError(msg)


def _run(study: "Study", place: Path, chosen: argparse.Namespace, done: list[int]) -> "xarray.Dataset":
    from dcfp.doors.cli.progress import study_bar
    from dcfp.study.cluster import run_on_cluster
    from dcfp.study.run import run_study

    options: dict[str, Any] = {"resume": chosen.resume, "overwrite": chosen.overwrite}
    try:
        with study_bar(study.plan) as report:
            if chosen.dask is None and chosen.processes is None:
                return run_study(study, place, threads=chosen.threads, report=report, **options)
            return run_on_cluster(
                study, place, address=chosen.dask, processes=chosen.processes, report=report, **options
            )
    except KeyboardInterrupt:
        import sys

        print(f"dcfp: stopped; {place} keeps what is done, and --resume goes on from it.", file=sys.stderr)
        raise
