"""The parts of the page that need no browser."""

import asyncio
import tomllib
from dataclasses import replace
from itertools import pairwise
from typing import Annotated, ClassVar

import numpy as np
import pytest

pytest.importorskip("nicegui", reason="the web page needs nicegui")

import dcfp
from dcfp.analysis.response import PEAKS
from dcfp.doors.app.analysis import Task, remarks_on, scenario_text
from dcfp.doors.app.charts import TOLERANCE, kept, kept_of_path, turning_points
from dcfp.doors.app.elements import Units
from dcfp.doors.app.machine_tab import grouped
from dcfp.doors.app.plane_view import beside
from dcfp.doors.app.serve import LARGEST_BODY, Guard
from dcfp.doors.app.session import (
    MOST_COMPONENTS,
    MOST_FILES,
    BearingForm,
    Session,
    bearing_fields,
    plain_name,
    read_upload,
)
from dcfp.errors import InputError
from dcfp.schema.declared import declared
from dcfp.schema.parameters import Parameter
from dcfp.schema.quantities import Quantity, quantity
from dcfp.schema.units import (
    DEGC,
    DEGF,
    INCH,
    INCH_PER_S,
    KIP,
    KN_PER_MM,
    MM,
    MM_PER_S,
    N_PER_MM,
    NEWTON,
    NONE,
)
from dcfp.study.scenario import calculate, read_scenario
from dcfp.system import FRICTION_LAWS, HEATINGS, LI_2020, ConstantFriction, Li2020, System

from .conftest import at2_text, pulse_motion


def test_components_are_joined_as_a_station_in_their_order():
    session = Session(chosen=["P695-FF-2-b", "P695-FF-2-a"])
    assert not session.in_plane
    session.choose([session.join()])
    assert session.in_plane
    assert session.bearing.values["heating"] == "precise"
    motion = session.motion(session.chosen[0])
    assert isinstance(motion, dcfp.Station)
    np.testing.assert_array_equal(motion.x.acceleration, dcfp.load_motion("P695-FF-2-b").acceleration)
    assert session.choices()[motion.name] == "P695-FF-2-b+P695-FF-2-a · joined"
    with pytest.raises(InputError, match="two or three components"):
        session.join()
    session.choose([])
    session.choose(["NCC"])
    assert session.bearing.values["heating"] == "simplified"


def test_a_heating_model_that_was_chosen_stays_with_a_station():
    session = Session()
    session.bearing.put("heating", "none")
    session.choose(["P695-FF-2"])
    assert session.bearing.values["heating"] == "none"


def test_stations_and_single_components_are_not_mixed():
    task = Task.of(Session(chosen=["P695-FF-2", "NCC"]))
    with pytest.raises(InputError, match="give only stations, or only single components"):
        task.analysed()
    with pytest.raises(InputError, match="give only stations, or only single components"):
        task.scenario()


def test_what_is_taken_away_of_a_station_is_what_is_shown(tmp_path):
    session = Session(chosen=["P695-FF-2"], rotate=30.0)
    session.bearing.put("heating", "none")
    (shown,) = Task.of(session).analysed()
    (result,) = calculate(Task.of(session).scenario()).results
    assert result.response.summary() | {"elapsed_s": 0} == shown.summary() | {"elapsed_s": 0}
    assert (
        shown.peak_displacement_x != dcfp.respond("P695-FF-2", pgv=500.0, heating="none").peak_displacement_x
    )
    with pytest.raises(InputError, match="leave out the angle, or take the report or the workbook"):
        scenario_text(session)
    session.rotate = None
    path = tmp_path / "scenario.toml"
    path.write_text(scenario_text(session))
    (again,) = calculate(read_scenario(path)).results
    assert again.response.peak_displacement == pytest.approx(shown.peak_displacement, rel=1e-9)


def test_the_vertical_force_is_in_the_scenario_of_a_station():
    session = Session(chosen=["P695-FF-2"], vertical=True)
    assert tomllib.loads(scenario_text(session))["analysis"] == {"vertical": True}
    with pytest.raises(InputError, match="no vertical component"):
        Task.of(session).scenario()
    session.choose(["NCC"])
    assert "analysis" not in tomllib.loads(scenario_text(session))


def test_the_pictures_of_a_plate_stand_beside_each_other():
    pictures = np.arange(11.0)[:, None, None] * np.ones((11, 2, 3))
    whole = beside(pictures)
    assert whole.shape == (4, 24)
    for number in range(11):
        row, column = divmod(number, 8)
        assert (whole[2 * row : 2 * row + 2, 3 * column : 3 * column + 3] == number).all()


def test_the_fields_begin_with_the_paper_s_bearing():
    assert BearingForm().system() == System()


@pytest.mark.parametrize("name", FRICTION_LAWS)
def test_every_law_can_be_chosen_with_its_own_parameters(name):
    form = BearingForm()
    form.put("law", name)
    assert form.system().friction == FRICTION_LAWS[name]()
    form.put(form.reference, 0.06)
    assert form.system().friction == FRICTION_LAWS[name]().with_reference(0.06)
    for key, one in form.law_fields().items():
        assert form.values[key] == one.written(getattr(form.system().friction, one.name))


@pytest.mark.parametrize("name", HEATINGS)
def test_every_heating_model_can_be_chosen_and_keeps_the_plates(name):
    form = BearingForm()
    for key, value in (("ambient", -10.0), ("thickness", 50.0), ("conductivity", 20.0)):
        form.put(key, value)
    form.put("heating", name)
    assert form.system().heating == HEATINGS[name](20.0, ambient=-10.0, thickness=50.0)


def test_a_parameter_of_a_law_that_another_module_adds_has_a_field():
    @declared
    class Toy(ConstantFriction):
        name: ClassVar[str] = "toy"
        words: ClassVar[str] = "of a test"
        length: Annotated[float, Parameter("length of the toy", MM, 1.0, 9.0, step=0.5)] = 2.0
        pair: Annotated[tuple[float, float] | None, Parameter("ends of the toy", NONE, 0.0, 1.0)] = None

    try:
        form = BearingForm()
        form.put("law", "toy")
        assert [one.words for one in form.law_fields().values()] == [
            "coefficient of friction", "length of the toy", "ends of the toy",
        ]  # fmt: skip
        form.put("friction.length", 3.0)
        form.put("friction.pair", [0.25, 0.5])
        law = form.system().friction
        assert (law.name, vars(law)) == ("toy", {"mu": 0.043, "length": 3.0, "pair": (0.25, 0.5)})
        form.put("friction.length", 9.5)
        with pytest.raises(
            InputError, match=r"^The length of the toy must be a number of mm from 1 to 9, not 9\.5\.$"
        ):
            form.system()
    finally:
        FRICTION_LAWS.remove("toy")


@pytest.mark.parametrize("name", [name for name, one in bearing_fields().items() if not one.optional])
def test_an_empty_field_and_one_out_of_range_are_said(name):
    form = BearingForm()
    words = bearing_fields()[name].words
    form.put(name, None)
    with pytest.raises(InputError, match=f"^The {words} .* is missing"):
        form.system()
    form.put(name, 1e9)
    with pytest.raises(InputError, match=f"^The {words} must be a number of .* from .* to .*, not 1e\\+09"):
        form.system()


def test_a_field_asks_whether_another_unit_was_meant():
    form = BearingForm()
    form.put("lower_radius", 4.5)
    with pytest.raises(InputError, match=r"not 4\.5 \(were m meant\?\)\.$"):
        form.system()
    form.reset()
    form.put("stiffness", 1.9)
    with pytest.raises(InputError, match=r"were MN/mm meant"):
        form.system()


def test_another_bearing_has_a_name_of_its_own():
    form = BearingForm()
    form.put("slider", 350.0)
    form.put("capacity", None)
    bearing = form.system().bearing
    assert (bearing.slider_diameter, bearing.displacement_capacity, bearing.name) == (
        350.0,
        None,
        "bearing of the page",
    )
    form.reset()
    assert form.system().bearing is LI_2020
    assert form.system().friction == Li2020()


def test_thinning_keeps_every_extreme():
    random = np.random.default_rng(1)
    for size in (10, 839, 841, 5000, 99_999):
        columns = [random.normal(size=size), random.normal(size=size).cumsum()]
        chosen = kept(columns)
        assert chosen[0] == 0
        assert chosen[-1] == size - 1
        assert (np.diff(chosen) > 0).all()
        assert chosen.size <= max(840, 420 * 4 + 2)
        for column in columns:
            assert column[chosen].max() == column.max()
            assert column[chosen].min() == column.min()


def long_loop() -> tuple[np.ndarray, np.ndarray]:
    """Displacement and force of a record of 300 s."""
    time = np.arange(0.0, 300.0, 0.01)
    random = np.random.default_rng(3).normal(size=time.size)
    waves = np.convolve(random, np.hanning(120), "same") * np.sin(np.pi * time / 300.0) ** 2
    motion = dcfp.GroundMotion(waves - waves.mean(), 0.01, name="long").scaled_to_pgv(700.0)
    response = dcfp.respond(motion)
    return response.displacement, response.force


def farthest_from(path: np.ndarray, chosen: np.ndarray) -> float:
    """How far a path is from the chords between the chosen of its points."""
    largest = 0.0
    for first, last in pairwise(chosen.tolist()):
        chord, along = path[last] - path[first], path[first : last + 1] - path[first]
        share = np.clip(along @ chord / max(float(chord @ chord), 1e-300), 0.0, 1.0)
        largest = max(largest, float(np.hypot(*(along - share[:, None] * chord).T).max()))
    return largest


@pytest.mark.slow
def test_a_loop_is_thinned_along_its_path():
    y, force = long_loop()
    assert y.size > 30_000
    path = np.column_stack((y / np.ptp(y), force / np.ptp(force)))
    chosen = kept_of_path(y, force)
    assert chosen.size < 0.2 * y.size
    assert (chosen[0], chosen[-1]) == (0, y.size - 1)
    assert (np.diff(chosen) > 0).all()
    assert farthest_from(path, chosen) <= TOLERANCE * (1.0 + 1e-9)
    # along time it would be chords with tips that are none
    assert farthest_from(path, kept((y, force), 700)) > 20.0 * TOLERANCE
    # every turn that can be seen, found in another way: a top or a bottom with lower or higher ground on both sides
    turns = np.flatnonzero(np.diff(np.sign(np.diff(y)), prepend=0.0, append=0.0)[:-1])
    inside = [place for place in turns.tolist() if stands_out(y, place, TOLERANCE * float(np.ptp(y)))]
    assert len(inside) > 100
    assert set(inside) <= set(chosen.tolist())


def stands_out(values: np.ndarray, place: int, least: float) -> bool:
    """Whether a sample is an extreme from which both ways lead away by more than `least` before they pass it."""
    for sign in (1.0, -1.0):
        heights = sign * (values - values[place])
        sides = (heights[:place][::-1], heights[place + 1 :])
        if all(_falls_first(side, least) for side in sides):
            return True
    return False


def _falls_first(heights: np.ndarray, least: float) -> bool:
    below, above = np.flatnonzero(heights < -least), np.flatnonzero(heights >= 0.0)
    return below.size > 0 and (above.size == 0 or below[0] < above[0])


def test_turning_points_are_those_that_can_be_seen():
    values = np.array([0.0, 0.5, 1.0, 0.95, 1.1, 0.2, 0.21, -1.0, 0.0])
    assert turning_points(values, 0.1).tolist() == [4, 7]
    assert turning_points(np.zeros(5), 0.1).tolist() == []


@pytest.fixture
def american() -> Units:
    units = Units()
    units.chosen |= {MM: INCH, NEWTON: KIP, MM_PER_S: INCH_PER_S, DEGC: DEGF}
    return units


def test_a_peak_is_shown_in_the_unit_that_is_chosen(american):
    response = dcfp.respond(dcfp.load_motion("NCC"))
    shown = {name: (american.text(one, response), american.name(one)) for name, one in PEAKS.items()}
    assert shown["peak_displacement"] == (f"{response.peak_displacement / 25.4:.2f}", "in")
    assert shown["input_velocity"] == (f"{response.input_velocity / 25.4:.2f}", "in/s")
    assert shown["least_friction"] == (f"{response.least_friction:.4f}", "–")
    assert shown["status"] == (response.status.value, "")


@pytest.mark.parametrize(
    ("name", "value", "decimals", "given", "chosen"),
    [
        ("displacement", 25.4, 1, "25.4 mm", "1.00 in"),
        ("displacement", -0.01, 1, "0.0 mm", "0.00 in"),
        ("force", 4448.2216, 0, "4 kN", "1.0 kip"),
        ("velocity", 254.0, 3, "0.254 m/s", "10.00 in/s"),
        ("temperature", 100.0, 0, "100 °C", "212 °F"),
        ("input_energy", 4448.2216 * 304.8, 0, "1 kN m", "1 kip ft"),
        ("friction", 0.05, 3, "0.050 –", "0.050 –"),
        ("ground_acceleration", 9806.65, 2, "9.81 m/s²", "9.81 m/s²"),
    ],
)
def test_values_are_shown_in_the_unit_that_is_chosen(american, name, value, decimals, given, chosen):
    one = replace(quantity(name), decimals=decimals)
    for units, expected in ((Units(), given), (american, chosen)):
        assert f"{units.written(one, value)} {units.name(one)}" == expected


def test_decimals_follow_a_unit_that_is_not_among_the_choices():
    one = Quantity("v", "velocity", MM_PER_S, decimals=0)
    assert (Units().written(one, 412.3), Units().name(one)) == ("0.412", "m/s")


def test_a_stiffness_follows_from_force_and_length(american):
    one = Quantity("k", "stiffness", N_PER_MM, KN_PER_MM, decimals=3)
    assert f"{Units().written(one, 1900.0)} {Units().name(one)}" == "1.900 kN/mm"
    assert (
        f"{american.written(one, 1900.0)} {american.name(one)}"
        == f"{1900.0 * 25.4 / 4448.2216152605:.3f} kip/in"
    )


@pytest.mark.parametrize(
    ("given", "shown"),
    [
        ("a.AT2", "a.AT2"),
        ("../../etc/passwd", "passwd"),
        ("C:\\records\\b.txt", "b.txt"),
        ("", "record"),
        ("..", "record"),
        ("a\x00b\n.AT2", "ab.AT2"),
    ],
)
def test_of_a_name_only_the_last_part_is_left(given, shown):
    assert plain_name(given) == shown


def test_a_long_name_is_shortened():
    assert len(plain_name("x" * 500 + ".AT2")) == 80


def test_a_record_of_too_many_steps_is_refused():
    with pytest.raises(InputError, match="too long for the page"):
        read_upload(at2_text(pulse_motion(points=300), step=1e-4).encode(), "fine.AT2")


def test_a_session_takes_so_many_files():
    uploads = read_upload(at2_text(pulse_motion(points=300)).encode(), "one.AT2")
    session = Session()
    for _ in range(MOST_FILES):
        session.take(uploads)
    with pytest.raises(InputError, match="at most 12 of your files"):
        session.take(uploads)
    with pytest.raises(InputError, match="components"):
        Session().take(uploads * (MOST_COMPONENTS + 1))
    assert Session().sent == {}


def test_a_record_that_was_sent_is_read_as_from_a_file(tmp_path):
    text = at2_text(pulse_motion())
    path = tmp_path / "mine.AT2"
    path.write_text(text)
    (upload,) = read_upload(text.encode(), "mine.AT2")
    assert upload.motion.digest == dcfp.load_motion(path).digest
    assert upload.motion.name == "mine"


async def _through(guard: Guard, scope: dict, bodies: list[bytes]) -> int:
    sent: list[dict] = []
    left = list(bodies)

    async def receive() -> dict:
        return {"type": "http.request", "body": left.pop(0) if left else b"", "more_body": bool(left)}

    async def send(message) -> None:
        sent.append(message)

    await guard({"type": "http", "headers": [], **scope}, receive, send)
    return sent[0]["status"]


async def _reading(scope, receive, send) -> None:
    """An application that reads everything."""
    del scope
    while (await receive())["more_body"]:
        pass
    await send({"type": "http.response.start", "status": 200, "headers": []})
    await send({"type": "http.response.body", "body": b""})


@pytest.mark.parametrize(
    ("local", "headers", "status"),
    [
        (True, {b"host": b"127.0.0.1:8080"}, 200),
        (True, {b"host": b"localhost:8080"}, 200),
        (True, {b"host": b"[::1]:8080"}, 200),
        (True, {}, 403),
        (True, {b"host": b"10.0.0.1:8080"}, 403),
        (False, {b"host": b"10.0.0.1:8080"}, 200),
        (False, {b"host": b"10.0.0.1:8080", b"origin": b"http://10.0.0.1:8080"}, 200),
        (False, {b"host": b"10.0.0.1:8080", b"origin": b"http://evil.example"}, 403),
        (False, {b"host": b"10.0.0.1:8080", b"origin": b"http://10.0.0.1:8081"}, 403),
        (False, {b"host": b"10.0.0.1:8080", b"origin": b"http://10.0.0.1"}, 403),
        (False, {b"host": b"10.0.0.1:8080", b"origin": b"https://10.0.0.1:8080"}, 403),
        (False, {b"host": b"10.0.0.1", b"origin": b"http://10.0.0.1:80"}, 200),
        (False, {b"host": b"10.0.0.1:8080", b"origin": b"null"}, 403),
        (False, {b"host": b"", b"origin": b"null"}, 403),
        (False, {b"host": b"10.0.0.1:8080", b"origin": b"http://10.0.0.1:port"}, 403),
        (True, {b"host": b"localhost", b"content-length": str(LARGEST_BODY + 1).encode()}, 413),
    ],
)
def test_who_is_let_in(local, headers, status):
    guard = Guard(_reading, local=local)
    assert asyncio.run(_through(guard, {"headers": list(headers.items())}, [b"x"])) == status


def test_a_body_that_goes_on_is_stopped():
    guard = Guard(_reading, local=False)
    part = b"0" * (LARGEST_BODY // 4)
    assert asyncio.run(_through(guard, {}, [part] * 4)) == 200
    assert asyncio.run(_through(guard, {}, [part] * 5)) == 413


def test_what_the_page_says_of_results_names_no_option():
    heating = dcfp.SimplifiedHeating()
    long = dcfp.respond(
        dcfp.load_motion("NCC").scaled_to_pgv(2500.0), dcfp.Bearing(3000.0), heating=heating, tail=700.0
    )
    tests = dcfp.run_program(dcfp.load_program("dependency"))
    said = [*remarks_on(long), *grouped(list(tests))]
    assert len(said) >= 2
    assert not [sentence for sentence in said if "--" in sentence]
