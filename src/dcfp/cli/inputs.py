"""From options to motions, a bearing, its friction law and its heating model."""

import argparse
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dcfp.errors import InputError

if TYPE_CHECKING:
    from dcfp.bearing import Bearing, FrictionLaw, Heating
    from dcfp.record.ground_motion import GroundMotion

_KILO = 1000.0
#: Velocity at the end over PGV above which the PGV is that of the baseline [-].
_LARGEST_DRIFT = 0.5


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
    from dcfp.record.load import load_motion
    from dcfp.record.named import record_set

    motions: list[GroundMotion] = []
    for name in record_names(options):
        of_set = record_set(name)
        if of_set is None:
            of_set = [load_motion(name, options.component, units=options.units, time_step=options.time_step)]
        motions += of_set
    return [_treated(motion, options) for motion in motions]


def scaled(motions: "list[GroundMotion]", pgvs: list[float] | None) -> "list[GroundMotion]":
    """Return every motion at every PGV [m/s]."""
    if pgvs is None:
        return motions
    for motion in motions:
        refuse_a_drift(motion)
    return [motion.scaled_to_pgv(pgv * _KILO) for motion in motions for pgv in pgvs]


def refuse_a_drift(motion: "GroundMotion") -> None:
    """Refuse a motion whose PGV is that of its baseline.

    Raises
    ------
    InputError
        If it ends at more than half of its PGV.
    """
    from dcfp.record.measures import baseline_drift

    drift = baseline_drift(motion)
    if drift > _LARGEST_DRIFT:
        msg = (
            f"{motion.name}: the ground still moves at {100.0 * drift:.0f} % of its PGV at the end, so that its PGV is"
            " that of its baseline; treat the record with --high-pass 0.05 or --baseline."
        )
        raise InputError(msg)


def _treated(motion: "GroundMotion", options: argparse.Namespace) -> "GroundMotion":
    from dcfp.record import treatment

    if options.baseline:
        motion = treatment.remove_linear_velocity(motion)
    if options.high_pass is not None:
        if not options.baseline:
            # the filter pads with zeros, between which a mean would be two steps
            motion = treatment.remove_mean(motion)
        motion = treatment.high_pass(motion, options.high_pass)
    return motion


@dataclass(frozen=True)
class Model:
    """What stands on the ground: a bearing, its friction law and its heating model."""

    bearing: "Bearing"
    friction: "FrictionLaw"
    heating: "Heating"


def model(options: argparse.Namespace) -> Model:
    """Return the bearing of the file, or of Li et al. (2020), with the options put before it."""
    from dcfp.bearing import LI_2020, Li2020, SimplifiedHeating, read_bearing

    if options.bearing is not None:
        file = read_bearing(options.bearing)
        base = Model(file.bearing, file.friction, file.heating)
    else:
        base = Model(LI_2020, Li2020(), SimplifiedHeating())
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
    from dcfp.bearing import friction_law

    law = base if options.friction is None else friction_law(options.friction)
    return law if options.mu is None else law.with_reference(options.mu)


def _heating(base: "Heating", options: argparse.Namespace) -> "Heating":
    from dcfp.bearing import heating_model, plates_of

    heating = base
    if options.heating is not None and options.heating.strip().lower() != base.name:
        heating = heating_model(options.heating, **plates_of(base))
    changes = {
        name: value for name in ("ambient", "thickness") if (value := getattr(options, name)) is not None
    }
    return replace(heating, **changes)
