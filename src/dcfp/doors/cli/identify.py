"""A law of friction from measured tests: estimates, 95 % intervals, and tests that were held out."""

import argparse
import json
import math
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.doors.cli import inputs, options
from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Parser
from dcfp.errors import InputError

if TYPE_CHECKING:
    from dcfp.inference.identification import Identification

EXTENSIONS = (".toml", ".json", ".csv")


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
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
        "coefficients, factors and residuals as .png, .pdf or .svg",
    )
    parser.set_defaults(later_records=[])


def run(chosen: argparse.Namespace) -> int:
    """Fit the law, predict what was held out, and write where it was asked for."""
    files: list[str] = [*chosen.files, *chosen.later_records]
    if not files:
        msg = "name at least one FILE, a measured test as CSV with time, displacement, force and load."
        raise InputError(msg)
    _refuse_other_laws(chosen)
    fixed = _fixed(chosen.fix)
    read = [*files, *chosen.hold_out, *([chosen.bearing] if chosen.bearing else [])]
    outputs = Outputs.checked(chosen, [Path(file) for file in read], EXTENSIONS)
    # late, so that a slip in the command is answered at once
    from dcfp.analysis.rig import read_measurement
    from dcfp.doors.cli.test_table import print_identification
    from dcfp.inference.identification import identify
    from dcfp.system import FittedFriction

    model = inputs.model(chosen)
    if model.friction.name not in ("fitted", "li2020"):
        msg = f"{chosen.bearing}: the law that is fitted has the form 'fitted', that of Li et al. (2020) with free constants, and not {model.friction.name!r}; leave [friction] out."
        raise InputError(msg)
    found = identify(
        [read_measurement(file) for file in files],
        model.bearing,
        model.heating,
        fit=chosen.fit,
        fixed=fixed,
        law=model.friction if isinstance(model.friction, FittedFriction) else None,
        held_out=[read_measurement(file) for file in chosen.hold_out],
    )
    outputs.write_with(
        lambda part, kind: _write_data(part, found, kind), lambda part, form: _write_figure(part, found, form)
    )
    if chosen.json:
        print(_json(found))
    else:
        print_identification(found)
    return 0


def _refuse_other_laws(chosen: argparse.Namespace) -> None:
    if chosen.friction is not None and chosen.friction.strip().lower() != "fitted":
        msg = f"--friction {chosen.friction}: the law that is fitted has the form 'fitted', that of Li et al. (2020) with free constants; leave the option out."
        raise InputError(msg)
    if chosen.pressure is not None:
        msg = f"--pressure {chosen.pressure:g} has no effect: the measured files hold the load; leave the option out."
        raise InputError(msg)
    if chosen.mu is not None:
        msg = f"--mu {chosen.mu:g}: to keep the reference coefficient at this value, say --fix mu_0={chosen.mu:g}."
        raise InputError(msg)


def _fixed(words: list[str]) -> dict[str, float]:
    """Return the values of ``NAME=VALUE`` by their names."""
    fixed: dict[str, float] = {}
    for word in words:
        name, _, text = word.partition("=")
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            msg = f"--fix {word}: write NAME=VALUE, such as pressure_exponent=0.19."
            raise InputError(msg)
        if name in fixed:
            msg = f"--fix {word}: {name} is fixed twice; leave one."
            raise InputError(msg)
        fixed[name] = value
    return fixed


def _json(found: "Identification") -> str:
    return json.dumps(found.summary(), indent=2, allow_nan=False)


def _write_data(path: Path, found: "Identification", kind: str) -> None:
    from dcfp.inference.identification import bearing_file

    if kind == ".toml":
        text = bearing_file(found.bearing, found.law, found.heating, _notes(found))
    elif kind == ".json":
        text = _json(found) + "\n"
    else:
        text = _csv(found)
    path.write_text(text, encoding="utf-8")


def _notes(found: "Identification") -> tuple[str, ...]:
    """Return what the head of a bearing file says of where its law comes from."""
    from dcfp.version import version

    tests = ", ".join(f"{h.name} (SHA-256 {h.measurement.digest[:12]})" for h in found.histories)
    return (
        f"dcfp {version()}: law fitted to {tests}",
        *(
            f"{one.name} = {one.value:.6g}, 95 % interval {one.lower:.6g} to {one.upper:.6g} {one.unit}".strip()
            for one in found.estimates
        ),
        *(f"{one.name} held: {one.reason}" for one in found.held),
        *found.remarks,
    )


def _csv(found: "Identification") -> str:
    from dcfp.present.tables import Column, table_text

    names = ("name", "unit", "value", "standard_error", "lower", "upper", "held", "words")
    blank: dict[str, object] = {}
    blank.update(dict.fromkeys(names))
    rows = [{**blank, **asdict(one), "unit": one.unit or "-"} for one in found.estimates]
    rows += [
        {**blank, "name": one.name, "unit": one.unit or "-", "value": one.value, "held": one.reason}
        for one in found.held
    ]
    return table_text([Column(name, name) for name in names], rows)


def _write_figure(path: Path, found: "Identification", form: str) -> None:
    from dcfp.present.figures import save_figure  # late: Matplotlib takes long to import
    from dcfp.present.figures.identification import plot_identification

    save_figure(plot_identification(found), path, form)
