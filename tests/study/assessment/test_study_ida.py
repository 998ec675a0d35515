"""Incremental dynamic analysis of studies whose quantiles are known."""

import numpy as np
import pytest
from scipy.stats import norm

from dcfp.errors import InputError
from dcfp.study.assessment import ida
from dcfp.study.assessment.selection import remarks_of


def test_quantiles_of_a_lognormal_are_those_of_the_normal(build):
    """The strengths are at the ranks i / (n + 1) of a lognormal, so that the quantiles are exact at whole ranks: 0.16, 0.5 and 0.84 of 99 records."""
    strength = np.exp(0.4 * norm.ppf(np.arange(1, 100) / 100.0))
    pgvs = [250.0, 500.0, 1000.0]
    found = ida(build({"record": 99, "pgv": pgvs}, strength=strength))
    middle = 0.1 * np.array(pgvs) ** 1.2
    for part in (0.16, 0.5, 0.84):
        curve = found["peak_displacement_quantile"].sel(quantile=part)
        np.testing.assert_allclose(curve, middle * np.exp(0.4 * norm.ppf(part)), rtol=1e-12)


def test_curves_are_those_of_the_records(records):
    found = ida(records)
    np.testing.assert_array_equal(found["peak_displacement"], records["peak_displacement"].isel(radius=0))
    assert found["peak_displacement"].dims == ("record", "pgv")


def test_quantiles_grow_with_their_part_and_lie_among_the_records(records):
    found = ida(records, quantiles=(0.1, 0.3, 0.5, 0.7, 0.9))
    curves = found["peak_displacement_quantile"].to_numpy()
    assert (np.diff(curves, axis=0) >= 0.0).all()
    values = found["peak_displacement"].to_numpy()
    assert (curves >= values.min(axis=0)).all()
    assert (curves <= values.max(axis=0)).all()


def test_intensities_may_stand_in_any_order(records):
    turned = records.isel(pgv=[3, 0, 7, 1, 9, 2, 8, 4, 6, 5])
    assert ida(turned).identical(ida(records))


def test_a_part_that_xarray_has_cut_out_can_be_used(records):
    """Its status then is of floats."""
    part = records.where(records["pgv"] > records["pgv"][3], drop=True)
    assert part["status"].dtype.kind == "f"
    found, expected = ida(part), ida(records.isel(pgv=slice(4, None)))
    np.testing.assert_array_equal(found["peak_displacement_quantile"], expected["peak_displacement_quantile"])


def test_other_intensities_and_other_quantities(build, strengths):
    study = build({"scale": [0.5, 1.0, 2.0], "record": 40}, strength=strengths)
    found = ida(study, "peak_force", (0.5,))
    assert found["peak_force_quantile"].dims == ("quantile", "scale")
    assert found["peak_force_quantile"].attrs["units"] == "N"


def test_one_record_and_one_intensity_are_an_analysis_too(records):
    found = ida(records.isel(record=[4], pgv=[2]), quantiles=(0.5,))
    assert found["peak_displacement_quantile"].item() == records["peak_displacement"][4, 2, 0]


def test_what_is_beyond_the_capacity_is_marked_and_counted(records):
    found = ida(records)
    beyond = found["peak_displacement"].to_numpy() > 600.0
    np.testing.assert_array_equal(found["beyond_capacity"], beyond)
    assert (
        f"{beyond.sum()} of the 400 analyses are beyond the displacement capacity" in found.attrs["remarks"]
    )


def test_too_few_records_for_a_quantile_are_named(records):
    remarks = remarks_of(ida(records.isel(record=slice(4)), quantiles=(0.16, 0.5, 0.95)))
    told = [remark for remark in remarks if "too few" in remark]
    assert [remark.split(";")[0] for remark in told] == [
        "4 records are too few for a quantile of 0.16",
        "4 records are too few for a quantile of 0.95",
    ]


@pytest.mark.parametrize("part", [0.0, 1.0, -0.1, 16.0])
def test_a_quantile_must_be_a_part(records, part):
    with pytest.raises(InputError, match="A quantile must lie between 0 and 1"):
        ida(records, quantiles=(part,))


def test_the_sources_are_named(records):
    assert "10.1002/eqe.141" in ida(records).attrs["references"]
