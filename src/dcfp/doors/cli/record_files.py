"""The files of `dcfp records`."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dcfp.present import tables
from dcfp.present.tables import MEASURES, Column

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dcfp.motion.ground_motion import GroundMotion
    from dcfp.motion.named import NamedRecord

_NAMED = (
    Column("name", "name"),
    Column("alias", "alias"),
    Column("event", "event"),
    Column("year", "year"),
    Column("station", "station"),
    Column("component", "component"),
    Column("magnitude", "magnitude", "1"),
    Column("record_sequence_number", "record_sequence_number", "1"),
    Column("time_step", "time_step", "s"),
    Column("duration", "duration", "s"),
    Column("points", "points", "1"),
    Column("peak_acceleration", "pga", "mm s-2"),
    Column("peak_velocity", "pgv", "mm s-1"),
    Column("available", "available"),
    Column("note", "note"),
)


def write_named(path: Path, rows: "Sequence[NamedRecord]") -> None:
    """Write the list of named records as CSV."""
    path.write_text(tables.table_text(_NAMED, [asdict(row) for row in rows]), encoding="utf-8")


def write_histories(
    path: Path, motions: "Sequence[GroundMotion]", rows: "Sequence[Mapping[str, object]]", kind: str
) -> None:
    """Write histories as ``".nc"``; as ``".csv"`` the histories of one motion, or the measures of several."""
    told = [
        {**row, "treatment": _joined(row["treatment"], "; "), "remarks": _joined(row["remarks"], " ")}
        for row in rows
    ]
    if kind == ".nc":
        tables.write_motions_netcdf(path, motions, told)
    elif len(motions) == 1:
        path.write_text(tables.motion_csv(motions[0]), encoding="utf-8")
    else:
        path.write_text(tables.table_text(MEASURES, told), encoding="utf-8")


def write_motion_figure(path: Path, motions: "Sequence[GroundMotion]", form: str) -> None:
    """Draw the histories of motions into `path` as ``"png"``, ``"pdf"`` or ``"svg"``."""
    from dcfp.present.figures import plot_motions, save_figure  # late: Matplotlib takes long to import

    save_figure(plot_motions(motions), path, form)


def _joined(words: Any, between: str) -> str:
    return between.join(words)
