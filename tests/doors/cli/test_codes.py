"""``dcfp codes`` from end to end, and the codes inside ``dcfp compare``."""

import csv
import json

import pytest

METHODS = ["ASCE 7-16 ELF", "Eurocode 8 simplified", "AIJ method 1", "AIJ method 2", "AIJ energy balance"]


def test_a_record_by_every_method_beside_its_analysis(run):
    (panel,) = json.loads(run("codes", "NCC", "--pgv", "0.5", "--json").out)
    assert [said["method"] for said in panel["answers"]][: len(METHODS)] == METHODS
    assert panel["analysis"]["displacement_mm"] == pytest.approx(89.1, abs=0.1)
    for said in panel["answers"]:
        assert said["verdict"]
        assert said["displacement_mm"] > 0.0
        # F/W = mu + D/R, on the backbone of the pendulum
        force = panel["friction"] + said["displacement_mm"] / panel["radius_mm"]
        if said["method"] in METHODS:
            assert said["base_shear_over_weight"] == pytest.approx(force)
    text = run("codes", "NCC", "--pgv", "0.5").out
    assert text.count("outside its limits") >= 2


def test_iterations_and_conditions_are_shown(run):
    text = run("codes", "--asce", "1.5", "0.6", "--details").out
    assert "Round" in text
    assert "unconfirmed" in text
    (panel,) = json.loads(run("codes", "--asce", "1.5", "0.6", "--json").out)
    elf = panel["answers"][0]
    last = elf["iteration"][-1]
    assert last["displacement_mm"] == pytest.approx(elf["displacement_mm"])
    # D_M = g S_M1 T_M / (4 pi^2 B_M) on the branch of constant velocity: Eq. (17.5-1)
    by_hand = 9806.65 * 0.6 * last["period_s"] / (4.0 * 3.141592653589793**2) * last["reduction"]
    assert elf["displacement_mm"] == pytest.approx(by_hand, rel=1e-8)
    verdicts = {one["name"]: one["verdict"] for one in elf["conditions"]}
    assert verdicts["site class"] == "not known"


def test_what_is_told_of_the_building_changes_the_verdicts(run):
    def verdicts(*words: str) -> dict[str, str]:
        (panel,) = json.loads(run("codes", "--asce", "1.5", "0.6", *words, "--json").out)
        return {one["name"]: one["verdict"] for said in panel["answers"] for one in said["conditions"]}

    assert verdicts("--site-class", "F")["site class"] == "not met"
    assert verdicts("--site-class", "c")["site class"] == "met"
    assert verdicts("--height", "30")["height of the structure above"] == "not met"
    assert verdicts("--plan", "60")["larger dimension of the plan"] == "not met"


def test_bounds_give_displacement_from_the_lower_and_force_from_the_worse(run):
    def elf(*words: str) -> dict[str, float]:
        (panel,) = json.loads(run("codes", "--asce", "1.5", "0.6", *words, "--json").out)
        return panel["answers"][0]

    nominal, bounded = elf(), elf("--bounds", "0.7", "1.8")
    assert bounded["displacement_mm"] > nominal["displacement_mm"]
    assert bounded["base_shear_over_weight"] >= nominal["base_shear_over_weight"]


def test_a_spectrum_from_a_file_table_and_figure(run, tmp_path):
    file, table, figure = (tmp_path / name for name in ("mine.csv", "table.csv", "figure.png"))
    file.write_text("period [s],acceleration [g]\n0.1,1.0\n0.6,1.0\n6.0,0.1\n")
    assert run("codes", "--spectrum", file, "--out", table, "--plot", figure).status == 0
    rows = list(csv.DictReader(table.read_text().splitlines()))
    assert [row["method"] for row in rows] == METHODS
    assert all(row["verdict"] for row in rows)
    assert figure.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("words", [("--eurocode", "3.0", "--ground", "C", "--type", "2"), ("--japan", "2")])
def test_other_design_spectra(run, words):
    (panel,) = json.loads(run("codes", *words, "--json").out)
    assert len(panel["answers"]) + len(panel["without_solution"]) == len(METHODS)


def test_the_codes_stand_in_the_comparison_with_their_verdicts(run):
    told = json.loads(run("compare", "NCC", "LPG", "--pgv", "0.5", "--json").out)
    for case in told["cases"]:
        assert [said["method"] for said in case["codes"]][: len(METHODS)] == METHODS
        assert all(said["verdict"] for said in case["codes"])
    methods = {row["method"] for row in told["scatter"]}
    assert methods >= set(METHODS)
    text = run("compare", "NCC", "--pgv", "0.5").out
    assert "outside of its limits" in " ".join(text.split())
    assert "*" in next(
        line for line in text.split("y_max of the methods of codes")[1].splitlines() if line.startswith("NCC")
    )


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ((), "either records or one of"),
        (("NCC", "--asce", "1.5", "0.6"), "either records or one of"),
        (("--asce", "1.5"), "--asce: it takes at least 2 numbers (acceleration S_MS at short periods, "),
        (("--asce", "1.5", "0.6", "--pgv", "0.5"), "--pgv"),
        (("--asce", "1.5", "0.6", "--bounds", "1.8", "0.7"), "lambda_min"),
        (("--asce", "1.5", "0.6", "--bounds", "0.7"), "it takes at least 2 numbers ("),
        (("--eurocode", "3.0", "--ground", "X"), "A, B, C, D, E"),
        (("NCC", "--ground", "C"), "--ground"),
        (("--japan", "7"), "must be a whole number from 1 to 3, not '7'."),
        (("--spectrum", "nowhere.csv"), "nowhere.csv"),
    ],
)
def test_bad_input_is_one_sentence(run, words, told):
    status, out, err = run("codes", *words)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert told in err


def test_the_details_do_not_ask_for_themselves(run):
    assert "--details says which" in " ".join(run("codes", "--asce", "1.5", "0.6").out.split())
    told = run("codes", "--asce", "1.5", "0.6", "--details").out
    assert "--details" not in told
    assert "they are marked above" in " ".join(told.split())


def test_a_set_as_one(run):
    records = ("NCC", "KNA", "LPG", "IVD")
    (mean,) = json.loads(run("codes", *records, "--pgv", "0.5", "--of-set", "mean", "--json").out)
    (most,) = json.loads(run("codes", *records, "--pgv", "0.5", "--of-set", "84", "--json").out)
    assert mean["analysis"]["displacement_mm"] < most["analysis"]["displacement_mm"]
    for one, other in zip(mean["answers"], most["answers"], strict=True):
        if one["method"] != "AIJ energy balance":
            assert one["displacement_mm"] < other["displacement_mm"], one["method"]
    assert run("codes", "--asce", "1.5", "0.6", "--of-set", "mean").status == 2
    assert run("codes", "NCC", "--of-set", "x").status == 2


def test_the_shear_of_the_structure_above(run):
    text = " ".join(run("codes", "--asce", "1.5", "0.6", "--weight-above", "0.85").out.split())
    (panel,) = json.loads(run("codes", "--asce", "1.5", "0.6", "--json").out)
    elf = panel["answers"][0]
    # V_st = V_b (W_s/W)^(1 - 2.5 beta_M)
    above = elf["base_shear_over_weight"] * 0.85 ** (1.0 - 2.5 * elf["effective_damping"])
    assert f"V_st/W of the structure above is {above:.3f}" in text
