"""Figures of assessments draw what they are given without a warning, and nothing that is written is cut off."""

from io import BytesIO
from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure

from dcfp.errors import InputError
from dcfp.present.figures import save_figure
from dcfp.present.figures.assessment import (
    plot_bounds,
    plot_design_chart,
    plot_fragility,
    plot_ida,
    plot_sensitivity,
)
from dcfp.study.assessment import bounds, design_space, fragility, ida, select, sensitivity

pytestmark = pytest.mark.slow


def assert_all_is_inside(figure: Figure) -> None:
    """Nothing that is written is cut off, no panel covers another, and the legend covers none."""
    figure.draw_without_rendering()
    width, height = figure.bbox.x1, figure.bbox.y1
    boxes = [axes.get_tightbbox() for axes in figure.axes]
    boxes += [legend.get_window_extent() for legend in figure.legends]
    for box in boxes:
        assert min(box.x0, box.y0) > -1.0
        assert box.x1 < width + 1.0
        assert box.y1 < height + 1.0
    for i, one in enumerate(boxes):
        assert all(not one.overlaps(other) for other in boxes[i + 1 :])


def figure_of(axes: Any) -> Figure:
    assert isinstance(axes.figure, Figure)
    return axes.figure


def labels_of(axes: Any) -> list[str]:
    return [text.get_text() for text in axes.get_legend().get_texts()]


def test_ida_draws_every_record_the_quantiles_and_the_capacity(records):
    found = ida(records)
    axes = plot_ida(found)
    assert_all_is_inside(figure_of(axes))
    assert labels_of(axes) == ["capacity, 600 mm", "40 records", "first beyond the capacity", "median"]
    assert [text.get_text() for text in axes.texts] == ["16 %", "50 %", "84 %"]
    lines = [line for line in axes.lines if line.get_linewidth() == 0.4]
    assert len(lines) == 40
    np.testing.assert_array_equal(lines[3].get_xdata(), found["peak_displacement"][3])
    np.testing.assert_allclose(lines[3].get_ydata(), found["pgv"] / 1e3)
    hollow = [line for line in axes.lines if line.get_marker() == "o"]
    assert len(hollow) == found["beyond_capacity"].any("pgv").sum()
    assert axes.get_xlabel() == "largest displacement of the isolation layer, $y_{\\mathrm{max}}$ [mm]"
    assert axes.get_ylabel() == "peak ground velocity [m/s]"


def test_ida_without_a_capacity_and_of_another_result(build, strengths):
    study = build({"record": 40, "scale": [0.5, 1.0]}, strength=strengths, capacity=None)
    axes = plot_ida(ida(study, "peak_temperature", (0.5, 0.9)))
    assert labels_of(axes) == ["40 records", "median"]
    assert_all_is_inside(figure_of(axes))


def test_fragility_draws_curve_band_and_fractions(records):
    found = fragility(records, [300.0, 600.0, 9000.0])
    axes = plot_fragility(found)
    assert_all_is_inside(figure_of(axes))
    median, beta = float(found["median"][1]) / 1e3, float(found["total_dispersion"][1])
    assert labels_of(axes)[1] == rf"600 mm: $\theta$ = {median:.3g} m/s, $\beta$ = {beta:.2f}"
    assert labels_of(axes)[2] == "9000 mm: no fit"
    title = axes.get_legend().get_title().get_text()
    assert title.startswith(r"$\theta$: median, $\beta$: dispersion; marks: observed in 40 records")
    squares = next(line for line in axes.lines if line.get_marker() == "s")
    np.testing.assert_array_equal(squares.get_ydata(), found["fraction"][1])
    assert len(axes.collections) == 3


def test_fragility_without_bounds_draws_too(records):
    axes = plot_fragility(fragility(records.isel(record=slice(6))))
    assert_all_is_inside(figure_of(axes))


def test_axes_that_are_given_are_used(records):
    axes = Figure().add_subplot()
    assert plot_ida(ida(records), axes) is axes
    assert plot_fragility(fragility(records), axes=axes) is axes


@pytest.mark.parametrize(
    "names", [("force_ratio",), ("peak_displacement", "force_ratio", "peak_temperature")]
)
def test_bounds_draw_a_panel_for_each_result(properties, names):
    found = bounds(properties, quantities=names)
    figure = plot_bounds(found)
    assert_all_is_inside(figure)
    panels = [axes for axes in figure.axes if axes.axison]
    assert len(panels) == len(names)
    nominal = panels[0].lines[0]
    np.testing.assert_allclose(nominal.get_ydata(), found[f"{names[0]}_nominal"][0])
    told = [text.get_text() for text in figure.legends[0].get_texts()]
    assert told[:2] == ["nominal, lambda 1, ambient 20 °C", "envelope, median of the records"]
    assert set(told[2:]) == {"lambda 0.8, ambient 40 °C", "lambda 1.6, ambient -10 °C"}
    assert "full the largest, hollow the least" in figure.legends[0].get_title().get_text()


def test_bounds_of_another_quantile(properties):
    figure = plot_bounds(bounds(properties), 0.84)
    told = [text.get_text() for text in figure.legends[0].get_texts()]
    assert told[1] == "envelope, what 84 % of the records do not exceed"


def test_sensitivity_draws_a_panel_for_each_intensity(sampled):
    found = sensitivity(sampled)
    figure = plot_sensitivity(found)
    assert_all_is_inside(figure)
    assert [axes.get_title() for axes in figure.axes] == ["PGV 0.25 m/s", "PGV 0.5 m/s", "PGV 1 m/s"]
    assert len({axes.get_xlim() for axes in figure.axes}) == 1
    assert figure.axes[0].get_xlim()[1] >= 1.0
    widths = [bar.get_width() for bar in figure.axes[1].patches]
    np.testing.assert_allclose(widths, np.concatenate([found[name][:, 1] for name in ("S1", "ST")]))
    one = plot_sensitivity(sensitivity(select(sampled, {"pgv": 500.0})))
    assert len(one.axes) == 1
    assert_all_is_inside(one)


def test_sensitivity_over_two_factors_is_refused(sampled):
    found = sensitivity(sampled).expand_dims(radius=[1500.0, 3000.0], axis=2)
    with pytest.raises(InputError, match="pgv and radius are left; choose values first"):
        plot_sensitivity(found)


def test_the_chart_has_the_panels_that_its_records_allow(bearings):
    few = plot_design_chart([design_space(bearings.isel(record=slice(10)), 500.0)], 150.0)
    assert [axes.get_title() for axes in few.axes] == ["PGV 0.50 m/s, half of the earthquakes"]
    many = plot_design_chart([design_space(bearings, 500.0)], 150.0)
    assert len(many.axes) == 2


def test_a_chart_without_a_line_of_a_round_number_draws_too(build):
    grid = {"record": 4, "pgv": [500.0], "radius": [4400.0, 4500.0], "mu": [0.06, 0.061]}
    space = design_space(build(grid), 500.0)
    figure = plot_design_chart([space], 150.0)
    assert_all_is_inside(figure)
    assert plot_design_chart([space], 1000.0).axes


def test_the_same_figure_is_the_same_file(records):
    files = [BytesIO(), BytesIO()]
    for file in files:
        save_figure(figure_of(plot_fragility(fragility(records))), file, "svg")
    assert files[0].getvalue() == files[1].getvalue()
