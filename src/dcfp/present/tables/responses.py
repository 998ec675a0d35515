"""Response history analyses as NetCDF groups and as lines of text, with units."""

import csv
import io
import re
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import xarray

from dcfp.present.tables.columns import Column, compressed, head_of, histories_csv
from dcfp.version import version

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dcfp.analysis import Response

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
    datasets = [compressed(response.to_dataset()) for response in responses]
    if len(datasets) == 1:
        datasets[0].to_netcdf(path, engine="h5netcdf")
        return
    groups = {f"/{name}": data for name, data in zip(group_names(responses), datasets, strict=True)}
    tree = xarray.DataTree.from_dict({"/": summary_dataset(responses), **groups})
    tree.to_netcdf(path, engine="h5netcdf")


def csv_text(responses: "Sequence[Response]") -> str:
    """Return the histories of one analysis, or the summary of several, with units in the head."""
    if len(responses) == 1:
        return histories_csv(responses[0].to_dataset().drop_dims(["profile_time"], errors="ignore"))
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow([*WORDS, *(head_of(column.name, column.unit) for column in COLUMNS), "remarks"])
    for response in responses:
        row = response.summary()
        numbers = [f"{float(row[column.key]):.9g}" for column in COLUMNS]
        writer.writerow([*(row[name] for name in WORDS), *numbers, " ".join(response.remarks)])
    return stream.getvalue()
