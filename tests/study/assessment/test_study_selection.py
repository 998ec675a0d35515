"""What is chosen of a study, and what is missing of it."""

import numpy as np
import pytest

from dcfp.errors import InputError
from dcfp.study.assessment import ida, select
from dcfp.study.assessment.selection import described, fixed_values, only, remarks_of, shown_values, usable


def test_values_are_found_by_their_number_and_dimensions_of_one_value_go(properties):
    chosen = select(properties, {"lambda": 0.1 * 16, "pgv": 750.0})
    assert set(chosen.dims) == {"record", "ambient"}
    expected = properties["peak_displacement"].isel({"lambda": 2, "pgv": 2})
    np.testing.assert_array_equal(chosen["peak_displacement"], expected)
    assert fixed_values(chosen) == "pgv 0.75 m/s, lambda 1.6"


def test_zero_is_a_value_like_any_other(build):
    study = build({"record": 2, "pgv": [100.0, 200.0], "ambient": [-20.0, 0.0]})
    assert select(study, {"ambient": 0.0})["ambient"] == 0.0


def test_a_name_is_a_value_and_what_has_one_value_may_be_named(records):
    chosen = select(records, {"record": "R7", "radius": 4500.0})
    assert chosen["record"].item() == "R7"
    assert select(chosen, {"radius": 4500.0}).sizes == chosen.sizes


def test_what_is_to_stay_stays(records):
    assert select(records, {}, keep=("radius",)).sizes["radius"] == 1


def test_a_sample_is_chosen_by_its_number(sampled):
    chosen = select(sampled, {"sample": 5.0})
    assert float(chosen["mu"]) == float(sampled["mu"][5])


def test_histories_have_no_part_in_it(records):
    with_histories = records.assign(
        history_force=(("record", "pgv", "radius", "step"), np.zeros((40, 10, 1, 3)))
    )
    assert "step" not in select(with_histories, {}).dims
    assert ida(with_histories).sizes["pgv"] == 10


@pytest.mark.parametrize(
    ("at", "told"),
    [
        ({"radius": 4501.0}, "no radius of 4501 mm in this study; there is 4500 mm"),
        ({"pgv": 0.6}, "there is 0.2 m/s, 0.4 m/s, "),
        ({"stiffness": 1.0}, "'stiffness' is no factor of this study, which is over record, pgv and radius"),
        ({"record": "R41"}, "no record of R41 in this study; there is R1, R2, "),
        ({"record": "R41"}, "and 28 more"),
        ({"pgv": "fast"}, "pgv is chosen by a number, not by 'fast'"),
        ({"event": "E3"}, "event cannot be chosen, because it goes with record"),
    ],
)
def test_what_is_not_there_is_refused(records, at, told):
    with pytest.raises(InputError) as error:
        select(records, at)
    assert told in str(error.value)


def test_factors_that_are_left_over_are_named_with_their_values(bearings):
    with pytest.raises(InputError) as error:
        ida(bearings)
    sentence = str(error.value)
    assert "radius (3000 mm, 1500 mm, 4500 mm) and mu (0.02, 0.04, 0.06, 0.1, 0.15) are left over" in sentence
    assert "choose one value of each first (at radius=... mu=...)" in sentence


def test_what_is_of_one_case_needs_a_value_of_each_factor(records):
    with pytest.raises(
        InputError, match=r"An analysis is of one case, and record .* and pgv .* are left over"
    ):
        only(records, (), "An analysis")
    assert not only(select(records, {"record": "R1", "pgv": 400.0}), (), "An analysis").dims


def test_a_factor_that_is_needed_and_missing_is_named(build):
    with pytest.raises(InputError, match="record is not in the grid of this study, which is over pgv"):
        ida(build({"pgv": [100.0, 200.0]}))
    with pytest.raises(InputError, match="one of pgv, pga, scale in the grid"):
        ida(build({"record": 3, "mu": [0.05, 0.1]}))


def test_an_unfinished_study_is_refused_or_counted(records, spoil):
    study = spoil(records, "not_run", record=3, pgv=2)
    with pytest.raises(InputError, match="1 of the 400 analyses have not been run; finish the study first"):
        ida(study)
    found = ida(study, unfinished=True)
    assert remarks_of(found)[0] == "1 of the 400 analyses have not been run, and are left out."
    # what was not selected may be missing
    assert ida(select(study.isel(pgv=slice(3, None)), {})).sizes["pgv"] == 7


def test_failed_analyses_are_left_out_and_counted(records, spoil):
    study = spoil(records, "failed", record=3, pgv=2)
    found = ida(study)
    assert "1 of the 400 analyses failed, and are left out." in remarks_of(found)
    without = ida(records.isel(record=[i for i in range(40) if i != 3]))
    np.testing.assert_array_equal(
        found["peak_displacement_quantile"].isel(pgv=2), without["peak_displacement_quantile"].isel(pgv=2)
    )


def test_nothing_at_all_is_refused(records, spoil):
    with pytest.raises(InputError, match="None of the 400 analyses has a result"):
        ida(spoil(records, "failed"))


def test_the_size_of_a_residual_displacement_counts(records, build):
    found = usable(select(records, {}), ["residual_displacement"])
    np.testing.assert_array_equal(
        found["residual_displacement"], -select(records, {})["residual_displacement"]
    )
    assert found["residual_displacement"].attrs["units"] == "mm"
    assert (records["residual_displacement"] < 0.0).all()  # the study is as it was


def test_a_study_still_moving_at_its_end_says_so_of_the_residual_displacement(records):
    study = records.copy(deep=True)
    study["status"][0, 0, 0] = 3
    assert any("still moves" in remark for remark in remarks_of(ida(study, "residual_displacement")))
    assert not any("still moves" in remark for remark in remarks_of(ida(study)))


def test_a_result_that_is_none_is_refused(records):
    with pytest.raises(
        InputError, match="'drift' is no result of this study; its results are peak_displacement"
    ):
        ida(records, "drift")


def test_factors_are_shown_in_their_units(properties):
    assert shown_values(properties["ambient"]) == "-10 °C, 20 °C, 40 °C"
    assert shown_values(properties["pgv"]) == "0.25 m/s, 0.5 m/s, 0.75 m/s, 1 m/s"
    assert described(properties["ambient"]).label == "$T_0$ [°C]"
    assert described(properties["pgv"]).shown.size == 1e3
