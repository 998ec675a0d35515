"""Paths in the plane: where they go and how fast, how they start, and what cannot be one."""

import math

import numpy as np
import pytest

from dcfp import InputError
from dcfp.analysis.rig import PATHS, Circle, Cloverleaf, Ellipse, FigureOfEight, RecordedPath, load_program
from dcfp.analysis.rig.plane_path import lap_bounds

EVERY = (Circle(100.0, 50.0, 2), Ellipse(100.0, 50.0, 2, second_amplitude=40.0), FigureOfEight(100.0, 50.0, 2), Cloverleaf(100.0, 50.0, 2))  # fmt: skip


def ends(travel) -> tuple[np.ndarray, np.ndarray]:
    """Positions and velocities at the ends of the pieces of a path."""
    h, c = travel.lengths, travel.pieces.T
    return c[0] + h * (c[1] + h * (c[2] + h * c[3])), c[1] + h * (2.0 * c[2] + 3.0 * h * c[3])


def test_every_path_is_tried_here() -> None:
    assert {type(one) for one in EVERY} == set(PATHS.values())


@pytest.mark.parametrize("path", EVERY, ids=lambda one: one.kind)
@pytest.mark.parametrize("start", ["speed", "ramp", "radius"])
def test_a_path_is_smooth_and_as_fast_as_it_says(path, start: str) -> None:
    path = type(path)(**{**path.__dict__, "start": start})
    travel = path.travel()
    position, velocity = ends(travel)
    assert position[:-1] == pytest.approx(travel.pieces[1:, 0], abs=1e-9)
    assert velocity[:-1] == pytest.approx(travel.pieces[1:, 1], abs=1e-8)
    inside = (travel.time[1:] > travel.cycles[0]) & (travel.time[1:] <= travel.cycles[-1] + 1e-9)
    assert np.abs(velocity[inside]).max() == pytest.approx(50.0, rel=1e-4)
    assert np.diff(travel.cycles) == pytest.approx(path.period)
    first, last = (
        position[np.searchsorted(travel.time[1:], bound - 1e-9)] for bound in travel.cycles[[-2, -1]]
    )
    assert first == pytest.approx(last, abs=1e-6)
    if start != "speed":
        # from rest in the middle, and back
        assert abs(travel.pieces[0, 0]) < 1e-9
        assert abs(travel.pieces[0, 1]) < 1e-9
        assert abs(position[-1]) < 1e-9
        assert abs(velocity[-1]) < 1e-6


def test_shapes() -> None:
    phase = np.linspace(0.0, 2.0 * math.pi, 361)
    assert np.abs(Circle(100.0, 1.0, 1).shape(phase)[0]) == pytest.approx(100.0)
    oval = Ellipse(100.0, 1.0, 1, second_amplitude=40.0).shape(phase)[0]
    assert (oval.real / 100.0) ** 2 + (oval.imag / 40.0) ** 2 == pytest.approx(1.0)
    eight = FigureOfEight(100.0, 1.0, 1).shape(phase)[0]
    assert [np.abs(eight.real).max(), np.abs(eight.imag).max()] == pytest.approx([100.0, 50.0])
    # Gerono's lemniscate: x4 = A2 (x2 - y2) for B = A / 2
    assert eight.real**4 == pytest.approx(100.0**2 * (eight.real**2 - eight.imag**2), abs=1e-4)
    clover = Cloverleaf(100.0, 1.0, 1).shape(phase)[0]
    assert clover == pytest.approx(100.0 * np.sin(2.0 * phase) * np.exp(1j * phase))
    # (x2 + y2)3 = 4 A2 x2 y2
    assert np.abs(clover) ** 6 == pytest.approx(4e4 * (clover.real * clover.imag) ** 2, abs=1.0)


@pytest.mark.parametrize("path", EVERY, ids=lambda one: one.kind)
def test_velocities_are_those_of_the_positions(path) -> None:
    phase = np.linspace(0.0, 2.0 * math.pi, 50)
    after, before = (path.shape(phase + away)[0] for away in (1e-5, -1e-5))
    assert path.shape(phase)[1] == pytest.approx((after - before) / 2e-5, abs=1e-5)


def test_laps_of_a_recorded_path() -> None:
    time = np.linspace(0.0, 5.0, 501)
    around = 100.0 * np.exp(2j * math.pi * 0.5 * time) + (3.0 + 2.0j)
    assert lap_bounds(time, around) == pytest.approx([0.0, 2.0, 4.0], abs=0.01)
    assert RecordedPath(time, around).period == pytest.approx(2.0, abs=0.01)
    # the other way around, and to and fro
    assert lap_bounds(time, around.conj()) == pytest.approx([0.0, 2.0, 4.0], abs=0.01)
    assert lap_bounds(time, around.real + 0j) == pytest.approx([0.0, 5.0])
    assert lap_bounds(time, Cloverleaf(100.0, 1.0, 1).shape(time)[0]) == pytest.approx([0.0, 5.0])


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("amplitude = -1\npeak_velocity = 5\ncycles = 1", "amplitude"),
        ("amplitude = 100\npeak_velocity = 5\ncycles = 0.3", "cycles"),
        ("amplitude = 100\npeak_velocity = 5\ncycles = 1\nwaveform = 'spiral'", "'spiral'"),
        ("amplitude = 100\npeak_velocity = 5\ncycles = 1\nsecond_amplitude = 5", "second_amplitude"),
        ("amplitude = 100\npeak_velocity = 5\ncycles = 1\nstart = 'peak'", "speed, ramp"),
        ("amplitude = 100\npeak_velocity = nan\ncycles = 1", "peak_velocity"),
        ("waveform = 'ellipse'\namplitude = 100\npeak_velocity = 5\ncycles = 1", "second_amplitude is missing"),
        ("waveform = 'ellipse'\namplitude = 0\nsecond_amplitude = 0\npeak_velocity = 5\ncycles = 1", "amplitude"),
        ("waveform = 'ellipse'\namplitude = 10\nsecond_amplitude = -5\npeak_velocity = 5\ncycles = 1", "second_amplitude"),
        ("waveform = 'eight'\namplitude = 10\nperiod = 5\npeak_velocity = 5\ncycles = 1", "either peak_velocity"),
    ],
)  # fmt: skip
def test_what_is_no_path_gets_a_sentence(tmp_path, words: str, said: str) -> None:
    if "waveform" not in words:
        words += "\nwaveform = 'circle'"
    file = tmp_path / "own.toml"
    file.write_text(f"[[test]]\n{words}\n")
    with pytest.raises(InputError, match=said):
        load_program(file)


def test_a_period_stands_for_a_peak_velocity(tmp_path) -> None:
    file = tmp_path / "own.toml"
    file.write_text(
        '[[test]]\nwaveform = "eight"\namplitude = 100\nsecond_amplitude = 80\nperiod = 4\ncycles = 1\n'
    )
    (test,) = load_program(file).tests
    assert test.waveform.period == pytest.approx(4.0)
    assert test.waveform.peak_velocity == pytest.approx(math.hypot(100.0, 160.0) * math.pi / 2.0)


def written(tmp_path, text: str):
    file = tmp_path / "path.csv"
    file.write_text(text)
    return file


CIRCLE = [(0.05 * i, *(f(0.05 * i) for f in (math.cos, math.sin))) for i in range(130)]


def test_a_path_from_a_file(tmp_path) -> None:
    rows = "\n".join(f"{1e3 * t},{10.0 * x},{10.0 * y},7000" for t, x, y in CIRCLE)
    program = load_program(written(tmp_path, f"time [ms],x [cm],y [cm],load [kN]\n{rows}\n"))
    assert program.plane
    (test,) = program.tests
    assert test.waveform.position == pytest.approx(
        np.array([100.0 * complex(x, y) for _, x, y in CIRCLE]), abs=1e-9
    )
    assert test.waveform.time[-1] == pytest.approx(CIRCLE[-1][0])
    assert test.load is not None
    assert test.load.values[0] == pytest.approx(7e6)


@pytest.mark.parametrize(
    ("head", "bad", "said"),
    [
        ("time [s],x [mm]", None, "a column 'x' and none 'y \\[mm\\]'"),
        ("time [s],y [mm],z [mm]", None, "a column 'y' and none 'x \\[mm\\]'"),
        ("t [s],x [mm],y [mm]", None, "no column 'time \\[s\\]'"),
        ("time [s],x,y [mm]", None, "'x' has no unit"),
        ("time [s],x [mm],y [mm]", "2.0,nan,0", "line 12: the x is 'nan'"),
        ("time [s],x [mm],y [mm]", "0.1,100,0", "must increase"),
        ("time [s],x [m],y [mm]", None, "look at its unit"),
    ],
)
def test_what_is_no_path_in_a_file_gets_a_sentence(tmp_path, head: str, bad: str | None, said: str) -> None:
    rows = [f"{t},{100.0 * x},{100.0 * y}" for t, x, y in CIRCLE]
    if bad is not None:
        rows[10] = bad
    with pytest.raises(InputError, match=said):
        load_program(written(tmp_path, "\n".join([head, *rows])))


def test_noise_is_no_path(tmp_path) -> None:
    noise = np.random.default_rng(1).normal(0.0, 20.0, (len(CIRCLE), 2))
    rows = [
        f"{t},{100.0 * x + dx},{100.0 * y + dy}" for (t, x, y), (dx, dy) in zip(CIRCLE, noise, strict=True)
    ]
    with pytest.raises(InputError, match="too noisy"):
        load_program(written(tmp_path, "\n".join(["time [s],x [mm],y [mm]", *rows])))
