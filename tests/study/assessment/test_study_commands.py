"""The commands on the results of a study from end to end: a store on disk, tables, JSON, CSV and figures."""

import csv
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
import xarray

from dcfp.doors.cli.main import main
from dcfp.study.assessment import bounds, fragility, ida, sensitivity


class Outcome(NamedTuple):
    status: int
    out: str
    err: str


Run = Callable[..., Outcome]


@pytest.fixture
def run(capfd: pytest.CaptureFixture[str]) -> Run:
    """Run ``dcfp study`` with words; return its exit status and what it wrote."""

    def call(*words: object) -> Outcome:
        status = main(["study", *(str(word) for word in words)])
        return Outcome(status, *capfd.readouterr())

    return call


def stored(study: xarray.Dataset, place: Path) -> Path:
    """Write a study as a store; the digest is what a store is known by."""
    study.assign_attrs(study_sha256="0" * 64, version="0").to_zarr(place, zarr_format=3, consolidated=False)
    return place


@pytest.fixture(scope="module")
def stores(
    tmp_path_factory: pytest.TempPathFactory,
    records: xarray.Dataset,
    properties: xarray.Dataset,
    bearings: xarray.Dataset,
    sampled: xarray.Dataset,
) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("stores")
    studies = {"records": records, "properties": properties, "bearings": bearings, "sampled": sampled}
    return {name: stored(study, folder / f"{name}.zarr") for name, study in studies.items()}


WORDS = {
    "ida": ("ida", "records"),
    "fragility": ("fragility", "records"),
    "bounds": ("bounds", "properties"),
    "sensitivity": ("sensitivity", "sampled"),
    "chart": ("chart", "bearings", "--pgv", "0.5", "--allow", "150"),
}


@pytest.mark.slow
@pytest.mark.parametrize("command", WORDS)
def test_every_command_writes_table_json_csv_and_figure(run, stores, tmp_path, command):
    name, store, *options = WORDS[command]
    data, figure = tmp_path / "out.csv", tmp_path / "figure.svg"
    status, out, err = run(name, stores[store], *options, "--out", data, "--plot", figure)
    assert (status, err) == (0, "")
    assert out.startswith("Study     A study\n")
    assert figure.read_text().startswith("<?xml")
    rows = list(csv.DictReader(data.read_text().splitlines()))
    assert rows
    assert all(None not in row for row in rows)
    document = json.loads(run(name, stores[store], *options, "--json").out)
    assert document["study"] == "formula"
    assert document["results"]
    # files that are there are not written over
    status, out, err = run(name, stores[store], *options, "--out", data)
    assert (status, out) == (2, "")
    assert "--overwrite" in err


@pytest.mark.slow
def test_ida(run, stores, records):
    found = ida(records)
    document = json.loads(run("ida", stores["records"], "--json").out)
    assert document["at"] == {"radius_mm": 4500.0}
    row = document["results"][4]
    assert row["pgv_m_s"] == 1.0
    assert row["quantiles"]["0.84"] == pytest.approx(float(found["peak_displacement_quantile"][2, 4]))
    assert row["records"]["R7"] == pytest.approx(float(found["peak_displacement"][6, 4]))
    assert row["beyond_capacity"] == int(found["beyond_capacity"][:, 4].sum())
    table = run("ida", stores["records"]).out
    median = float(found["peak_displacement_quantile"][1, 4])
    assert re.search(rf"^ +1 +\S+ {median:.4g} ", table, re.MULTILINE)
    assert "  PGV  16 %  50 %  84 %" in table
    half = run("ida", stores["records"], "--quantity", "peak_force", "--quantiles", "0.5").out
    assert "50 %" in half
    assert "[kN]" in half


def test_what_is_in_a_store_is_told_by_the_quantiles_of_the_curves(run, stores, records):
    found = ida(records)["peak_displacement_quantile"]
    rows = json.loads(run("show", stores["records"], "--json").out)["by_intensity"]
    for i, row in enumerate(rows):
        assert list(row["peak_displacement"].values()) == pytest.approx(found[:, i].to_numpy())


def test_no_line_of_the_envelopes_is_broken(run, stores):
    table = run("bounds", stores["properties"]).out
    assert "residual displacement [mm]" in table


def test_selection_in_the_units_that_are_shown(run, stores, bearings):
    words = ("ida", stores["bearings"], "--at", "radius=1500", "mu=0.06", "--at", "pgv=0.5", "--json")
    document = json.loads(run(*words).out)
    assert document["at"] == {"radius_mm": 1500.0, "mu": 0.06}
    (row,) = document["results"]
    expected = bearings["peak_displacement"].sel(radius=1500.0, mu=0.06, pgv=500.0)
    np.testing.assert_allclose(list(row["records"].values()), expected, rtol=1e-8)


def test_fragility(run, stores, records):
    found = fragility(records, [300.0, 9000.0], further_dispersions={"a": 0.2})
    words = ("fragility", stores["records"], "--capacity", "300", "9000", "--further-dispersion", "0.2")
    document = json.loads(run(*words, "--json").out)
    first, second = document["results"]
    assert first["capacity_mm"] == 300.0
    assert first["median_m_s"] == pytest.approx(float(found["median"][0]) / 1e3)
    assert first["median_bounds_m_s"] == pytest.approx(found["median_bound"][0].to_numpy() / 1e3)
    assert first["total_dispersion"] == pytest.approx(float(found["total_dispersion"][0]))
    assert first["observed"][4] == {"pgv_m_s": 1.0, "fraction": pytest.approx(float(found["fraction"][0, 4]))}
    assert second["median_m_s"] is None
    table = run(*words).out
    assert "40 records of 20 earthquakes" in table
    assert re.search(rf"^ +300  ?{float(found['median'][0]) / 1e3:.4g} ", table, re.MULTILINE)
    assert "9000 mm: none of the 40 records exceeds it up to 2 m/s" in " ".join(table.split())


@pytest.mark.slow
def test_bounds(run, stores, properties):
    found = bounds(properties)
    words = (
        "bounds",
        stores["properties"],
        "--over",
        "lambda",
        "ambient",
        "--nominal",
        "lambda=1",
        "ambient=20",
    )
    document = json.loads(run(*words, "--json").out)
    row = next(one for one in document["results"] if (one["quantity"], one["quantile"], one["pgv_m_s"]) == ("force_ratio", 0.84, 0.5))  # fmt: skip
    for side in ("least", "nominal", "largest"):
        assert row[side] == pytest.approx(float(found[f"force_ratio_{side}"][1, 1]))
    assert row["largest_at"] == "lambda 1.6, ambient -10 °C"
    assert document["nominal"] == "lambda 1, ambient 20 °C"
    table = run(*words).out
    assert "lambda 0.8, ambient 40 °C" in table
    assert "ASCE 7-16" in table
    only = run("bounds", stores["properties"], "--quantities", "peak_temperature", "--quantiles", "0.5").out
    assert "peak temperature [°C]" in only
    assert "force" not in only


@pytest.mark.slow
def test_sensitivity_table(run, stores, sampled):
    found = sensitivity(sampled, over_records=0.5)
    words = ("sensitivity", stores["sampled"], "--over-records", "0.5")
    rows = json.loads(run(*words, "--json").out)["results"]
    assert [row["factor"] for row in rows[:3]] == ["mu", "lambda", "ambient"]
    assert rows[1]["pgv_m_s"] == 0.25
    assert rows[1]["ST"] == pytest.approx(float(found["ST"][1, 0]))
    table = run(*words).out
    assert f"{float(found['S1'][0, 0]):.3f} ± {float(found['S1_confidence'][0, 0]):.3f}" in table
    assert "quantile 0.5 of 4 records" in table


def test_chart(run, stores):
    document = json.loads(run("chart", stores["bearings"], "--pgv", "1", "--allow", "300", "--json").out)
    rows = document["results"]
    assert [row["radius_mm"] for row in rows] == [1500.0, 3000.0, 4500.0]
    # y_max does not know the radius in this study, and the force falls with it
    assert len({row["least_coefficient_50_percent"] for row in rows}) == 1
    forces = [row["force_over_weight_50_percent"] for row in rows]
    assert forces == sorted(forces, reverse=True)
    assert rows[0]["least_coefficient_95_percent"] is None
    table = run("chart", stores["bearings"], "--pgv", "1", "--allow", "300").out
    assert "which friction and radius hold y_max to 300 mm" in table
    assert "–" in table
    assert "where none is enough, 0.15 counts, which is too low." in " ".join(table.split())
    held = " ".join(run("chart", stores["bearings"], "--pgv", "0.5", "--allow", "400").out.split())
    assert "mean of the radii, between" in held
    assert "where none is enough" not in held


def test_chart_of_few_records_and_a_property_factor(run, build, tmp_path):
    grid = {"record": 4, "pgv": [500.0], "radius": [1500.0, 3000.0], "mu": [0.04, 0.12], "lambda": [0.8, 1.2]}
    store = stored(build(grid), tmp_path / "few.zarr")
    table = run("chart", store, "--allow", "150", "--at", "lambda=0.8").out
    assert "What 95 % do not exceed needs more than 4 records." in table
    assert "mu is before the property factor lambda of 0.8." in table
    assert "95 %\n" not in table


def test_a_netcdf_file_does_as_well(run, records, tmp_path):
    file = tmp_path / "study.nc"
    names = {name: records[name].to_numpy().astype(object) for name in ("record", "event")}
    whole = records.assign_coords({name: ("record", values) for name, values in names.items()})
    whole.assign_attrs(study_sha256="0" * 64).to_netcdf(file, engine="h5netcdf")
    assert run("ida", file).status == 0


def test_an_unfinished_study(run, records, spoil, tmp_path):
    store = stored(spoil(records, "not_run", record=3), tmp_path / "part.zarr")
    status, out, err = run("fragility", store)
    assert (status, out) == (2, "")
    assert "10 of the 400 analyses have not been run; finish the study first" in err
    assert "10 of the 400 analyses have not been run, and are left out." in " ".join(
        run("fragility", store, "--unfinished").out.split()
    )


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("ida", "records", "--at", "radius"), "--at: write FACTOR=VALUE, for example radius=4500, not 'radius'"),
        (("ida", "records", "--at", "radius=4501"), "no radius of 4501 mm in this study; there is 4500 mm"),
        (("ida", "records", "--at", "radius=wide"), "radius is chosen by a number, not by 'wide'"),
        (("ida", "records", "--at", "pgv=1", "pgv=2"), "--at: pgv is given twice"),
        (("ida", "records", "--at", "law=li2020"), "'law' is no factor of this study"),
        (("ida", "bearings"), "--at radius=... mu=..."),
        (("ida", "records", "--quantiles", "50"), "--quantiles: parts of the records that do not exceed must be a number above 0 and up to 0.9999, not '50' (were % meant?)."),
        (("ida", "records", "--quantity", "drift"), "'drift' is no result of this study"),
        (("ida", "records", "--out", "out.nc"), "out.nc"),
        (("fragility", "records", "--capacity", "-5"), "must be a number of mm above 0, not '-5'"),
        (("fragility", "records", "--capacity", "90000"), "No fragility can be fitted"),
        (("fragility", "records", "--quantity", "force_ratio"), "needs a capacity"),
        (("fragility", "records", "--seed", "x"), "--seed: seed of the draws must be a whole number"),
        (("bounds", "records"), "None of lambda, ambient has several values"),
        (("bounds", "properties", "--nominal", "lambda=1.1"), "no lambda of 1.1"),
        (("sensitivity", "records"), "samples of the method 'saltelli'"),
        (("sensitivity", "sampled", "--over-records", "mean"), "--over-records: write geometric-mean or a quantile"),
        (("sensitivity", "sampled", "--unfinished"), "--unfinished is not an option"),
        (("chart", "bearings", "--allow", "300"), "for one PGV; choose one of 0.5 m/s, 1 m/s"),
        (("chart", "bearings", "--pgv", "0.7", "--allow", "300"), "no pgv of 0.7 m/s"),
        (("chart", "bearings", "--pgv", "0.5"), "--allow"),
    ],
)  # fmt: skip
def test_bad_input_is_one_sentence(run, stores, words, told):
    name, store, *options = words
    status, out, err = run(name, stores[store], *options)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert err.startswith("dcfp: ")
    assert told in err


def test_what_is_no_store_is_refused(run, tmp_path):
    for place in (tmp_path / "missing.zarr", tmp_path):
        status, out, err = run("ida", place)
        assert (status, out, err.count("\n")) == (2, "", 1)
        assert str(place) in err
