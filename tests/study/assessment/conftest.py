"""Studies whose results are a formula, so that what an assessment must find is known."""

import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import pytest
import xarray

UNITS = {
    "pgv": "mm s-1", "pga": "mm s-2", "scale": "1", "radius": "mm", "mu": "1", "lambda": "1", "ambient": "degC",
}  # fmt: skip
RESULTS = {
    "peak_displacement": "mm", "peak_change": "mm", "peak_velocity": "mm s-1", "peak_force": "N", "force_ratio": "1",
    "peak_temperature": "degC", "least_friction": "1", "residual_displacement": "mm", "input_velocity": "mm s-1",
    "hysteretic_velocity": "mm s-1",
}  # fmt: skip
MEANINGS = ("not_run", "ok", "beyond_capacity", "still_moving", "failed")
WEIGHT = 7.54e6

Build = Callable[..., xarray.Dataset]


def build(
    grid: Mapping[str, Sequence[Any]],
    *,
    strength: Sequence[float] | None = None,
    events: Sequence[str] | None = None,
    samples: Mapping[str, Sequence[float]] | None = None,
    method: str = "grid",
    capacity: float | None = 600.0,
    displacement: Callable[[dict[str, Any]], Any] | None = None,
) -> xarray.Dataset:
    """Return a study: y = 0.1 strength pgv^1.2 (0.06 / friction)^0.5 of each record, friction mu lambda falling with the ambient temperature.

    Parameters
    ----------
    grid
        Values by the names of the factors; of the record their number or their names.
    strength
        Of each record [-]; 1 if not given.
    events
        The earthquake of each record; by default each has its own.
    samples
        Values of sampled factors.
    displacement
        Another formula for y [mm], from the factors by their names.
    """
    coords: dict[str, Any] = {}
    for name, values in grid.items():
        listed = [f"R{i + 1}" for i in range(values)] if isinstance(values, int) else list(values)
        if isinstance(listed[0], str):
            listed = np.array(listed, dtype=np.dtypes.StringDType())  # as a store has them
        coords[name] = (name, listed, _words(name))
    sizes = {name: len(one[1]) for name, one in coords.items()}
    if "record" in sizes:
        named = list(events or (f"E{i + 1}" for i in range(sizes["record"])))
        coords["event"] = ("record", np.array(named, dtype=np.dtypes.StringDType()))
    for name, values in (samples or {}).items():
        coords[name] = ("sample", list(values), _words(name))
        sizes["sample"] = len(list(values))
    frame = xarray.Dataset(coords=coords)
    every: dict[str, Any] = {name: frame[name] for name in coords if name != "event"}
    every["strength"] = xarray.DataArray(list(strength), dims="record") if strength is not None else 1.0
    shape = xarray.DataArray(np.ones(tuple(sizes.values())), dims=tuple(sizes))
    y = ((displacement or _displacement)(every) * shape).transpose(*sizes)
    friction = _friction(every) * shape
    values = {
        "peak_displacement": y, "peak_change": 1.5 * y, "peak_velocity": 3.0 * y,
        "force_ratio": friction + y / (2.0 * every.get("radius", 4500.0)), "peak_temperature": 20.0 + 0.2 * y,
        "least_friction": friction, "residual_displacement": -0.1 * y, "input_velocity": 2.0 * y, "hysteretic_velocity": 1.9 * y,
    }  # fmt: skip
    values["peak_force"] = WEIGHT * values["force_ratio"]
    status = np.where(y > (capacity or np.inf), 2, 1).astype("uint8")
    flags = {"flag_values": np.arange(5, dtype="uint8"), "flag_meanings": " ".join(MEANINGS)}
    attrs: dict[str, Any] = {
        "title": "A study", "study_name": "formula", "sampling_method": method, "sampling_seed": 1, "study": "", "remarks": "",
        "sampling_factors": json.dumps([{"name": name} for name in samples or {}]),
    }  # fmt: skip
    if capacity is not None:
        attrs["displacement_capacity"] = capacity
    variables = {
        name: (
            tuple(sizes),
            np.array((values[name] * shape).transpose(*sizes)),
            {"units": unit, "long_name": name},
        )
        for name, unit in RESULTS.items()
    }
    return xarray.Dataset({**variables, "status": (tuple(sizes), status, flags)}, coords, attrs)


def _words(name: str) -> dict[str, str]:
    return {"units": UNITS[name], "long_name": name} if name in UNITS else {}


def _friction(every: dict[str, Any]) -> Any:
    return (
        every.get("mu", 0.06) * every.get("lambda", 1.0) * (1.0 - 0.004 * (every.get("ambient", 20.0) - 20.0))
    )


def _displacement(every: dict[str, Any]) -> Any:
    motion = every["pgv"] if "pgv" in every else 500.0 * every.get("scale", 1.0)
    return 0.1 * every["strength"] * motion**1.2 * (0.06 / _friction(every)) ** 0.5


def spoil(study: xarray.Dataset, meaning: str, **places: int) -> xarray.Dataset:
    """Return a study in which the analyses at some places have not been run, or failed."""
    changed = study.copy(deep=True)
    changed["status"][places] = MEANINGS.index(meaning)
    for name in RESULTS:
        changed[name][places] = np.nan
    return changed


@pytest.fixture(name="build", scope="session")
def build_fixture() -> Build:
    return build


@pytest.fixture(name="spoil", scope="session")
def spoil_fixture() -> Callable[..., xarray.Dataset]:
    return spoil


@pytest.fixture(scope="session")
def strengths() -> list[float]:
    """40 records, two components of each of 20 earthquakes; lognormal with dispersions of 0.35 between earthquakes and 0.2 within."""
    numbers = np.random.default_rng(4)
    logarithms = np.repeat(0.35 * numbers.standard_normal(20), 2) + 0.2 * numbers.standard_normal(40)
    return np.exp(logarithms).tolist()


@pytest.fixture(scope="session")
def records(strengths: list[float]) -> xarray.Dataset:
    """A study over 40 records and 10 PGVs."""
    events = [f"E{i // 2}" for i in range(40)]
    pgvs = np.arange(200.0, 2001.0, 200.0)
    return build({"record": 40, "pgv": pgvs, "radius": [4500.0]}, strength=strengths, events=events)


@pytest.fixture(scope="session")
def properties(strengths: list[float]) -> xarray.Dataset:
    """A study over 8 records, 4 PGVs, 3 property factors and 3 ambient temperatures."""
    grid = {
        "record": 8,
        "pgv": [250.0, 500.0, 750.0, 1000.0],
        "lambda": [0.8, 1.0, 1.6],
        "ambient": [-10.0, 20.0, 40.0],
    }
    return build(grid, strength=strengths[:8])


@pytest.fixture(scope="session")
def bearings(strengths: list[float]) -> xarray.Dataset:
    """A study over 40 records, 2 PGVs, 3 radii and 5 coefficients."""
    grid = {
        "record": 40, "pgv": [500.0, 1000.0], "radius": [3000.0, 1500.0, 4500.0], "mu": [0.02, 0.04, 0.06, 0.1, 0.15],
    }  # fmt: skip
    return build(grid, strength=strengths)


def saltelli_rows(base: int, bounds: Sequence[tuple[float, float]], seed: int = 7) -> np.ndarray:
    """Return samples in the order of SALib, shape (base (d + 2), d)."""
    from SALib.sample import sobol

    problem = {"num_vars": len(bounds), "names": [f"x{i}" for i in range(len(bounds))], "bounds": bounds}
    return sobol.sample(problem, base, calc_second_order=False, seed=seed)


@pytest.fixture(name="saltelli_rows", scope="session")
def saltelli_rows_fixture() -> Callable[..., np.ndarray]:
    return saltelli_rows


@pytest.fixture(scope="session")
def sampled(strengths: list[float]) -> xarray.Dataset:
    """A study of 4 records at 3 PGVs with mu, lambda and the ambient temperature sampled: 128 base samples."""
    rows = saltelli_rows(128, [(0.03, 0.09), (0.8, 1.6), (-10.0, 40.0)])
    samples = dict(zip(("mu", "lambda", "ambient"), rows.T.tolist(), strict=True))
    grid = {"record": 4, "pgv": [250.0, 500.0, 1000.0]}
    return build(grid, strength=strengths[:4], samples=samples, method="saltelli")
