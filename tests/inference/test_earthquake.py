"""Whether two records are of one earthquake."""

from datetime import date

import numpy as np
import pytest
from samples import sample_folder

from dcfp.inference.earthquake import (
    earthquake_of,
    event_of,
    is_known,
    is_same_record,
    read_earthquake,
    same_earthquake,
)
from dcfp.inference.forecast import calibration_set
from dcfp.motion.ground_motion import GroundMotion, Origin
from dcfp.motion.load import load_motion


def record(event: str = "", start: str = "") -> GroundMotion:
    return GroundMotion(np.zeros(2), 1.0, "own", origin=Origin(event=event, start=start))


@pytest.mark.parametrize(
    ("one", "other", "same"),
    [
        ("Northridge 1994", "Northridge 1994", True),
        ("Northridge, 1/17/1994", "Northridge 1994", True),
        ("NORTHRIDGE 01/17/94 1231", "Northridge-01 1994", True),
        ("CHI-CHI 09/20/99", "Chi-Chi, Taiwan 1999", True),
        ("CHI-CHI 09/20/99", "Hector Mine 1999", False),
        ("CHALFANT 07/20/86 1429", "CHALFANT 07/31/86 0722", True),  # an aftershock: one too many
        ("BORAH PEAK AS, 10/29/83, 23:29", "BORAH PEAK, 10/29/83, 23:29", True),
        ("AQABA 11/22/95 0418", "Kobe, Japan 1995", False),
        ("BIG BEAR 06/28/92 0805", "Landers 1992", False),  # on the same day
        ("Kobe Japan, 1/16/1995", "Kobe, Japan 1995", True),
        ("Hyogo-ken Nanbu 17.1.1995", "Kobe, Japan 1995", True),
        ("Imperial Valley-02, 5/19/1940", "Imperial Valley-06 1979", False),
        ("1995/01/17 05:46:00", "Kobe, Japan 1995", True),  # the day in Japan
        ("1999/11/12 16:57:00, M 7.2", "Duzce, Turkey 1999", True),
        ("1999/11/12 16:57:00, M 7.2", "Kocaeli, Turkey 1999", False),
        ("1999", "Kocaeli, Turkey 1999", True),  # one too many rather than one too few
        ("Chi-Chi", "Chi-Chi, Taiwan 1999", True),
        ("Kocaeli, Turkey 1999", "Duzce, Turkey 1999", False),  # the country is not the name
        ("Chi-Chi, Taiwan 1999", "Hector Mine 1999", False),
        ("Northridge 1994", "Northridge 1987", False),
        ("mine", "Northridge 1994", False),
        ("2011/03/11 14:46:00", "Kobe, Japan 1995", False),
    ],
)
def test_events(one: str, other: str, same: bool) -> None:
    assert same_earthquake(one, other) is same
    assert same_earthquake(other, one) is same


@pytest.mark.parametrize(
    ("event", "day"),
    [
        ("CHI-CHI 09/20/99", date(1999, 9, 20)),
        ("BORREGO MOUNTAIN 10/21/42 1622", date(1942, 10, 21)),
        ("Somewhere, 11/20/11", date(2011, 11, 20)),
        ("40199209, 7/20/2007", date(2007, 7, 20)),  # the number in front is no date
        ("GREECE, 20190728, M 4.6", date(2019, 7, 28)),
        ("Point MacKenzie Earthquake of Fri Nov 30, 2018 17:29 UTC", date(2018, 11, 30)),
        ("Los Angeles, CA June 16,2005 13:53 PDT", date(2005, 6, 16)),
        ("16 June 2005", date(2005, 6, 16)),
        ("17/01/94", date(1994, 1, 17)),
        ("13/13/94", None),
        ("Imperial Valley 1979", date(1979, 10, 15)),
        ("Imperial Valley 1981", None),
    ],
)
def test_the_day_in_whatever_form(event: str, day: date | None) -> None:
    assert read_earthquake(event).day == day


@pytest.mark.parametrize(
    ("motion", "known"),
    [
        (record("Kobe 1995"), True),
        (record("CHI-CHI 09/20/99"), True),
        (record("Tottori"), True),  # what has a name is said to be of it
        (record(start="1995-01-17T05:46:52+09:00"), True),
        (record(), False),
        (record("number 19951"), False),
    ],
)
def test_a_name_or_a_year_makes_an_earthquake_known(motion: GroundMotion, known: bool) -> None:
    assert is_known(motion) is known


def test_a_record_that_says_when_it_began_is_of_the_earthquake_of_that_day() -> None:
    assert event_of(record(start="1995-01-17T05:46:52+09:00")) == "Kobe, Japan 1995"
    assert event_of(record("Rcrd of Sun Jan 17, 1994", "1994-01-17T12:31:00+00:00")) == "Northridge 1994"
    assert event_of(record(start="1996-01-17T05:46:52+09:00")) == "own"


def test_every_earthquake_of_fema_p695_has_its_day_and_is_itself_alone() -> None:
    events = sorted({event_of(motion) for motion in calibration_set()})
    assert len(events) == 19
    assert all(read_earthquake(event).day is not None for event in events)
    assert all(same_earthquake(one, other) == (one == other) for one in events for other in events)


@pytest.mark.parametrize("folder", ["peer_old", "paper"])
def test_every_sample_is_of_the_earthquake_that_was_found_by_hand(folder: str) -> None:
    """Of 73 old PEER records 51 are of Chi-Chi, two of Loma Prieta and one of Northridge; no other is of an earthquake of FEMA P-695."""
    samples = sample_folder()
    if samples is None:
        pytest.skip("no sample records: set DCFP_SAMPLE_RECORDS")
    known = {event_of(motion) for motion in calibration_set()}
    found = {file.name: event_of(load_motion(file)) for file in sorted((samples / folder).iterdir())}
    of_set = {name: event for name, event in found.items() if event in known}
    if folder == "paper":
        assert set(of_set.values()) == {"Kobe, Japan 1995"}
        assert len(of_set) == len(found) == 3
        return
    others = {
        "ARL360.at2": "Northridge 1994",
        "RSN763_LOMAP_GIL067.AT2": "Loma Prieta 1989",
        "RSN763_LOMAP_GIL337.AT2": "Loma Prieta 1989",
    }
    chi_chi = ("CHY", "HWA", "ILA", "KAU", "NSK", "NST", "TAI", "TAP", "TCU", "TTN")
    by_hand = {name: "Chi-Chi, Taiwan 1999" for name in found if name.startswith(chi_chi)}
    assert len(found) == 73
    assert of_set == by_hand | others
    assert len(by_hand) == 51


def test_a_record_of_unknown_earthquake_is_of_none() -> None:
    assert not earthquake_of(record()).may_be(read_earthquake("Kobe, Japan 1995"))


def test_the_same_samples_at_another_scale_and_sign() -> None:
    values = np.random.default_rng(3).standard_normal(500)
    motion = GroundMotion(values, 0.01)
    assert is_same_record(motion, GroundMotion(np.round(-3.7 * values, 4), 0.01))
    assert not is_same_record(motion, GroundMotion(np.roll(values, 1), 0.01))
    assert not is_same_record(motion, GroundMotion(values[:-1], 0.01))
    assert not is_same_record(motion, GroundMotion(np.zeros(500), 0.01))
