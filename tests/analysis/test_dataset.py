"""The data set of a response: units, provenance, and a way through a file."""

import json

import numpy as np
import pytest
import xarray

import dcfp
from dcfp.analysis.integration import Keep
from dcfp.schema.citations import bibliography, citation
from dcfp.schema.quantities import NOMENCLATURE


@pytest.fixture(scope="module")
def response():
    return dcfp.respond(
        dcfp.load_motion("KNA").scaled_to_pgv(500.0),
        heating=dcfp.PreciseHeating(cells=16),
        keep=Keep(every=100),
    )


def test_every_variable_has_words_and_a_unit(response):
    dataset = response.to_dataset()
    for name in (*dataset.data_vars, *dataset.coords):
        if name in ("plate", "profile_time"):
            continue
        assert dataset[name].attrs["long_name"]
        assert dataset[name].attrs["units"] == NOMENCLATURE[name].unit.udunits


def test_a_file_gives_back_what_was_written(response, tmp_path):
    path = tmp_path / "response.nc"
    response.to_dataset().to_netcdf(path, engine="h5netcdf")
    with xarray.open_dataset(path, engine="h5netcdf") as back:
        np.testing.assert_array_equal(back["displacement"], response.displacement)
        assert back.attrs["record_sha256"] == response.motion.digest
        assert back.attrs["y_max_mm"] == response.peak_displacement
        assert "10.3390/app10155259" in back.attrs["references"]
        assert json.loads(back.attrs["bearing"])["radii"] == [4500.0, 4500.0]


def test_peaks_agree_with_the_histories(response):
    assert response.peak_displacement >= np.abs(response.displacement).max()
    assert response.peak_displacement == pytest.approx(np.abs(response.displacement).max(), rel=1e-3)
    assert response.peak_force == pytest.approx(np.abs(response.force).max(), rel=0.02)
    assert response.peak_temperature == pytest.approx(response.temperature.max(), rel=1e-3)
    assert response.peak_change >= response.peak_displacement


def test_the_summary_is_plain_numbers_and_words(response):
    summary = json.loads(json.dumps(response.summary()))
    assert summary["pgv_m_s"] == pytest.approx(0.5)
    assert summary["status"] == "ok"
    assert summary["energy_residual"] < 1e-9


def test_every_citation_resolves():
    for law in (dcfp.Li2020, dcfp.Kumar2015, dcfp.Constantinou1990, dcfp.ConstantFriction):
        assert law.citation in bibliography()
    for key, entry in bibliography().items():
        assert entry.get("doi", entry["title"]) in citation(key)
