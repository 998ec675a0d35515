"""From options to motions, a bearing, its friction law and its heating model."""

import argparse
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dcfp.errors import InputError

if TYPE_CHECKING:
    from dcfp.motion.ground_motion import GroundMotion
    from dcfp.system import Bearing, FrictionLaw, Heating, Model

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


def model(options: argparse.Namespace) -> "Model":
    """Return the bearing of the file, or of Li et al. (2020), with the options put before it."""
    from dcfp.system import Model, read_bearing

    base = Model() if options.bearing is None else read_bearing(options.bearing)
    return Model(
        _bearing(base.bearing, options), _friction(base.friction, options), _heating(base.heating, options)
    )


def _bearing(base: "Bearing", options: argparse.Namespace) -> "Bearing":
    changes: dict[str, Any] = {}
    if options.radius is not None:
        changes["radii"] = tuple(options.radius if len(options.radius) == 2 else options.radius * 2)
    if options.slider is not None:
        changes["slider_diameter"] = options.slider
    if (
        changes and options.bearing is None
    ):  # the paper's capacity belongs to its plates; a file's is its user's
        changes |= {"displacement_capacity": None, "capacity_note": ""}
    if options.pressure is not None:
        changes["pressure"] = options.pressure
    if options.stiffness is not None:
        changes["elastic_stiffness"] = options.stiffness * _KILO
    if options.capacity is not None:
        changes |= {"displacement_capacity": options.capacity, "capacity_note": ""}
    changed = replace(base, **changes)
    return base if changed == base else replace(changed, name=f"{base.name}, changed")


def _friction(base: "FrictionLaw", options: argparse.Namespace) -> "FrictionLaw":
    from dcfp.system import friction_law

    law = base if options.friction is None else friction_law(options.friction)
    return law if options.mu is None else law.with_reference(options.mu)


def _heating(base: "Heating", options: argparse.Namespace) -> "Heating":
    from dcfp.system import heating_model, plates_of

    heating = base
    if options.heating is not None and options.heating.strip().lower() != base.name:
        heating = heating_model(options.heating, **plates_of(base))
    changes = {
        name: value for name in ("ambient", "thickness") if (value := getattr(options, name)) is not None
    }
    return replace(heating, **changes)
