"""Virtual tests as NetCDF groups and as lines of text, with units."""

import re
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import xarray

from dcfp.analysis.rig.loops import cycle_rows
from dcfp.present.tables.columns import Column, compressed, histories_csv, table_text
from dcfp.version import version

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dcfp.analysis.rig import Loops

WORDS = (
    Column("test", "test"),
    Column("friction", "friction"),
    Column("heating", "heating"),
    Column("waveform", "waveform"),
)
NUMBERS = (
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
    return table_text([*WORDS, *NUMBERS], [row for test in loops for row in cycle_rows(test)])


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
    words = {c.name: ("row", np.array([str(row[c.key]) for row in rows], dtype=object)) for c in WORDS}
    numbers = {
        c.name: (
            "row",
            np.array([np.nan if row[c.key] is None else row[c.key] for row in rows], dtype=np.float64),
            {"long_name": c.words, "units": c.unit},
        )
        for c in NUMBERS
    }
    return xarray.Dataset(
        {**words, **numbers},
        attrs={
            "Conventions": "CF-1.11",
            "title": "Measures of every cycle of several virtual tests; the histories are in a group for each",
            "source": f"dcfp {version()}",
        },
    )
