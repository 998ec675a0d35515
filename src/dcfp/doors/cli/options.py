"""The options that several commands share: records, bearing, output."""

import argparse
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from dcfp.doors.cli.parser import Numbers, Parser, fraction, not_negative, positive
from dcfp.errors import InputError
from dcfp.schema.parameters import Parameter


def add_records(parser: Parser, count: str, words: str) -> None:
    """Add the records and how to read them; `count` is ``"*"`` or ``"+"``."""
    parser.add_argument("records", nargs="*", metavar="RECORD", help=words)
    parser.set_defaults(later_records=[], needs_records=count == "+")
    group = parser.add_argument_group("reading a file")
    group.add_argument(
        "--component", metavar="NAME", help="component of a file that holds several (NS, EW, ...)"
    )
    group.add_argument("--units", metavar="U", help="unit of a plain file: mm/s2, cm/s2, gal, m/s2 or g")
    group.add_argument(
        "--time-step", type=positive("s"), metavar="S", help="time step of a plain file with one column [s]"
    )


def add_treatment(parser: Parser) -> None:
    """Add how the records are scaled and treated."""
    group = parser.add_argument_group("motion")
    group.add_argument(
        "--pgv",
        action=Numbers,
        check=positive("m/s", 1e-3, 20.0),
        metavar="M_PER_S",
        help="scale each record to these PGVs; without it a record is used as it is",
    )
    group.add_argument(
        "--baseline",
        action="store_true",
        help="remove the constant acceleration whose velocity fits best (an instrument's offset)",
    )
    group.add_argument(
        "--high-pass",
        type=positive("Hz"),
        metavar="HZ",
        help="zero-phase Butterworth high-pass filter, corner [Hz]",
    )


def option_name(key: str) -> str:
    """Return the name under which the options keep a parameter of the system."""
    return "friction" if key == "law" else key


def add_bearing(parser: Parser) -> None:
    """Add the bearing, its friction law and its heating model: an option for each parameter of a system."""
    from dcfp.system import system_parameters

    group = parser.add_argument_group(
        "bearing", "The bearing of Li et al. (2020), or that of a file; single values override either."
    )
    group.add_argument(
        "--bearing", metavar="FILE.toml", help="bearing file: geometry, load, friction, heating"
    )
    for key, parameter in system_parameters().items():
        if parameter.option:
            add_parameter(group, parameter, option_name(key))


def add_parameter(group: Any, parameter: Parameter, name: str) -> None:
    """Add one declared parameter as an option, to be kept in the package's units."""
    option = f"--{name.replace('_', '-')}"
    settings: dict[str, Any] = {
        "dest": name,
        "metavar": metavar(parameter),
        "help": parameter.help.replace("%", "%%"),
    }
    if parameter.counts:
        group.add_argument(
            option,
            action=Numbers,
            check=_reader(parameter),
            most=max(parameter.counts),
            repeat=parameter.repeat,
            **settings,
        )
    else:
        group.add_argument(option, type=_reader(parameter), **settings)


def _reader(parameter: Parameter) -> Callable[[str], Any]:
    """Return a type that reads the words behind an option, in the package's units."""
    one = replace(parameter, counts=())

    def read(text: str) -> Any:
        value: Any = (
            {"yes": True, "true": True, "no": False, "false": False}.get(text.lower(), text)
            if one.kind is bool
            else text
        )
        try:
            return one.read(value, "")
        except InputError as error:
            raise argparse.ArgumentTypeError(str(error).strip().rstrip(".")) from None

    return read


def metavar(parameter: Parameter) -> str:
    """Return what stands for the value in the help."""
    if not parameter.is_number:
        return "NAME" if parameter.choices else "YES_OR_NO" if parameter.kind is bool else "TEXT"
    unit = parameter.unit.text if parameter.unit.has_dimension else "value"
    return unit.upper().replace("/", "_PER_").translate(str.maketrans(" ()*", "____")).strip("_")


def add_integration(parser: Parser) -> None:
    """Add how finely and how far the analysis goes."""
    group = parser.add_argument_group("integration")
    group.add_argument(
        "--step",
        type=positive("s"),
        metavar="S",
        help="longest step [s]; by default the record's, at most 0.01 while sliding",
    )
    group.add_argument(
        "--tail",
        type=not_negative("s", 3600.0),
        metavar="S",
        help="time after the record [s]; by default until it rests",
    )
    group.add_argument(
        "--tolerance",
        type=fraction(),
        metavar="VALUE",
        help="largest change of the friction coefficient off its chord in a step, relative [-]; default 0.02",
    )


def add_output(
    parser: Parser,
    data: str = "results as NetCDF (.nc) or CSV (.csv); of several analyses a CSV holds the peaks only",
    figure: str = "a figure as .png, .pdf or .svg",
) -> None:
    """Add where results go; `data` and `figure` are the words of the help."""
    group = parser.add_argument_group("output")
    group.add_argument("--json", action="store_true", help="one JSON document on standard output")
    group.add_argument("--out", metavar="FILE", help=data)
    group.add_argument("--plot", metavar="FILE", help=figure)
    group.add_argument("--overwrite", action="store_true", help="replace files that exist")
