"""The commands: what each is called, does and may be told; the modules that carry them out are imported when they are run."""

import argparse
from collections.abc import Callable
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.doors.cli import options
from dcfp.doors.cli.parser import Parser, add_parameter, add_parameters
from dcfp.errors import InputError
from dcfp.files import DATA_EXTENSIONS
from dcfp.schema.parameters import Parameter, parameters
from dcfp.schema.units import FRACTION, KM, M_PER_S2, METRE, MM, NONE, SECOND

if TYPE_CHECKING:
    from dcfp.doors.cli.outputs import Answer

RECORD = "name of a record (dcfp records lists them) or a file, FILE::COMPONENT"
RECORD_OR_SET = "name of a record or set, or a file, FILE::COMPONENT"
FIGURE = "a figure"

STOREYS = Parameter("number of storeys", NONE, 1, 60, kind=int, default=5)
FIXED_BASE_PERIOD = Parameter("first period on a fixed base", SECOND, 0.01, 10.0, default=0.5)
BUILDING_DAMPING = Parameter(
    "damping ratio of the first mode on a fixed base, proportional to the stiffness",
    FRACTION,
    0.0,
    0.5,
    default=0.02,
)
ALLOWED = Parameter("displacement that is to hold", MM, 1.0, 1e4)
DAMPING = Parameter("ratio of critical damping", FRACTION, 0.0, 0.99, default=0.05)
PERIODS = Parameter("increasing periods", SECOND, 0.01, 100.0, more="default 200 from 0.05 to 10")
ASCE = (
    Parameter("S_MS in g", NONE, 1e-3, 10.0),
    Parameter("S_M1 in g", NONE, 1e-3, 10.0),
    Parameter("T_L", SECOND, 0.1, 30.0, default=8.0),
)
EUROCODE = Parameter("ground acceleration a_g on ground type A", M_PER_S2, 0.01, 50.0)
SPECTRUM_TYPE = Parameter("type of the spectrum of Eurocode 8; 1 unless given", NONE, 1, 2, kind=int)
SOIL = Parameter("very rare earthquake of Notification 1457 on a soil class", NONE, 1, 3, kind=int)
PART = Parameter("percentage", NONE, 1.0, 99.0)
STRUCTURE = {
    "fixed_base_period": Parameter(
        "period of the structure without isolation; 0 for a rigid one", SECOND, 0.0, 10.0
    ),
    "height": Parameter("height above the isolation", METRE, 0.0, 1000.0, above=True),
    "plan": Parameter("larger dimension of the plan", METRE, 0.0, 1000.0, above=True),
    "fault_distance": Parameter("distance to a fault of magnitude 6.5 or more", KM, 0.0, 1e4, above=True),
    "weight_above": Parameter(
        "weight above the base level over the whole, for V_st of ASCE 7", FRACTION, 0.0, 0.9999, above=True
    ),
}
BOUNDS = (
    Parameter("property modification factor lambda_min on the friction", NONE, 0.1, 10.0),
    Parameter("lambda_max", NONE, 0.1, 10.0),
)
DESIGN = {
    "displacement": Parameter("maximum displacement D_M or d_bd", MM, 1.0, 1e4),
    "period": Parameter("effective period at that displacement", SECOND, 0.1, 100.0),
    "total_displacement": Parameter(
        "maximum displacement with torsion", MM, 1.0, 1e4, more="default 1.15 times the displacement"
    ),
}
PORT = Parameter("port", NONE, 1, 65535, kind=int, default=8080)


@dataclass(frozen=True)
class Command:
    """One command.

    Attributes
    ----------
    name
        The words behind ``dcfp``.
    add_options
        Adds its options to a parser; its docstring says what the command does.
    home
        Module of this package and function in it that carry it out.
    check
        Refuses options that do not go together, before anything is imported.
    """

    name: str
    add_options: Callable[[Parser], None]
    home: str
    check: Callable[[argparse.Namespace], None]

    @property
    def words(self) -> str:
        """What it does."""
        return (self.add_options.__doc__ or "").strip()

    @property
    def parser(self) -> Parser:
        """The parser of its options."""
        parser = Parser(prog=f"dcfp {self.name}", description=self.words)
        parser.set_defaults(later_records=[], needs_records=False, kinds=(), noun="data")
        self.add_options(parser)
        return parser

    @property
    def run(self) -> "Callable[[argparse.Namespace], Answer | None]":
        """What carries it out."""
        module, _, function = self.home.partition(":")
        return getattr(import_module(f"dcfp.doors.cli.{module}"), function or "run")


COMMANDS: dict[str, Command] = {}


def command(
    name: str, home: str = "", check: Callable[[argparse.Namespace], None] = lambda chosen: None
) -> Callable[[Callable[[Parser], None]], Callable[[Parser], None]]:
    """Make a command of what adds its options."""

    def add(add_options: Callable[[Parser], None]) -> Callable[[Parser], None]:
        COMMANDS[name] = Command(name, add_options, home or name, check)
        return add_options

    return add


@command("app")
def app(parser: Parser) -> None:
    """Web page: response, test machine and design chart, served to a browser on this machine."""
    parser.add_argument(
        "--host",
        default="127.0.0.1",
        metavar="ADDRESS",
        help="address to serve at; by default 127.0.0.1, which only this machine can reach",
    )
    add_parameter(parser, PORT, "port", default=True)
    parser.add_argument("--no-browser", action="store_true", help="do not open a browser")


@command("building")
def building(parser: Parser) -> None:
    """Multi-storey shear building on the bearing, beside the rigid structure: energies, drifts and floor accelerations."""
    options.add_records(parser, "+", RECORD_OR_SET)
    group = parser.add_argument_group("building: equal storeys on a base as heavy as a floor")
    add_parameter(group, STOREYS, "storeys", default=True)
    add_parameter(group, FIXED_BASE_PERIOD, "fixed_base_period", default=True)
    add_parameter(group, BUILDING_DAMPING, "damping", default=True)
    options.add_treatment(parser)
    options.add_bearing(parser)
    options.add_output(parser, "a line for each analysis as CSV (.csv)")


def _check_codes(chosen: argparse.Namespace) -> None:
    given = [name for name in ("asce", "eurocode", "japan", "spectrum") if getattr(chosen, name) is not None]
    names = [*chosen.records, *chosen.later_records]
    if len(given) + bool(names) != 1:
        what = ", ".join([*(f"--{name}" for name in given), *names[:1]]) or "nothing"
        msg = f"give either records or one of --asce, --eurocode, --japan and --spectrum, not {what}."
        raise InputError(msg)
    for name, words in (("of_set", "is of records"), ("pgv", "scales records")):
        if given and getattr(chosen, name) is not None:
            msg = f"--{name.replace('_', '-')} {words}, and --{given[0]} is none; leave out one of the two."
            raise InputError(msg)
    for name in ("ground", "type"):
        if getattr(chosen, name) is not None and chosen.eurocode is None:
            msg = f"--{name} belongs to --eurocode."
            raise InputError(msg)


@command("codes", check=_check_codes)
def codes(parser: Parser) -> None:
    """Displacement and base shear by ASCE 7, Eurocode 8 and the AIJ, from records or a design spectrum, each with its verdict."""
    options.add_records(
        parser, "*", "name of a record or set, or a file: the record's own spectrum, beside its analysis"
    )
    group = parser.add_argument_group("design spectrum, instead of records")
    add_parameters(group, ASCE, "asce", least=2)
    add_parameter(group, EUROCODE, "eurocode")
    group.add_argument("--ground", metavar="TYPE", help="ground type of Eurocode 8, A to E; B unless given")
    add_parameter(group, SPECTRUM_TYPE, "type")
    add_parameter(group, SOIL, "japan")
    group.add_argument(
        "--spectrum", metavar="FILE.csv", help="periods and pseudo-accelerations at a damping of 5 %%"
    )
    group = parser.add_argument_group("building and site, for the conditions of the codes")
    for name, parameter in STRUCTURE.items():
        add_parameter(group, parameter, name)
    group.add_argument("--site-class", metavar="A-F", help="site class of ASCE 7")
    add_parameter(group, options.NOMINAL, "nominal_mu", more="as for predict")
    add_parameters(group, BOUNDS, "bounds", least=2)
    parser.add_argument(
        "--of-set",
        type=_part,
        metavar="mean|PERCENT",
        help="take all records as one: the geometric mean of their spectra, or what so many percent of them stay below",
    )
    parser.add_argument(
        "--details", action="store_true", help="also every condition and every round of the iterations"
    )
    options.add_treatment(parser)
    options.add_bearing(parser)
    options.add_output(parser, "a line for each method as CSV (.csv)", FIGURE)


def _part(text: str) -> float:
    """Return 0 for the mean, else a percentage as a part [-]."""
    if text.strip().lower() == "mean":
        return 0.0
    try:
        return PART.read(text, "what so many percent of the records stay below") / 100.0
    except InputError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _check_compare(chosen: argparse.Namespace) -> None:
    if chosen.held_out and chosen.pgv is None:
        msg = "--held-out compares records at the same PGV; say which with --pgv, for example --pgv 0.25 0.5 0.75 1.0."
        raise InputError(msg)


@command("compare", check=_check_compare)
def compare(parser: Parser) -> None:
    """Predictions against response history analysis, for any set of records and PGVs: ratios, scatter, refitted constants."""
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
    options.add_method(parser)
    options.add_bearing(parser)
    options.add_output(parser, "every prediction and analysis as CSV (.csv)", FIGURE)


@command("export", "scenario:export")
def export(parser: Parser) -> None:
    """Write a scenario for another program: a script for OpenSees, a workbook for spreadsheets, or NetCDF and CSV."""
    parser.add_argument(
        "scenario",
        metavar="SCENARIO.toml",
        help="study file of one bearing: records, intensities, bearing (dcfp study new writes one)",
    )
    options.add_output(
        parser,
        "file to write: .py runs with openseespy alone (of one record and intensity), .xlsx is a workbook, .nc and .csv hold the analyses",
        kinds=(".py", ".xlsx", ".nc", ".csv"),
        required=True,
    )


def _check_identify(chosen: argparse.Namespace) -> None:
    if not [*chosen.files, *chosen.later_records]:
        msg = "name at least one FILE, a measured test as CSV with time, displacement, force and load."
        raise InputError(msg)
    if chosen.friction is not None and chosen.friction != "fitted":
        msg = f"--friction {chosen.friction}: the law that is fitted has the form 'fitted', that of Li et al. (2020) with free constants; leave the option out."
        raise InputError(msg)
    if chosen.pressure is not None:
        msg = f"--pressure {chosen.pressure:g} has no effect: the measured files hold the load; leave the option out."
        raise InputError(msg)
    if chosen.mu is not None:
        msg = f"--mu {chosen.mu:g}: to keep the reference coefficient at this value, say --fix mu_0={chosen.mu:g}."
        raise InputError(msg)


@command("identify", check=_check_identify)
def identify(parser: Parser) -> None:
    """Friction law from measured tests: estimates, 95 % intervals, and tests that were held out."""
    parser.add_argument(
        "files",
        nargs="*",
        metavar="FILE",
        help="measured tests as CSV, whose head names time, displacement, force and load with their units",
    )
    parser.add_argument(
        "--hold-out", nargs="+", default=[], metavar="FILE", help="tests to predict by the law, not to fit"
    )
    parser.add_argument(
        "--fit",
        nargs="+",
        metavar="NAME",
        help="parameters to fit: mu_0, pressure_exponent, pressure_floor, speed_drop, speed_rate, temperature_rate, conductivity;"
        " by default all but pressure_floor and conductivity, as far as the data determine them",
    )
    parser.add_argument(
        "--fix",
        nargs="+",
        default=[],
        metavar="NAME=VALUE",
        help="values of others, in the units of a bearing file; also reference_pressure, reference_temperature and diffusivity",
    )
    options.add_bearing(parser)
    options.add_output(
        parser,
        "a bearing file with the law (.toml), everything (.json), or the estimates (.csv)",
        "coefficients, factors and residuals",
        (".toml", ".json", ".csv"),
    )


def _check_predict(chosen: argparse.Namespace) -> None:
    names = [*chosen.records, *chosen.later_records]
    if chosen.allow is not None:
        _check_design(chosen)
    if chosen.pgv_only is None:
        chosen.needs_records = True
        return
    if names:
        msg = f"--pgv-only takes no record; leave out {names[0]}, or say --pgv."
        raise InputError(msg)
    for name in ("component", "units", "time_step", "baseline", "high_pass", "threshold"):
        if getattr(chosen, name):
            msg = f"--{name.replace('_', '-')} is for records; with --pgv-only there is none."
            raise InputError(msg)
    if chosen.pgv is not None:
        msg = "--pgv scales records, and --pgv-only is for PGVs without one; give one of the two."
        raise InputError(msg)


def _check_design(chosen: argparse.Namespace) -> None:
    if chosen.pgv_only is None:
        msg = "--allow asks for a design, which is for PGVs without a record; say which with --pgv-only."
        raise InputError(msg)
    if chosen.interval:
        msg = "--allow and --interval answer different questions; give one of the two."
        raise InputError(msg)
    for name in ("radius", "mu"):
        if getattr(chosen, name) is not None:
            msg = f"--allow varies what --{name} sets; leave out one of the two."
            raise InputError(msg)


@command("predict", check=_check_predict)
def predict(parser: Parser) -> None:
    """Displacement and energy from the velocity pulses of a record, or from the PGV alone, without a response history analysis."""
    options.add_records(parser, "*", RECORD)
    only = replace(
        options.PGV, words="instead of records: the design method for these peak ground velocities"
    )
    add_parameter(parser, only, "pgv_only", several=True)
    parser.add_argument(
        "--interval",
        action="store_true",
        help="also where 90 %% of analyses lie, from the 100 components of FEMA P-695 at the same PGV",
    )
    add_parameter(
        parser,
        ALLOWED,
        "allow",
        more="with --pgv-only: which friction and radius hold y_max to it; --plot draws the chart",
    )
    options.add_treatment(parser)
    options.add_method(parser)
    options.add_bearing(parser)
    options.add_output(parser, "predictions as CSV (.csv)", FIGURE)


def _check_records(chosen: argparse.Namespace) -> None:
    if chosen.records or chosen.later_records:
        return
    if chosen.plot is not None:
        msg = "--plot draws the histories of records; name at least one RECORD."
        raise InputError(msg)
    if chosen.out is not None and Path(chosen.out).suffix.lower() == ".nc":
        msg = f"{chosen.out}: the list of named records can be written as .csv; name a RECORD for its histories."
        raise InputError(msg)


@command("records", check=_check_records)
def records(parser: Parser) -> None:
    """Named records; or the components of record files and what their motions measure."""
    options.add_records(parser, "*", "name of a record or a file; without any, the named records are listed")
    options.add_output(
        parser,
        "the list as CSV (.csv); of records, their histories as NetCDF (.nc), or as CSV (.csv) the histories of one, "
        "the measures of several",
        "the histories of each RECORD",
        DATA_EXTENSIONS,
    )


def _name_report(chosen: argparse.Namespace) -> None:
    if chosen.out is None and not chosen.json:
        chosen.out = f"{Path(chosen.scenario).stem}.pdf"


@command("report", "scenario:report", _name_report)
def report(parser: Parser) -> None:
    """Write the calculation report of a scenario, as PDF or as one page of HTML: inputs, formulas with numbers, results, checks and verdicts."""
    parser.add_argument(
        "scenario",
        metavar="SCENARIO.toml",
        help="a bearing and its ground motions: a study file in which only record and intensity vary, with a table [report]",
    )
    options.add_output(
        parser,
        "the report as .pdf or .html; by default SCENARIO.pdf in the current folder, with --json none",
        kinds=(".pdf", ".html", ".htm"),
    )
    parser.set_defaults(noun="a report")


@command("reproduce")
def reproduce(parser: Parser) -> None:
    """Make the findings and figures of Li et al. (2020), section 6, again, and put them beside what the paper prints."""
    parser.add_argument(
        "files",
        nargs="*",
        metavar="NAME=FILE",
        help="a record of the paper that does not come with the package, where you have it: JKB, TC1, TSD or TIM and its file",
    )
    options.add_output(
        parser, "one page with findings and figures (.html)", "all figures on one sheet", (".html",)
    )


@command("respond")
def respond(parser: Parser) -> None:
    """Response history analysis of a rigid structure on a friction pendulum bearing."""
    options.add_records(parser, "+", RECORD)
    options.add_treatment(parser)
    options.add_bearing(parser)
    options.add_integration(parser)
    options.add_output(
        parser,
        "results as NetCDF (.nc) or CSV (.csv; of several analyses the peaks only), with predictions and codes as a workbook (.xlsx),"
        " or one analysis as a script that runs with openseespy alone (.py)",
        FIGURE,
        (*DATA_EXTENSIONS, ".xlsx", ".py"),
    )


@command("spectrum")
def spectrum(parser: Parser) -> None:
    """Elastic response and input energy spectra of records, or of a set of them."""
    options.add_records(parser, "+", RECORD_OR_SET)
    group = parser.add_argument_group("oscillators")
    add_parameter(group, DAMPING, "damping", default=True)
    add_parameter(group, PERIODS, "periods", several=True)
    options.add_treatment(parser)
    options.add_output(parser, "every period of every record as CSV (.csv)", FIGURE)


def _check_test(chosen: argparse.Namespace) -> None:
    if chosen.later_records:
        msg = f"{chosen.later_records[0]!r} is one PROGRAM too many; name one."
        raise InputError(msg)
    if chosen.checks and (chosen.compare or chosen.measured):
        msg = f"--checks is made with one model and without measured tests; leave out {'--compare' if chosen.compare else '--measured'}."
        raise InputError(msg)


@command("test", check=_check_test)
def test(parser: Parser) -> None:
    """Virtual test machine: a bearing through the tests of a program, measures of every cycle, checks of codes."""
    from dcfp.analysis.integration import Integration  # late: other commands analyse nothing

    parser.add_argument(
        "program",
        metavar="PROGRAM",
        help="dependency or asce (Li et al. 2020, Tables 1 and 2); asce7-16 or en15129 (prototype tests of a design); or a file: a program as "
        ".toml, a measured displacement as .csv",
    )
    parser.add_argument("--tests", nargs="+", metavar="NAME", help="only these tests of the program")
    parser.add_argument(
        "--compare",
        action="store_true",
        help="precise and simplified heating and the constant nominal coefficient, side by side",
    )
    parser.add_argument(
        "--checks",
        action="store_true",
        help="instead of the cycles: the checks of the program's code and the property modification factors",
    )
    parser.add_argument(
        "--measured",
        nargs="+",
        default=[],
        metavar="TEST=FILE",
        help="measured tests (CSV with time, displacement, force and load) to put beside those of the program",
    )
    add_parameter(parser, parameters(Integration)["tolerance"], "tolerance")
    group = parser.add_argument_group("design, for asce7-16 and en15129")
    for name, parameter in DESIGN.items():
        add_parameter(group, parameter, name)
    options.add_bearing(parser)
    options.add_output(
        parser,
        "results as NetCDF (.nc) or CSV (.csv): histories of one test; of several a CSV holds the measures of every cycle",
        FIGURE,
        DATA_EXTENSIONS,
    )


@command("verify")
def verify(parser: Parser) -> None:
    """Check the package against other programs and against formulas, and tell by how much it differs."""
    parser.add_argument("--full", action="store_true", help="also the checks that take minutes")
    options.add_output(parser, "every check as CSV (.csv)", "differences over what is allowed")
