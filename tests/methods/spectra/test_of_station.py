"""Response spectra of stations: against oscillators under the turned record one direction at a time, and by law."""

import numpy as np
import pytest

from dcfp import GroundMotion, InputError, Station, load_station
from dcfp.kernels import all_directions as kernels
from dcfp.methods.spectra import input_energy_spectrum, response_spectrum
from dcfp.methods.spectra.of_station import (
    ANGLES,
    PAIR_MEASURES,
    STATION_ORDINATES,
    station_ordinates,
    station_spectrum,
)
from dcfp.schema.table import Table

#: From where the record's step is divided to where only its samples are looked at [s].
PERIODS = np.array([0.05, 0.11, 0.3, 0.9, 1.2, 3.0, 7.0])


@pytest.fixture(scope="module")
def station() -> Station:
    found = load_station("P695-FF-2")
    assert found is not None
    return found


def noise(size: int, seed: int, step: float = 0.01) -> GroundMotion:
    return GroundMotion(np.random.default_rng(seed).normal(0.0, 500.0, size), step)


@pytest.mark.parametrize("pair", ["record", "noise", "one direction", "short", "there and back"])
def test_every_direction_is_that_of_the_turned_record(station, pair) -> None:
    """What is skipped as inside of what every direction has reached is skipped rightly, for any orbit."""
    if pair == "noise":
        station = Station(noise(700, 1), noise(700, 2).scaled(0.05))
    elif pair == "one direction":
        station = Station(noise(700, 1), noise(700, 1).scaled(0.0))
    elif pair == "short":  # ends while it moves outwards
        station = Station(noise(12, 3), noise(12, 4))
    elif pair == "there and back":  # in less than a tenth of the longest periods
        wave = 900.0 * np.cos(np.linspace(0.0, 2.0 * np.pi, 30))
        station = Station(GroundMotion(wave, 0.01), noise(30, 1).scaled(0.1))
    found = station_spectrum(station, PERIODS)
    for place in (0, 1, 37, 45, 89, 90, 133, 179):
        angle = float(ANGLES[place])
        alone = response_spectrum(station.rotated(-angle).x, PERIODS).displacement
        np.testing.assert_allclose(found.directions[:, place], alone, rtol=1e-12, atol=1e-12 * found.x.max())
    np.testing.assert_allclose(found.x, response_spectrum(station.x, PERIODS).displacement, rtol=1e-12)
    np.testing.assert_allclose(
        found.y, response_spectrum(station.y, PERIODS).displacement, rtol=1e-12, atol=1e-9
    )


@pytest.mark.parametrize(
    "name",
    ["P695-FF-2", "P695-FF-11", "P695-FF-12", "noise", "line", "narrow", "spiral", "short"],
)
def test_what_is_left_out_changes_no_digit(name, monkeypatch) -> None:
    """Against every step of every oscillator, which a slack that leaves nothing of the polygon makes it look at."""
    time = 0.01 * np.arange(1500)
    stations = {
        "noise": lambda: Station(noise(900, 7), noise(900, 8)),
        "line": lambda: Station(noise(900, 7), noise(900, 7).scaled(0.3)),
        "narrow": lambda: Station(noise(900, 7), noise(900, 8).scaled(1e-3)),
        "short": lambda: Station(noise(60, 0), noise(60, 1)),
        "spiral": lambda: Station(*(GroundMotion(900.0 * wave(2.1 * time), 0.01) for wave in (np.sin, np.cos))),
    }  # fmt: skip
    station = stations.get(name, lambda: load_station(name))()
    assert station is not None
    found = station_spectrum(station)
    every = kernels.respond_in_all_directions
    nothing = np.array([[0.0], [1e30]])
    monkeypatch.setattr(
        kernels,
        "respond_in_all_directions",
        lambda *given: every(*given[:4], nothing + 0.0 * given[4], *given[5:]),
    )
    np.testing.assert_array_equal(found.directions, station_spectrum(station).directions)


def test_rotd_is_that_of_boore(station) -> None:
    """By brute force from single oscillators under the record turned by every degree."""
    periods = np.array([0.2, 2.0])
    brute = np.array(
        [response_spectrum(station.rotated(-angle).x, periods).displacement for angle in range(180)]
    )
    found = station_spectrum(station, periods)
    np.testing.assert_allclose(found.rotated(50.0), np.median(brute, axis=0), rtol=1e-12)
    np.testing.assert_allclose(found.rotated(100.0), brute.max(axis=0), rtol=1e-12)
    np.testing.assert_allclose(found.rotated(0.0), brute.min(axis=0), rtol=1e-12)
    np.testing.assert_array_equal(found.largest_direction, brute.argmax(axis=0))


def test_what_measures_of_a_pair_may_be(station) -> None:
    found = station_spectrum(station)
    middle, largest, hypotenuse, mean = (one.get(found) for one in PAIR_MEASURES.values())
    assert (largest >= middle).all()
    assert (hypotenuse >= largest * (1.0 - 1e-12)).all()
    assert (largest >= np.maximum(found.x, found.y)).all()
    assert (mean <= hypotenuse / np.sqrt(2.0) * (1.0 + 1e-12)).all()
    # half of the directions are within 45 degrees of the largest
    assert (largest <= np.sqrt(2.0) * middle * 1.02).all()
    assert (hypotenuse <= np.sqrt(2.0) * largest * (1.0 + 1e-12)).all()


def test_turning_the_pair_changes_no_rotd(station) -> None:
    one = station_spectrum(station, PERIODS)
    other = station_spectrum(station.rotated(34.0), PERIODS)
    for percent in (0.0, 50.0, 84.0, 100.0):
        np.testing.assert_allclose(other.rotated(percent), one.rotated(percent), rtol=1e-12)
    np.testing.assert_array_equal((one.largest_direction + 34.0) % 180.0, other.largest_direction)
    assert abs(PAIR_MEASURES["srss"].get(other) / PAIR_MEASURES["srss"].get(one) - 1.0).max() > 0.01
    # between two of the directions that are looked at
    between = station_spectrum(station.rotated(0.5), PERIODS)
    np.testing.assert_allclose(between.rotated(100.0), one.rotated(100.0), rtol=1e-4)


def test_a_second_component_of_zero_is_the_first_alone() -> None:
    one = noise(500, 5)
    found = station_spectrum(Station(one, one.scaled(0.0)), PERIODS, damping=0.1)
    alone = response_spectrum(one, PERIODS, damping=0.1).displacement
    for measure, factor in (("rotd100", 1.0), ("srss", 1.0), ("geomean", 0.0), ("rotd50", np.sqrt(0.5))):
        np.testing.assert_allclose(found.measured(measure).displacement, factor * alone, rtol=0.01, atol=1e-9)
    np.testing.assert_array_equal(found.largest_direction, 0.0)


def test_the_measures_as_spectra_and_in_a_table(station) -> None:
    found = station_spectrum(station, PERIODS)
    said = found.measured("rotd100")
    assert said.name == "RotD100 of P695-FF-2"
    np.testing.assert_array_equal(said.displacement, found.rotated(100.0))
    (row, *_) = Table(tuple(STATION_ORDINATES), station_ordinates(station, found)).objects()
    assert row["S_a_rotd100_mm_s2"] == pytest.approx(said.pseudo_acceleration[0])
    assert row["S_d_srss_mm"] == pytest.approx(np.hypot(row["S_d_x_mm"], row["S_d_y_mm"]))
    assert row["direction_deg"] == found.largest_direction[0]
    with pytest.raises(InputError, match="one of rotd50, rotd100, srss, geomean, not 'largest'"):
        found.measured("largest")
    with pytest.raises(InputError, match="0 to 100 percent"):
        found.rotated(101.0)
    with pytest.raises(InputError, match="must increase"):
        station_spectrum(station, np.array([1.0, 0.5]))


def test_one_direction_and_a_station_are_told_apart(station) -> None:
    for function in (response_spectrum, input_energy_spectrum):
        with pytest.raises(InputError, match="this takes one direction; choose its x or its y"):
            function(station)
    with pytest.raises(InputError, match="a Station, as of load_station"):
        station_spectrum(station.x)
    np.testing.assert_array_equal(
        response_spectrum("P695-FF-2-a", PERIODS).displacement,
        response_spectrum(station.x, PERIODS).displacement,
    )
