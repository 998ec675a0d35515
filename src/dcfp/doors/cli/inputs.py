"""From options to motions, a bearing, its friction law and its heating model, and to how records are predicted."""

import argparse
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.doors.cli.options import option_name
from dcfp.doors.cli.parser import Parser, fraction, number_from, positive
from dcfp.errors import InputError

if TYPE_CHECKING:
    from dcfp.inference import Setting
    from dcfp.inference.nominal import Nominal
    from dcfp.motion.ground_motion import GroundMotion
    from dcfp.system import System


_KILO = 1000.0


def record_names(options: argparse.Namespace) -> list[str]:
    """Return the records that were asked for; one at least where the command needs one."""
    names: list[str] = [*options.records, *options.later_records]
    if options.needs_records and not names:
        msg = "name at least one RECORD, for example NCC or a file; dcfp records lists the named ones."
        raise InputError(msg)
    return names


def input_files(options: argparse.Namespace) -> list[Path]:
    """Return the files that the command reads, so that it does not write over them."""
    bearing: str | None = getattr(options, "bearing", None)  # not every command has one
    words = [*options.records, *options.later_records, *([bearing] if bearing else [])]
    return [Path(word.rpartition("::")[0] or word) for word in words]


def load_motions(options: argparse.Namespace) -> "list[GroundMotion]":
    """Return every record as it will be used but for the scale; the name of a set stands for all records in it."""
    from dcfp.motion.load import load_motions as load
    from dcfp.motion.treatment import treated

    motions = load(record_names(options), options.component, units=options.units, time_step=options.time_step)
    return [treated(motion, baseline=options.baseline, corner=options.high_pass) for motion in motions]


def scaled(motions: "list[GroundMotion]", pgvs: list[float] | None) -> "list[GroundMotion]":
    """Return every motion at every PGV [m/s]."""
    from dcfp.motion.measures import refuse_a_drift

    if pgvs is None:
        return motions
    for motion in motions:
        refuse_a_drift(motion)
    return [motion.scaled_to_pgv(pgv * _KILO) for motion in motions for pgv in pgvs]


def model(options: argparse.Namespace) -> "System":
    """Return the system of the bearing file, or of Li et al. (2020), with the options put before it."""
    from dcfp.system import System, read_bearing, system_parameters

    base = System() if options.bearing is None else read_bearing(options.bearing)
    values = {
        key: value
        for key in system_parameters()
        if (value := getattr(options, option_name(key), None)) is not None
    }
    if not values:
        return base
    changed = base.changed(values)
    if changed.bearing == base.bearing:
        return changed
    return replace(changed, bearing=replace(changed.bearing, name=f"{base.bearing.name}, changed"))


# From options to how records are predicted.


def add_method(parser: Parser) -> None:
    """Add the constants of the methods."""
    group = parser.add_argument_group(
        "prediction", "Constants of the methods of Li et al. (2020); by default the paper's."
    )
    group.add_argument(
        "--nominal-mu",
        type=fraction(),
        metavar="VALUE",
        help="constant coefficient mu_n that stands for the law [-]; default 0.043 for the paper's law, else what the virtual test T01 gives",
    )
    group.add_argument(
        "--eps", type=number_from(1e-3, 10.0), metavar="VALUE", help="eps of Eq. (26) [-]; default 0.25"
    )
    group.add_argument(
        "--zeta", type=number_from(0.1, 10.0), metavar="VALUE", help="zeta of Eq. (29) [-]; default 1.5"
    )
    group.add_argument(
        "--average-slope",
        type=positive("mm/s2", 10.0, 1e5),
        metavar="MM_PER_S2",
        help="kg_ave of Eq. (28), at a PGV of 0.25 m/s [mm/s2]; default 930",
    )
    group.add_argument(
        "--threshold",
        type=fraction(),
        metavar="VALUE",
        help="part of PGV by which the ground velocity must turn back for a peak to count [-]; default 0.2",
    )


def nominal(chosen: argparse.Namespace, model: "System") -> "Nominal":
    """Return the nominal coefficient and where it comes from."""
    from dcfp.inference.nominal import Nominal, nominal_coefficient

    if chosen.nominal_mu is not None:
        return Nominal(chosen.nominal_mu, "as given")
    return nominal_coefficient(model.bearing, model.friction, model.heating)


def setting(chosen: argparse.Namespace, model: "System") -> "tuple[Setting, Nominal]":
    """Return how records are predicted, and where the nominal coefficient comes from."""
    from dcfp.inference import Setting
    from dcfp.methods.li_2020 import LI_2020

    found = nominal(chosen, model)
    given = {
        "nominal_friction": found.value,
        "fall_ratio": chosen.eps,
        "change_ratio": chosen.zeta,
        "average_slope": chosen.average_slope,
    }
    constants = replace(LI_2020, **{name: value for name, value in given.items() if value is not None})
    made = Setting(model.bearing, model.friction, model.heating, constants)
    return (made if chosen.threshold is None else replace(made, threshold=chosen.threshold)), found
