"""Response history analyses, virtual tests and studies as NetCDF groups and as lines of text, with units."""

import csv
import io
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray

from dcfp.analysis.rig.loops import cycle_rows
from dcfp.present.tables.columns import Column, compressed, head_of, histories_csv, table_text
from dcfp.study.results import parts_of
from dcfp.version import version

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dcfp.analysis import Response
    from dcfp.analysis.rig import Loops


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


# Virtual tests.


TEST_WORDS = (
    Column("test", "test"),
    Column("friction", "friction"),
    Column("heating", "heating"),
    Column("waveform", "waveform"),
)
TEST_NUMBERS = (
    Column("cycle", "cycle", "1", "number of the cycle in its test"),
    Column("pressure_N_mm2", "pressure", "N mm-2", "mean pressure on the slider"),
    Column("load_kN", "load", "kN", "mean vertical force"),
    Column("peak_velocity_mm_s", "peak_velocity", "mm s-1", "largest velocity of the test"),
    Column("period_s", "period", "s", "period of the test"),
    Column("displacement_max_mm", "displacement_max", "mm", "largest displacement d+"),
    Column("displacement_min_mm", "displacement_min", "mm", "smallest displacement d-"),
    Column("force_at_displacement_max_kN", "force_at_displacement_max", "kN", "force at d+"),
    Column("force_at_displacement_min_kN", "force_at_displacement_min", "kN", "force at d-"),
    Column("keff_kN_mm", "keff", "kN mm-1", "effective stiffness"),
    Column("beta_eff", "beta_eff", "1", "effective damping"),
    Column("post_yield_stiffness_kN_mm", "post_yield_stiffness", "kN mm-1", "post-yield stiffness"),
    Column("strength_kN", "strength", "kN", "characteristic strength"),
    Column("energy_kN_m", "energy", "kN m", "energy per cycle"),
    Column("friction_at_zero", "friction_at_zero", "1", "coefficient of friction at zero displacement"),
    Column("friction_of_loop", "friction_of_loop", "1", "coefficient of the Coulomb loop of the same area"),
    Column("temperature_max_degC", "temperature_max", "degC", "highest temperature of the contact"),
)


def cycles_csv(loops: "Sequence[Loops]") -> str:
    """Return the histories of one test, or the measures of every cycle of several, with units in the head."""
    if len(loops) == 1:
        return histories_csv(loops[0].to_dataset().drop_dims(["profile_time"], errors="ignore"))
    return table_text([*TEST_WORDS, *TEST_NUMBERS], [row for test in loops for row in cycle_rows(test)])


def write_tests_netcdf(path: Path, loops: "Sequence[Loops]") -> None:
    """Write one data set, or a tree with the measures of every cycle at its root and a group for each test."""
    datasets = [compressed(test.to_dataset()) for test in loops]
    if len(datasets) == 1:
        datasets[0].to_netcdf(path, engine="h5netcdf")
        return
    groups = {f"/{name}": data for name, data in zip(_group_names(loops), datasets, strict=True)}
    xarray.DataTree.from_dict({"/": _cycles_dataset(loops), **groups}).to_netcdf(path, engine="h5netcdf")


def _group_names(loops: "Sequence[Loops]") -> list[str]:
    names: list[str] = []
    for test in loops:
        plain = re.sub(r"[^\w.-]+", "-", test.test.name)
        choices = [plain, f"{plain}_{test.friction_law.name}_{test.heating.name}"]
        choices += [f"{choices[1]}_{number}" for number in range(2, len(loops) + 2)]
        names.append(next(choice for choice in choices if choice not in names))
    return names


def _cycles_dataset(loops: "Sequence[Loops]") -> xarray.Dataset:
    rows = [row for test in loops for row in cycle_rows(test)]
    words = {c.name: ("row", np.array([str(row[c.key]) for row in rows], dtype=object)) for c in TEST_WORDS}
    numbers = {
        c.name: (
            "row",
            np.array([np.nan if row[c.key] is None else row[c.key] for row in rows], dtype=np.float64),
            {"long_name": c.words, "units": c.unit},
        )
        for c in TEST_NUMBERS
    }
    return xarray.Dataset(
        {**words, **numbers},
        attrs={
            "Conventions": "CF-1.11",
            "title": "Measures of every cycle of several virtual tests; the histories are in a group for each",
            "source": f"dcfp {version()}",
        },
    )


# The results of a study as one file.


def write_study_netcdf(dataset: xarray.Dataset, path: Path) -> None:
    """Write everything that a store holds, as NetCDF."""
    whole = dataset.load().copy()
    for name in (*whole.coords, *whole.data_vars):
        whole[name].encoding = {}
        if whole[name].dtype.kind == "T":  # NetCDF knows strings as objects
            whole[name] = whole[name].astype(object)
    compressed(whole).to_netcdf(path, engine="h5netcdf")


def study_csv(dataset: xarray.Dataset, path: Path) -> None:
    """Write a line for each analysis, with units in the head; histories are left out."""
    quantities = [str(name) for name in dataset.data_vars if not str(name).startswith("history_")]
    dimensions = [str(name) for name in dataset[quantities[0]].dims]
    beside = [
        str(name) for name in dataset.coords if name not in dimensions and dataset[name].dims == ("sample",)
    ]
    names = [*dimensions, *beside, *quantities]
    with path.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        units = [str(dataset[name].attrs.get("units", "")) for name in names]
        writer.writerow([head_of(*one) if one[1] else one[0] for one in zip(names, units, strict=True)])
        for part in parts_of(dataset):
            writer.writerows(_lines(part, names, dimensions))


def _lines(part: xarray.Dataset, names: list[str], dimensions: list[str]) -> "zip[tuple[Any, ...]]":
    order = tuple(dimensions)
    like = part[names[-1]].transpose(*order)
    columns = [_words(part[name].broadcast_like(like).transpose(*order)) for name in names]
    return zip(*columns, strict=True)


def _words(array: xarray.DataArray) -> list[str]:
    values: np.ndarray[Any, Any] = array.to_numpy().ravel()
    if "flag_meanings" in array.attrs:
        meanings = str(array.attrs["flag_meanings"]).split()
        return [meanings[int(value)] for value in values.tolist()]
    if values.dtype.kind == "f":
        return ["" if np.isnan(value) else f"{value:.9g}" for value in values.tolist()]
    return [str(value) for value in values.tolist()]
