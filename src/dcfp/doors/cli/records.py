"""``dcfp records``: the named records; or the components of record files and what their motions measure."""

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path

from dcfp.doors.cli.console import Page, grid
from dcfp.doors.cli.inputs import Moved
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import load_records, read_motions
from dcfp.motion.measures import MEASURES, motion_remarks
from dcfp.motion.named import ALIASES, NAMED, SETS, STATIONS_TOLD, NamedRecord, named_records
from dcfp.motion.station import Station, stations_of
from dcfp.motion.station_measures import STATION_MEASURES, station_remarks
from dcfp.motion.treatment import record_treated
from dcfp.present.tables import write_motions
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table

_LEGEND = (
    "PGA, PGV, PGD: of the resultant of x and y; dir. PGV: where the ground moves at its PGV; axis, ratio: direction of the stronger principal axis of"
    " the acceleration, and root mean square along the weaker over that along the stronger (Penzien and Watabe 1975); directions are counted from x towards y.",
)


def run(chosen: argparse.Namespace) -> Answer:
    """List the named records, or describe those that are asked for."""
    if not chosen.records:
        return _named()
    records = [one for name in chosen.records for one in _records(name, chosen)]
    stations = stations_of(records)
    if stations:
        return _described(stations, STATION_MEASURES, station_remarks, "stations.plot_stations", _LEGEND)
    singles = [one for one in records if isinstance(one, GroundMotion)]
    sets = [STATIONS_TOLD] if SETS.keys() & map(str.upper, chosen.records) else []
    return _described(singles, MEASURES, motion_remarks, "plot_motions", sets)


def _described(
    motions: Sequence[Moved],
    measures: Sequence[Quantity],
    remarks: Callable[[Moved], list[str]],
    figure: str,
    legend: Sequence[str] = (),
) -> Answer:
    table = Table(tuple(measures), motions)
    return Answer(
        table.objects,
        lambda: Page(
            [grid(table), *dict.fromkeys(map(_origin, motions))],
            [*(remark for motion in motions for remark in remarks(motion)), *legend],
        ),
        lambda part, kind: write_motions(part, motions, kind),
        drawn(figure, motions),
    )


def _named() -> Answer:
    named = named_records()
    # the paper's records first, then those of the paper that have to be supplied, then the sets in their own order
    places = [*ALIASES, *(row.name for row in named if not row.alias)]
    rows: list[NamedRecord] = sorted(named, key=lambda row: places.index(row.alias or row.name))
    remarks = [STATIONS_TOLD, *(f"{row.name}: {row.note}." for row in rows if row.note)]
    return Answer.of_table(Table(tuple(NAMED), rows), remarks=remarks)


def _records(name: str, chosen: argparse.Namespace) -> Sequence[GroundMotion | Station]:
    reading = {"units": chosen.units, "time_step": chosen.time_step}
    if chosen.component is None and Path(name).is_file():
        records: Sequence[GroundMotion | Station] = read_motions(name, **reading)
    else:
        records = load_records([name], chosen.component, vertical=True, **reading)
    return [record_treated(one, baseline=chosen.baseline, corner=chosen.high_pass) for one in records]


def _origin(motion: GroundMotion | Station) -> tuple[tuple[str, str], ...]:
    origin = motion.origin
    several = ("Components", origin.component if isinstance(motion, Station) else "")
    lines = (
        ("Event", origin.event),
        ("Station", origin.station),
        several,
        ("Source", f"{origin.source} ({origin.file_format})" if origin.file_format else origin.source),
        ("In the data", origin.processing or "the source does not say which baseline or filter"),
        ("Cite", origin.citation),
    )
    return tuple(line for line in lines if line[1])
