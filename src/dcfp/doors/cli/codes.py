"""Displacement and base shear by ASCE 7, Eurocode 8 and the AIJ, from records or a design spectrum, each with its verdict."""

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dcfp.doors.cli import inputs, options
from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Numbers, Parser, fraction, not_negative, number_from, positive, whole_number
from dcfp.errors import InputError

if TYPE_CHECKING:
    from dcfp.methods.asce_2016 import Bounds
    from dcfp.methods.panel import Panel
    from dcfp.methods.result import Structure
    from dcfp.methods.spectra import ElasticSpectrum

_KILO = 1000.0
#: Options that choose a spectrum.
_SPECTRA = ("asce", "eurocode", "japan", "spectrum")


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    options.add_records(
        parser, "*", "name of a record or set, or a file: the record's own spectrum, beside its analysis"
    )
    _add_spectra(parser)
    _add_structure(parser)
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
    options.add_output(parser, "a line for each method as CSV (.csv)")


def _add_spectra(parser: Parser) -> None:
    group = parser.add_argument_group("design spectrum, instead of records")
    group.add_argument(
        "--asce",
        action=Numbers,
        check=positive("g", 1e-3, 10.0),
        most=3,
        metavar="S",
        help="S_MS and S_M1 [g], and T_L [s] (8 unless given)",
    )
    group.add_argument(
        "--eurocode",
        type=positive("m/s2", 0.01, 50.0),
        metavar="AG",
        help="ground acceleration a_g on ground type A [m/s2]",
    )
    group.add_argument("--ground", metavar="TYPE", help="ground type of Eurocode 8, A to E; B unless given")
    group.add_argument(
        "--type",
        type=whole_number(1, 2),
        metavar="1|2",
        help="type of the spectrum of Eurocode 8; 1 unless given",
    )
    group.add_argument(
        "--japan",
        type=whole_number(1, 3),
        metavar="SOIL",
        help="very rare earthquake of Notification 1457 on soil class 1, 2 or 3",
    )
    group.add_argument(
        "--spectrum", metavar="FILE.csv", help="periods and pseudo-accelerations at a damping of 5 %%"
    )


def _add_structure(parser: Parser) -> None:
    group = parser.add_argument_group("building and site, for the conditions of the codes")
    group.add_argument(
        "--fixed-base-period",
        type=not_negative("s", 10.0),
        metavar="S",
        help="of the structure without isolation [s]; 0 for a rigid one",
    )
    group.add_argument(
        "--height", type=positive("m", 0.0, 1000.0), metavar="M", help="above the isolation [m]"
    )
    group.add_argument("--site-class", metavar="A-F", help="site class of ASCE 7")
    group.add_argument(
        "--plan", type=positive("m", 0.0, 1000.0), metavar="M", help="larger dimension of the plan [m]"
    )
    group.add_argument(
        "--fault-distance",
        type=positive("km", 0.0, 1e4),
        metavar="KM",
        help="to a fault of magnitude 6.5 or more [km]",
    )
    group.add_argument(
        "--weight-above",
        type=fraction(),
        metavar="RATIO",
        help="weight above the base level over the whole, for V_st of ASCE 7 [-]",
    )
    group.add_argument(
        "--nominal-mu",
        type=fraction(),
        metavar="VALUE",
        help="coefficient of the methods [-]; as for predict",
    )
    group.add_argument(
        "--bounds",
        action=Numbers,
        check=number_from(0.1, 10.0),
        most=2,
        metavar="LAMBDA",
        help="property modification factors lambda_min and lambda_max of ASCE 7 on the friction [-]",
    )


def run(chosen: argparse.Namespace) -> int:
    """Ask every method under every record or the spectrum."""
    _check(chosen)
    outputs = Outputs.checked(
        chosen,
        [*inputs.input_files(chosen), *([Path(chosen.spectrum)] if chosen.spectrum else [])],
        (".csv",),
    )
    from dcfp.doors.cli.codes_table import print_panels
    from dcfp.present.tables.comparisons import panel_object

    model = inputs.model(chosen)
    panels, nominal = _panels(chosen, model)
    _write(panels, outputs)
    if chosen.json:
        print(json.dumps([panel_object(panel) for panel in panels], indent=2, allow_nan=False))
    else:
        print_panels(panels, model, nominal, details=chosen.details)
    return 0


def _check(chosen: argparse.Namespace) -> None:
    given = [name for name in _SPECTRA if getattr(chosen, name) is not None]
    names = inputs.record_names(chosen)
    if len(given) + bool(names) != 1:
        what = ", ".join([*(f"--{name}" for name in given), *names[:1]]) or "nothing"
        msg = f"give either records or one of --asce, --eurocode, --japan and --spectrum, not {what}."
        raise InputError(msg)
    if given and chosen.of_set is not None:
        msg = f"--of-set is of records, and --{given[0]} is none; leave out one of the two."
        raise InputError(msg)
    if given and chosen.pgv is not None:
        msg = f"--pgv scales records, and --{given[0]} is no record; leave out one of the two."
        raise InputError(msg)
    if chosen.asce is not None and len(chosen.asce) < 2:
        msg = "--asce needs S_MS and S_M1, for example --asce 1.5 0.6."
        raise InputError(msg)
    if chosen.bounds is not None and len(chosen.bounds) != 2:
        msg = "--bounds needs lambda_min and lambda_max, for example --bounds 0.7 1.8."
        raise InputError(msg)
    for name in ("ground", "type"):
        if getattr(chosen, name) is not None and chosen.eurocode is None:
            msg = f"--{name} belongs to --eurocode."
            raise InputError(msg)


def _part(text: str) -> float:
    """Return 0 for the mean, else a percentage as a part [-]."""
    return 0.0 if text.strip().lower() == "mean" else positive("%", 1.0, 99.0)(text) / 100.0


def _panels(chosen: argparse.Namespace, model: "inputs.System") -> "tuple[list[Panel], Any]":
    from dcfp.doors.cli.progress import progress
    from dcfp.methods.equivalent_linear import PendulumWithFriction
    from dcfp.methods.panel import panel_of_motion, panel_of_set, panel_of_spectrum
    from dcfp.motion.measures import refuse_a_drift

    nominal = inputs.nominal(chosen, model)
    pendulum = PendulumWithFriction(model.bearing.effective_radius, nominal.value)
    structure, bounds = _structure(chosen), _bounds(chosen)
    spectrum = _spectrum(chosen)
    if spectrum is not None:
        return [panel_of_spectrum(spectrum, pendulum, structure, bounds)], nominal
    motions = inputs.scaled(inputs.load_motions(chosen), chosen.pgv)
    panels: list[Panel] = []
    with progress("records", len(motions)) as advance:
        for motion in motions:
            refuse_a_drift(motion)
            panels.append(
                panel_of_motion(
                    motion, model.bearing, model.friction, model.heating, pendulum, structure, bounds
                )
            )
            advance()
    if chosen.of_set is not None:
        return [panel_of_set(panels, chosen.of_set or None, structure, bounds)], nominal
    return panels, nominal


def _structure(chosen: argparse.Namespace) -> "Structure":
    from dcfp.methods.result import Structure

    def scaled(value: float | None, factor: float) -> float | None:
        return None if value is None else factor * value

    return Structure(
        fixed_base_period=chosen.fixed_base_period,
        height=scaled(chosen.height, _KILO),
        site_class=None if chosen.site_class is None else chosen.site_class.strip().upper(),
        plan=scaled(chosen.plan, _KILO),
        fault_distance=scaled(chosen.fault_distance, _KILO**2),
        weight_above=chosen.weight_above,
    )


def _bounds(chosen: argparse.Namespace) -> "Bounds | None":
    from dcfp.methods.asce_2016 import Bounds

    return None if chosen.bounds is None else Bounds(*chosen.bounds, source="as given")


def _spectrum(chosen: argparse.Namespace) -> "ElasticSpectrum | None":
    from dcfp.methods.spectra import Asce2016Spectrum, Eurocode8Spectrum, Notification2000Spectrum
    from dcfp.methods.spectra.elastic import read_spectrum

    if chosen.asce is not None:
        return Asce2016Spectrum(*chosen.asce)
    if chosen.eurocode is not None:
        return Eurocode8Spectrum(chosen.eurocode * _KILO, (chosen.ground or "B").upper(), chosen.type or 1)
    if chosen.japan is not None:
        return Notification2000Spectrum(chosen.japan)
    return None if chosen.spectrum is None else read_spectrum(chosen.spectrum)


def _write(panels: "list[Panel]", outputs: Outputs) -> None:
    def data(part: Path, kind: str) -> None:
        from dcfp.present.tables.comparisons import panels_csv

        del kind
        part.write_text(panels_csv(panels), encoding="utf-8")

    def figure(part: Path, form: str) -> None:
        from dcfp.present.figures import save_figure  # late: Matplotlib takes long to import
        from dcfp.present.figures.spectra import plot_codes

        save_figure(plot_codes(panels), part, form)

    outputs.write_with(data, figure)
