"""The options that several commands share: records, bearing, output."""

from dcfp.doors.cli.parser import Numbers, Parser, any_number, fraction, not_negative, positive


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


def add_bearing(parser: Parser) -> None:
    """Add the bearing, its friction law and its heating model."""
    group = parser.add_argument_group(
        "bearing", "The bearing of Li et al. (2020), or that of a file; single values override either."
    )
    group.add_argument(
        "--bearing", metavar="FILE.toml", help="bearing file: geometry, load, friction, heating"
    )
    group.add_argument(
        "--radius",
        action=Numbers,
        check=positive("mm", 100.0, 1e6),
        most=2,
        metavar="MM",
        help="effective radius of both plates, or of the lower and the upper one [mm]; default 4500",
    )
    group.add_argument(
        "--slider",
        type=positive("mm", 10.0, 1e4),
        metavar="MM",
        help="diameter of the slider [mm]; default 400",
    )
    group.add_argument(
        "--pressure",
        type=positive("N/mm2", 0.1, 1000.0),
        metavar="N_PER_MM2",
        help="pressure on the slider [N/mm2]; default 60",
    )
    group.add_argument(
        "--stiffness",
        type=positive("kN/mm", 1.0, 1e6),
        metavar="KN_PER_MM",
        help="stiffness before sliding [kN/mm]; default 1900",
    )
    group.add_argument(
        "--capacity", type=positive("mm", 1.0, 1e5), metavar="MM", help="displacement capacity [mm]"
    )
    group.add_argument(
        "--friction",
        metavar="NAME",
        help="friction law: li2020 (default), constant, constantinou1990, kumar2015, kim2023-third, kim2023-two-thirds, lomiento2013 or fitted",
    )
    group.add_argument(
        "--mu", type=fraction(), metavar="VALUE", help="reference coefficient of the friction law [-]"
    )
    group.add_argument(
        "--heating", metavar="NAME", help="heating model: simplified (default), precise or none"
    )
    group.add_argument(
        "--ambient",
        type=any_number("degC", -60.0, 200.0),
        metavar="DEGC",
        help="temperature at the start [degC]; default 20",
    )
    group.add_argument(
        "--thickness",
        type=positive("mm", 10.0, 200.0),
        metavar="MM",
        help="thickness of the plates, with an insulated back [mm]; by default they are endlessly thick",
    )


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
