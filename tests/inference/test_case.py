"""One record beside its analysis, and the ratios of many."""

from dataclasses import replace

import numpy as np
import pytest

from dcfp.analysis import respond
from dcfp.analysis.swings import swings_of
from dcfp.inference import Case, Methods, compare
from dcfp.inference.earthquake import event_of
from dcfp.inference.statistics import displacement_over_change, ratios, scatter, scatters
from dcfp.methods import Prediction, find_pulses
from dcfp.methods.li_2020 import LI_2020, predict_from_pgv, predict_from_pulses, predict_simplified
from dcfp.methods.li_2020.constants import DESIGN, PULSE, SIMPLIFIED
from dcfp.methods.method import Information, Variant, variants
from dcfp.methods.prediction import nominal_coefficient
from dcfp.methods.pulse_march import NAME as MARCH
from dcfp.methods.pulses import (
    CHANGE,
    DISPLACEMENT,
    HYSTERETIC,
    INPUT,
    PREDICTION_QUANTITIES,
    TOTAL,
    value_of,
)
from dcfp.motion.ground_motion import GroundMotion, Origin
from dcfp.motion.load import load_motion
from dcfp.motion.named import all_keys, read_stored
from dcfp.system import LI_2020 as BEARING
from dcfp.system import ConstantFriction, Kumar2015, Li2020, NoHeating, SimplifiedHeating, System

#: What a comparison without the methods of codes has.
OWN = [one for one in variants() if one.information is not Information.SPECTRUM]


@pytest.fixture(scope="module")
def motion() -> GroundMotion:
    return load_motion("NCC")


@pytest.fixture(scope="module")
def case(motion: GroundMotion) -> Case:
    return compare(motion, keep_response=True)


def test_every_method_has_its_say(motion: GroundMotion, case: Case) -> None:
    assert set(case.predicted) == set(OWN)
    assert (case.record, case.event, case.pgv) == ("NCC", "Northridge 1994", motion.peak_velocity)
    assert compare(motion).response is None


def test_the_analysed_are_those_of_the_analysis(motion: GroundMotion, case: Case) -> None:
    response, whole = respond(motion), case.analysed.whole
    swings = swings_of(response)
    assert whole.displacement_change == response.peak_change
    assert whole.displacement == response.peak_displacement
    assert whole.total_velocity == response.input_velocity
    assert whole.input_velocity == swings.input_velocity
    assert whole.hysteretic_velocity == swings.hysteretic_velocity
    assert case.response is not None
    np.testing.assert_array_equal(case.response.displacement, response.displacement)


def test_blind_is_of_all_pulses_and_informed_of_the_one_that_governs(
    motion: GroundMotion, case: Case
) -> None:
    pulse = case.analysed.pulse
    assert pulse is not None
    swing = case.analysed.swing
    assert swing is not None
    assert swing.start <= case.pulses.peaks[pulse] <= swing.end
    by_pulse, simplified = predict_from_pulses(case.pulses), predict_simplified(case.pulses)
    for method, made in ((PULSE, by_pulse), (SIMPLIFIED, simplified)):
        blind, informed = (
            case.predicted[Variant(method, one)] for one in (Information.BLIND, Information.INFORMED)
        )
        assert blind == made.largest
        assert informed == made.of(pulse)
        for quantity in (CHANGE, INPUT, HYSTERETIC):
            assert value_of(informed, quantity) <= value_of(blind, quantity)
        # in this record the pulse with the largest input is another
        assert informed.input_velocity < blind.input_velocity
    assert case.analysed.governing.input_velocity == swing.input_velocity < case.analysed.whole.input_velocity
    assert case.predicted[Variant(DESIGN, Information.PGV)] == predict_from_pgv(motion.peak_velocity)


def test_each_information_is_compared_with_its_own(case: Case) -> None:
    assert case.analysed.beside(Information.INFORMED) is case.analysed.governing
    for information in (Information.BLIND, Information.PGV):
        assert case.analysed.beside(information) is case.analysed.whole


def test_a_mirrored_record_is_predicted_the_same(motion: GroundMotion, case: Case) -> None:
    back = compare(motion.scaled(-1.0))
    assert back.analysed.pulse == case.analysed.pulse
    for variant in OWN:
        for quantity in (CHANGE, INPUT, HYSTERETIC):
            there, here = (
                value_of(case.predicted[variant], quantity),
                value_of(back.predicted[variant], quantity),
            )
            assert here == pytest.approx(there, rel=1e-9)


def test_friction_above_the_average_slope_leaves_out_what_cannot_be_used(motion: GroundMotion) -> None:
    """mu_n g of 1177 mm/s2 is more than kg_ave of 930: Eq. (28) would need the root of a negative number."""
    methods = Methods(System(friction=Li2020(0.2)), replace(LI_2020, nominal_friction=0.12))
    rough = compare(motion.scaled_to_pgv(1000.0), methods)
    assert {method for method, _ in rough.predicted} == {PULSE, MARCH}
    assert rough.predicted[Variant(PULSE, Information.BLIND)].displacement_change > 0.0
    assert rough.predicted[Variant(MARCH, Information.BLIND)].displacement_change > 0.0
    assert np.isnan(ratios([rough], Variant(DESIGN, Information.PGV), CHANGE)).all()
    assert Variant(DESIGN, Information.PGV) not in {variant for variant, _ in scatters([rough])}


def test_a_record_that_moves_nothing_has_no_governing_pulse(motion: GroundMotion) -> None:
    quiet = compare(motion.scaled(1e-3))
    assert quiet.analysed.whole.hysteretic_velocity == 0.0
    assert quiet.predicted[Variant(PULSE, Information.BLIND)].displacement_change == 0.0
    assert quiet.predicted[Variant(MARCH, Information.BLIND)].displacement_change == 0.0
    assert scatter(ratios([quiet], Variant(MARCH, Information.BLIND), CHANGE)).without == 1


def test_the_threshold_of_the_methods_is_that_of_their_pulses(motion: GroundMotion) -> None:
    coarse = compare(motion, Methods(threshold=0.5))
    np.testing.assert_array_equal(coarse.pulses.times, find_pulses(motion, 0.5).times)
    assert coarse.pulses.count < find_pulses(motion).count


# ----- events -----


def test_one_earthquake_has_one_name_in_both_sets_of_records() -> None:
    """Of 22 earthquakes in FEMA P-695, table A-4 and A-6, three are in both sets under two names."""
    stored = [record.motion for record in read_stored(all_keys())]
    events = {event_of(motion) for motion in stored}
    assert {"Northridge 1994", "Imperial Valley 1979", "Superstition Hills 1987"} <= events
    assert not any("-0" in event for event in events)
    assert len({motion.origin.event for motion in stored}) == len(events) + 3


@pytest.mark.parametrize(
    ("event", "found"),
    [
        ("Irpinia, Italy-01 1980", "Irpinia, Italy 1980"),
        ("Chi-Chi, Taiwan 1999", "Chi-Chi, Taiwan 1999"),
        ("", "own"),
    ],
)
def test_names_of_events(event: str, found: str) -> None:
    assert event_of(GroundMotion(np.zeros(2), 1.0, "own", Origin(event=event))) == found


# ----- ratios -----


def test_measures_of_ratios() -> None:
    measures = scatter(np.array([0.5, 2.0, 1.0, 0.0, np.nan]))
    assert (measures.number, measures.without) == (3, 2)
    assert (measures.least, measures.largest, measures.median) == (0.5, 2.0, 1.0)
    assert measures.bias == pytest.approx(1.0)
    assert measures.dispersion == pytest.approx(np.log(2.0))
    nothing = scatter(np.array([np.nan, 0.0]))
    assert (nothing.number, nothing.without) == (0, 2)
    assert np.isnan(nothing.bias)
    assert scatter(np.array([3.0])).dispersion == 0.0


def test_ratios_are_prediction_over_analysis(case: Case, make_case) -> None:
    for variant in OWN:
        for quantity in PREDICTION_QUANTITIES.values():
            says_total = variant.method == MARCH or quantity is not TOTAL
            assert np.isfinite(ratios([case], variant, quantity)).all() == says_total
    blind = Variant(PULSE, Information.BLIND)
    made = make_case(Prediction(10.0, 20.0, 40.0, 8.0), Prediction(20.0, 20.0, 20.0))
    found = [ratios([made], blind, quantity)[0] for quantity in (CHANGE, INPUT, HYSTERETIC, DISPLACEMENT)]
    assert found == [2.0, 1.0, 0.5, 2.5]
    assert displacement_over_change([made]).tolist() == [0.8]


def test_the_nominal_coefficient_is_the_papers_and_goes_on_from_there() -> None:
    def nominal(**changes: object) -> float:
        law = replace(Li2020(), **{k: v for k, v in changes.items() if k == "mu_0"})
        bearing = replace(BEARING, **{k: v for k, v in changes.items() if k == "pressure"})
        heating = changes.get("heating", SimplifiedHeating())
        return nominal_coefficient(System(bearing, law, heating)).value

    assert nominal() == 0.043
    # no jump beside the paper's own values
    assert nominal(mu_0=0.0751) == pytest.approx(0.043, rel=2e-3)
    assert nominal(pressure=60.1) == pytest.approx(0.043, rel=2e-3)
    assert nominal(mu_0=0.1) > nominal(mu_0=0.05)
    # without heat it does not fall during the test
    assert nominal(heating=NoHeating()) > 1.5 * nominal()
    assert (
        nominal(heating=SimplifiedHeating(ambient=40.0))
        < nominal()
        < nominal(heating=SimplifiedHeating(ambient=-10.0))
    )
    assert nominal_coefficient(System(BEARING, ConstantFriction(0.06), NoHeating())).value == 0.06
    assert 0.02 < nominal_coefficient(System(BEARING, Kumar2015(), SimplifiedHeating())).value < 0.06


def test_measures_are_of_the_cases_that_every_blind_method_predicts(make_case) -> None:
    moved, still = Prediction(2.0, 2.0, 2.0), Prediction(0.0, 0.0, 0.0)
    cases = [make_case(moved, moved), make_case(moved, still)]
    (one,) = {found for (_, quantity), found in scatters(cases).items() if quantity is CHANGE}
    assert (one.number, one.without, one.below) == (1, 1, 0.5)


def test_the_codes_are_asked_where_they_are_wanted(motion: GroundMotion, case: Case) -> None:
    asked = compare(motion, codes=True)
    assert set(asked.predicted) == set(variants())
    assert not case.codes
    for variant, said in asked.predicted.items():
        if variant.method in asked.codes:
            assert said.displacement == asked.codes[variant.method].displacement
            assert np.isnan(said.displacement_change)
