"""``dcfp records``: the named records; or the components of record files and what their motions measure."""

import argparse
from pathlib import Path

from dcfp.doors.cli.console import Page, grid
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import load_motion, read_motions
from dcfp.motion.measures import MEASURES, motion_remarks
from dcfp.motion.named import ALIASES, NAMED, NamedRecord, named_records
from dcfp.present.tables import write_motions
from dcfp.schema.table import Table


def run(chosen: argparse.Namespace) -> Answer:
    """List the named records, or describe those that are asked for."""
    if not chosen.records:
        return _named()
    motions = [motion for name in chosen.records for motion in _motions(name, chosen)]
    table = Table(tuple(MEASURES), motions)
    return Answer(
        table.objects,
        lambda: Page(
            [grid(table), *dict.fromkeys(map(_origin, motions))],
            [remark for motion in motions for remark in motion_remarks(motion)],
        ),
        lambda part, kind: write_motions(part, motions, kind),
        drawn("plot_motions", motions),
    )


def _named() -> Answer:
    named = named_records()
    # the paper's records first, then those of the paper that have to be supplied, then the sets in their own order
    places = [*ALIASES, *(row.name for row in named if not row.alias)]
    rows: list[NamedRecord] = sorted(named, key=lambda row: places.index(row.alias or row.name))
    remarks = [f"{row.name}: {row.note}." for row in rows if row.note]
    return Answer.of_table(Table(tuple(NAMED), rows), remarks=remarks)


def _motions(name: str, chosen: argparse.Namespace) -> list[GroundMotion]:
    if chosen.component is None and Path(name).is_file():
        return read_motions(name, units=chosen.units, time_step=chosen.time_step)
    return [load_motion(name, chosen.component, units=chosen.units, time_step=chosen.time_step)]


def _origin(motion: GroundMotion) -> tuple[tuple[str, str], ...]:
    origin = motion.origin
    lines = (
        ("Event", origin.event),
        ("Station", origin.station),
        ("Source", f"{origin.source} ({origin.file_format})" if origin.file_format else origin.source),
        ("In the data", origin.processing or "the source does not say which baseline or filter"),
        ("Cite", origin.citation),
    )
    return tuple(line for line in lines if line[1])
