"""Stations: named, joined from files, brought together, turned and scaled; and what is refused."""

from dataclasses import replace

import numpy as np
import pytest

from dcfp import (
    GroundMotion,
    InputError,
    Station,
    compare,
    find_pulses,
    load_motion,
    load_station,
    respond,
)
from dcfp.motion.ground_motion import Origin
from dcfp.motion.load import load_motions, load_records, seen_from
from dcfp.motion.station import joined, stations_of
from dcfp.motion.treatment import station_treated, treated


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


@pytest.mark.parametrize("text", ["", " "])
def test_no_name_is_no_folder(text: str) -> None:
    assert load_station(text) is None
    with pytest.raises(InputError, match="there is no record named"):
        load_motion(text)


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
        ([motion("000"), motion("090"), motion("045", seed=5)], "the third component, 045, is horizontal"),
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


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("P695-FF-2+P695-FF-3", "P695-FF-2 has both components already, and + joins single ones; between stations stand blanks"),
        ("KNA+P695-FF-7", "P695-FF-7 has both components already"),
        ("P695-stations+KNA", "P695-stations has both components already"),
        ("P695-NF+KNA", "P695-NF is a set of records, and + joins the components of one station"),
    ],
)  # fmt: skip
def test_a_plus_joins_single_components(text: str, sentence: str) -> None:
    for load in (load_station, load_motion):
        with pytest.raises(InputError) as caught:
            load(text)
        assert str(caught.value).startswith(f"{text}: {sentence}")


def test_what_a_component_does_not_say_is_told() -> None:
    told, silent = motion("EW", event="Kobe 1995"), motion("NS", seed=2)
    with_station = replace(told, origin=replace(told.origin, station="JMA Kobe"))
    assert joined([told, silent], "pair").treatment == (
        "NS does not say of which earthquake it is, which is taken to be as of EW",
    )
    assert joined([silent, with_station], "pair").treatment == (
        "NS does not say of which earthquake and station it is, which is taken to be as of EW",
    )
    other = motion("UD", seed=3, event="Northridge 1994")
    with pytest.raises(InputError, match="EW and UD are of different earthquakes, 'Kobe 1995' and 'North"):
        joined([silent, told, other], "three")
    assert joined([silent, motion("EW")], "plain").treatment == ()


def test_a_component_without_motion_is_told() -> None:
    dead = motion("NS", seed=2).scaled(0.0)
    (remark,) = joined([motion("EW"), replace(dead, treatment=())], "pair").treatment
    assert remark == "NS is zero throughout, which is taken for a ground that does not move in its direction"


def test_a_missing_file_of_a_triple_is_named(tmp_path) -> None:
    east, north = (replace(motion(name, seed=place), origin=Origin(component=name, source=f"AKT0139703.{name}")) for place, name in enumerate(("EW", "NS")))  # fmt: skip
    with pytest.raises(
        InputError, match=r"no vertical component; put its file AKT0139703\.UD beside the others"
    ):
        joined([east, north], "pair").require_vertical()
    with pytest.raises(InputError, match="no vertical component; join it as the third one"):
        joined([motion("EW"), motion("NS", seed=2)], "pair").require_vertical()
    for name in ("AKT0139703.EW", "AKT0139703.NS"):
        (tmp_path / name).touch()
    for name in ("AKT0139703.UD", "AKT01"):
        with pytest.raises(
            InputError, match=r"there is no such file; in its folder are AKT0139703\.EW, AKT0139703\.NS"
        ):
            load_motion(tmp_path / name)


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


def later(seconds: float, component: str, size: int = 50, step: float = 0.01, seed: int = 1) -> GroundMotion:
    """A motion that starts so many seconds after another."""
    one = motion(component, size, step, seed)
    return replace(one, origin=replace(one.origin, start="2011-03-11T14:47:10+09:00").later(seconds))


def test_a_component_that_starts_later_begins_at_rest() -> None:
    early, late = later(0.0, "EW"), later(0.2, "NS", seed=2)
    found = joined([early, late], "pair")
    assert found.x.acceleration.size == found.y.acceleration.size == 70
    np.testing.assert_array_equal(found.x.acceleration[:50], early.acceleration)
    np.testing.assert_array_equal(found.y.acceleration[:20], 0.0)
    np.testing.assert_array_equal(found.y.acceleration[20:], late.acceleration)
    assert found.treatment == (
        "NS starts 0.2 s later, and its ground is at rest before",
        "EW ends 0.2 s earlier, and keeps its velocity from there on",
    )
    other_way = joined([late, early], "pair")
    np.testing.assert_array_equal(other_way.y.acceleration, found.x.acceleration)


def test_starts_are_instants_whatever_clock_they_are_told_by() -> None:
    one = later(0.0, "EW")
    utc = replace(motion("NS"), origin=Origin(component="NS", start="2011-03-11T05:47:10.1+00:00"))
    assert joined([one, utc], "pair").y.acceleration[9:12].tolist() == [0.0, *utc.acceleration[:2]]


def test_a_start_between_two_values_is_moved_to_the_nearest() -> None:
    found = joined([later(0.0, "EW"), later(0.203, "NS", seed=2)], "pair")
    assert found.y.acceleration.size == 70
    assert found.treatment[0] == (
        "NS starts 0.203 s later, moved by -3 ms to the nearest value, and its ground is at rest before"
    )
    # to the nearest value of the finer component
    fine = joined([later(0.0, "EW", 100, 0.005), later(0.203, "NS", 50, 0.02)], "pair")
    assert np.flatnonzero(fine.y.acceleration)[0] == 41
    assert fine.time_step == 0.005


def test_a_start_that_is_not_known_is_told() -> None:
    found = joined([later(0.0, "EW"), motion("NS", seed=2)], "pair")
    assert found.treatment == ("NS does not say when it starts, which is taken to be with EW",)
    assert joined([motion("EW"), motion("NS", seed=2)], "pair").treatment == ()


def test_components_are_treated_before_zeros_are_added() -> None:
    """A filter's margins and an offset belong to what was recorded."""
    early = replace(later(0.0, "EW", 500), acceleration=later(0.0, "EW", 500).acceleration + 100.0)
    late = replace(
        later(1.0, "NS", 400, seed=2), acceleration=later(1.0, "NS", 400, seed=2).acceleration - 50.0
    )
    found = station_treated(joined([early, late], "pair"), corner=0.5)
    assert found.treatment[0] == "mean removed"
    assert "starts 1 s later" in found.treatment[2]
    alone = treated(late, corner=0.5)
    np.testing.assert_array_equal(found.y.acceleration[100:], alone.acceleration)
    assert abs(found.y.velocity[-1]) < 5.0
    # the margins of 0.75 order / corner = 3 s begin before what was recorded
    assert (late.origin.start, alone.origin.start) == (
        "2011-03-11T14:47:11+09:00",
        "2011-03-11T14:47:08+09:00",
    )


@pytest.mark.parametrize(("steps", "fits"), [((0.005, 0.01), True), ((0.005, 0.02), True), ((0.01, 0.004), False), ((0.02, 0.006), False)])  # fmt: skip
def test_time_steps_that_fit_and_those_that_do_not(steps, fits) -> None:
    pair = [motion(name, 60, step, seed) for name, step, seed in zip(("EW", "NS"), steps, (1, 2), strict=True)]  # fmt: skip
    if not fits:
        with pytest.raises(InputError, match=f"EW and NS, {steps[0]} and {steps[1]} s, do not fit"):
            joined(pair, "pair")
        return
    found = joined(pair, "pair")
    parts = round(steps[1] / steps[0])
    np.testing.assert_allclose(found.y.acceleration[::parts], pair[1].acceleration)
    np.testing.assert_allclose(found.y.velocity[::parts], pair[1].velocity, atol=1e-9)


def test_a_vertical_that_is_positive_downwards_is_turned_over() -> None:
    down = motion("DWN", seed=3)
    found = joined([motion("EW"), motion("NS", seed=2), down], "three")
    assert found.vertical is not None
    np.testing.assert_array_equal(found.vertical.acceleration, -down.acceleration)
    assert found.treatment == ("DWN is positive downwards, and was turned over",)


def test_where_x_and_y_point_and_what_turning_makes_of_it() -> None:
    right = joined([motion("EW"), motion("NS", seed=2)], "pair")
    assert right.azimuths == (90.0, 0.0)
    assert "counter-clockwise" in right.orientation
    turned = right.rotated(30.0)
    assert turned.azimuths == (120.0, 30.0)
    # what x has now is the motion along its direction: 120 degrees from north
    along = right.x.acceleration * np.sin(np.radians(120.0)) + right.y.acceleration * np.cos(
        np.radians(120.0)
    )
    np.testing.assert_allclose(turned.x.acceleration, along, atol=1e-9)
    left = joined([motion("000"), motion("090", seed=2)], "pair")
    assert " clockwise" in left.orientation
    turned = left.rotated(30.0)
    assert turned.azimuths == (330.0, 60.0)
    along = left.x.acceleration * np.cos(np.radians(330.0)) + left.y.acceleration * np.sin(np.radians(330.0))
    np.testing.assert_allclose(turned.x.acceleration, along, atol=1e-9)
    unknown = joined([motion("H1"), motion("H2", seed=2)], "pair")
    assert (unknown.azimuths, unknown.orientation) == (None, "")
    assert unknown.rotated(30.0).origin.component == "x + y"


def test_nearly_a_right_angle_is_told() -> None:
    found = joined([motion("021"), motion("292", seed=2)], "pair")
    assert found.treatment == ("021 and 292 point to 21 and 292 degrees, which is taken for a right angle",)


def test_times_that_do_not_overlap() -> None:
    with pytest.raises(InputError, match="NS starts 3600 s after EW, which has ended by then"):
        joined([later(0.0, "EW"), later(3600.0, "NS", seed=2)], "pair")


def test_names_of_files_with_a_plus(tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    values = np.random.default_rng(3).normal(0.0, 0.1, (50, 3))
    plain = {"units": "g", "time_step": 0.01}
    for name, column in zip(("a+b.txt", "a.txt", "c+d.txt"), values.T, strict=True):
        np.savetxt(name, column)
    assert load_station("a+b.txt", **plain) is None
    assert load_motion("a+b.txt", **plain).name == "a+b"
    found = load_station("a+b.txt+c+d.txt+a.txt", **plain)
    assert found is not None
    np.testing.assert_allclose(found.x.acceleration / 9806.65, values[:, 0])
    np.testing.assert_allclose(found.y.acceleration / 9806.65, values[:, 2])


def k_net(folder, stem: str, endings: str, first: int = 0, record_time: str = "04:50:42") -> None:
    """Write files of K-NET or KiK-net."""
    codes = {"EW": "E-W", "NS": "N-S", "UD": "U-D", "EW2": "5", "NS2": "4", "UD2": "6", "EW1": "2", "NS1": "1", "UD1": "3"}  # fmt: skip
    for place, ending in enumerate(endings.split()):
        header = f"""Origin Time       2003/09/26 04:50:00
Lat.              41.78
Long.             144.08
Depth. (km)       42
Mag.              8.0
Station Code      {stem[:6]}
Station Lat.      42.1303
Station Long.     142.9351
Station Height(m) 25
Record Time       2003/09/26 {record_time}
Sampling Freq(Hz) 100Hz
Duration Time(s)  0.08
Dir.              {codes[ending]}
Scale Factor      2000(gal)/8388608
Max. Acc. (gal)   1.0
Last Correction   2003/09/26 04:50:27
Memo.
"""
        numbers = "".join(f"{first + 100 * place + 10 * step:9d}" for step in range(8))
        (folder / f"{stem}.{ending}").write_text(header + numbers + "\n")


def test_a_folder_or_a_stem_of_k_net_and_kik_net(tmp_path) -> None:
    k_net(tmp_path, "HKD100", "EW NS UD")
    found = load_station(tmp_path)
    assert found is not None
    assert (found.name, found.origin.component) == ("HKD100", "E-W + N-S + U-D")
    # the time of the record is 15 s later than its first value
    assert found.x.origin.start == "2003-09-26T04:50:27+09:00"
    kik = tmp_path / "kik"
    kik.mkdir()
    k_net(kik, "AICH04", "EW1 NS1 UD1 EW2 NS2 UD2")
    surface = load_station(kik / "AICH04")
    assert surface is not None
    assert surface.origin.component == "EW2 + NS2 + UD2"
    borehole = load_station("+".join(str(kik / f"AICH04.{one}1") for one in ("EW", "NS", "UD")))
    assert borehole is not None
    assert borehole.origin.component == "EW1 + NS1 + UD1"


def test_what_is_wrong_with_a_folder_or_a_stem(tmp_path) -> None:
    with pytest.raises(InputError, match="and this one holds none; name a file in it"):
        load_station(tmp_path)
    k_net(tmp_path, "HKD100", "EW UD")
    with pytest.raises(
        InputError, match=r"lacks the file HKD100\.NS beside HKD100\.EW, HKD100\.UD; both horizontal"
    ):
        load_station(tmp_path / "HKD100")
    k_net(tmp_path, "HKD100", "NS", 500)
    k_net(tmp_path, "HKD200", "EW NS UD")
    with pytest.raises(InputError, match="the files of several records, HKD100, HKD200; name one, as in"):
        load_station(tmp_path)
    k_net(tmp_path, "HKD300", "EW NS", record_time="04:50:43")
    k_net(tmp_path, "HKD300", "NS", 300, record_time="05:50:43")
    with pytest.raises(InputError, match="HKD300 N-S starts 3600 s after HKD300 E-W"):
        load_station(tmp_path / "HKD300")


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("P695-FF-2", "choose P695-FF-2-a or P695-FF-2-b"),
        ("KNA+P695-FF-7-b", "choose KNA or P695-FF-7-b"),
        ("{}/HKD100", r"choose .*HKD100\.EW or .*HKD100\.NS"),
        ("{}", r"choose .*HKD100\.EW or .*HKD100\.NS"),
        ("{0}/HKD100.EW+{0}/HKD100.NS", r"choose .*HKD100\.EW or .*HKD100\.NS"),
    ],
)
def test_every_analysis_in_one_direction_says_what_to_choose(tmp_path, text, sentence) -> None:
    k_net(tmp_path, "HKD100", "EW NS UD")
    name = text.format(tmp_path)
    for function in (compare, find_pulses, load_motion):
        with pytest.raises(InputError, match=f"and this takes one direction; {sentence}"):
            function(name)
    station = load_station(name)
    with pytest.raises(InputError, match="this takes one direction; choose its x or its y"):
        find_pulses(station)


def test_a_vertical_component_is_horizontal_only_where_it_is_asked_for(tmp_path) -> None:
    k_net(tmp_path, "HKD100", "EW NS UD")
    file = tmp_path / "HKD100.UD"
    for function in (respond, compare, find_pulses):
        with pytest.raises(
            InputError, match=r"is a vertical component \(U-D\).*choose it by its name, as in .*UD::U-D"
        ):
            function(file)
        with pytest.raises(InputError, match=r"if that is meant, give its as_horizontal\(\)"):
            function(load_motion(file))
    meant = respond(f"{file}::U-D", heating="none")
    assert meant.motion.treatment == ("the vertical component, taken as horizontal",)
    assert respond(load_motion(file).as_horizontal(), heating="none").peak_displacement == pytest.approx(
        meant.peak_displacement
    )
    assert load_motion(file, "UD").treatment == ()
    assert respond(tmp_path / "HKD100.EW", heating="none").motion.treatment == ()


def test_five_joined_files_and_the_same_motion_twice() -> None:
    for text in ("+".join(f"P695-FF-{one}-a" for one in range(1, 6)), "KNA+P695-FF-7-a"):
        with pytest.raises(InputError, match="two or three different components joined by"):
            load_station(text)
