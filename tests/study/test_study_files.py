"""A study file: what it means, and the sentence for whatever is wrong with it."""

from pathlib import Path

import numpy as np
import pytest

import dcfp
from dcfp.errors import InputError
from dcfp.study import Choice, Normal, Plan, Sampling, Study, Uniform, read_study
from dcfp.study.factors import catalogue, is_of_system

RECORD = '[factors]\nrecord = ["NCC"]\n'


def read(tmp_path: Path, text: str) -> Study:
    path = tmp_path / "mine.toml"
    path.write_text(text, encoding="utf-8")
    return read_study(path)


def refused(tmp_path: Path, text: str) -> str:
    with pytest.raises(InputError) as caught:
        read(tmp_path, text)
    sentence = str(caught.value)
    assert "\n" not in sentence
    return sentence


@pytest.mark.parametrize(
    ("line", "name", "values"),
    [
        ('pgv = { values = [0.25, 0.5], unit = "m/s" }', "pgv", [250.0, 500.0]),
        ('pgv = { values = [10], unit = "inch/s" }', "pgv", [254.0]),
        ('pgv = { from = 0.1, to = 2.0, count = 20, unit = "m/s" }', "pgv", [100.0 * i for i in range(1, 21)]),
        ('pgv = { from = 10, to = 1000, count = 3, spacing = "log", unit = "mm/s" }', "pgv", [10.0, 100.0, 1000.0]),
        ('pga = { values = [0.5], unit = "g_0" }', "pga", [4903.325]),
        ("scale = [0.5, 2]", "scale", [0.5, 2.0]),
        ("scale = 1.5", "scale", [1.5]),
        ("pgv = [0.5, 0.07]", "pgv", [500.0, 70.0]),
        ("stiffness = [1900]", "stiffness", [1.9e6]),
        ('radius = { values = [15], unit = "ft" }', "radius", [4572.0]),
        ('pressure = { values = [60], unit = "MPa" }', "pressure", [60.0]),
        ('pressure = { values = [60], unit = "N/mm2" }', "pressure", [60.0]),
        ('pressure = { values = [10], unit = "ksi" }', "pressure", [68.94757293168362]),
        ('stiffness = { values = [1900], unit = "kN/mm" }', "stiffness", [1.9e6]),
        ('ambient = { values = [14, 104], unit = "degF" }', "ambient", [-10.0, 40.0]),
        ('conductivity = { values = [16], unit = "W/(m*K)" }', "conductivity", [16.0]),
        ('diffusivity = { values = [4.07e-6], unit = "m**2/s" }', "diffusivity", [4.07]),
        ("lambda = [0.85, 1.3]", "lambda", [0.85, 1.3]),
        ('mu = { values = [5], unit = "percent" }', "mu", [0.05]),
        ('heating = ["none", "precise"]', "heating", ["none", "precise"]),
        ('heating = "Precise"', "heating", ["precise"]),
        ('radius = "4.5 m"', "radius", [4500.0]),
        ('stiffness = ["1900 kN/mm", 2000, "1.8e6 N/mm"]', "stiffness", [1.9e6, 2.0e6, 1.8e6]),
        ('radius = { from = "3 m", to = 6000, count = 2 }', "radius", [3000.0, 6000.0]),
    ],
)  # fmt: skip
def test_values_come_in_the_units_of_the_package(tmp_path, line: str, name: str, values: list) -> None:
    found = read(tmp_path, RECORD + line).factors[name]
    assert found == (values if isinstance(values[0], str) else pytest.approx(values, rel=1e-12))


def test_a_range_has_the_digits_that_were_meant(tmp_path) -> None:
    study = read(tmp_path, RECORD + 'pgv = { from = 0.1, to = 1.0, count = 10, unit = "m/s" }')
    assert study.factors["pgv"] == [100.0, 200.0, 300.0, 400.0, 500.0, 600.0, 700.0, 800.0, 900.0, 1000.0]


def test_the_order_of_the_dimensions_is_that_of_the_file(tmp_path) -> None:
    text = '[factors]\nmu = [0.05]\npgv = { values = [0.5], unit = "m/s" }\nrecord = ["NCC", "KNA"]\n'
    assert list(Plan(read(tmp_path, text)).sizes.items()) == [("mu", 1), ("pgv", 1), ("record", 2)]


def test_a_set_is_all_its_records(tmp_path) -> None:
    study = read(tmp_path, '[factors]\nrecord = ["P695-FF"]\n')
    assert len(study.motions) == 44
    assert study.factors["record"][0] == "P695-FF-1-a"


def test_files_are_found_from_the_folder_of_the_study(tmp_path, record_file: Path, monkeypatch) -> None:
    (tmp_path / "b.toml").write_text("radius = 3000\ncapacity = 300\n", encoding="utf-8")
    monkeypatch.chdir("/")
    text = f'[factors]\nrecord = ["{record_file.name}"]\nbearing = ["b.toml"]\n[motion]\nunits = "m/s2"\n'
    plan = Plan(read(tmp_path, text))
    (model,) = plan.models_at_ends()
    assert (model.bearing.radii, model.bearing.displacement_capacity) == ((3000.0, 3000.0), 300.0)


def test_the_bearing_of_the_study(tmp_path) -> None:
    text = (
        RECORD + "[bearing]\nradius = 3000\ncapacity = 350\n[bearing.friction]\nlaw = 'constant'\nmu = 0.06\n"
    )
    model = read(tmp_path, text).model
    assert model.bearing.radii == (3000.0, 3000.0)
    assert model.friction == dcfp.ConstantFriction(0.06)


def test_without_a_bearing_it_is_that_of_the_paper(tmp_path) -> None:
    assert read(tmp_path, RECORD).model.bearing == dcfp.LI_2020


def test_sampled_factors(tmp_path) -> None:
    text = RECORD + (
        '[sampling]\nmethod = "sobol"\ncount = 16\nseed = 3\n[sampling.factors]\n'
        'radius = { from = 2, to = 6, unit = "m" }\n'
        'mu = { distribution = "lognormal", median = 0.075, dispersion = 0.2 }\n'
        'ambient = { distribution = "normal", mean = "68 degF", standard_deviation = "9 degF" }\n'
        'pressure = { distribution = "log-uniform", from = 30, to = 90, unit = "MPa" }\n'
        'heating = ["none", "simplified"]\n'
    )
    assert read(tmp_path, text).sampling == Sampling(
        {
            "radius": Uniform(2000.0, 6000.0),
            "mu": Normal(0.075, 0.2, logarithmic=True),
            "ambient": Normal(20.0, 5.0),
            "pressure": Uniform(30.0, 90.0, logarithmic=True),
            "heating": Choice(("none", "simplified")),
        },
        16,
        "sobol",
        3,
    )


def test_parameters_of_the_law(tmp_path) -> None:
    text = RECORD + '[factors.friction]\nmu = [0.04, 0.05]\n[bearing.friction]\nlaw = "constant"\n'
    plan = Plan(read(tmp_path, text))
    assert [model.friction for model in plan.models_at_ends()] == [
        dcfp.ConstantFriction(0.04),
        dcfp.ConstantFriction(0.05),
    ]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (RECORD + "pgw = [1]", "there is no factor 'pgw'; did you mean 'pgv'?"),
        (RECORD + 'pgv = { values = [5], unit = "m" }', "'pgv' is in m/s, with which 'm' is not compatible"),
        (RECORD + 'mu = { values = [0.05], unit = "mm" }', "'mu' is in no unit, with which 'mm' is not compatible"),
        (RECORD + 'pgv = { values = [5], unit = "mph/banana" }', "'mph/banana' is not a unit"),
        (RECORD + 'pgv = { values = [5], unit = "" }', "'pgv' is in m/s, with which '' is not compatible"),
        (RECORD + 'pgv = { values = [5], unit = 3 }', "factor 'pgv': unit: unit of plain numbers must be a text, not 3"),
        (RECORD + 'pgv = { values = [], unit = "m/s" }', "factor 'pgv' has no value; give it at least one"),
        (RECORD + "mu = []", "factor 'mu' has no value; give it at least one"),
        ("[factors]\nrecord = []", "factor 'record' has no value; name at least one record"),
        ("[factors]\nmu = [0.05]", "there is no factor 'record'; name at least one"),
        ("", "there is no factor 'record'; name at least one"),
        ('[factors]\nrecord = ["NCX"]', "there is no record named 'NCX'"),
        ('[factors]\nrecord = ["NCC", "P695-FF-2-b"]', "P695-FF-2-b: this is the same record as NCC; name it once"),
        ('[factors]\nrecord = ["NCC", "NCC"]', "NCC: this is named twice; name it once"),
        (RECORD + "mu = [0.05, 0.05]", "factor 'mu' has the value 0.05 twice; give it once"),
        (RECORD + "mu = [1.5]", "factor 'mu' must be a number above 0 and up to 0.9999, not 1.5"),
        (RECORD + 'pgv = { values = [500], unit = "m/s" }', "factor 'pgv' must be a number of m/s from 0.005 to 20, not 500 (were mm/s meant?)"),
        (RECORD + 'mu = ["a"]', "factor 'mu' must be a number above 0 and up to 0.9999, not 'a'"),
        (RECORD + "mu = [true]", "factor 'mu' must be a number above 0 and up to 0.9999, not True"),
        (RECORD + "mu = [nan]", "factor 'mu' must be a number above 0 and up to 0.9999, not nan"),
        (RECORD + "law = [3]", "factor 'law' must be one of constant, li2020, constantinou1990, fitted, kumar2015, kim2023-third, kim2023-two-thirds, lomiento2013, not 3"),
        (RECORD + 'law = ["li2021"]', "lomiento2013, not 'li2021'"),
        (RECORD + 'heating = ["hot"]', "factor 'heating' must be one of simplified, precise, none, not 'hot'"),
        (RECORD + 'procedure = ["guess"]', "factor 'procedure' must be one of analysis, pulse, simplified"),
        (RECORD + 'heating = { values = ["none"], unit = "m" }', "factor 'heating' takes words, which have no unit"),
        (RECORD + 'bearing = ["nowhere.toml"]', "there is no such file"),
        (RECORD + "mu = { from = 0.1, to = 0.2 }", "factor 'mu' needs 'count'; it has from, to, count, spacing, unit"),
        (RECORD + "mu = { from = 0.1, to = 0.2, count = 0 }", "count: number of values must be a whole number from 1 to 1e+06, not 0"),
        (RECORD + "mu = { from = 0.1, count = 3 }", "factor 'mu' needs 'to'"),
        (RECORD + "mu = { from = 0.1, to = 0.2, steps = 3 }", "factor 'mu': there is no key of a range 'steps'; the choices are count, spacing, unit"),
        (RECORD + "mu = { values = [0.1], count = 3 }", "factor 'mu': there is no key beside values 'count'"),
        (RECORD + 'mu = { from = 0.1, to = 0.2, count = 3, spacing = "cubic" }', "spacing: spacing must be one of linear, log, not 'cubic'"),
        (RECORD + 'scale = { from = 0, to = 2, count = 3 }', "factor 'scale': from must be a number from 0.001 to 1000, not 0"),
        (RECORD + 'ambient = { from = -10, to = 20, count = 3, spacing = "log" }', "must be of positive numbers"),
        (RECORD + 'radius = "4500 m"', "factor 'radius' must be a number of mm from 100 to 1e+06, not '4500 m'"),
        (RECORD + 'radius = [[3000, 4500]]', "factor 'radius' must be a number of mm from 100 to 1e+06"),
        (RECORD + 'scale = [1]\npgv = { values = [0.5], unit = "m/s" }', "pgv and scale both scale the ground motions"),
        (RECORD + 'friction = { mu_9 = [1.0] }', "there is no factor 'friction.mu_9'; did you mean 'friction.mu_0'?"),
        (RECORD + 'slider = { values = [9500], unit = "mm" }', "slider = 9500: the slider diameter"),
        (RECORD + 'thickness = { values = [20, 500], unit = "mm" }', "must be a number of mm from 10 to 200, not 500"),
        (RECORD + "[sampling]\ncount = 3\n", "nothing is sampled; give at least one factor"),
        (RECORD + "[sampling.factors]\nmu = { from = 0.1, to = 0.2 }", "[sampling] needs a count"),
        (RECORD + "[sampling]\ncount = 3.5\n[sampling.factors]\nmu = [0.1]", "number of samples must be a whole number from 1 to 1e+06, not 3.5"),
        (RECORD + '[sampling]\ncount = 3\nmethod = "dice"\n[sampling.factors]\nmu = [0.1]', "must be one of latin-hypercube"),
        (RECORD + '[sampling]\ncount = 3\nmethod = "sobol"\n[sampling.factors]\nmu = [0.1]', "power of two samples, for example 2 or 4"),
        (RECORD + "[sampling]\ncount = 3\nseed = -1\n[sampling.factors]\nmu = [0.1]", "seed of the random numbers must be a whole number of at least 0, not -1"),
        (RECORD + "mu = [0.1]\n[sampling]\ncount = 3\n[sampling.factors]\nmu = [0.1]", "both in the grid and sampled"),
        (RECORD + "[sampling]\ncount = 3\n[sampling.factors]\nmu = { from = 0.2, to = 0.1 }", "from a smaller to a larger number"),
        (RECORD + "[sampling]\ncount = 3\n[sampling.factors]\nmu = { from = 0.2, to = 1.2 }", "must be a number above 0 and up to 0.9999, not 1.2"),
        (RECORD + '[sampling]\ncount = 3\n[sampling.factors]\nmu = { distribution = "cauchy" }', "must be one of uniform, log-uniform"),
        (RECORD + '[sampling]\ncount = 3\n[sampling.factors]\nmu = { distribution = "normal", mean = 0.1 }', "factor 'mu' needs 'standard_deviation'; it has mean"),
        (RECORD + '[sampling]\ncount = 3\n[sampling.factors]\nheating = { from = 1, to = 2 }', "factor 'heating' takes words"),
        (RECORD + "[analysis]\ntolerance = 2", "must be a number above 0 and up to 0.9999, not 2"),
        (RECORD + '[analysis]\ntail = "long"', "time after the record must be a number of s from 0 to 3600, not 'long'"),
        (RECORD + "[analysis]\nstride = 2", "[analysis]: there is no parameter of an analysis 'stride'; did you mean 'step'?"),
        (RECORD + "[analysis]\nstep = -1.0", "longest step must be a number of s from 1e-06 to 10, not -1"),
        (RECORD + "[keep]\nhistories = 'displacement'", "histories must be a list"),
        (RECORD + "[keep]\nhistories = ['drift']", "there is no history 'drift'"),
        (RECORD + "[bearing]\nradius = -3", "[bearing]"),
        (RECORD + "[bearing]\ncolour = 3", "there is no parameter of a bearing 'colour'"),
        (RECORD + "[bearing]\nfile = 'no.toml'", "there is no such file"),
        (RECORD + "[bearing]\nfile = 'no.toml'\nradius = 3", "'radius' has no place beside it"),
        ("facts = 3\n" + RECORD, "there is no part of a study file 'facts'; did you mean 'factors'?"),
        ("factors = 3", "'factors' must be a table, written [factors]"),
        ("title = 3\n" + RECORD, "title must be a text, not 3"),
        (RECORD + "mu = [", "this is not TOML"),
        (RECORD + 'law = [["li2020"]]', "lomiento2013, not ['li2020']"),
        (RECORD + 'procedure = [["analysis"]]', "iwan, not ['analysis']"),
        (RECORD + 'pgv = { values = [5], unit = "(" }', "'(' is not a unit"),
        (RECORD + 'pgv = { values = [5], unit = "m/0" }', "'m/0' is not a unit"),
        (RECORD + 'pgv = { values = [5], unit = "9**9**9" }', "'9**9**9' is not a unit"),
        (RECORD + 'pga = { values = [5], unit = "g" }', "the acceleration of gravity is 'g_0', and 'g' the gram"),
        (RECORD + 'mu = { values = [0.1], unit = "dB" }', "'mu' is in no unit, with which 'dB' is not compatible"),
        (RECORD + "mu = [1" + "0" * 400 + "]", "factor 'mu' must be a number above 0 and up to 0.9999, not 1000"),
        (RECORD + "mu = { from = 1e400, to = 2, count = 2 }", "factor 'mu': from must be a number above 0 and up to 0.9999, not inf"),
        (RECORD + 'pgv = { values = [0.5, 0.5], unit = "m/s" }', "factor 'pgv' has the value 0.5 m/s twice"),
        (RECORD + 'radius = { values = [3], unit = "m" }\nlower_radius = { values = [3], unit = "m" }', "have no place beside it"),
        (RECORD + 'heating = ["none"]\nthickness = { values = [50], unit = "mm" }', "without heating 'thickness' changes nothing"),
        (RECORD + 'procedure = ["pulse"]\n[keep]\nhistories = ["force"]', "histories are of the procedure 'analysis'"),
        (RECORD + '[sampling]\ncount = 3\n[sampling.factors]\nmu = { distribution = ["normal"] }', "must be one of uniform"),
        (RECORD + "[sampling]\ncount = 2000000000\n[sampling.factors]\nmu = [0.1]", "must be a whole number from 1 to 1e+06, not 2000000000"),
        (RECORD + "mu = { from = 0.01, to = 0.9, count = 40000 }\nlambda = { from = 0.1, to = 1, count = 40000 }", "the study has 1.6e+09 analyses, more than 1e+09"),
    ],
)  # fmt: skip
def test_what_is_wrong_gets_one_sentence(tmp_path, text: str, words: str) -> None:
    sentence = refused(tmp_path, text)
    assert words in sentence
    assert sentence.startswith(str(tmp_path / "mine.toml"))


def test_a_file_that_is_not_there(tmp_path) -> None:
    with pytest.raises(InputError, match=r"there is no such file; a study is a TOML file; dcfp study new"):
        read_study(tmp_path / "none.toml")


def test_a_record_that_drifts_is_not_scaled_to_a_pgv(motions) -> None:
    drifting = dcfp.GroundMotion(motions[0].acceleration + 300.0, 0.01, "drifting")
    Study(motions=[drifting], factors={"scale": [1.0]})
    with pytest.raises(InputError, match="drifting: the ground still moves"):
        Study(motions=[drifting], factors={"pgv": [500.0]})


def test_the_catalogue_changes_what_it_says(motions) -> None:
    """Every factor of the model changes the model, and none of the others does."""
    values = {
        "radius": 3000.0, "lower_radius": 3000.0, "upper_radius": 3000.0, "slider": 300.0, "pressure": 40.0,
        "stiffness": 1e6, "law": "kumar2015", "mu": 0.05, "lambda": 1.2, "heating": "precise", "ambient": 0.0,
        "conductivity": 18.0, "diffusivity": 5.0, "thickness": 50.0,
    }  # fmt: skip
    plain = Plan(Study(motions=motions)).models_at_ends()[0]
    for name, value in values.items():
        (model,) = Plan(Study(motions=motions, factors={name: [value]})).models_at_ends()
        assert model != plain, name
    names = {name for name in catalogue() if is_of_system(name)}
    assert {name for name in names if not name.startswith("friction.")} == {*values, "bearing"}


def test_a_law_is_chosen_before_its_reference_is_changed(motions) -> None:
    factors = {"lambda": [1.2], "mu": [0.05], "law": ["kumar2015"]}
    (model,) = Plan(Study(motions=motions, factors=factors)).models_at_ends()
    assert model.friction.name == "kumar2015"
    assert model.friction.reference == pytest.approx(0.06, rel=1e-15)


def test_the_parts_of_a_bearing_are_checked_together(motions) -> None:
    """A slider of 300 mm fits on a radius of 200 mm, on which one of 400 mm, that of the paper, would not."""
    for names in (("radius", "slider"), ("slider", "radius")):
        factors = {name: [{"radius": 200.0, "slider": 300.0}[name]] for name in names}
        (model,) = Plan(Study(motions=motions, factors=factors)).models_at_ends()
        assert (model.bearing.radii, model.bearing.slider_diameter) == ((200.0, 200.0), 300.0)


def test_new_plates_do_not_have_the_capacity_of_the_papers(motions) -> None:
    def capacity(**factors) -> float | None:
        (model,) = Plan(Study(motions=motions, factors=factors)).models_at_ends()
        return model.bearing.displacement_capacity

    assert capacity(mu=[0.05]) == 440.0
    assert capacity(radius=[4500.0]) is None  # beside others that have none it would not be fair
    assert capacity(radius=[3000.0]) is None


def test_arrays_are_as_good_as_lists(motions) -> None:
    study = Study(motions=motions, factors={"mu": np.array([0.04, 0.05])})
    assert study.factors["mu"] == [0.04, 0.05]
