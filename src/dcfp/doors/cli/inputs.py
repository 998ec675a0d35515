"""From options to motions, a bearing, its friction law and its heating model."""

import argparse
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.doors.cli.options import option_name
from dcfp.errors import InputError

if TYPE_CHECKING:
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
