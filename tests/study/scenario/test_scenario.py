"""A scenario: read, written, read again, calculated."""

from pathlib import Path

import pytest

import dcfp
from dcfp.analysis.integration import Keep
from dcfp.errors import InputError
from dcfp.study.scenario import Heading, calculate, read_scenario, scenario_toml
from dcfp.system import System

TEXT = """
title = "Tower A"
[factors]
record = ["NCC", "KNA"]
pgv = { values = [0.25, 0.5], unit = "m/s" }
[bearing]
radius = 3000
capacity = 300
[bearing.heating]
model = "precise"
[report]
project = "Tower"
author = "A. Engineer"
"""


def write(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "scenario.toml"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.slow
def test_every_result_is_that_of_the_parts_alone(tmp_path) -> None:
    scenario = read_scenario(write(tmp_path, TEXT))
    assert scenario.heading == Heading(project="Tower", author="A. Engineer")
    calculation = calculate(scenario)
    names = [(one.motion.name, one.motion.peak_velocity) for one in calculation.results]
    assert names == [
        ("NCC", pytest.approx(250.0)),
        ("NCC", pytest.approx(500.0)),
        ("KNA", pytest.approx(250.0)),
        ("KNA", pytest.approx(500.0)),
    ]
    one = calculation.results[1]
    # the temperature along the plates is looked at on the way, between samples: the last digit may differ
    alone = dcfp.respond(
        one.motion, scenario.model.bearing, heating=dcfp.PreciseHeating(), keep=Keep(every=1000)
    )
    assert one.response.peak_displacement == pytest.approx(alone.peak_displacement, rel=1e-12)
    assert one.response.profiles is not None
    assert one.case.analysed.whole.displacement == one.response.peak_displacement
    assert calculation.summary[1]["y_max_mm"] == one.response.peak_displacement


@pytest.mark.parametrize(
    "model",
    [
        System(),
        System(dcfp.Bearing((3000.0, 2500.0), 350.0, 45.0, 1.2e6, 500.0, "tested", "Tower A"), dcfp.Kumar2015(), dcfp.PreciseHeating(ambient=-10.0, thickness=50.0)),
        System(friction=dcfp.ConstantFriction(0.06), heating=dcfp.NoHeating()),
        System(friction=dcfp.FittedFriction()),
    ],
)  # fmt: skip
def test_what_is_written_reads_back_as_the_same(tmp_path, model: System) -> None:
    heading = Heading(project='A "quoted" name', notes="two\nlines")
    text = scenario_toml(["NCC"], model, title="T", pgvs=[250.0, 500.0], heading=heading)
    scenario = read_scenario(write(tmp_path, text))
    assert scenario.model == model
    assert scenario.heading == heading
    assert scenario.study.factors == {"record": ["NCC"], "pgv": [250.0, 500.0]}


def test_a_date_of_toml_is_its_own_text(tmp_path) -> None:
    assert read_scenario(write(tmp_path, TEXT + "date = 2026-01-31\n")).heading.date == "2026-01-31"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (TEXT.replace("[bearing]", "mu = [0.05, 0.06]\n[bearing]"), "a scenario has one bearing, but factor 'mu' has 2 values"),
        (TEXT + "[sampling]\ncount = 2\n[sampling.factors]\nmu = [0.05]\n", "a scenario has one bearing, but there is a [sampling]"),
        (TEXT.replace("[bearing]", 'procedure = ["analysis"]\n[bearing]'), "leave out the factor 'procedure'"),
        (TEXT.replace("values = [0.25, 0.5]", "from = 0.1, to = 1, count = 21"), "at most 40 analyses, not 42"),
        (TEXT + 'colour = "red"\n', "[report]: there is no parameter of a report 'colour'; the choices are project, client"),
        (TEXT.replace('"A. Engineer"', "5"), "[report]: author: who has calculated it must be a text, not 5."),
        (TEXT.replace('"A. Engineer"', "2026-01-31"), "[report]: author: who has calculated it must be a text, not datetime.date(2026, 1, 31)."),
        ("report = 3\n" + TEXT.split("[report]")[0], "'report' must be a table"),
    ],
)  # fmt: skip
def test_what_is_wrong_gets_one_sentence(tmp_path, text: str, words: str) -> None:
    path = write(tmp_path, text)
    with pytest.raises(InputError) as caught:
        read_scenario(path)
    assert words in str(caught.value)
    assert str(caught.value).startswith(str(path))
