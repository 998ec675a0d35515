"""Figures in the plane: what their axes are called, one range of colours for one temperature, and a path of the force that can be read."""

import pytest

from dcfp import respond
from dcfp.analysis.rig import Circle, Program, RigTest, run_in_the_plane
from dcfp.present.figures.plane import plot_orbit, plot_orbits, plot_plane_response
from dcfp.present.figures.plane_tests import plot_plane_program


@pytest.fixture(scope="module")
def response():
    return respond("P695-FF-22", pgv=300.0, heating="simplified")


def test_axes_are_called_by_direction_and_symbol(response) -> None:
    for of, symbol, unit in (("displacement", "y", "mm"), ("force", "F", "kN")):
        axes = plot_orbit(response, of=of)
        assert axes.get_xlabel() == f"direction x,  ${symbol}_1$ [{unit}]"
        assert axes.get_ylabel() == f"direction y,  ${symbol}_2$ [{unit}]"
    labels = [text.get_text() for part in plot_plane_response(response).subfigs for axes in part.axes if axes.get_legend() for text in axes.get_legend().get_texts()]  # fmt: skip
    assert {"direction x, $y_1$", "direction y, $y_2$", "direction x, $v_{g,1}$"} <= set(labels)


def test_a_force_is_in_colour_while_the_friction_works(response) -> None:
    whole, part = (plot_orbit(response, of="force", between=ends) for ends in ((0.0, 1.0), (0.05, 0.95)))
    work = response.histories["hysteretic_energy"].of(response)
    strong = int(((work >= 0.05 * work[-1]) & (work <= 0.95 * work[-1])).sum())
    counts = [len(axes.collections[0].get_segments()) for axes in (whole, part)]
    assert counts[1] == pytest.approx(strong, abs=1)
    assert counts[1] < 0.7 * counts[0]
    pale = part.lines[-1]
    assert len(pale.get_xdata()) == counts[0] + 1
    assert len(part.lines) == len(whole.lines) + 1


def test_several_have_one_scale_and_names_that_fit(response) -> None:
    joined = respond("P695-FF-7-a+P695-FF-7-b", pgv=300.0, heating="simplified")
    figure = plot_orbits([response, joined])
    *panels, bar = figure.axes
    assert [one.get_title().split("\n")[0] for one in panels] == ["P695-FF-22", "P695-FF-7-a+P695-FF-7-b"]
    norms = [one.collections[0].norm for one in panels]
    ends = [min(one.temperature.min() for one in (response, joined)), max(one.temperature.max() for one in (response, joined))]  # fmt: skip
    for norm in norms:
        assert [norm.vmin, norm.vmax] == ends
    assert "T" in bar.get_ylabel()


def test_tests_of_a_program_have_one_range_of_colours_in_all_columns() -> None:
    tests = tuple(
        RigTest(name, Circle(radius, 400.0, 1)) for name, radius in (("small", 40.0), ("large", 150.0))
    )
    loops = run_in_the_plane(program := Program("two", tests))
    figure = plot_plane_program(program, loops)
    norms = {(one.norm.vmin, one.norm.vmax) for axes in figure.axes[:6] for one in axes.collections[:1]}
    assert norms == {(20.0, max(float(one.fields.temperature.max()) for one in loops))}
