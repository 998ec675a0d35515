"""The commands: what each is called, does and may be told; the modules that carry them out are imported when they are run."""

import argparse
from collections.abc import Callable
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.doors.cli import options
from dcfp.doors.cli.parser import Pairs, Parser, add_declared, add_parameter, add_switch
from dcfp.errors import InputError
from dcfp.files import DATA_EXTENSIONS
from dcfp.schema.declared import parameters
from dcfp.schema.parameters import PGV, Parameter
from dcfp.schema.units import DEGREE, FRACTION, MM, NONE, SECOND

if TYPE_CHECKING:
    from dcfp.doors.cli.outputs import Answer

RECORD = "name of a record (dcfp records lists them) or a file, FILE::COMPONENT"
STATION = "P695-FF-2, files joined by + (x, y, vertical), FILE::NS+::EW+::UD, or what K-NET files have before .EW, .NS and .UD, or their folder"
RECORD_OR_STATION = f"{RECORD}; or a station, analysed in the plane: {STATION}"
RECORD_OR_SET = "name of a record or set, or a file, FILE::COMPONENT"
FIGURE = "a figure"

#: Elastic oscillators.
DAMPING = Parameter("ratio of critical damping", FRACTION, 0.0, 0.99, key="damping", default=0.05)
PERIODS = Parameter("increasing periods", SECOND, 0.01, 100.0, key="periods", more="default 200 from 0.05 to 10")  # fmt: skip
ALLOWED = Parameter("displacement that is to hold", MM, 1.0, 1e4, key="allow")
PART = Parameter("percentage", NONE, 1.0, 99.0)
ROTATE = Parameter(
    "angle by which the motion of a station is turned from x towards y", DEGREE, -360.0, 360.0, key="rotate"
)
PORT = Parameter("port", NONE, 1, 65535, key="port", kind=int, default=8080)


#: Endings of the names of reports.
REPORTS = (".pdf", ".html", ".htm")


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
    words = "address to serve at; by default 127.0.0.1, which only this machine can reach"
    parser.add_argument("--host", default="127.0.0.1", metavar="ADDRESS", help=words)
    add_parameter(parser, PORT, default=True)
    add_switch(parser, "--no-browser", "do not open a browser")


def _spectra_given(chosen: argparse.Namespace) -> tuple[list[str], str]:
    """Return the options of design spectra that were given, and in words what can be; an option of one that was not given is refused."""
    from dcfp.methods.spectra.elastic import DESIGN_SPECTRA  # late: other commands need no methods

    known = sorted(DESIGN_SPECTRA)
    given = [name for name in (*known, "spectrum") if getattr(chosen, name) is not None]
    for name in known:
        for key in DESIGN_SPECTRA[name].own_options():
            if getattr(chosen, key) is not None and name not in given:
                msg = f"--{key} belongs to --{name}."
                raise InputError(msg)
    return given, ", ".join(f"--{name}" for name in known) + " and --spectrum"


def _check_codes(chosen: argparse.Namespace) -> None:
    given, choices = _spectra_given(chosen)
    if len(given) + bool(chosen.records) != 1:
        what = ", ".join([*(f"--{name}" for name in given), *chosen.records[:1]]) or "nothing"
        msg = f"give either records or one of {choices}, not {what}."
        raise InputError(msg)
    for name, words in (("of_set", "is of records"), ("pgv", "scales records")):
        if given and getattr(chosen, name) is not None:
            msg = f"--{name.replace('_', '-')} {words}, and --{given[0]} is none; leave out one of the two."
            raise InputError(msg)


@command("codes", check=_check_codes)
def codes(parser: Parser) -> None:
    """Displacement and base shear by ASCE 7, Eurocode 8 and the AIJ, from records or a design spectrum, each with its verdict."""
    from dcfp.methods.code import Bounds, Structure  # late: other commands need no codes
    from dcfp.methods.prediction import Constants

    words = "name of a record or set, or a file: the record's own spectrum, beside its analysis"
    options.add_records(parser, "*", words)
    options.add_design_spectrum(parser.add_argument_group("design spectrum, instead of records"))
    group = parser.add_argument_group("building and site, for the conditions of the codes")
    add_declared(group, Structure)
    add_declared(group, Constants, "nominal_friction", more={"nominal_friction": "as for predict"})
    bounds = parameters(Bounds)
    words = "property modification factors lambda_min and lambda_max on the friction [-]"
    add_parameter(group, bounds["least"], bounds["largest"], name="bounds", words=words, least=2)
    words = "take all records as one: the geometric mean of their spectra, or what so many percent of them stay below"
    parser.add_argument("--of-set", type=_part, metavar="mean|PERCENT", help=words)
    add_switch(parser, "--details", "also every condition and every round of the iterations")
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
    words = (
        "name of a record or a file, FILE::COMPONENT; or of a set: P695 (100 components), P695-FF, P695-NF"
    )
    options.add_records(parser, "+", words)
    words = "also constants and intervals from half of the earthquakes, judged on the other half"
    add_switch(parser, "--held-out", words)
    options.add_treatment(parser)
    options.add_method(parser)
    options.add_bearing(parser)
    options.add_output(parser, "every prediction and analysis as CSV (.csv)", FIGURE)


@command("export", "study:export_scenario")
def export(parser: Parser) -> None:
    """Write a scenario for another program: a script for OpenSees, a workbook for spreadsheets, or NetCDF and CSV."""
    words = "study file of one bearing: records, intensities, bearing (dcfp study new writes one)"
    parser.add_argument("scenario", metavar="SCENARIO.toml", help=words)
    words = "file to write: .py runs with openseespy alone (of one record and intensity), .xlsx is a workbook, .nc and .csv hold the analyses"
    options.add_output(parser, words, kinds=(".py", ".xlsx", *DATA_EXTENSIONS), required=True)


def _check_identify(chosen: argparse.Namespace) -> None:
    if not chosen.files:
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
    words = "measured tests as CSV, whose head names time, displacement, force and load with their units"
    parser.add_argument("files", nargs="*", metavar="FILE", help=words)
    words = "tests to predict by the law, not to fit"
    parser.add_argument("--hold-out", nargs="+", default=[], metavar="FILE", help=words)
    words = (
        "parameters to fit: mu_0, pressure_exponent, pressure_floor, speed_drop, speed_rate, temperature_rate, conductivity;"
        " by default all but pressure_floor and conductivity, as far as the data determine them"
    )
    parser.add_argument("--fit", nargs="+", metavar="NAME", help=words)
    parser.add_argument(
        "--fix",
        action=Pairs,
        read=float,
        example="pressure_exponent=0.19",
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
    if chosen.allow is not None:
        _check_design(chosen)
    given, choices = _spectra_given(chosen)
    if len(given) > 1:
        msg = f"give one of {choices}, not {' and '.join(f'--{name}' for name in given)}."
        raise InputError(msg)
    if given and (chosen.pgv_only is None or chosen.allow is not None):
        msg = f"--{given[0]} is for the design method, which takes PGVs with --pgv-only, without a record and without --allow."
        raise InputError(msg)
    if chosen.pgv_only is None:
        chosen.needs_records = True
        return
    if chosen.records:
        msg = f"--pgv-only takes no record; leave out {chosen.records[0]}, or say --pgv."
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
    words = "instead of records: the design method for these peak ground velocities"
    add_parameter(parser, replace(PGV, words=words, key="pgv_only"), any_number=True)
    words = "also where 90 %% of analyses lie, from the 100 components of FEMA P-695 at the same PGV"
    add_switch(parser, "--interval", words)
    more = "with --pgv-only: which friction and radius hold y_max to it; --plot draws the chart"
    add_parameter(parser, replace(ALLOWED, more=more))
    options.add_design_spectrum(parser.add_argument_group("design spectrum, with --pgv-only"))
    options.add_treatment(parser)
    options.add_method(parser)
    options.add_bearing(parser)
    options.add_output(parser, "predictions as CSV (.csv)", FIGURE)


def _check_records(chosen: argparse.Namespace) -> None:
    if chosen.records:
        return
    if chosen.plot is not None:
        msg = "--plot draws the histories of records; name at least one RECORD."
        raise InputError(msg)
    for name in ("baseline", "high_pass"):
        if getattr(chosen, name):
            msg = f"--{name.replace('_', '-')} corrects records; name at least one RECORD."
            raise InputError(msg)
    if chosen.out is not None and Path(chosen.out).suffix.lower() == ".nc":
        msg = f"{chosen.out}: the list of named records can be written as .csv; name a RECORD for its histories."
        raise InputError(msg)


@command("records", check=_check_records)
def records(parser: Parser) -> None:
    """Named records; or the components of record files and what their motions measure."""
    options.add_records(
        parser,
        "*",
        f"name of a record or a file, or a station: {STATION}; without any, the named records are listed",
    )
    options.add_correction(parser.add_argument_group("motion"))
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


@command("report", "study:report", _name_report)
def report(parser: Parser) -> None:
    """Write the calculation report of a scenario, as PDF or as one page of HTML: inputs, formulas with numbers, results, checks and verdicts."""
    words = "a bearing and its ground motions: a study file in which only record and intensity vary, with a table [report]"
    parser.add_argument("scenario", metavar="SCENARIO.toml", help=words)
    words = "the report as .pdf or .html; by default SCENARIO.pdf in the current folder, with --json none"
    options.add_output(parser, words, kinds=REPORTS)
    parser.set_defaults(noun="a report")


@command("reproduce", "verify:reproduce")
def reproduce(parser: Parser) -> None:
    """Make the findings and figures of Li et al. (2020), section 6, again, and put them beside what the paper prints."""
    parser.add_argument(
        "files",
        nargs="*",
        action=Pairs,
        example="JKB=kobe.csv::NS",
        metavar="NAME=FILE",
        help="a record of the paper that does not come with the package, where you have it: JKB, TC1, TSD or TIM and its file",
    )
    group = parser.add_argument_group("records of your own")
    words = "folder with files of such records, found by earthquake and station (or a name as JKB.csv); of several components the one whose PGV is nearest to Table 3"
    group.add_argument("--records", metavar="FOLDER", help=words)
    options.add_correction(group)
    words = "one page with findings and figures (.html)"
    options.add_output(parser, words, "all figures on one sheet", (".html",))


@command("respond")
def respond(parser: Parser) -> None:
    """Response history analysis of a rigid structure on a friction pendulum bearing."""
    from dcfp.analysis.half_cycles import LEAST_CHANGE  # late: other commands analyse nothing
    from dcfp.analysis.integration import Integration

    options.add_records(parser, "+", RECORD_OR_STATION)
    group = options.add_treatment(parser)
    add_parameter(group, ROTATE)
    add_switch(group, "--vertical", "let the vertical force of a station follow its vertical component")
    options.add_bearing(parser)
    add_declared(parser.add_argument_group("integration"), Integration)
    add_parameter(parser.add_argument_group("half cycles, in place of the peaks"), LEAST_CHANGE)
    options.add_output(
        parser,
        "results as NetCDF (.nc) or CSV (.csv; of several analyses the peaks only), with predictions and codes as a workbook (.xlsx),"
        " or one analysis as a script that runs with openseespy alone (.py)",
        FIGURE,
        (*DATA_EXTENSIONS, ".xlsx", ".py"),
    )


@command("spectrum")
def spectrum(parser: Parser) -> None:
    """Elastic response and input energy spectra of records, or of a set of them; response spectra of stations over all directions."""
    options.add_records(parser, "+", f"{RECORD_OR_SET}; or a station: {STATION}")
    group = parser.add_argument_group("oscillators")
    add_parameter(group, DAMPING, default=True)
    add_parameter(group, PERIODS, any_number=True)
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
    from dcfp.analysis.integration import Integration  # late: other commands test nothing
    from dcfp.analysis.rig.codes import PrototypeDesign

    words = (
        "dependency or asce (Li et al. 2020, Tables 1 and 2); plane (paths in two directions); asce7-16 or en15129 (prototype tests of a design); or a file: a"
        " program as .toml, a measured displacement or path as .csv"
    )
    parser.add_argument("program", metavar="PROGRAM", help=words)
    parser.add_argument("--tests", nargs="+", metavar="NAME", help="only these tests of the program")
    words = "precise and simplified heating and the constant nominal coefficient, side by side"
    add_switch(parser, "--compare", words)
    words = "instead of the cycles: the checks of the program's code and the property modification factors"
    add_switch(parser, "--checks", words)
    parser.add_argument(
        "--measured",
        action=Pairs,
        alone=True,
        example="T01=loop.csv",
        metavar="TEST=FILE",
        help="measured tests (CSV with time, displacement, force and load) to put beside those of the program",
    )
    add_declared(parser, Integration, "tolerance")
    group = parser.add_argument_group("design, for asce7-16 and en15129")
    add_declared(group, PrototypeDesign, "displacement", "period", "total_displacement")
    options.add_bearing(parser)
    options.add_output(
        parser,
        "results as NetCDF (.nc) or CSV (.csv): histories of one test; of several a CSV holds the measures of every cycle or lap",
        FIGURE,
        DATA_EXTENSIONS,
    )


@command("verify")
def verify(parser: Parser) -> None:
    """Check the package against other programs and against formulas, and tell by how much it differs."""
    add_switch(parser, "--full", "also the checks that take minutes")
    options.add_output(parser, "every check as CSV (.csv)", "differences over what is allowed")
