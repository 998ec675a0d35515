"""The commands of ``dcfp study``: what each is called, does and may be told."""

import argparse
from dataclasses import replace

from dcfp.doors.cli import options
from dcfp.doors.cli.commands import ALLOWED, FIGURE, command
from dcfp.doors.cli.parser import Pairs, Parser, add_parameter, add_switch
from dcfp.errors import InputError
from dcfp.files import DATA_EXTENSIONS
from dcfp.schema.parameters import PGV, Parameter
from dcfp.schema.units import FRACTION, MM, NONE

ABOUT = """Studies: many analyses over records, intensities and bearings, into a store that survives an interruption.

dcfp study STUDY.toml is short for dcfp study run STUDY.toml."""
#: The command that a study file alone asks for.
USUAL = "run"
STUDY = "study file; dcfp study new writes one"
AT = "one value of each factor that is not looked at: pgv in m/s, the others in the units of the tables"

THREADS = Parameter(
    "analyses at the same time", NONE, 1, 1024, key="threads", kind=int, more="by default one for each processor"
)  # fmt: skip
PROCESSES = Parameter("Dask workers to start on this machine", NONE, 1, 1024, key="processes", kind=int)
PART = Parameter("parts of the records that do not exceed", FRACTION, 0.0, 0.9999, key="quantiles", above=True)  # fmt: skip
CONFIDENCE = replace(PART, key="confidence", words="confidence of the intervals", default=0.95)
CAPACITY = Parameter(
    "capacities, or other values of the result", MM, 0.0, key="capacity", above=True,
    more="default the displacement capacity of the study's bearing",
)  # fmt: skip
DISPERSION = Parameter(
    "further dispersions, of design and model for example, added as the root of the sum of squares",
    NONE, 0.0, 2.0, key="further_dispersion",
)  # fmt: skip
SEED = Parameter("seed of the draws", NONE, 0, 2**31 - 1, key="seed", kind=int, default=2015)


def add_store(parser: Parser, *, may_be_unfinished: bool = True) -> None:
    """Add the store of the study and what is chosen of it."""
    parser.add_argument("store", metavar="STORE", help="results of a study: a folder .zarr, or a file .nc")
    add_values(parser, "--at", AT)
    if may_be_unfinished:
        words = "leave out the analyses that have not been run, rather than refuse the study"
        add_switch(parser, "--unfinished", words)


def add_values(parser: Parser, name: str, words: str) -> None:
    """Add an option that takes values of factors."""
    parser.add_argument(name, action=Pairs, example="radius=4500", metavar="FACTOR=VALUE", help=words)


def add_quantity(parser: Parser) -> None:
    """Add which result is looked at."""
    words = (
        "the result: peak_displacement (default), force_ratio, peak_temperature, residual_displacement, ..."
    )
    parser.add_argument("--quantity", default="peak_displacement", metavar="NAME", help=words)


@command("study new", "study:new")
def new(parser: Parser) -> None:
    """Write a study file to start from, with every kind of factor in it and words beside each."""
    parser.add_argument("out", metavar="STUDY.toml", help="file to write")
    add_switch(parser, "--overwrite", "replace a file that exists")
    parser.set_defaults(json=False, kinds=(".toml",), noun="a study")


@command("study plan", "study:plan")
def plan(parser: Parser) -> None:
    """How many analyses a study has and how long they will take, from some that are timed; nothing is written."""
    parser.add_argument("study", metavar="STUDY.toml", help=STUDY)
    add_parameter(parser, THREADS)
    options.add_output(parser)


def check_run(chosen: argparse.Namespace) -> None:
    """Refuse two ways of dealing with a store, or two places to run at."""
    if chosen.resume and chosen.overwrite:
        msg = "--resume goes on with a store and --overwrite replaces it; give one of the two."
        raise InputError(msg)
    places = [name for name in ("threads", "dask", "processes") if getattr(chosen, name) is not None]
    if len(places) > 1:
        msg = f"--{places[0]} and --{places[1]} say where the analyses run in two ways; give one."
        raise InputError(msg)


@command("study run", "study:run", check_run)
def run(parser: Parser) -> None:
    """Run a study, or what is left of it: every combination of its factors, into a store."""
    parser.add_argument("study", metavar="STUDY.toml", help=STUDY)
    # a store is no file: it is checked where it is written
    words = "folder of the store; by default that of the study file, as .zarr, here"
    parser.add_argument("--out", dest="store", metavar="STORE", help=words)
    add_switch(parser, "--resume", "go on with a store that is there")
    add_switch(parser, "--overwrite", "replace a store that is there")
    group = parser.add_argument_group("machine")
    add_parameter(group, THREADS)
    words = "Dask scheduler whose workers run the analyses, tcp://HOST:PORT"
    group.add_argument("--dask", metavar="ADDRESS", help=words)
    add_parameter(group, PROCESSES)
    add_switch(parser, "--json", "one JSON document on standard output")


@command("study show", "study:show")
def show(parser: Parser) -> None:
    """Show what is in a store: its dimensions, what is done, and the peaks by intensity."""
    parser.add_argument("store", metavar="STORE", help="store of a study, or the NetCDF it was exported to")
    options.add_output(parser)


@command("study histories", "study:histories")
def histories(parser: Parser) -> None:
    """Response history analysis behind one case of a study: made again in a moment, with its histories and its figure."""
    parser.add_argument("study", metavar="STUDY.toml", help="the study file")
    add_values(parser, "--at", AT)
    options.add_output(parser, "results as NetCDF (.nc) or CSV (.csv)", FIGURE, DATA_EXTENSIONS)


@command("study export", "study:export")
def export(parser: Parser) -> None:
    """Write a store as one file: NetCDF with everything, or CSV with a line for each analysis."""
    parser.add_argument("store", metavar="STORE", help="store of a study")
    options.add_output(parser, "file to write, .nc or .csv", kinds=DATA_EXTENSIONS, required=True)


@command("study ida", "assessment:ida")
def ida(parser: Parser) -> None:
    """Incremental dynamic analysis from the results of a study: the curves of the records, and what parts of them do not exceed."""
    add_store(parser)
    add_quantity(parser)
    add_parameter(parser, replace(PART, more="default 0.16 0.5 0.84"), any_number=True)
    options.add_output(parser, "the quantiles and every record by intensity as CSV (.csv)", FIGURE)


@command("study fragility", "assessment:fragility")
def fragility(parser: Parser) -> None:
    """Fragility from the results of a study: how probable it is that a capacity is exceeded, over the intensity."""
    add_store(parser)
    add_parameter(parser, CAPACITY, any_number=True)
    add_quantity(parser)
    add_parameter(parser, DISPERSION, any_number=True)
    words = "part of the draws of earthquakes inside the bounds"
    add_parameter(parser, replace(CONFIDENCE, words=words, default=0.9), default=True)
    add_parameter(parser, SEED, default=True)
    options.add_output(parser, "the curve of every capacity with its bounds as CSV (.csv)", FIGURE)


@command("study bounds", "assessment:bounds")
def bounds(parser: Parser) -> None:
    """Property bounds from the results of a study: the envelope over property factors and ambient temperatures, and what governs it."""
    add_store(parser)
    words = "the property factors; default those of lambda and ambient that vary"
    parser.add_argument("--over", nargs="+", metavar="FACTOR", help=words)
    add_values(parser, "--nominal", "the nominal value of each; default lambda=1 ambient=20")
    words = "the results; default peak_displacement force_ratio residual_displacement peak_temperature"
    parser.add_argument("--quantities", nargs="+", metavar="NAME", help=words)
    more = "the figure shows the first; default 0.5 0.84"
    add_parameter(parser, replace(PART, more=more), any_number=True)
    words = "least, nominal and largest by result, quantile and intensity as CSV (.csv)"
    options.add_output(parser, words, FIGURE)


@command("study sensitivity", "assessment:sensitivity")
def sensitivity(parser: Parser) -> None:
    """Sobol indices from the results of a study: which sampled factor the variance of a result comes from."""
    add_store(parser, may_be_unfinished=False)
    add_quantity(parser)
    words = "how the records are taken together: geometric-mean (default), or a quantile between 0 and 1"
    parser.add_argument("--over-records", type=reduction, metavar="WAY", help=words)
    add_switch(parser, "--logarithm", "the variance of the logarithm of the result")
    add_parameter(parser, CONFIDENCE, default=True)
    add_parameter(parser, replace(SEED, words="seed of the intervals", least=1, default=2010), default=True)
    options.add_output(parser, "the indices by factor and intensity as CSV (.csv)", FIGURE)


def reduction(text: str) -> str | float:
    """Return a way of taking records together: its name, or a quantile."""
    if text == "geometric-mean":
        return text
    try:
        return PART.read(text, "")
    except InputError as error:
        msg = f"write geometric-mean or a quantile between 0 and 1, not {text!r}"
        raise argparse.ArgumentTypeError(msg) from error


@command("study chart", "assessment:chart")
def chart(parser: Parser) -> None:
    """Design chart from the results of a study: which radius and friction hold a displacement at a PGV."""
    add_store(parser)
    words = "which peak ground velocity of the study"
    add_parameter(parser, replace(PGV, words=words, more="not needed where it has only one"))
    add_parameter(parser, ALLOWED, required=True)
    options.add_output(parser, "the least coefficient for every radius as CSV (.csv)", FIGURE)
