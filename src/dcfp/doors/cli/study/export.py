"""Write a store as one file: NetCDF with everything, or CSV with a line for each analysis."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Parser

if TYPE_CHECKING:
    import xarray


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    parser.add_argument("store", metavar="STORE", help="store of a study")
    parser.add_argument("--out", metavar="FILE", required=True, help="file to write, .nc or .csv")
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")


def run(chosen: argparse.Namespace) -> int:
    """Write the file."""
    outputs = Outputs.checked(chosen, [Path(chosen.store)])
    from dcfp.study.results import open_store

    dataset = open_store(chosen.store)
    outputs.write_with(lambda part, kind: _write(dataset, part, kind), lambda _, __: None)
    print(f"{chosen.out}: written.")
    return 0


def _write(dataset: "xarray.Dataset", part: Path, kind: str) -> None:
    from dcfp.present.tables.responses import study_csv, write_study_netcdf

    if kind == ".csv":
        study_csv(dataset, part)
    else:
        write_study_netcdf(dataset, part)
