"""The picture of a plate: its own temperatures, where the slider is, and the hottest point with its value."""

import numpy as np
import pytest

from dcfp import InputError, respond
from dcfp.analysis.integration import Keep
from dcfp.present.figures import plot_field, plot_plane_response


@pytest.fixture(scope="module")
def response():
    return respond("P695-FF-2", pgv=1000.0, keep=Keep(profiles=4))


def test_the_hottest_moment_with_the_slider_and_its_hottest_point(response) -> None:
    axes, fields = plot_field(response), response.fields
    mesh, levels = axes.collections
    np.testing.assert_allclose(
        mesh.get_array().reshape(fields.y.size, -1), fields.temperature[fields.hottest, 0]
    )
    assert 20.0 < min(levels.levels) < max(levels.levels) < fields.temperature.max()
    path, rim, dot = (np.column_stack(line.get_data()) for line in axes.lines)
    sample = int(np.abs(response.time - fields.time[fields.hottest]).argmin())
    np.testing.assert_allclose(path[-1], 0.5 * response.displacement_vectors[sample])
    np.testing.assert_allclose(np.hypot(*(rim - path[-1]).T), 0.5 * response.bearing.slider_diameter)
    row, column = np.unravel_index(
        fields.temperature[fields.hottest, 0].argmax(), (fields.y.size, fields.x.size)
    )
    np.testing.assert_allclose(dot[0], [fields.x[column], fields.y[row]])
    words = [one.get_text() for one in axes.texts]
    assert f"{fields.temperature.max():.0f} °C" in words
    assert axes.get_aspect() == 1.0
    assert axes.get_xlabel() == "direction x, on the plate [mm]"


def test_any_moment_that_was_kept(response) -> None:
    fields = response.fields
    axes = plot_field(response, float(fields.time[0]))
    assert f"{fields.time[0]:.2f} s" in [one.get_text() for one in axes.texts]


def test_the_sheet_has_it_where_it_was_kept(response) -> None:
    plain = respond("P695-FF-2", pgv=1000.0, heating="none")
    counts = [sum(len(part.axes) for part in plot_plane_response(one).subfigs) for one in (response, plain)]
    assert counts[0] == counts[1] + 1
    with pytest.raises(InputError, match="not kept"):
        plot_field(plain)
