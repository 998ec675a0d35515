"""Stations: named, joined from files, brought together, turned and scaled; and what is refused."""

import numpy as np
import pytest

from dcfp import GroundMotion, InputError, Station, load_motion, load_station
from dcfp.motion.ground_motion import Origin
from dcfp.motion.load import load_motions, load_records, seen_from
from dcfp.motion.station import joined, stations_of
from dcfp.motion.treatment import station_treated


def motion(
    component: str = "", size: int = 50, step: float = 0.01, seed: int = 1, event: str = ""
) -> GroundMotion:
    values = np.random.default_rng(seed).normal(0.0, 300.0, size)
    return GroundMotion(values, step, component or f"motion{seed}", Origin(event=event, component=component))


def test_the_pairs_of_fema_p695_have_names() -> None:
    found = load_station("p695-ff-02")
    assert isinstance(found, Station)
    assert found.name == "P695-FF-2"
    np.testing.assert_array_equal(found.x.acceleration, load_motion("P695-FF-2-a").acceleration)
    np.testing.assert_array_equal(found.y.acceleration, load_motion("P695-FF-2-b").acceleration)
    assert load_station("P695-FF-2-a") is load_station("NCC") is load_station("P695-FF-23") is None


def test_names_joined_by_a_plus() -> None:
    found = load_station("KNA+P695-FF-7-b")
    assert found is not None
    assert found.name == "KNA+P695-FF-7-b"
    np.testing.assert_array_equal(found.acceleration, load_station("P695-FF-7").acceleration)


def test_files_joined_by_a_plus_and_columns_of_one_file(tmp_path) -> None:
    values = np.random.default_rng(3).normal(0.0, 0.1, (200, 3))
    for name, column in zip(("east", "north", "up"), values.T, strict=True):
        np.savetxt(tmp_path / f"{name}.txt", column)
    plain = {"units": "g", "time_step": 0.01}
    pair = load_station(f"{tmp_path}/east.txt+{tmp_path}/north.txt", **plain)
    assert pair is not None
    assert pair.vertical is None
    three = load_station("+".join(str(tmp_path / f"{name}.txt") for name in ("east", "north", "up")), **plain)
    assert three is not None
    assert three.vertical is not None
    np.testing.assert_allclose(three.acceleration / 9806.65, values[:, :2])
    np.testing.assert_allclose(three.vertical.acceleration / 9806.65, values[:, 2])


def test_the_three_files_of_k_net_by_what_their_names_have_in_common(tmp_path) -> None:
    for ending, direction, first in ((".EW", "E-W", 100), (".NS", "N-S", 200), (".UD", "U-D", 300)):
        header = f"""Origin Time       2003/09/26 04:50:00
Lat.              41.78
Long.             144.08
Depth. (km)       42
Mag.              8.0
Station Code      HKD100
Station Lat.      42.1303
Station Long.     142.9351
Station Height(m) 25
Record Time       2003/09/26 04:50:42
Sampling Freq(Hz) 100Hz
Duration Time(s)  0.08
Dir.              {direction}
Scale Factor      2000(gal)/8388608
Max. Acc. (gal)   1.0
Last Correction   2003/09/26 04:50:27
Memo.
"""
        numbers = "".join(f"{first + 10 * place:9d}" for place in range(8))
        (tmp_path / f"HKD1000309260450{ending}").write_text(header + numbers + "\n")
    found = load_station(tmp_path / "HKD1000309260450")
    assert found is not None
    assert [one.origin.component for one in found.components] == [
        "EW",
        "NS",
        "UD",
    ] or found.vertical is not None
    assert found.x.acceleration[0] < found.y.acceleration[0]


def test_shorter_components_and_longer_steps_are_brought_together_and_told() -> None:
    coarse, fine = motion("EW", 50, 0.02), motion("NS", 60, 0.01, seed=2)
    found = joined([coarse, fine], "both")
    assert found.time_step == 0.01
    np.testing.assert_array_equal(found.x.acceleration[::2], coarse.acceleration)
    np.testing.assert_array_equal(found.y.acceleration[60:], 0.0)
    assert "time step of EW divided by 2" in found.treatment
    assert "NS ends 0.39 s earlier, and keeps its velocity from there on" in found.treatment
    # a finer time step does not move the ground otherwise
    assert found.x.velocity[::2] == pytest.approx(coarse.velocity)


def test_scaled_by_the_resultant_and_turned() -> None:
    found = joined([motion("EW"), motion("NS", seed=2), motion("UD", seed=3)], "three")
    scaled = found.scaled_to_pgv(500.0)
    assert scaled.peak_velocity == pytest.approx(500.0)
    factor = scaled.x.acceleration[3] / found.x.acceleration[3]
    np.testing.assert_allclose(scaled.vertical.acceleration, factor * found.vertical.acceleration)
    turned = scaled.rotated(90.0)
    np.testing.assert_allclose(turned.x.acceleration, -scaled.y.acceleration, atol=1e-9)
    np.testing.assert_allclose(turned.y.acceleration, scaled.x.acceleration, atol=1e-9)
    assert scaled.rotated(33.0).peak_velocity == pytest.approx(500.0)
    assert turned.treatment[-1] == "rotated by 90 degrees"
    assert turned.digest != scaled.digest


def test_treated_in_every_component() -> None:
    found = station_treated(joined([motion("EW"), motion("NS", seed=2)], "pair"), baseline=True)
    assert found.treatment == ("linear baseline in velocity removed",)
    assert abs(found.x.velocity @ found.x.time) < 1e-6


@pytest.mark.parametrize(
    ("components", "sentence"),
    [
        ([motion("EW", event="Kobe 1995"), motion("NS", event="Northridge 1994")], "are of different earthquakes, 'Kobe 1995' and 'Northridge 1994'"),
        ([motion("EW")], "has two horizontal components and may have a vertical one, not 1"),
        ([motion("EW"), motion("UD")], "UD is the vertical component; give the two horizontal ones first"),
        ([motion("EW"), motion("NS"), motion("N-S", seed=5)], "the third component, N-S, is horizontal"),
        ([motion("000"), motion("045")], "point to 0 and 45 degrees; the horizontal components of a station are at right angles"),
        ([motion("EW", step=0.01), motion("NS", step=0.015)], "0.01 and 0.015 s, do not fit: one must be a multiple of the other"),
    ],
)  # fmt: skip
def test_what_does_not_go_together(components, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        joined(components, "pair")


@pytest.mark.parametrize("text", ["KNA+KNA", "KNA+", "+KNA"])
def test_a_plus_needs_two_different_components(text: str) -> None:
    with pytest.raises(InputError, match="two or three different components joined by"):
        load_station(text)


def test_one_direction_asks_for_a_component() -> None:
    with pytest.raises(
        InputError,
        match="a station with two horizontal components, and this takes one direction; choose P695-FF-2-a or",
    ):
        load_motion("P695-FF-2")


def test_parts_that_do_not_fit_make_no_station() -> None:
    with pytest.raises(InputError, match="same time step and length"):
        Station(motion("EW"), motion("NS", size=40))
    with pytest.raises(InputError, match="every value is zero"):
        Station(motion("EW").scaled(0.0), motion("NS").scaled(0.0)).scaled_to_pgv(500.0)


def test_a_set_of_stations_is_one_word() -> None:
    stations = load_records(["p695-FF-Stations"])
    assert [one.name for one in stations] == [f"P695-FF-{number}" for number in range(1, 23)]
    second = load_station("P695-FF-2")
    assert second is not None
    assert stations[1].digest == second.digest
    with pytest.raises(InputError, match=r"P695-FF-stations is a set of stations .* P695-FF is the set of"):
        load_motions(["P695-FF-stations"])


def test_stations_and_single_components_are_not_mixed() -> None:
    found = joined([motion("EW"), motion("NS", seed=2)], "pair")
    assert stations_of([found]) == [found]
    assert stations_of([motion("EW")]) == []
    with pytest.raises(InputError, match="give only stations, or only single components"):
        stations_of([found, motion("EW")])


def test_files_are_seen_from_a_folder(tmp_path) -> None:
    for name in ("east.AT2", "north.AT2", "AKT0.EW", "AKT0.NS", "a+b.csv"):
        (tmp_path / name).write_text("")
    here = f"{tmp_path}/"
    assert seen_from(tmp_path, "east.AT2+north.AT2") == f"{here}east.AT2+{here}north.AT2"
    assert seen_from(tmp_path, "east.AT2::NS+::EW") == f"{here}east.AT2::NS+::EW"
    assert seen_from(tmp_path, "a+b.csv") == f"{here}a+b.csv"
    assert seen_from(tmp_path, "AKT0") == f"{here}AKT0"
    assert seen_from(tmp_path, "P695-FF-2") == "P695-FF-2"
    assert seen_from(tmp_path, "NCC+east.AT2") == f"NCC+{here}east.AT2"
