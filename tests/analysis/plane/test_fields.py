"""The temperature of the plates that an analysis in the plane keeps: the same numbers as without, and at every moment the mean under the slider."""

import numpy as np
import pytest

import dcfp
from dcfp import Bearing, InputError, respond
from dcfp.analysis.integration import PLATES, Keep


@pytest.fixture(scope="module")
def station():
    found = dcfp.load_station("P695-FF-2")
    assert found is not None
    return found.scaled_to_pgv(1000.0)


@pytest.fixture(scope="module")
def kept(station):
    return respond(station, keep=PLATES)


def test_every_number_is_the_same_as_without(station, kept) -> None:
    plain = respond(station)
    assert plain.fields is None
    np.testing.assert_array_equal(kept.lines, plain.lines)
    told, same = plain.summary(), kept.summary()
    del told["elapsed_s"], same["elapsed_s"]
    assert same == told


def test_the_hottest_moment_is_among_them(kept) -> None:
    fields = kept.fields
    assert 30 < fields.time.size <= 62
    assert fields.temperature.shape == (fields.time.size, 1, fields.y.size, fields.x.size)
    hottest = fields.temperature[fields.hottest]
    assert fields.temperature.max() == hottest.max()
    # the highest between two samples and between two points may be a little higher
    assert hottest.max() == pytest.approx(float(kept.line("point_temperature")[-1]), abs=0.5)
    assert fields.nearest() == fields.hottest
    assert fields.nearest(float(fields.time[3]) + 1e-3) == 3


def covered(response, number: int, plate: int = 0) -> np.ndarray:
    """Which points are under the slider at one of the moments."""
    fields = response.fields
    sample = int(np.abs(response.time - fields.time[number]).argmin())
    x, y = response.bearing.shares[plate] * response.displacement_vectors[sample]
    across, up = np.meshgrid(fields.x - x, fields.y - y)
    return np.hypot(across, up) <= 0.5 * response.bearing.slider_diameter


@pytest.mark.parametrize("radii", [None, (3000.0, 6000.0)])
def test_their_mean_under_the_slider_is_the_temperature_of_the_contact(station, kept, radii) -> None:
    response = kept if radii is None else respond(station, Bearing(radii=radii), keep=Keep(profiles=8))
    fields = response.fields
    assert fields.temperature.shape[1] == (1 if radii is None else 2)
    for number, time in enumerate(fields.time):
        sample = int(np.abs(response.time - time).argmin())
        for plate in range(fields.temperature.shape[1]):
            mean = fields.temperature[number, plate][covered(response, number, plate)].mean()
            # a point at the rim more or less
            assert mean == pytest.approx(response.plate_temperatures[sample, plate], abs=0.1)


def test_they_hold_all_that_was_ever_hot(kept) -> None:
    fields = kept.fields
    ambient = kept.heating.ambient
    reach = 0.5 * kept.bearing.slider_diameter + 0.5 * np.abs(kept.displacement_vectors[:, 0])
    assert fields.x.max() <= reach.max() + 8.0
    assert fields.temperature.min() >= ambient - 1e-3
    edges = [fields.temperature[..., 0, :], fields.temperature[..., -1, :]]
    assert all(float(edge.max()) < fields.temperature.max() for edge in edges)


def test_their_interval_can_be_chosen(station) -> None:
    fields = respond(station, keep=Keep(every=400)).fields
    assert fields is not None
    apart = 400 * station.time_step
    for number in range(1, 5):  # and the hottest moment between two of these
        assert np.abs(fields.time - number * apart).min() < 1e-9
    with pytest.raises(InputError, match="precise"):
        respond(station, heating="simplified", keep=Keep(every=400))
    assert respond(station, heating="simplified", keep=PLATES).fields is None


def test_they_go_on_from_a_warm_plate(station, kept) -> None:
    later = respond(station, start=kept.final_state, keep=Keep(profiles=4))
    assert later.fields is not None
    assert later.fields.time[0] < later.time[-1]
    number = later.fields.time.size - 1
    sample = int(np.abs(later.time - later.fields.time[number]).argmin())
    mean = later.fields.temperature[number, 0][covered(later, number)].mean()
    assert mean == pytest.approx(later.plate_temperatures[sample, 0], abs=0.1)


def test_a_data_set_has_them_with_units(kept) -> None:
    dataset = kept.to_dataset()
    one = dataset["plate_temperature"]
    assert one.dims == ("profile_time", "plate", "plate_y", "plate_x")
    assert one.attrs["units"] == "degC"
    assert dataset["plate_x"].attrs["units"] == "mm"
    np.testing.assert_array_equal(one, kept.fields.temperature)
