"""The options that several commands share: records, bearing, integration, prediction, output."""

from dataclasses import replace
from typing import Any

from dcfp.doors.cli.parser import Parser, add_declared, add_parameter, add_switch
from dcfp.schema.declared import parameters
from dcfp.schema.parameters import HIGH_PASS, PGV, TIME_STEP

PGVS = replace(
    PGV,
    words="peak ground velocities that each record is scaled to",
    more="without it a record is used as it is",
)


def add_records(parser: Parser, count: str, words: str) -> None:
    """Add the records and how to read them; `count` is ``"*"`` or ``"+"``."""
    parser.add_argument("records", nargs="*", metavar="RECORD", help=words)
    parser.set_defaults(needs_records=count == "+")
    group = parser.add_argument_group("reading a file")
    words = "component of a file that holds several (NS, EW, ...)"
    group.add_argument("--component", metavar="NAME", help=words)
    group.add_argument("--units", metavar="U", help="unit of a plain file: mm/s2, cm/s2, gal, m/s2 or g")
    add_parameter(group, TIME_STEP)


def add_treatment(parser: Parser) -> Any:
    """Add how the records are scaled and treated; return the group of these options."""
    group = parser.add_argument_group("motion")
    add_parameter(group, PGVS, any_number=True)
    add_correction(group)
    return group


def add_correction(group: Any) -> None:
    """Add how an instrument's offset and what is slower than the record can tell are taken out of the records."""
    words = "remove the constant acceleration whose velocity fits best (an instrument's offset)"
    add_switch(group, "--baseline", words)
    add_parameter(group, HIGH_PASS)


def add_design_spectrum(group: Any) -> None:
    """Add the options that choose a design spectrum."""
    from dcfp.methods.spectra.elastic import DESIGN_SPECTRA  # late: other commands need no methods

    for name, kind in sorted(DESIGN_SPECTRA.items()):
        least, most = kind.behind
        own = list(parameters(kind).values())[:most]
        add_parameter(group, *own, name=name, words=kind.words, least=least)
        for one in kind.own_options().values():
            add_parameter(group, replace(one, more=f"of --{name}"))
    words = "periods and pseudo-accelerations at a damping of 5 %%"
    group.add_argument("--spectrum", metavar="FILE.csv", help=words)


def option_name(key: str) -> str:
    """Return the name under which the options keep a parameter of the system."""
    return "friction" if key == "law" else key


def add_bearing(parser: Parser) -> None:
    """Add the bearing, its friction law and its heating model: an option for each parameter of a system."""
    from dcfp.system import system_parameters  # late: other commands need no laws

    group = parser.add_argument_group(
        "bearing", "The bearing of Li et al. (2020), or that of a file; single values override either."
    )
    words = "bearing file: geometry, load, friction, heating"
    group.add_argument("--bearing", metavar="FILE.toml", help=words)
    for key, parameter in system_parameters().items():
        if parameter.option:
            add_parameter(group, replace(parameter, key=option_name(key)))


def add_method(parser: Parser) -> None:
    """Add the constants of the methods of prediction."""
    from dcfp.methods.prediction import Constants, Methods  # late: other commands predict nothing

    group = parser.add_argument_group(
        "prediction", "Constants of the methods of Li et al. (2020); by default the paper's."
    )
    more = {"nominal_friction": "default 0.043 for the paper's law, else what the virtual test T01 gives"}
    add_declared(group, Constants, more=more)
    add_declared(group, Methods)


def add_output(
    parser: Parser,
    data: str = "",
    figure: str = "",
    kinds: tuple[str, ...] = (".csv",),
    *,
    required: bool = False,
) -> None:
    """Add where results go.

    Parameters
    ----------
    parser
        Of the command.
    data, figure
        Words of the help; empty where there is no such file.
    kinds
        Formats of the data.
    required
        Whether the data must be asked for.
    """
    group = parser.add_argument_group("output")
    add_switch(group, "--json", "one JSON document on standard output")
    if data:
        group.add_argument("--out", metavar="FILE", help=data, required=required)
    if figure:
        group.add_argument("--plot", metavar="FILE", help=f"{figure} as .png, .pdf or .svg")
    if data or figure:
        add_switch(group, "--overwrite", "replace files that exist")
    parser.set_defaults(kinds=kinds)
