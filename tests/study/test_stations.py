"""Studies whose records are stations: the right numbers in the plane, from a file or from Python, and what is refused."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import xarray

import dcfp
from dcfp.analysis.response import NUMBERS
from dcfp.errors import InputError
from dcfp.motion.station import Station, joined
from dcfp.study import Study, open_store, read_study, run_study
from dcfp.study.assessment import bounds, fragility, ida
from dcfp.study.assessment.selection import remarks_of, response_at
from dcfp.study.results import kept_peaks
from dcfp.system import System

pytestmark = pytest.mark.filterwarnings("error")


@pytest.fixture(scope="module")
def stations(motions) -> list[Station]:
    """Two stations of three and of six seconds."""
    short, long, middle = motions
    turned = replace(short.scaled(0.7), name="turned", origin=long.origin)
    return [
        joined([short, replace(middle, origin=short.origin)], "first"),
        joined([long, turned], "second"),
    ]


@pytest.fixture(scope="module")
def results(stations) -> xarray.Dataset:
    factors = {"pgv": [200.0, 500.0], "heating": ["none", "simplified", "precise"], "lambda": [0.8, 1.0]}
    return run_study(Study(stations, factors, title="Stations"))


def test_every_result_is_that_of_the_analysis_alone(stations, results) -> None:
    assert list(results.data_vars)[:3] == [
        "peak_displacement",
        "peak_displacement_x",
        "peak_displacement_y",
    ]
    for station in stations:
        for pgv in (200.0, 500.0):
            for heating in ("none", "simplified", "precise"):
                alone = dcfp.respond(station.scaled(pgv / station.peak_velocity), heating=heating)
                found = results.sel({"record": station.name, "pgv": pgv, "heating": heating, "lambda": 1.0})
                assert found["status"].item() == NUMBERS[alone.status]
                for name in kept_peaks(in_plane=True):
                    assert found[name].item() == pytest.approx(getattr(alone, name), rel=1e-9), name


def test_what_is_said_of_the_stations(stations, results) -> None:
    assert results.attrs["directions"] == 2
    assert results["event"].values.tolist() == ["Event of short", "Event of long"]
    assert results["record_sha256"].values.tolist() == [one.digest for one in stations]
    assert results["unscaled_pgv"].values.tolist() == [one.peak_velocity for one in stations]
    assert results["peak_point_temperature"].attrs["units"] == "degC"
    hotter = results["peak_point_temperature"] >= results["peak_temperature"]
    assert hotter.all()


def test_the_field_is_what_is_meant_unless_something_is_said(stations, motions) -> None:
    assert Study(stations).model.heating.name == "precise"
    assert Study(motions).model.heating.name == "simplified"
    assert Study(stations, model=System()).model.heating.name == "simplified"


def test_histories_of_both_directions(stations) -> None:
    study = Study(stations[:1], model=System.of(heating="none"), histories=("displacement_x", "force"))
    kept, alone = run_study(study), dcfp.respond(stations[0], heating="none")
    size = len(stations[0].acceleration)
    for name in study.histories:
        assert np.array_equal(kept[f"history_{name}"].values[0], alone.history(name)[:size])
    assert response_at(study.plan, {}).peak_displacement == alone.peak_displacement
    with pytest.raises(InputError, match="there is no history 'displacement_z'"):
        Study(stations, histories=("displacement_z",))


def test_a_store_is_gone_on_with_and_is_that_of_its_stations(stations, tmp_path: Path) -> None:
    study = Study(stations, {"pgv": [100.0, 200.0, 300.0, 400.0]}, model=System.of(heating="none"))
    whole = run_study(study)

    def stop(analyses: int, cost: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_study(study, tmp_path / "s.zarr", threads=1, report=stop)
    assert (open_store(tmp_path / "s.zarr")["status"] == 0).any()
    assert run_study(study, tmp_path / "s.zarr", resume=True).identical(whole)
    other = Study([one.rotated(30.0) for one in stations], study.factors, model=study.model)
    with pytest.raises(InputError, match="this store is of another study"):
        run_study(other, tmp_path / "s.zarr", resume=True)


def test_the_vertical_force_follows_the_vertical_component(stations, motions) -> None:
    first = stations[0]
    three = replace(first, vertical=replace(first.x.scaled(0.3), name="up"))
    study = Study([three], {"pgv": [300.0]}, model=System.of(heating="none"), vertical=True)
    found = run_study(study).squeeze()
    alone = dcfp.respond(three, pgv=300.0, heating="none", vertical=True)
    assert found["least_load"].item() == pytest.approx(alone.least_load, rel=1e-9)
    assert found["peak_force"].item() == pytest.approx(alone.peak_force, rel=1e-9)
    assert alone.least_load < alone.bearing.vertical_force < alone.largest_load
    with pytest.raises(InputError, match="vertical is for stations"):
        Study(motions, vertical=True)


def test_what_follows_from_it(results) -> None:
    one = results.sel({"heating": "precise"})
    found = bounds(one, ["lambda"])
    assert float(found["peak_displacement_least"].min()) < float(found["peak_displacement_largest"].max())
    curves = ida(one.sel({"lambda": 1.0}), "peak_displacement_x")
    assert curves["peak_displacement_x"].dims == ("record", "pgv")
    # a distance has no direction to leave out
    assert not [line for line in remarks_of(ida(one.sel({"lambda": 1.0}), "residual_displacement")) if "size" in line]  # fmt: skip
    with pytest.raises(InputError, match="A fragility needs at least 4 records, and here are 2"):
        fragility(one.sel({"lambda": 1.0}), 50.0)


def test_a_file_names_stations(tmp_path: Path) -> None:
    wave = np.sin(2.0 * np.pi * np.arange(101) * 0.01)
    for name, factor in (("east.txt", 2.0), ("north.txt", 1.0)):
        np.savetxt(tmp_path / name, factor * wave)
    path = tmp_path / "pairs.toml"
    path.write_text(
        '[factors]\nrecord = ["P695-FF-stations", "east.txt+north.txt"]\n[motion]\nunits = "m/s2"\ntime_step = 0.01\n'
        "[bearing]\nradius = 3000\n",
        encoding="utf-8",
    )
    study = read_study(path)
    assert study.factors["record"] == [*(f"P695-FF-{number}" for number in range(1, 23)), "east+north"]
    assert study.model.heating.name == "precise"
    assert study.motions[-1].peak_acceleration == pytest.approx(1e3 * np.hypot(2.0, 1.0))


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"motions": 1}, "give only stations, or only single components"),
        ({"factors": {"procedure": ["analysis", "march"]}}, "the procedure 'march' is of one direction, and the records are stations"),
        ({"vertical": True}, "first: the station has no vertical component"),
    ],
)  # fmt: skip
def test_what_cannot_be_gets_one_sentence(stations, motions, changes, sentence: str) -> None:
    records = [*stations, *motions[: changes.pop("motions", 0)]]
    with pytest.raises(InputError, match=sentence):
        Study(records, **changes)
