"""The options that several commands share: records, bearing, integration, prediction, output."""

from dataclasses import replace

from dcfp.doors.cli.parser import Parser, add_parameter
from dcfp.schema.parameters import PGV, Parameter, parameters
from dcfp.schema.units import FRACTION, HERTZ, MM_PER_S2, NONE, SECOND

TIME_STEP = Parameter("time step of a plain file with one column", SECOND, 0.0, above=True)
HIGH_PASS = Parameter("corner of a zero-phase Butterworth high-pass filter", HERTZ, 0.0, above=True)
NOMINAL = Parameter("constant coefficient mu_n that stands for the law", FRACTION, 0.0, 0.9999, above=True)
EPS = Parameter("eps of Eq. (26)", NONE, 1e-3, 10.0, default=0.25)
ZETA = Parameter("zeta of Eq. (29)", NONE, 0.1, 10.0, default=1.5)
AVERAGE_SLOPE = Parameter("kg_ave of Eq. (28), at a PGV of 0.25 m/s", MM_PER_S2, 10.0, 1e5, default=930.0)
THRESHOLD = Parameter(
    "part of PGV by which the ground velocity must turn back for a peak to count",
    FRACTION,
    0.0,
    0.9999,
    above=True,
    default=0.2,
)


def add_records(parser: Parser, count: str, words: str) -> None:
    """Add the records and how to read them; `count` is ``"*"`` or ``"+"``."""
    parser.add_argument("records", nargs="*", metavar="RECORD", help=words)
    parser.set_defaults(needs_records=count == "+")
    group = parser.add_argument_group("reading a file")
    group.add_argument(
        "--component", metavar="NAME", help="component of a file that holds several (NS, EW, ...)"
    )
    group.add_argument("--units", metavar="U", help="unit of a plain file: mm/s2, cm/s2, gal, m/s2 or g")
    add_parameter(group, TIME_STEP, "time_step")


def add_treatment(parser: Parser) -> None:
    """Add how the records are scaled and treated."""
    group = parser.add_argument_group("motion")
    words = replace(
        PGV,
        words="scale each record to these peak ground velocities",
        more="without it a record is used as it is",
    )
    add_parameter(group, words, "pgv", several=True)
    group.add_argument(
        "--baseline",
        action="store_true",
        help="remove the constant acceleration whose velocity fits best (an instrument's offset)",
    )
    add_parameter(group, HIGH_PASS, "high_pass")


def option_name(key: str) -> str:
    """Return the name under which the options keep a parameter of the system."""
    return "friction" if key == "law" else key


def add_bearing(parser: Parser) -> None:
    """Add the bearing, its friction law and its heating model: an option for each parameter of a system."""
    from dcfp.system import system_parameters  # late: other commands need no laws

    group = parser.add_argument_group(
        "bearing", "The bearing of Li et al. (2020), or that of a file; single values override either."
    )
    group.add_argument(
        "--bearing", metavar="FILE.toml", help="bearing file: geometry, load, friction, heating"
    )
    for key, parameter in system_parameters().items():
        if parameter.option:
            add_parameter(group, parameter, option_name(key))


def add_integration(parser: Parser) -> None:
    """Add how finely and how far the analysis goes."""
    from dcfp.analysis.integration import Integration  # late: other commands analyse nothing

    group = parser.add_argument_group("integration")
    for name, parameter in parameters(Integration).items():
        add_parameter(group, parameter, name)


def add_method(parser: Parser) -> None:
    """Add the constants of the methods of prediction."""
    group = parser.add_argument_group(
        "prediction", "Constants of the methods of Li et al. (2020); by default the paper's."
    )
    more = "default 0.043 for the paper's law, else what the virtual test T01 gives"
    add_parameter(group, NOMINAL, "nominal_mu", more=more)
    for name, parameter in (
        ("eps", EPS),
        ("zeta", ZETA),
        ("average_slope", AVERAGE_SLOPE),
        ("threshold", THRESHOLD),
    ):
        add_parameter(group, parameter, name)


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
    group.add_argument("--json", action="store_true", help="one JSON document on standard output")
    if data:
        group.add_argument("--out", metavar="FILE", help=data, required=required)
    if figure:
        group.add_argument("--plot", metavar="FILE", help=f"{figure} as .png, .pdf or .svg")
    if data or figure:
        group.add_argument("--overwrite", action="store_true", help="replace files that exist")
    parser.set_defaults(kinds=kinds)
