"""Analyses and ground motions as NetCDF groups and as lines of text, with units."""

import csv
import io
import json
import re
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import xarray

from dcfp.nomenclature import quantity
from dcfp.version import version

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dcfp.record.ground_motion import GroundMotion
    from dcfp.response import Response


@dataclass(frozen=True)
class Column:
    """One column of a table: its key in a row, and its name, unit (UDUNITS; empty for text) and words."""

    key: str
    name: str
    unit: str = ""
    words: str = ""


COLUMNS = (
    Column("pgv_m_s", "pgv", "m s-1", "peak ground velocity"),
    Column("y_max_mm", "y_max", "mm", "largest displacement of the isolation layer"),
    Column("dy_max_mm", "dy_max", "mm", "largest change of displacement between two successive peaks"),
    Column("v_max_mm_s", "v_max", "mm s-1", "largest relative velocity"),
    Column("residual_mm", "residual", "mm", "residual displacement"),
    Column("force_max_kN", "force_max", "kN", "largest horizontal force"),
    Column("temperature_max_degC", "temperature_max", "degC", "highest temperature of the contact"),
    Column("friction_min", "friction_min", "1", "smallest coefficient of friction while sliding"),
    Column("V_E_mm_s", "V_E", "mm s-1", "equivalent velocity of the input energy"),
    Column("V_Eh_mm_s", "V_Eh", "mm s-1", "equivalent velocity of the hysteretic energy"),
    Column(
        "energy_residual",
        "energy_residual",
        "1",
        "residual of the energy balance over the largest input energy",
    ),
    Column("elapsed_s", "elapsed", "s", "computing time of the analysis"),
)
WORDS = ("record", "friction", "heating", "status")


def summary_dataset(responses: "Sequence[Response]") -> xarray.Dataset:
    """Return the peaks of every analysis over the dimension ``analysis``."""
    rows = [response.summary() for response in responses]
    words = {name: ("analysis", np.array([str(row[name]) for row in rows], dtype=object)) for name in WORDS}
    numbers = {
        column.name: (
            "analysis",
            np.array([float(row[column.key]) for row in rows]),
            {"long_name": column.words, "units": column.unit},
        )
        for column in COLUMNS
    }
    remarks = np.array([" ".join(response.remarks) for response in responses], dtype=object)
    return xarray.Dataset(
        {**words, **numbers, "remarks": ("analysis", remarks)},
        coords={"analysis": ("analysis", np.array(group_names(responses), dtype=object))},
        attrs={
            "Conventions": "CF-1.11",
            "title": "Peaks of several response history analyses; the histories are in a group for each",
            "source": f"dcfp {version()}",
        },
    )


def group_names(responses: "Sequence[Response]") -> list[str]:
    """Return a name for each analysis, such as ``NCC_0.50``: the record and the PGV [m/s]."""
    names: list[str] = []
    for response in responses:
        record = re.sub(r"[^\w.-]+", "-", response.motion.name)
        pgv = response.motion.peak_velocity / 1e3
        choices = [f"{record}_{pgv:.2f}", f"{record}_{pgv:.6g}"]
        choices += [f"{choices[0]}_{number}" for number in range(2, len(responses) + 2)]
        names.append(next(choice for choice in choices if choice not in names))
    return names


def write_netcdf(path: Path, responses: "Sequence[Response]") -> None:
    """Write one data set, or a tree with the summary at its root and a group for each analysis."""
    datasets = [_compressed(response.to_dataset()) for response in responses]
    if len(datasets) == 1:
        datasets[0].to_netcdf(path, engine="h5netcdf")
        return
    groups = {f"/{name}": data for name, data in zip(group_names(responses), datasets, strict=True)}
    tree = xarray.DataTree.from_dict({"/": summary_dataset(responses), **groups})
    tree.to_netcdf(path, engine="h5netcdf")


def _compressed(data: xarray.Dataset) -> xarray.Dataset:
    for variable in data.variables.values():
        variable.encoding.update(zlib=True, complevel=1, shuffle=True)
    return data


def csv_text(responses: "Sequence[Response]") -> str:
    """Return the histories of one analysis, or the summary of several, with units in the head."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    if len(responses) == 1:
        data = responses[0].to_dataset().drop_dims(["profile_time"], errors="ignore")
        names = ["time", *(str(name) for name in data.data_vars)]
        writer.writerow([_head(name, str(data[name].attrs["units"])) for name in names])
        table = np.column_stack([data[name].to_numpy() for name in names])
        writer.writerows([[f"{value:.9g}" for value in row] for row in table.tolist()])
    else:
        writer.writerow([*WORDS, *(_head(column.name, column.unit) for column in COLUMNS), "remarks"])
        for response in responses:
            row = response.summary()
            numbers = [f"{float(row[column.key]):.9g}" for column in COLUMNS]
            writer.writerow([*(row[name] for name in WORDS), *numbers, " ".join(response.remarks)])
    return stream.getvalue()


def _head(name: str, unit: str) -> str:
    return f"{name} [{'-' if unit == '1' else unit}]"


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


def table_text(columns: "Sequence[Column]", rows: "Sequence[Mapping[str, object]]") -> str:
    """Return rows as CSV, with units in the head; what is None leaves its cell empty."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow([_head(column.name, column.unit) if column.unit else column.name for column in columns])
    writer.writerows([[_cell(row[column.key]) for column in columns] for row in rows])
    return stream.getvalue()


def _cell(value: object) -> str:
    if value is None:
        return ""
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:.9g}" if isinstance(value, float) else str(value)


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
    datasets = [_compressed(motion_dataset(motion)) for motion in motions]
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
    data = motion_dataset(motion)
    names = ["time", *(str(name) for name in data.data_vars)]
    columns = [Column(name, name, quantity(name).unit) for name in names]
    table = np.column_stack([data[name].to_numpy() for name in names])
    return table_text(columns, [dict(zip(names, row, strict=True)) for row in table.tolist()])
