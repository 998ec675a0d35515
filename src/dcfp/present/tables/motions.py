"""Ground motions as NetCDF groups and as lines of text, with units."""

import json
import re
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import xarray

from dcfp.present.tables.columns import Column, compressed, histories_csv
from dcfp.schema.nomenclature import quantity
from dcfp.version import version

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dcfp.motion.ground_motion import GroundMotion

#: What `dcfp records` tells of each motion.
MEASURES = (
    Column("record", "record"),
    Column("component", "component"),
    Column("event", "event"),
    Column("station", "station"),
    Column("time_step_s", "time_step", "s", "time step"),
    Column("duration_s", "duration", "s", "time from the first to the last value"),
    Column("points", "points", "1", "number of values"),
    Column("pga_m_s2", "pga", "m s-2", "peak ground acceleration"),
    Column("pgv_m_s", "pgv", "m s-1", "peak ground velocity"),
    Column("pgd_mm", "pgd", "mm", "peak ground displacement"),
    Column("arias_intensity_m_s", "arias_intensity", "m s-1", "Arias intensity"),
    Column(
        "significant_duration_s",
        "significant_duration",
        "s",
        "time between 5 and 95 % of the Arias intensity",
    ),
    Column(
        "cumulative_absolute_velocity_m_s",
        "cumulative_absolute_velocity",
        "m s-1",
        "cumulative absolute velocity",
    ),
    Column("baseline_drift", "baseline_drift", "1", "velocity at the end over the peak ground velocity"),
    Column("treatment", "treatment"),
    Column("remarks", "remarks"),
)


def motion_dataset(motion: "GroundMotion") -> xarray.Dataset:
    """Return the histories of a ground motion over ``time``, and its provenance as attributes."""
    histories = {
        "ground_acceleration": motion.acceleration,
        "ground_velocity": motion.velocity,
        "ground_displacement": motion.displacement,
    }
    return xarray.Dataset(
        {name: ("time", np.array(values), quantity(name).attributes) for name, values in histories.items()},
        coords={"time": ("time", np.array(motion.time), quantity("time").attributes)},
        attrs={
            "Conventions": "CF-1.11",
            "title": f"Ground motion {motion.name}",
            "source": f"dcfp {version()}",
            "references": motion.origin.citation,
            "record": motion.name,
            "record_sha256": motion.digest,
            "record_origin": json.dumps(asdict(motion.origin)),
            "record_treatment": "; ".join(motion.treatment) or "none",
        },
    )


def write_motions_netcdf(
    path: Path, motions: "Sequence[GroundMotion]", rows: "Sequence[Mapping[str, object]]"
) -> None:
    """Write one data set with its measures, or a tree with the measures at its root and a group for each motion.

    Parameters
    ----------
    path
        File to write.
    motions
        The ground motions.
    rows
        The measures of each, by the keys of `MEASURES`.
    """
    datasets = [compressed(motion_dataset(motion)) for motion in motions]
    if len(datasets) == 1:
        measured = {column.key: rows[0][column.key] for column in MEASURES if column.key != "treatment"}
        datasets[0].attrs.update(measured)
        datasets[0].to_netcdf(path, engine="h5netcdf")
        return
    names = motion_names(motions)
    groups = {f"/{name}": data for name, data in zip(names, datasets, strict=True)}
    tree = xarray.DataTree.from_dict({"/": _measures_dataset(names, rows), **groups})
    tree.to_netcdf(path, engine="h5netcdf")


def motion_names(motions: "Sequence[GroundMotion]") -> list[str]:
    """Return a name of its own for each motion: the record, and its component or a number where need be."""
    given = [motion.name for motion in motions]
    names: list[str] = []
    for motion in motions:
        component = motion.origin.component
        full = f"{motion.name}_{component}" if component and given.count(motion.name) > 1 else motion.name
        plain = re.sub(r"[^\w.-]+", "-", full)
        choices = [plain, *(f"{plain}_{number}" for number in range(2, len(motions) + 2))]
        names.append(next(choice for choice in choices if choice not in names))
    return names


def _measures_dataset(names: list[str], rows: "Sequence[Mapping[str, object]]") -> xarray.Dataset:
    variables = {
        column.name: ("motion", *_values(column, [row[column.key] for row in rows])) for column in MEASURES
    }
    return xarray.Dataset(
        variables,
        coords={"motion": ("motion", np.array(names, dtype=object))},
        attrs={
            "Conventions": "CF-1.11",
            "title": "Measures of several ground motions; the histories are in a group for each",
            "source": f"dcfp {version()}",
        },
    )


def _values(column: Column, cells: list[object]) -> tuple[np.ndarray, dict[str, str]]:
    if not column.unit:
        return np.array([str(cell) for cell in cells], dtype=object), {}
    return np.array(cells, dtype=np.float64), {"long_name": column.words, "units": column.unit}


def motion_csv(motion: "GroundMotion") -> str:
    """Return the histories of one ground motion, with units in the head."""
    return histories_csv(motion_dataset(motion))
