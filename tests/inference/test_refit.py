"""Constants found again in cases that were made with them."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from dcfp.errors import InputError
from dcfp.inference import Case, refit
from dcfp.methods.li_2020 import LI_2020, Constants, predict_from_pgv, predict_simplified
from dcfp.methods.li_2020.constants import DESIGN

#: Far from the paper's 930 mm/s2, 0.25 and 1.5.
TRUE = replace(LI_2020, average_slope=700.0, fall_ratio=0.6, change_ratio=1.2)
PGVS = (250.0, 500.0, 1000.0)


@pytest.fixture(scope="module")
def simplified_cases(a_pulse, make_case) -> list[Case]:
    """The analysis gives what the simplified method says with the true constants."""
    random = np.random.default_rng(4)
    cases = []
    for _ in range(30):
        pulses = a_pulse(random.uniform(100.0, 900.0), random.uniform(500.0, 3000.0))
        cases.append(make_case(predict_simplified(pulses, TRUE).largest, pulses=pulses))
    return cases


@pytest.fixture(scope="module")
def design_cases(a_pulse, make_case) -> list[Case]:
    """The same with the design method, whose pulse has a change of 1.2 PGV and a slope in proportion to PGV."""
    cases = []
    for pgv in PGVS:
        pulses = a_pulse(TRUE.change_ratio * pgv, TRUE.average_slope * pgv / TRUE.reference_pgv)
        cases.append(make_case(predict_from_pgv(pgv, TRUE), pulses=pulses, pgv=pgv))
    return cases


def found(constants: Constants) -> tuple[float, float, float]:
    return constants.average_slope, constants.fall_ratio, constants.change_ratio


def test_the_simplified_method_by_least_squares(simplified_cases: Sequence[Case]) -> None:
    fitted = refit.refit_by_squares(simplified_cases)
    assert found(fitted) == pytest.approx((700.0, 0.6, LI_2020.change_ratio), rel=1e-4)


def test_the_design_method_by_least_squares(design_cases: Sequence[Case]) -> None:
    """kg_ave is kept, so it is given."""
    start = replace(LI_2020, average_slope=TRUE.average_slope)
    assert found(refit.refit_by_squares(design_cases, start, DESIGN)) == pytest.approx(
        (700.0, 0.6, 1.2), rel=1e-4
    )


def test_what_is_fitted_follows_the_scale_of_the_analysis(
    design_cases: Sequence[Case],
) -> None:
    """Energies of twice the velocity need twice zeta, and no other eps."""
    doubled = [
        replace(
            case,
            analysed=replace(
                case.analysed,
                whole=replace(
                    case.analysed.whole,
                    input_velocity=2.0 * case.analysed.whole.input_velocity,
                    hysteretic_velocity=2.0 * case.analysed.whole.hysteretic_velocity,
                ),
            ),
        )
        for case in design_cases
    ]
    start = replace(LI_2020, average_slope=TRUE.average_slope)
    assert found(refit.refit_by_squares(doubled, start, DESIGN)) == pytest.approx((700.0, 0.6, 2.4), rel=1e-4)


def test_as_the_paper_did(design_cases: Sequence[Case]) -> None:
    assert found(refit.refit_as_paper(design_cases)) == pytest.approx((700.0, 0.6, 1.2), rel=1e-4)


def test_means_of_the_governing_pulses(a_pulse, make_case) -> None:
    """kg_ave of those at the reference PGV only, zeta of all; a case without a governing pulse counts nowhere."""
    said = predict_from_pgv(250.0)
    cases = [
        make_case(said, pulses=a_pulse(300.0, 800.0), pgv=250.0),
        make_case(said, pulses=a_pulse(400.0, 1000.0), pgv=250.0),
        make_case(said, pulses=a_pulse(500.0, 4000.0), pgv=500.0),
        make_case(said, pulses=a_pulse(900.0, 9000.0), pgv=250.0, pulse=None),
    ]
    assert refit.average_slope(cases) == pytest.approx(900.0)
    assert refit.change_ratio(cases) == pytest.approx((1.2 + 1.6 + 1.0) / 3.0)
    changes, slopes = refit.governing(cases)
    assert changes.tolist() == pytest.approx([300.0, 400.0, 500.0])
    assert slopes.tolist() == pytest.approx([800.0, 1000.0, 4000.0])


def test_the_average_slope_stays_above_friction(a_pulse, make_case) -> None:
    """Eq. (28) has no meaning below; without a floor a weak set could not be fitted at all."""
    cases = [make_case(predict_from_pgv(250.0), pulses=a_pulse(300.0, 200.0))]
    assert refit.refit_as_paper(cases).average_slope == pytest.approx(1.02 * LI_2020.friction_deceleration)


def test_cases_at_other_pgvs_are_refused(design_cases: Sequence[Case]) -> None:
    with pytest.raises(InputError, match=r"^kg_ave needs analyses at a PGV of 0\.25 m/s; .*\.$"):
        refit.refit_as_paper(design_cases[1:])


@pytest.mark.parametrize("fit", [refit.refit_as_paper, refit.refit_by_squares])
def test_nothing_to_fit_to_is_refused(fit) -> None:
    with pytest.raises(InputError):
        fit([])
