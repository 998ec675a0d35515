"""Figures draw without a warning, carry units, use the axes that they are given, and leave nothing behind."""

import itertools
import sys
from dataclasses import replace
from pathlib import Path

import matplotlib as mpl
import pytest
from matplotlib.figure import Figure

from dcfp import ConstantFriction, NoHeating, PreciseHeating, load_motion, respond
from dcfp.analysis import Response
from dcfp.analysis.integration import Keep
from dcfp.errors import InputError
from dcfp.present.figures import (
    plot_displacement,
    plot_energies,
    plot_friction,
    plot_loop,
    plot_motions,
    plot_overview,
    plot_profile,
    plot_response,
    plot_temperature,
    plot_velocities,
    save_figure,
)
from dcfp.present.figures.style import drawable
from dcfp.present.panels import shown
from dcfp.schema.formulas import metres_per_second, millimetres, typeset

LABELS = {
    plot_loop: ("$y$ [mm]", "$F$ [kN]"),
    plot_velocities: ("$t$ [s]", "$v$ [m/s]"),
    plot_displacement: ("$t$ [s]", "$y$ [mm]"),
    plot_temperature: ("$t$ [s]", "$T$ [°C]"),
    plot_friction: ("$t$ [s]", r"$\mu$"),
    plot_energies: ("$t$ [s]", "$E$ [kN m]"),
    plot_profile: ("$t$ [s]", "$x$ [mm]"),
}


@pytest.fixture(scope="module")
def response() -> Response:
    return respond(load_motion("NCC").scaled_to_pgv(750.0))


@pytest.fixture(scope="module")
def precise() -> Response:
    return respond(load_motion("NCC").scaled_to_pgv(500.0), heating=PreciseHeating(), keep=Keep(every=20))


@pytest.mark.parametrize("draw", LABELS, ids=lambda draw: draw.__name__)
def test_each_uses_the_axes_given_and_carries_units(draw, precise: Response) -> None:
    axes = Figure().add_subplot()
    assert draw(precise, axes) is axes
    assert (axes.get_xlabel(), axes.get_ylabel()) == LABELS[draw]
    axes.get_figure().draw_without_rendering()


@pytest.mark.parametrize("draw", LABELS, ids=lambda draw: draw.__name__)
def test_each_makes_its_own_axes(draw, precise: Response, tmp_path: Path) -> None:
    save_figure(draw(precise).figure, tmp_path / "a.png")
    assert (tmp_path / "a.png").stat().st_size > 5000


@pytest.mark.slow
def test_the_user_s_settings_and_pyplot_are_left_alone(
    response: Response, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = dict(mpl.rcParams)
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)  # so that it cannot be imported
    save_figure(plot_response(response), tmp_path / "a.png")
    plot_loop(response)  # on axes of its own
    assert dict(mpl.rcParams) == before


def test_a_loop_is_coloured_by_temperature_or_by_time(response: Response) -> None:
    cold = respond(response.motion, friction=ConstantFriction(), heating=NoHeating())
    for which, colour, label in (
        (response, None, "$T$ [°C]"),
        (response, "time", "$t$ [s]"),
        (cold, None, "$t$ [s]"),
    ):
        axes = plot_loop(which, colour=colour)
        assert axes.child_axes[0].get_ylabel() == label
    assert plot_loop(response, colour_bar=False).child_axes == []


def test_the_peak_is_written_and_the_capacity_drawn_where_it_is_near(response: Response) -> None:
    axes = plot_displacement(response)
    assert [text.get_text() for text in axes.texts] == [millimetres(response.peak_displacement)]
    assert axes.get_legend() is None
    tight = replace(
        response,
        system=replace(response.system, bearing=replace(response.bearing, displacement_capacity=200.0)),
    )
    axes = plot_displacement(tight)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["capacity"]
    assert axes.get_ylim()[1] > 200.0


def test_energies_fill_up_to_the_input(response: Response) -> None:
    axes = plot_energies(response)
    top = max(float(path.vertices[:, 1].max()) for area in axes.collections for path in area.get_paths())
    assert top == pytest.approx(float(response.energy.input[shown(response)].max()) / 1e6, rel=1e-6)


def test_a_profile_needs_one(response: Response) -> None:
    with pytest.raises(InputError, match="precise"):
        plot_profile(response)


@pytest.mark.slow
def test_a_figure_is_always_the_same_in_every_format(precise: Response, tmp_path: Path) -> None:
    # a loop has lines in colours, a raster and a scale; sheets in every format are drawn by `dcfp respond`
    for form, draw in (("png", plot_response), ("pdf", plot_loop), ("svg", plot_loop)):
        first, second = (tmp_path / f"{place}.{form}" for place in (1, 2))
        for file in (first, second):
            save_figure(draw(precise).figure, file)
        assert first.read_bytes() == second.read_bytes(), form
    for dated in (b"CreationDate", b"<dc:date>"):  # by the second, in which both may have been saved
        assert not any(dated in file.read_bytes() for file in tmp_path.iterdir())


@pytest.mark.slow
def test_nothing_on_a_sheet_is_cut_off_or_overlaps(response: Response) -> None:
    note = "largest amplitude tested by Li et al. (2020), Table 2; the paper prints no capacity"
    bearing = replace(response.bearing, displacement_capacity=100.0, capacity_note=note)
    limited = replace(response, system=replace(response.system, bearing=bearing))
    figure = plot_response(limited)
    figure.draw_without_rendering()
    left, right = figure.subfigs[1].subfigs
    panels = [axes.get_tightbbox() for axes in right.axes]
    for above, below in itertools.pairwise(panels):
        assert above.y0 >= below.y1
    loop, notes = left.axes
    assert len(limited.remarks) >= 1
    assert len(notes.texts) == 1 + len(limited.remarks)
    for text in notes.texts:
        box = text.get_window_extent()
        assert figure.bbox.x0 < box.x0
        assert box.x1 < min(panel.x0 for panel in panels)
        assert figure.bbox.y0 < box.y0
        assert box.y1 <= loop.get_tightbbox().y0
    assert all(figure.bbox.x1 >= panel.x1 for panel in panels)


@pytest.mark.slow
def test_names_with_odd_characters_are_drawn(response: Response, tmp_path: Path) -> None:
    origin = replace(response.motion.origin, station="仙台 $x_$ station", event="日本")
    odd = replace(response, motion=replace(response.motion, name="a_b$c{", origin=origin))
    save_figure(plot_response(odd), tmp_path / "a.png")
    save_figure(plot_overview([odd, odd]), tmp_path / "b.png")
    assert drawable("abc \U0010fffd d") == "abc d"
    assert drawable("a name too long", 9) == "a name t…"


def test_of_a_joined_name_what_is_alike_stands_once_and_the_ends_stay() -> None:
    name = "AOM0031801241951 E-W+AOM0031801241951 N-S"
    assert drawable(name, 50) == drawable(name) == name
    assert drawable(name, 30) == "AOM0031801241951 E-W+N-S"
    assert drawable(name, 16) == "AOM00318…E-W+N-S"
    assert drawable("KNA+P695-FF-7-b", 11) == "KNA+P…F-7-b"
    assert drawable("east.AT2+eastern.AT2", 15) == "east.AT…ern.AT2"


def test_an_overview_is_a_table_of_records_and_velocities() -> None:
    motions = [load_motion(name) for name in ("NCC", "KNA")]
    responses = [respond(motion.scaled_to_pgv(pgv)) for motion in motions for pgv in (250.0, 500.0, 750.0)]
    figure = plot_overview(responses)
    panels = figure.axes[:6]
    assert [panel.get_title() for panel in panels[:3]] == ["PGV 0.25 m/s", "PGV 0.50 m/s", "PGV 0.75 m/s"]
    assert [panels[0].get_ylabel(), panels[3].get_ylabel()] == ["NCC", "KNA"]
    assert len({panel.get_xlim() for panel in panels}) == 1
    for panel, response in zip(panels, responses, strict=True):
        words = panel.texts[0].get_text()
        assert words == f"{millimetres(response.peak_displacement)}\n{typeset(response.peak_temperature)} °C"
    assert figure.get_supxlabel() == "$y$ [mm]"
    assert figure.get_supylabel() == "$F$ [kN]"


@pytest.mark.slow
def test_an_overview_of_records_as_they_are_names_each_panel(tmp_path: Path) -> None:
    responses = [respond(load_motion(name)) for name in ("NCC", "KNA", "LPG")]
    figure = plot_overview(responses)
    assert [panel.get_title() for panel in figure.axes[:3]] == [
        "NCC, 0.45 m/s",
        "KNA, 0.37 m/s",
        "LPG, 0.45 m/s",
    ]
    save_figure(figure, tmp_path / "a.svg")


def test_the_quiet_ends_of_a_response_are_left_out() -> None:
    response = respond(load_motion("LPG").scaled_to_pgv(500.0), tail=60.0)
    part = shown(response)
    assert part.start == 0
    assert response.time[part.stop - 1] < 0.5 * response.time[-1]
    assert response.energy.hysteretic[part][-1] > 0.998 * response.energy.hysteretic[-1]


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        (typeset(-0.2), "0"),
        (typeset(-3.26, 1), "−3.3"),
        (millimetres(123.4), "123 mm"),
        (millimetres(-4.56), "−4.6 mm"),
        (millimetres(0.0456), "0.05 mm"),
        (metres_per_second(500.0), "0.50 m/s"),
        (metres_per_second(3.0), "0.003 m/s"),
    ],
)
def test_numbers_in_words(written: str, expected: str) -> None:
    assert written == expected


@pytest.mark.slow
def test_motions_stand_beside_each_other_with_their_peaks() -> None:
    motion = load_motion("NCC")
    figure = plot_motions([motion] * 5)
    figure.draw_without_rendering()
    assert sum(axes.axison for axes in figure.axes) == 15
    assert figure.axes[0].get_ylabel() == "$a_g$ [m/s²]"
    assert "0.45 m/s" in [text.get_text() for text in figure.axes[4].texts]
    with pytest.raises(InputError, match="at most 12"):
        plot_motions([motion] * 13)
