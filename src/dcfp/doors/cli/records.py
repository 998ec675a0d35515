"""The named records; or the components of record files and what their motions measure."""

import argparse
import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.doors.cli import inputs, options
from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Parser
from dcfp.errors import InputError

if TYPE_CHECKING:
    from dcfp.motion.ground_motion import GroundMotion
    from dcfp.motion.measures import Measures


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    options.add_records(parser, "*", "name of a record or a file; without any, the named records are listed")
    options.add_output(
        parser,
        "the list as CSV (.csv); of records, their histories as NetCDF (.nc), or as CSV (.csv) the histories of one, "
        "the measures of several",
        "the histories of each RECORD as .png, .pdf or .svg",
    )


def run(chosen: argparse.Namespace) -> int:
    """List the named records, or describe those that are asked for."""
    names = inputs.record_names(chosen)
    outputs = _outputs(chosen, names)
    if not names:
        return _list_named(chosen, outputs)
    described = [Described.of(motion) for name in names for motion in _motions(name, chosen)]
    _write_described(described, outputs)
    if chosen.json:
        print(json.dumps([entry.row() for entry in described], indent=2, allow_nan=False))
    else:
        from dcfp.doors.cli.response_table import print_described

        print_described(described)
    return 0


def _outputs(chosen: argparse.Namespace, names: list[str]) -> Outputs:
    outputs = Outputs.checked(chosen, inputs.input_files(chosen))
    if not names and outputs.figure is not None:
        msg = "--plot draws the histories of records; name at least one RECORD."
        raise InputError(msg)
    if not names and outputs.data is not None and outputs.data.suffix.lower() != ".csv":
        msg = f"{outputs.data}: the list of named records can be written as .csv; name a RECORD for its histories."
        raise InputError(msg)
    return outputs


@dataclass(frozen=True)
class Described:
    """A motion, its measures and what a reader must know of them."""

    motion: "GroundMotion"
    measures: "Measures"
    remarks: list[str]

    @classmethod
    def of(cls, motion: "GroundMotion") -> "Described":
        """Measure a motion."""
        from dcfp.motion.measures import measure, motion_remarks

        return cls(motion, measure(motion), motion_remarks(motion))

    def row(self) -> dict[str, object]:
        """Return what the JSON holds, with units in the names."""
        motion, found = self.motion, self.measures
        return {
            "record": motion.name,
            **asdict(motion.origin),
            "time_step_s": motion.time_step,
            "duration_s": motion.duration,
            "points": int(motion.acceleration.size),
            "pga_m_s2": found.peak_acceleration / 1e3,
            "pgv_m_s": found.peak_velocity / 1e3,
            "pgd_mm": found.peak_displacement,
            "arias_intensity_m_s": found.arias_intensity / 1e3,
            "significant_duration_s": found.significant_duration,
            "cumulative_absolute_velocity_m_s": found.cumulative_absolute_velocity / 1e3,
            "baseline_drift": found.baseline_drift,
            "treatment": list(motion.treatment),
            "remarks": self.remarks,
        }


def _motions(name: str, chosen: argparse.Namespace) -> "list[GroundMotion]":
    from dcfp.motion.load import load_motion, read_motions

    if chosen.component is None and Path(name).is_file():
        return read_motions(name, units=chosen.units, time_step=chosen.time_step)
    return [load_motion(name, chosen.component, units=chosen.units, time_step=chosen.time_step)]


def _write_described(described: "list[Described]", outputs: Outputs) -> None:
    if not outputs.paths:
        return
    from dcfp.doors.cli.record_files import write_histories, write_motion_figure

    motions = [entry.motion for entry in described]
    rows = [entry.row() for entry in described]
    outputs.write_with(
        lambda part, kind: write_histories(part, motions, rows, kind),
        lambda part, form: write_motion_figure(part, motions, form),
    )


def _list_named(chosen: argparse.Namespace, outputs: Outputs) -> int:
    from dcfp.motion.named import ALIASES, named_records

    named = named_records()
    # the paper's records first, then those of the paper that have to be supplied, then the sets in their own order
    places = [*ALIASES, *(row.name for row in named if not row.alias)]
    rows = sorted(named, key=lambda row: places.index(row.alias or row.name))
    if outputs.data is not None:
        from dcfp.doors.cli.record_files import write_named

        outputs.write_with(lambda part, kind: write_named(part, rows), lambda part, form: None)
    if chosen.json:
        print(json.dumps([asdict(row) for row in rows], indent=2, allow_nan=False))
    else:
        from dcfp.doors.cli.response_table import print_named

        print_named(rows)
    return 0
