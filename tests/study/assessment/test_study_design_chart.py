"""A study as the space of bearings of a design chart."""

import numpy as np
import pytest

from dcfp import load_motion
from dcfp.errors import InputError
from dcfp.inference.design_space import survey
from dcfp.study import Study
from dcfp.study.assessment import design_space, select
from dcfp.study.run import run_study
from dcfp.system import System


def test_the_space_is_that_of_the_study_with_its_axes_increasing(bearings):
    space = design_space(bearings, 500.0)
    assert space.pgv == 500.0
    assert space.radii.tolist() == [1500.0, 3000.0, 4500.0]
    assert space.coefficients.tolist() == [0.02, 0.04, 0.06, 0.1, 0.15]
    expected = bearings["peak_displacement"].sel(pgv=500.0, radius=1500.0, mu=0.06)
    np.testing.assert_array_equal(space.displacement[0, 2], expected)
    np.testing.assert_array_equal(
        space.force[0, 2], bearings["force_ratio"].sel(pgv=500.0, radius=1500.0, mu=0.06)
    )
    assert space.events[0] == "E1"


def test_the_coefficient_that_holds_is_that_of_the_formula(build):
    """y = 0.1 pgv^1.2 (0.06 / mu)^0.5 is 150 mm at mu = 0.06 (0.1 500^1.2 / 150)^2; the chart takes lines between its coefficients."""
    grid = {"record": 4, "pgv": [500.0], "radius": [1500.0, 3000.0], "mu": np.linspace(0.02, 0.15, 66)}
    least, force = design_space(build(grid)).holding(150.0, 0.5)
    expected = 0.06 * (0.1 * 500.0**1.2 / 150.0) ** 2
    np.testing.assert_allclose(least, expected, rtol=1e-3)
    np.testing.assert_allclose(force, expected + 150.0 / (2.0 * np.array([1500.0, 3000.0])), rtol=1e-3)


def test_a_study_and_a_survey_are_the_same():
    motions = [load_motion("KNA"), load_motion("NCC")]
    radii, coefficients = np.array([1500.0, 4500.0]), np.array([0.05, 0.1])
    study = design_space(run_study(Study(motions, {"pgv": [500.0], "radius": radii, "mu": coefficients})))
    other = survey(motions, 500.0, System(), radii, coefficients)
    np.testing.assert_allclose(study.displacement, other.displacement, rtol=1e-9)
    np.testing.assert_allclose(study.force, other.force, rtol=1e-9)
    assert study.events == other.events


def test_a_record_that_failed_on_one_bearing_is_left_out_of_all(bearings, spoil):
    space = design_space(spoil(bearings, "failed", record=3, pgv=0, radius=1, mu=2), 500.0)
    assert space.records == 39
    assert "E4" not in space.events
    assert design_space(bearings, 500.0).records == 40


@pytest.mark.parametrize(
    ("at", "pgv", "told"),
    [
        ({}, None, "for one PGV; choose one of 0.5 m/s, 1 m/s"),
        ({}, 600.0, "no pgv of 0.6 m/s in this study"),
        ({"radius": 3000.0}, 500.0, "several values of radius, and here is 3000 mm"),
    ],
)
def test_what_makes_no_chart_is_said(bearings, at, pgv, told):
    with pytest.raises(InputError) as error:
        design_space(select(bearings, at), pgv)
    assert told in str(error.value)


def test_other_factors_must_be_chosen(build):
    grid = {"record": 4, "pgv": [500.0], "radius": [1500.0, 3000.0], "mu": [0.05, 0.1], "lambda": [0.8, 1.2]}
    with pytest.raises(InputError, match=r"lambda \(0.8, 1.2\) is left over"):
        design_space(build(grid))


def test_another_intensity_makes_no_chart(build):
    study = build({"record": 4, "scale": [1.0], "radius": [1500.0, 3000.0], "mu": [0.05, 0.1]})
    with pytest.raises(InputError, match="pgv is no factor of this study"):
        design_space(study)
