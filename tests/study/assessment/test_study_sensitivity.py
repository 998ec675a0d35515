"""Sobol indices through the data set of a study, against functions whose indices are known."""

import sys

import numpy as np
import pytest
import xarray

from dcfp.errors import InputError
from dcfp.study.assessment import sensitivity
from dcfp.study.assessment.selection import remarks_of

# Ishigami and Homma (1990) with a = 7 and b = 0.1
A, B = 7.0, 0.1
VARIANCE = A**2 / 8.0 + B * np.pi**4 / 5.0 + B**2 * np.pi**8 / 18.0 + 0.5
FIRST = np.array([0.5 * (1.0 + B * np.pi**4 / 5.0) ** 2, A**2 / 8.0, 0.0]) / VARIANCE
BOTH = 8.0 * B**2 * np.pi**8 / 225.0 / VARIANCE
TOTAL = FIRST + np.array([BOTH, 0.0, BOTH])


@pytest.fixture(scope="module")
def ishigami(build, saltelli_rows) -> xarray.Dataset:
    """The function of Ishigami in place of a displacement, larger at the higher PGV."""
    rows = saltelli_rows(1024, [(-np.pi, np.pi)] * 3)
    samples = dict(zip(("x1", "x2", "x3"), rows.T.tolist(), strict=True))

    def displacement(every):
        first, second, third = (every[name] for name in ("x1", "x2", "x3"))
        return every["pgv"] * (np.sin(first) + A * np.sin(second) ** 2 + B * third**4 * np.sin(first))

    return build({"pgv": [500.0, 1000.0]}, samples=samples, method="saltelli", displacement=displacement)


def test_ishigami(ishigami):
    """With 1024 base samples of a Sobol sequence; the standard error that the draws give is up to 0.04, of independent samples, of which three are allowed."""
    found = sensitivity(ishigami)
    for name, expected in (("S1", FIRST), ("ST", TOTAL)):
        values = found[name]
        assert values.dims == ("factor", "pgv")
        error = np.abs(values.to_numpy() - expected[:, None])
        half = found[f"{name}_confidence"].to_numpy()
        assert (error <= 1.5 * half + 1e-9).all()
        assert error.max() < 0.06
    # the indices do not know the scale
    np.testing.assert_allclose(found["S1"].isel(pgv=0), found["S1"].isel(pgv=1), rtol=1e-9)
    assert found["factor"].to_numpy().tolist() == ["x1", "x2", "x3"]


def test_the_factors_of_a_product_share_the_logarithm(sampled):
    """The logarithm of y is that of mu, of lambda and of the temperature's part added up: the first order is all there is, and their sum is 1."""
    found = sensitivity(sampled, logarithm=True)
    shares = np.array(
        [np.var(np.log(values)) for values in (sampled["mu"], sampled["lambda"], 1.0 - 0.004 * (sampled["ambient"] - 20.0))]
    )  # fmt: skip
    # 128 base samples: the standard error of a total index is below 0.08
    np.testing.assert_allclose(found["ST"].isel(pgv=0), shares / shares.sum(), atol=0.1)
    assert float(found["S1"].isel(pgv=0).sum()) == pytest.approx(1.0, abs=0.1)
    assert found.attrs["over_records"] == "geometric-mean of 4 records"


def test_a_quantile_of_records_that_differ_by_a_factor_is_the_mean_up_to_a_factor(sampled):
    mean, half = sensitivity(sampled), sensitivity(sampled, over_records=0.5)
    np.testing.assert_allclose(mean["ST"], half["ST"], rtol=1e-9)
    assert half.attrs["over_records"] == "quantile 0.5 of 4 records"


def test_the_temperature_is_taken_at_its_median(sampled):
    assert sensitivity(sampled, "peak_temperature").attrs["over_records"].startswith("quantile 0.5")


def test_the_same_seed_gives_the_same_intervals_and_another_does_not(sampled):
    first, again, other = (sensitivity(sampled, seed=seed)["ST_confidence"] for seed in (1, 1, 2))
    assert first.identical(again)
    assert (first != other).any()


def test_a_result_that_does_not_vary_has_no_indices(sampled):
    still = sampled.copy(deep=True)
    still["peak_displacement"][:, 0] = 5.0
    found = sensitivity(still)
    assert np.isnan(found["ST"].isel(pgv=0)).all()
    assert np.isfinite(found["ST"].isel(pgv=1)).all()
    assert "– where the result does not vary with any factor." in remarks_of(found)


def test_a_record_that_failed_once_is_left_out_of_all_samples(sampled, spoil):
    study = spoil(sampled, "failed", record=2, pgv=1, sample=100)
    found, without = sensitivity(study), sensitivity(sampled.isel(record=[0, 1, 3]))
    np.testing.assert_allclose(found["ST"].isel(pgv=1), without["ST"].isel(pgv=1), rtol=1e-12)
    np.testing.assert_allclose(found["ST"].isel(pgv=0), sensitivity(sampled)["ST"].isel(pgv=0), rtol=1e-12)
    assert "1 of the 7680 analyses failed" in found.attrs["remarks"]


def test_all_records_failing_somewhere_is_refused(sampled, spoil):
    with pytest.raises(InputError, match="1 sets of samples have an analysis that failed"):
        sensitivity(spoil(sampled, "failed", pgv=1, sample=100))


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"over_records": "mean"}, "taken together by 'geometric-mean' or a quantile between 0 and 1, not by 'mean'"),
        ({"over_records": 1.5}, "must lie between 0 and 1"),
        ({"quantity": "residual_displacement", "over_records": "geometric-mean"}, "not above zero, so that there is no geometric mean"),
        ({"seed": 0}, "The seed must be a positive whole number"),
        ({"draws": 1}, "the draws at least 2"),
        ({"confidence": 0.0}, "The confidence must lie between 0 and 1"),
        ({"quantity": "drift"}, "'drift' is no result"),
    ],
)  # fmt: skip
def test_bad_options_are_refused_in_one_sentence(sampled, options, told):
    study = sampled.copy(deep=True)
    study["residual_displacement"][0, 0, 0] = 0.0
    with pytest.raises(InputError) as error:
        sensitivity(study, **options)
    assert told in str(error.value)


def test_other_samples_are_refused(records, sampled, spoil):
    with pytest.raises(InputError, match="samples of the method 'saltelli', and this study has 'grid'"):
        sensitivity(records)
    with pytest.raises(InputError, match="this study has 'latin-hypercube'"):
        sensitivity(sampled.assign_attrs(sampling_method="latin-hypercube"))
    with pytest.raises(InputError, match="639 samples are not a multiple of 5"):
        sensitivity(sampled.isel(sample=slice(639)))
    with pytest.raises(
        InputError, match=r"12 of the 7680 analyses have not been run; finish the study first\."
    ):
        sensitivity(spoil(sampled, "not_run", sample=7))


def test_without_salib_it_says_how_to_get_it(sampled, monkeypatch):
    monkeypatch.setitem(sys.modules, "SALib.analyze.sobol", None)
    with pytest.raises(InputError, match=r"pip install 'dcfp\[studies\]'"):
        sensitivity(sampled)
