"""``dcfp compare`` of stations from end to end."""

import csv
import json
import math

import numpy as np
import pytest

CONSTANT = ("--friction", "constant", "--heating", "none")


def test_every_prediction_stands_beside_the_analysis(run, tmp_path):
    words = ("compare", "P695-FF-2", "P695-FF-5", "--pgv", "0.5", "1.0", *CONSTANT)
    file = tmp_path / "compared.csv"
    told = json.loads(run(*words, "--json", "--out", file).out)
    assert [(one["record"], one["pgv_m_s"]) for one in told["cases"]] == [
        (name, pgv) for name in ("P695-FF-2", "P695-FF-5") for pgv in (0.5, 1.0)
    ]
    (analysed,) = json.loads(run("respond", "P695-FF-5", "--pgv", "1.0", *CONSTANT, "--json").out)
    (said,) = json.loads(run("predict", "P695-FF-5", "--pgv", "1.0", *CONSTANT, "--json").out)
    case = told["cases"][-1]
    for key, truth in (("y_mm", "y_max_mm"), ("dy_mm", "dy_max_mm"), ("V_E_mm_s", "V_E_mm_s")):
        assert case["analysis"][key] == pytest.approx(analysed[truth], rel=1e-3)
    for prediction, alone in zip(case["predictions"], said["predictions"], strict=True):
        assert prediction["method"] == alone["method"]
        assert prediction["dy_mm"] == alone["dy_mm"]
        bound = prediction["dy_mm"] if prediction["y_mm"] is None else prediction["y_mm"]
        assert prediction["ratios"]["y"] == pytest.approx(bound / case["analysis"]["y_mm"], rel=1e-3)
    # the scatter is that of the ratios
    (march,) = (one for one in told["scatter"] if (one["method"], one["quantity"]) == ("plane march", "y"))
    ratios = np.log([one["predictions"][0]["ratios"]["y"] for one in told["cases"]])
    assert march["cases"] == 4
    assert march["bias"] == pytest.approx(math.exp(ratios.mean()), rel=1e-12)
    assert march["dispersion"] == pytest.approx(ratios.std(ddof=1), rel=1e-12)
    lines = list(csv.DictReader(file.read_text().splitlines()))
    assert len(lines) == 4 * 6
    assert [one["method"] for one in lines[:2]] == ["analysis", "plane march"]


def test_as_a_table(run):
    text = " ".join(run("compare", "P695-FF-2", "--pgv", "0.5", *CONSTANT).out.split())
    assert "analysis" in text
    assert "directions, SRSS" in text
    assert "Prediction over the analysis" not in text  # of one case there is no scatter


def test_the_same_station_counts_once(run):
    told = json.loads(run("compare", "P695-FF-2", "P695-FF-2", "--pgv", "0.5", *CONSTANT, "--json").out)
    assert len(told["cases"]) == 1


def test_halves_are_of_single_components(run):
    outcome = run("compare", "P695-FF-2", "--pgv", "0.5", "--held-out")
    assert outcome.status == 2
    assert "--held-out is for single components" in outcome.err


def test_stations_and_components_do_not_go_together(run):
    outcome = run("compare", "P695-FF-2", "NCC")
    assert outcome.status == 2
    assert "give only stations" in outcome.err
