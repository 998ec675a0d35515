"""Measures of stations: principal axes, directions, and what is told of them."""

import math

import numpy as np
import pytest

from dcfp import GroundMotion, Station, load_station
from dcfp.motion.measures import arias_intensity
from dcfp.motion.station_measures import (
    STATION_MEASURES,
    direction_of_pgv,
    principal_axes,
    station_remarks,
)
from dcfp.schema.table import Table


def independent(ratio: float, angle: float) -> Station:
    """Two waves that are not correlated, of which the weaker is `ratio` of the other, turned by an angle."""
    time = np.arange(4000) * 0.01
    strong, weak = np.sin(2.0 * math.pi * time), ratio * np.sin(4.0 * math.pi * time)
    return Station(GroundMotion(1e3 * strong, 0.01), GroundMotion(1e3 * weak, 0.01)).rotated(angle)


@pytest.mark.parametrize(("ratio", "angle"), [(0.5, 0.0), (0.5, 30.0), (0.8, -70.0), (0.0, 45.0)])
def test_principal_axes_are_found_again(ratio: float, angle: float) -> None:
    found = principal_axes(independent(ratio, angle))
    assert found.angle == pytest.approx(angle, abs=0.05)
    assert found.ratio == pytest.approx(ratio, abs=1e-3)


def test_along_the_principal_axes_the_components_are_not_correlated() -> None:
    station = load_station("P695-FF-2")
    assert station is not None
    axes = principal_axes(station)
    along = station.rotated(-axes.angle)
    assert principal_axes(along).angle == pytest.approx(0.0, abs=1e-9)
    strong, weak = (arias_intensity(one) for one in (along.x, along.y))
    assert math.sqrt(weak / strong) == pytest.approx(axes.ratio)
    # no other direction is stronger
    for angle in range(0, 180, 10):
        assert arias_intensity(station.rotated(angle).x) <= strong * (1.0 + 1e-12)


def test_of_a_silent_station() -> None:
    silent = Station(GroundMotion(np.zeros(9), 0.01), GroundMotion(np.zeros(9), 0.01))
    assert principal_axes(silent) == (0.0, 0.0)
    assert direction_of_pgv(silent) == 0.0


def test_the_direction_of_the_pgv_is_that_of_a_line() -> None:
    push = GroundMotion(np.array([0.0, 100.0, 0.0, 0.0]), 0.1)
    for x, y, expected in ((1.0, 1.0, 45.0), (-1.0, 1.0, -45.0), (-1.0, -1.0, 45.0), (0.0, -1.0, 90.0)):
        assert direction_of_pgv(Station(push.scaled(x), push.scaled(y))) == pytest.approx(expected)


def test_what_is_told_of_a_station() -> None:
    station = load_station("P695-FF-2")
    assert station is not None
    (row,) = Table(tuple(STATION_MEASURES), [station]).objects()
    assert row["pgv_m_s"] == pytest.approx(np.hypot(*station.velocity.T).max() / 1e3)
    assert row["pgv_m_s"] >= max(row["pgv_x_m_s"], row["pgv_y_m_s"])
    assert row["arias_intensity_m_s"] == pytest.approx(
        (arias_intensity(station.x) + arias_intensity(station.y)) / 1e3
    )
    assert (row["azimuth_x_deg"], row["azimuth_y_deg"]) == (0.0, 270.0)
    assert row["pga_vertical_m_s2"] is None
    assert row["points"] == 1999
    turned = Table(tuple(STATION_MEASURES), [station.rotated(25.0)]).objects()[0]
    for key in ("pga_m_s2", "pgv_m_s", "pgd_mm", "arias_intensity_m_s", "principal_ratio"):
        assert turned[key] == pytest.approx(row[key]), key
    assert turned["principal_axis_deg"] == pytest.approx(row["principal_axis_deg"] + 25.0)
    assert station_remarks(station)[0].startswith("P695-FF-2: x points to 0 and y to 270 degrees from north")


def test_the_histories_as_a_data_set() -> None:
    station = independent(0.5, 0.0)
    data = station.to_dataset()
    assert set(data) == {
        f"ground_{name}_{direction}"
        for name in ("acceleration", "velocity", "displacement")
        for direction in ("x", "y")
    }
    np.testing.assert_array_equal(data["ground_velocity_y"], station.y.velocity)
    assert data["ground_velocity_y"].attrs["units"] == "mm s-1"
    assert data["ground_velocity_y"].attrs["long_name"] == "ground velocity, direction y"
