"""``dcfp predict`` of a station from end to end."""

import json
import math

import pytest


def test_a_station_in_the_plane_and_by_its_directions(run):
    (told,) = json.loads(run("predict", "P695-FF-2", "--pgv", "0.5", "--json").out)
    (analysed,) = json.loads(run("respond", "P695-FF-2", "--pgv", "0.5", "--json").out)
    assert (told["record"], told["heating"]) == ("P695-FF-2", "precise")
    march, srss, *others = told["predictions"]
    assert [march["method"], srss["method"]] == ["plane march", "directions, SRSS"]
    assert [(one["method"], one["basis"]) for one in others] == [
        ("design", "PGV only"),
        ("pulse", "blind"),
        ("simplified", "blind"),
    ]
    (line,) = json.loads(run("predict", "--pgv-only", "0.5", "--heating", "precise", "--json").out)
    assert others[0]["dy_mm"] == pytest.approx(line["predictions"][0]["dy_mm"], rel=1e-9)
    assert others[0]["direction_deg"] is None
    assert all(0.0 <= one["direction_deg"] < 180.0 for one in others[1:])
    assert march["y_mm"] == pytest.approx(analysed["y_max_mm"], rel=0.1)
    assert march["dy_mm"] == pytest.approx(analysed["dy_max_mm"], rel=0.1)
    assert march["V_dE_mm_s"] is None
    assert march["interval"] is None
    assert told["interval_from_spectrum"] is None
    assert 50 < march["nodes"] < 100
    # of the same factor as the station
    factor = (
        march["y_mm"]
        / json.loads(run("predict", "P695-FF-2", "--pgv", "0.5", "--heating", "none", "--json").out)[0][
            "predictions"
        ][0]["y_mm"]
    )
    assert factor != 1.0
    assert srss["y_mm"] < march["y_mm"]
    assert srss["V_E_mm_s"] == pytest.approx(march["V_E_mm_s"], rel=0.15)
    assert math.isfinite(srss["dy_mm"])


def test_the_table_says_what_a_reader_must_know(run):
    outcome = run("predict", "P695-FF-5", "--pgv", "1.0", "--heating", "simplified")
    assert outcome.status == 0
    assert "plane march" in outcome.out
    text = " ".join(outcome.out.split())
    assert (
        "The methods of Li et al. (2020) are of one direction: those of pulses are put to 12 directions"
        in text
    )
    assert "goes beyond the capacity of 440 mm" in text


def test_as_csv(run, tmp_path):
    file = tmp_path / "said.csv"
    assert run("predict", "P695-FF-2", "--pgv", "0.5", "--heating", "none", "--out", file).status == 0
    head, *lines = file.read_text().splitlines()
    assert "nodes" in head
    assert len(lines) == 5


@pytest.mark.parametrize("command", ["predict", "compare"])
def test_a_figure_is_of_one_station_at_one_pgv(run, tmp_path, command):
    file = tmp_path / "a.png"
    words = (command, "P695-FF-2", "--heating", "none", "--plot", file, "--pgv", "0.5")
    outcome = run(*words, "1.0")
    assert outcome.status == 2
    assert "--plot draws one station at one PGV, not 2" in outcome.err
    assert not file.exists()
    assert run(*words).status == 0
    assert file.stat().st_size > 20_000


def test_the_options_of_the_methods_act_on_a_station(run):
    words = ("predict", "P695-FF-2", "--pgv", "0.5", "--heating", "none", "--json")
    (usual,) = json.loads(run(*words).out)
    (other,) = json.loads(run(*words, "--nominal-mu", "0.05", "--threshold", "0.4", "--eps", "0.5").out)
    usual, other = ({one["method"]: one["dy_mm"] for one in said["predictions"]} for said in (usual, other))
    assert other["plane march"] == usual["plane march"]
    for method in ("design", "pulse", "simplified"):
        assert other[method] != pytest.approx(usual[method], rel=1e-3)


def test_stations_and_components_do_not_go_together(run):
    outcome = run("predict", "P695-FF-2", "NCC")
    assert outcome.status == 2
    assert "give only stations" in outcome.err


def test_intervals_of_a_station_know_its_spectrum_and_leave_out_its_own_earthquake(run):
    words = (
        "predict",
        "P695-FF-2",
        "--pgv",
        "0.5",
        "--interval",
        "--heating",
        "none",
        "--friction",
        "constant",
    )
    (told,) = json.loads(run(*words, "--json").out)
    (analysed,) = json.loads(run("respond", *words[1:4], *words[5:], "--json").out)
    by_spectrum, march = told["interval_from_spectrum"], told["predictions"][0]["interval"]
    for key, truth in (("dy_mm", "dy_max_mm"), ("y_mm", "y_max_mm"), ("V_E_mm_s", "V_E_mm_s")):
        for one in (by_spectrum[key], march[key]):
            assert one["low"] < analysed[truth] < one["high"]
            assert one["cases"] == 50 - 6  # of Northridge
        widths = [math.log(one[key]["high"] / one[key]["low"]) for one in (march, by_spectrum)]
        assert widths[0] < 0.6 * widths[1]
    assert any("6 of the 50 stations" in remark for remark in told["remarks"])
    text = " ".join(run(*words).out.split())
    assert "Intervals hold 90 % of analyses of this bearing in the plane" in text
