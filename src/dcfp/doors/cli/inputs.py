"""From options to motions and a system."""

import argparse
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

from dcfp.doors.cli.options import option_name
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import load_motions as load
from dcfp.motion.load import load_records as load_stations
from dcfp.motion.measures import refuse_a_drift
from dcfp.motion.station import Station
from dcfp.motion.treatment import record_treated, treated
from dcfp.schema.declared import Declared, parameters
from dcfp.system import SimplifiedHeating, System, system_parameters

if TYPE_CHECKING:
    from dcfp.methods.spectra.elastic import ElasticSpectrum

Moved = TypeVar("Moved", GroundMotion, Station, GroundMotion | Station)


def given(chosen: argparse.Namespace, kind: type[Declared]) -> dict[str, Any]:
    """Return the values of those options of a declared class that were given, by the names of its fields."""
    return {
        name: value
        for name, one in parameters(kind).items()
        if (value := getattr(chosen, one.key, None)) is not None
    }


def load_motions(chosen: argparse.Namespace) -> list[GroundMotion]:
    """Return every record as it will be used but for the scale; the name of a set stands for all records in it."""
    motions = load(chosen.records, chosen.component, units=chosen.units, time_step=chosen.time_step)
    return [treated(motion, baseline=chosen.baseline, corner=chosen.high_pass) for motion in motions]


def load_records(chosen: argparse.Namespace, *, vertical: bool = False) -> list[GroundMotion | Station]:
    """Return every station and single record, which may be `vertical` or not, as it will be used but for the scale."""
    reading = {"units": chosen.units, "time_step": chosen.time_step}
    records = load_stations(chosen.records, chosen.component, vertical=vertical, **reading)
    return [record_treated(one, baseline=chosen.baseline, corner=chosen.high_pass) for one in records]


def motions(chosen: argparse.Namespace) -> list[GroundMotion]:
    """Return every record at every PGV."""
    return scaled(load_motions(chosen), chosen.pgv)


def scaled(motions: Sequence[Moved], pgvs: list[float] | None, *, allow_drift: bool = False) -> list[Moved]:
    """Return every motion at every PGV [mm/s]; one whose PGV is that of its baseline is refused, unless it may drift and is not scaled."""
    if pgvs is not None or not allow_drift:
        for motion in motions:
            refuse_a_drift(motion)
    return (
        list(motions) if pgvs is None else [motion.scaled_to_pgv(pgv) for motion in motions for pgv in pgvs]
    )


def system(chosen: argparse.Namespace, usual: str = SimplifiedHeating.name) -> System:
    """Return the system of the bearing file, or of Li et al. (2020), with the options put before it; `usual` is the heating model where none is said."""
    return changed_system(System.of(chosen.bearing, usual=usual), chosen)


def changed_system(base: System, chosen: argparse.Namespace) -> System:
    """Return a system with the options put before it."""
    options = {key: option_name(key) for key, one in system_parameters().items() if one.option}
    values = {key: value for key, name in options.items() if (value := getattr(chosen, name)) is not None}
    changed = base.changed(values) if values else base
    if changed.bearing == base.bearing:
        return changed
    return replace(changed, bearing=replace(changed.bearing, name=f"{base.bearing.name}, changed"))


def spectrum(chosen: argparse.Namespace) -> "ElasticSpectrum | None":
    """Return the design spectrum that was chosen; None for none."""
    from dcfp.methods.spectra.elastic import DESIGN_SPECTRA, read_spectrum  # late: few commands need it

    for name, kind in DESIGN_SPECTRA.items():
        if (values := getattr(chosen, name)) is not None:
            keys = {one.key: one.name for one in parameters(kind).values()}
            own = {keys[key]: getattr(chosen, key) for key in kind.own_options()}
            behind: list[Any] = values if kind.behind[1] > 1 else [values]
            return kind(*behind, **{field: value for field, value in own.items() if value is not None})
    return None if chosen.spectrum is None else read_spectrum(chosen.spectrum)
