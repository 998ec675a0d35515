"""Figures of pulses and predictions draw real cases without a warning, and what is missing does not stop them."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from dcfp import GroundMotion, PreciseHeating, load_motion, respond
from dcfp.errors import InputError
from dcfp.inference import Case, compare
from dcfp.inference.case import analysed_of
from dcfp.methods import NOTHING, PulseMarch, find_pulses, march_through_pulses
from dcfp.methods.li_2020 import LI_2020, predict_from_pgv
from dcfp.methods.li_2020.constants import DESIGN, PULSE
from dcfp.methods.method import Information, Variant
from dcfp.present.figures import plot_comparison, plot_pulses, save_figure
from dcfp.present.figures.li_2020 import PaperFigure, marks_of, paper_figures
from dcfp.present.figures.predictions import plot_pgv_prediction

PGVS = (250.0, 1000.0)


@pytest.fixture(scope="module")
def cases() -> list[Case]:
    return [
        compare(load_motion(name).scaled_to_pgv(pgv), keep_response=True)
        for name in ("KNA", "NCC", "LPG", "IVD")
        for pgv in PGVS
    ]


@pytest.fixture(scope="module")
def still() -> Case:
    """The pulses are too weak to make anything slide."""
    time = np.arange(0.0, 4.0, 0.01)
    motion = GroundMotion(2.0 * np.sin(np.pi * time), 0.01, name="still")
    return compare(motion, keep_response=True)


@pytest.fixture(scope="module")
def silent() -> Case:
    """The response never turns, and no method could be used."""
    response = respond(GroundMotion(np.zeros(200), 0.01, name="silent"))
    pulses = find_pulses(response.motion)
    return Case("silent", "none", 1.0, pulses, analysed_of(response, pulses), {}, response=response)


@pytest.fixture(scope="module")
def figures(cases: list[Case]) -> list[PaperFigure]:
    loops = {}
    for pgv in PGVS:
        motion = load_motion("NCC").scaled_to_pgv(pgv)
        loops["NCC", pgv] = (respond(motion), respond(motion, heating=PreciseHeating()))
    return paper_figures(cases, loops)


def march_of(case: Case) -> PulseMarch:
    motion = case.response.motion
    return march_through_pulses(motion, with_path=True)


def assert_all_is_inside(figure: Figure) -> None:
    """Nothing that is written is cut off, and no panel covers another."""
    figure.draw_without_rendering()
    width, height = figure.bbox.x1, figure.bbox.y1
    boxes = [axes.get_tightbbox() for axes in figure.axes]
    for box in boxes:
        assert box.x0 > -1.0
        assert box.y0 > -1.0
        assert box.x1 < width + 1.0
        assert box.y1 < height + 1.0
    panels = [axes.bbox for axes in figure.axes]
    for i, one in enumerate(panels):
        assert all(not one.overlaps(other) for other in panels[i + 1 :])
    for legend in figure.legends:
        box = legend.get_window_extent()
        assert box.x1 < width + 1.0
        assert all(not box.overlaps(panel) for panel in panels)


def points_are_within(figure: Figure) -> bool:
    """Every point that is drawn as a mark lies within the limits."""
    for axes in figure.axes:
        (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
        for line in axes.lines:
            if line.get_linestyle() != "None":
                continue
            x, y = (np.asarray(values, dtype=float) for values in line.get_data())
            if not ((left <= x) & (x <= right) & (low <= y) & (y <= high)).all():
                return False
    return True


# ----- pulses -----


@pytest.mark.slow
def test_pulses_and_what_they_do_share_their_time(cases: list[Case]) -> None:
    for case in (cases[0], cases[3], cases[7]):  # the weakest, one between, and the strongest
        figure = plot_pulses(case, march_of(case))
        assert_all_is_inside(figure)
        ground, velocities, displacement = figure.axes
        first, last = ground.get_xlim()
        assert ground.get_xlim() == displacement.get_xlim()
        assert first <= case.analysed.swing.start < case.analysed.swing.end <= last
        assert displacement.get_xlabel() == "$t$ [s]"
        assert [axes.get_ylabel() for axes in figure.axes] == ["$v_g$ [m/s]", "$v$ [m/s]", "$y$ [mm]"]
        (area,) = (one for one in velocities.collections if str(one.get_label()).startswith("area"))
        vertices = area.get_paths()[0].vertices
        across, up = vertices[:, 0], vertices[:, 1]
        enclosed = 0.5 * abs(np.dot(across, np.roll(up, 1)) - np.dot(up, np.roll(across, 1)))
        assert 1e3 * enclosed == pytest.approx(case.analysed.whole.displacement_change, rel=0.02)


def test_the_pulses_that_govern_are_named_once_where_they_are_one(cases: list[Case]) -> None:
    two, one = (
        [text.get_text() for text in plot_pulses(cases[which]).axes[0].get_legend().get_texts()]
        for which in (2, 4)
    )
    assert len(two) == 2
    assert len(one) == 1
    assert "in the analysis" in one[0]


@pytest.mark.slow
def test_no_pulse_and_no_swing_are_said_and_do_not_fail(still: Case, silent: Case) -> None:
    assert silent.analysed.swing is None
    assert silent.pulses.count == 0
    for case in (still, silent):
        figure = plot_pulses(case)
        assert_all_is_inside(figure)
        by_method, behind_swing = (text.get_text() for text in figure.axes[0].get_legend().get_texts())
        assert by_method.endswith("none")
        assert behind_swing.endswith("none") == (case.analysed.pulse is None)


def test_an_analysis_that_was_not_kept_is_asked_for(cases: list[Case]) -> None:
    without = replace(cases[0], response=None)
    with pytest.raises(InputError, match="keep_response"):
        plot_pulses(without)
    assert isinstance(plot_pulses(without, response=cases[0].response), Figure)


# ----- comparison -----


@pytest.mark.slow
@pytest.mark.parametrize(
    "number", [1, 8, 240]
)  # one, each once in large marks, and so many that they are small
def test_predicted_against_analysed(cases: list[Case], number: int) -> None:
    figure = plot_comparison([cases[i % len(cases)] for i in range(number)])
    assert len(figure.axes) == 4
    assert_all_is_inside(figure)
    assert points_are_within(figure)
    for axes in figure.axes:
        assert axes.get_xlim() == axes.get_ylim()
        labels = [text.get_text().split(":")[0] for text in axes.get_legend().get_texts()]
        assert labels == ["pulse", "simplified", "design", "pulse march"]


def test_where_nothing_is_predicted_it_lies_hollow_on_the_edge_and_counts(cases: list[Case]) -> None:
    blind = Variant(PULSE, Information.BLIND)
    nothing = replace(NOTHING, displacement_change=0.0, input_velocity=0.0, hysteretic_velocity=0.0)
    changed = [replace(cases[0], predicted={**cases[0].predicted, blind: nothing}), *cases[1:]]
    axes = plot_comparison(changed).axes[0]
    assert axes.get_legend().get_texts()[0].get_text().endswith("(1 none)")
    hollow = [line for line in axes.lines if line.get_markerfacecolor() == "white"]
    assert [list(line.get_ydata()) for line in hollow] == [[axes.get_ylim()[0]]]


@pytest.mark.slow
def test_a_comparison_of_nothing(still: Case, silent: Case) -> None:
    for several in ([silent], [still, silent]):  # no prediction at all, and of nothing
        assert_all_is_inside(plot_comparison(several))
    with pytest.raises(InputError, match="at least one case"):
        plot_comparison([])


def test_a_method_that_cannot_be_used_is_not_in_the_legend(cases: list[Case]) -> None:
    usable = {variant: one for variant, one in cases[0].predicted.items() if variant.method != DESIGN}
    texts = plot_comparison([replace(cases[0], predicted=usable)]).axes[0].get_legend().get_texts()
    assert len(texts) == 3


# ----- the figures of the paper -----


@pytest.mark.slow
def test_every_figure_of_the_paper_is_drawn(figures: list[PaperFigure], tmp_path: Path) -> None:
    numbers = [one.number for one in figures]
    assert numbers == ["10", "11", "13", "14", "15", "18", "19", "20", "22", "23", "24", "25", "26", "27"]
    for one in figures:
        assert one.words.endswith(".")
        assert one.title
    for one in figures[:7:3]:  # one of loops, of histories and of points; the next test draws all
        save_figure(one.figure, tmp_path / f"{one.number}.png")
        assert (tmp_path / f"{one.number}.png").stat().st_size > 4000


@pytest.mark.slow
def test_nothing_in_them_is_cut_off(figures: list[PaperFigure]) -> None:
    for one in figures:
        assert_all_is_inside(one.figure)
        if one.number not in ("13", "14", "15"):
            assert points_are_within(one.figure), one.number


def test_each_record_looks_the_same_in_all(figures: list[PaperFigure], cases: list[Case]) -> None:
    marks = marks_of(cases)
    assert len({mark.marker for mark in marks.values()}) == len(marks)
    assert marks_of(cases[2:])["NCC"] == marks["NCC"]
    for one in figures:
        for legend in one.figure.legends[: one.number != "10"]:
            drawn = {line.get_label(): (line.get_marker(), line.get_color()) for line in legend.get_lines()}
            assert drawn == {name: (mark.marker, mark.colour) for name, mark in marks.items()}


def test_the_lines_are_those_of_the_equations(figures: list[PaperFigure]) -> None:
    by_number = {one.number: one.figure.axes for one in figures}
    for number, panel, label, value in (
        ("26", 0, "Eq. (31)", lambda one: one.input_velocity / 1e3),
        ("26", 1, "Eq. (32)", lambda one: one.hysteretic_velocity / 1e3),
        ("27", 0, "Eq. (33)", lambda one: one.displacement_change),
    ):
        (line,) = (one for one in by_number[number][panel].lines if one.get_label() == label)
        for pgv, drawn in zip(*line.get_data(), strict=True):
            assert drawn == pytest.approx(value(predict_from_pgv(1e3 * pgv)))
    curves = {str(line.get_label()): line for line in by_number["19"][0].lines}
    at, drawn = curves[r"$\varepsilon=0.25$"].get_data()
    assert np.interp(0.25, at, drawn) == pytest.approx((1.25 * 0.25 / 0.5) ** 0.5, rel=1e-3)


@pytest.mark.slow
def test_one_case_no_pulse_and_many_records(cases: list[Case], still: Case, silent: Case) -> None:
    many = [replace(cases[i % 8], record=f"P695_FF-{i + 10}-a$") for i in range(12)]
    for several, drawn in (
        ([still], ("13", "20")),
        ([silent], ("11", "14", "19", "26")),
        ([cases[0], still, silent], ("18", "19", "20", "25", "26", "27")),
    ):
        found = {one.number: one for one in paper_figures(several, {})}
        assert len(found) == 13
        for number in drawn:
            assert_all_is_inside(found[number].figure)
    assert "of 3 analyses: 1 without" in found["19"].words
    # the names of records are above all figures of a width in the same way
    for several, numbers in (([cases[0]], ["18"]), (many[:8], ["11", "26"]), (many, ["26"])):
        for one in paper_figures(several, {}, numbers=numbers):
            assert_all_is_inside(one.figure)
    with pytest.raises(InputError, match="at least one case"):
        paper_figures([], {})
    assert [one.number for one in paper_figures([cases[0]], {}, numbers=["26", "14", "10"])] == ["14", "26"]


def test_constants_without_a_simplified_method_draw_no_line_for_it(cases: list[Case]) -> None:
    rough = replace(LI_2020, nominal_friction=0.12)
    figures = {one.number: one.figure for one in paper_figures(cases[:1], {}, rough)}
    for number in ("20", "26", "27"):
        assert all(axes.get_legend() is None for axes in figures[number].axes)


# ----- the PGV alone -----


@pytest.mark.slow
def test_the_design_method_with_and_without_intervals() -> None:
    pgvs = [500.0, 250.0, 1000.0]
    predictions = [predict_from_pgv(pgv) for pgv in pgvs]
    band = [(0.5 * pgv, pgv, 2.0 * pgv) for pgv in pgvs]
    for intervals in (None, dict.fromkeys(("dy", "V_dE", "V_dEhr"), band)):
        figure = plot_pgv_prediction(pgvs, predictions, intervals)
        assert_all_is_inside(figure)
        (line,) = (one for one in figure.axes[0].lines if one.get_label() == "design method")
        assert list(line.get_xdata()) == [0.25, 0.5, 1.0]
        assert list(line.get_ydata()) == sorted(one.displacement_change for one in predictions)
    one = plot_pgv_prediction(pgvs[:1], predictions[:1], {"dy": band[:1]})
    assert_all_is_inside(one)


@pytest.mark.slow
def test_figures_know_nothing_of_kernels_and_of_windows_when_they_are_imported() -> None:
    code = """
import importlib, pkgutil, sys
import dcfp.present.figures as figures, dcfp.present.figures.li_2020, dcfp.present.figures.predictions
late = ("dcfp.analysis", "dcfp.inference", "dcfp.methods", "numba")
assert not [name for name in sys.modules if name.startswith(late)]
for one in pkgutil.iter_modules(figures.__path__):
    importlib.import_module(f"{figures.__name__}.{one.name}")
assert "matplotlib.pyplot" not in sys.modules
"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=120
    )
    assert done.returncode == 0, done.stderr
