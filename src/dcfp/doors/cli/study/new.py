"""Write a study file to start from, with every kind of factor in it and words beside each."""

import argparse
from importlib.resources import files
from pathlib import Path

from dcfp.doors.cli.parser import Parser
from dcfp.files import check_outputs, known_extension, whole_files


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    parser.add_argument("study", metavar="STUDY.toml", help="file to write")
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")


def run(chosen: argparse.Namespace) -> int:
    """Write the file."""
    path = known_extension(chosen.study, (".toml",), "a study")
    check_outputs([path], overwrite=chosen.overwrite)
    text = files("dcfp.study").joinpath("template.toml").read_text(encoding="utf-8")
    with whole_files([path], overwrite=chosen.overwrite) as (part,):
        Path(part).write_text(text, encoding="utf-8")
    print(f"{path}: written; dcfp study plan {path} says how long it takes, dcfp study {path} runs it.")
    return 0
