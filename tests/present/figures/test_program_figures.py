"""Figures of several tests: one colour scale for all, any number of models, and points that lie on their law."""

import numpy as np
import pytest
from matplotlib.text import Text

from dcfp.analysis.rig import Program, RigTest, Sine, VerticalLoad, load_program, run_program
from dcfp.errors import InputError
from dcfp.present.figures.overviews import plot_dependency, plot_tests
from dcfp.system import LI_2020, Li2020, NoHeating, PreciseHeating, SimplifiedHeating

HEATINGS = {"precise": PreciseHeating(), "simplified": SimplifiedHeating(), "none": NoHeating()}


@pytest.fixture(scope="module")
def program() -> Program:
    return load_program("dependency")


@pytest.fixture(scope="module")
def runs(program):
    return {name: run_program(program, LI_2020, Li2020(), heating) for name, heating in HEATINGS.items()}


@pytest.mark.slow
@pytest.mark.parametrize("models", [1, 2, 4])  # 4 are more than there are models of heating
def test_any_number_of_models_is_drawn(program, runs, models) -> None:
    shown = dict([*runs.items(), ("again", runs["none"])][:models])
    figure = plot_tests(program, shown, {})
    figure.draw_without_rendering()
    assert len(figure.legends) == (models > 1)
    plot_dependency(program, shown, {}).draw_without_rendering()


def test_one_test_that_heats_gives_all_the_scale_of_temperature(program, runs) -> None:
    mixed = [runs["none"][0], *runs["simplified"][1:]]
    bar = plot_tests(program, {"mixed": mixed}, {}).axes[-1]
    assert bar.get_ylabel() == "$T$ [°C]"
    low, high = bar.get_ylim()
    assert 19.0 < low < 21.0
    assert high == pytest.approx(max(float(test.temperature.max()) for test in mixed), abs=1.0)


def test_points_lie_on_the_factors_of_the_law(program, runs) -> None:
    figure = plot_dependency(program, runs, {})
    for axes in figure.axes[:2]:
        curve = axes.lines[0].get_xydata()
        for point in axes.lines[1:]:
            ((x, y),) = point.get_xydata()
            assert y == pytest.approx(np.interp(x, *curve.T), rel=2e-3)


def test_a_program_without_the_tests_is_refused() -> None:
    program = Program("short", (RigTest("a", Sine(100.0, 50.0, 2), VerticalLoad((60.0,))),))
    with pytest.raises(InputError, match="no tests for both"):
        plot_dependency(program, {"one": run_program(program)}, {})


@pytest.mark.slow
def test_a_long_name_stays_above_its_panel() -> None:
    tests = [RigTest(f"{i} of a long name {'x' * 40}", Sine(50.0, 50.0, 1), VerticalLoad((60.0,))) for i in range(10)]  # fmt: skip
    program = Program("long", tuple(tests))
    figure = plot_tests(program, {"one": run_program(program)}, {})
    figure.draw_without_rendering()
    bar = figure.axes[-1].get_window_extent()
    titles = [text for text in figure.findobj(Text) if "of a long name" in text.get_text()]
    assert len(titles) == 10
    assert all(title.get_window_extent().x1 < bar.x0 for title in titles)
