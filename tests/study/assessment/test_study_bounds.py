"""Envelopes over properties: of a formula in which friction alone decides."""

import numpy as np
import pytest

from dcfp.errors import InputError
from dcfp.study.assessment import bounds, select
from dcfp.study.assessment.selection import remarks_of


@pytest.mark.slow
def test_the_least_friction_moves_most_and_the_largest_pushes_most(properties):
    found = bounds(properties)
    assert set(found["peak_displacement_largest_at"].to_numpy().ravel()) == {"lambda 0.8, ambient 40 °C"}
    assert set(found["peak_displacement_least_at"].to_numpy().ravel()) == {"lambda 1.6, ambient -10 °C"}
    assert set(found["force_ratio_largest_at"].to_numpy().ravel()) == {"lambda 1.6, ambient -10 °C"}
    told = remarks_of(found)[-1]
    assert "lower bound of lambda (0.8) governs the displacement in 8 of 8" in told
    assert (
        "upper bound of lambda (1.6) governs the force in 8 of 8, as usual; ASCE 7-16 asks for both." in told
    )


def test_what_is_not_usual_is_said(build):
    """Where the restoring force decides, the lower bound of the friction governs the force as well."""
    grid = {"record": 4, "pgv": [1000.0], "radius": [100.0], "lambda": [0.8, 1.0, 1.2]}
    told = remarks_of(bounds(build(grid), quantiles=(0.5,)))[-1]
    assert "upper bound of lambda (1.2) governs the force in 0 of 1, which is not everywhere as usual" in told


def test_the_envelope_is_that_of_the_values(properties):
    found = bounds(properties)
    for name in ("peak_displacement", "force_ratio", "residual_displacement", "peak_temperature"):
        values = found[name]
        assert values.dims == ("quantile", "pgv", "lambda", "ambient")
        np.testing.assert_array_equal(found[f"{name}_least"], values.min(["lambda", "ambient"]))
        np.testing.assert_array_equal(found[f"{name}_largest"], values.max(["lambda", "ambient"]))
        np.testing.assert_array_equal(found[f"{name}_nominal"], values.sel({"lambda": 1.0, "ambient": 20.0}))


def test_the_ratio_is_that_of_the_formula(properties):
    """y goes with the root of the friction, and that is 0.8 times 0.92 at the softest."""
    found = bounds(properties)
    np.testing.assert_allclose(found["peak_displacement_ratio"], (0.8 * 0.92) ** -0.5, rtol=1e-12)
    assert np.isnan(found["peak_temperature_ratio"]).all()  # a ratio of temperatures means nothing


def test_one_property_alone_and_another_nominal(properties):
    chosen = select(properties, {"ambient": -10.0})
    found = bounds(chosen, nominal={"lambda": 1.6})
    np.testing.assert_array_equal(found["peak_displacement_nominal"], found["peak_displacement_least"])
    assert found.attrs["over"] == "lambda"
    assert float(found["ambient"]) == -10.0


def test_names_may_be_properties(build):
    study = build({"record": 4, "pgv": [500.0], "law": ["li2020", "constant"]})
    found = bounds(study, ("law",), {"law": "constant"})
    assert found["force_ratio_least_at"].to_numpy().ravel()[0] == "law li2020"  # the first of equals


def test_a_record_that_failed_is_left_out_of_its_combination(properties, spoil):
    study = spoil(properties, "failed", record=slice(None), **{"lambda": 0, "ambient": 2})
    found = bounds(study, quantiles=(0.5,))
    assert "lambda 0.8, ambient 40 °C" not in found["peak_displacement_largest_at"].to_numpy()
    assert "32 of the 288 analyses failed" in found.attrs["remarks"]


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"over": ("radius",)}, "'radius' has no bounds in this study, in which several values are of record, pgv, lambda, ambient"),
        ({"over": ("record",)}, "'record' has no bounds"),
        ({"over": ("lambda",)}, "ambient (-10 °C, 20 °C, 40 °C) is left over"),
        ({"nominal": {"lambda": 1.0}}, "Which ambient is nominal must be said; the study has -10 °C, 20 °C, 40 °C"),
        ({"nominal": {"lambda": 1.1, "ambient": 20.0}}, "no lambda of 1.1 in this study; there is 0.8, 1, 1.6"),
        ({"quantiles": (2.0,)}, "between 0 and 1"),
        ({"quantities": ("drift",)}, "'drift' is no result"),
    ],
)  # fmt: skip
def test_what_makes_no_envelope_is_said_in_one_sentence(properties, options, told):
    with pytest.raises(InputError) as error:
        bounds(properties, **options)
    assert told in str(error.value)


def test_a_study_without_properties_is_refused(records):
    with pytest.raises(InputError, match="None of lambda, ambient has several values"):
        bounds(records)
