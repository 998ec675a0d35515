"""``dcfp predict`` from end to end."""

import csv
import json
import math

import pytest

from dcfp.inference.forecast import calibration_set
from dcfp.motion.named import named_motion

CHECK_VALUES = {"0.250": ("73.4", "277.2", "248.8"), "1.000": ("568.4", "1108.8", "692.5")}
METHODS = ["design", "pulse", "simplified", "pulse march"]


def rows_of(text: str, first: str) -> list[list[str]]:
    return [line.split() for line in text.splitlines() if line.split()[:1] == [first]]


def test_the_pgv_alone_gives_the_check_values_of_the_paper(run):
    outcome = run("predict", "--pgv-only", "0.25", "1.0")
    assert outcome.status == 0
    for pgv, (change, put_in, dissipated) in CHECK_VALUES.items():
        assert rows_of(outcome.out, pgv) == [[pgv, "design", "PGV", change, "–", put_in, dissipated, "–"]]


def test_a_record_by_every_method(run):
    told = json.loads(run("predict", "NCC", "--pgv", "0.5", "1.0", "--json").out)
    assert [(one["record"], round(one["pgv_m_s"], 9)) for one in told] == [("NCC", 0.5), ("NCC", 1.0)]
    for one in told:
        assert [said["method"] for said in one["predictions"]] == METHODS
        assert one["nominal_friction"] == 0.043
        by_name = {said["method"]: said for said in one["predictions"]}
        pulse = by_name["pulse"]
        assert pulse["basis"] == "blind"
        assert pulse["y_mm"] is None
        assert pulse["pulse"]["start_s"] < pulse["pulse"]["peak_s"] < pulse["pulse"]["end_s"]
        # Eq. (21): what is dissipated is the work of the nominal friction on dy
        work = 2.0 * 421.83 * by_name["simplified"]["dy_mm"]
        assert by_name["simplified"]["V_dEhr_mm_s"] == pytest.approx(math.sqrt(work), rel=1e-4)
        assert by_name["pulse march"]["y_mm"] < by_name["pulse march"]["dy_mm"]


def test_intervals_of_a_record_leave_out_its_own_earthquake(run):
    (told,) = json.loads(run("predict", "NCC", "--pgv", "0.5", "--interval", "--json").out)
    by_name = {said["method"]: said for said in told["predictions"]}
    march = by_name["pulse march"]["interval"]["y_mm"]
    assert march["low"] < march["median"] < march["high"]
    # three records of the Northridge earthquake in either set, two components each
    assert march["cases"] == 100 - 12
    assert told["interval_from_pgv"]["y_mm"]["cases"] == 100 - 12
    assert any("12 of the 100 components" in remark for remark in told["remarks"])
    wide = told["interval_from_pgv"]["y_mm"]
    assert wide["high"] / wide["low"] > 2.0 * march["high"] / march["low"]


@pytest.mark.parametrize(
    ("event", "left_out"),
    [("Northridge-01, 1/17/1994", 12), ("1994/01/17", 12), ("", 1), ("Tottori 2000", 1)],
)
def test_the_record_in_another_file_is_known_again(run, tmp_path, event, left_out):
    """By its earthquake, or else by its samples."""
    stored = named_motion("NCC")
    file = tmp_path / "mine.AT2"
    values = [f"{value / 9806.65:15.7E}" for value in stored.acceleration]
    lines = ["PEER NGA STRONG MOTION DATABASE RECORD", f"{event}, somewhere, 0" if event else "somewhere, 0"]
    lines += [
        "ACCELERATION TIME SERIES IN UNITS OF G",
        f"NPTS= {len(values)}, DT= {stored.time_step:.4f} SEC",
    ]
    file.write_text("\n".join(lines + ["".join(values[i : i + 5]) for i in range(0, len(values), 5)]))
    (told,) = json.loads(run("predict", file, "--pgv", "0.5", "--interval", "--json").out)
    assert told["interval_from_pgv"]["y_mm"]["cases"] == 100 - left_out


def test_constants_and_threshold_can_be_given(run):
    def dy(*words: object) -> float:
        (told,) = json.loads(run("predict", "--pgv-only", "0.5", *words, "--json").out)
        return told["predictions"][0]["dy_mm"]

    assert dy("--zeta", "2") > dy() > dy("--eps", "0.5")
    assert dy("--nominal-mu", "0.06") < dy()
    assert dy("--average-slope", "1200") != dy()
    few, many = (
        json.loads(run("predict", "NCC", "--threshold", part, "--json").out)[0]["pulses"]
        for part in ("0.5", "0.05")
    )
    assert few < many


def test_a_law_of_its_own_has_a_nominal_coefficient_of_its_own(run):
    (constant,) = json.loads(run("predict", "NCC", "--friction", "constant", "--mu", "0.06", "--json").out)
    assert constant["nominal_friction"] == 0.06
    (kumar,) = json.loads(run("predict", "NCC", "--friction", "kumar2015", "--json").out)
    assert 0.02 < kumar["nominal_friction"] < 0.06
    assert "virtual dependency test T01" in " ".join(
        run("predict", "NCC", "--friction", "kumar2015").out.split()
    )


def test_without_slope_the_simplified_and_the_design_method_are_left_out(run):
    outcome = run("predict", "NCC", "--nominal-mu", "0.1", "--json")
    (told,) = json.loads(outcome.out)
    assert [said["method"] for said in told["predictions"]] == ["pulse", "pulse march"]
    assert any("left out" in remark for remark in told["remarks"])


def test_a_silent_record_moves_nothing(run, zeros):
    (told,) = json.loads(run("predict", zeros, "--units", "m/s2", "--json").out)
    assert all(said["dy_mm"] == 0.0 for said in told["predictions"])
    assert "no pulse" in told["remarks"][0]


def test_a_table_as_csv(run, tmp_path):
    table = tmp_path / "table.csv"
    assert run("predict", "NCC", "LPG", "--pgv", "0.25", "0.5", "--out", table).status == 0
    rows = list(csv.DictReader(table.read_text().splitlines()))
    assert len(rows) == 2 * 2 * 4
    assert {row["method"] for row in rows} == set(METHODS)
    assert float(rows[0]["dy [mm]"]) == pytest.approx(73.4, abs=0.05)


@pytest.mark.slow
@pytest.mark.parametrize(
    "words",
    [
        ("NCC", "--pgv", "0.5"),
        ("NCC", "LPG", "--pgv", "0.25", "0.5"),
        ("--pgv-only", "0.25", "0.5"),
        ("--pgv-only", "0.25", "0.5", "--interval"),
    ],
)
def test_figures(run, tmp_path, words):
    figure = tmp_path / "figure.png"
    assert run("predict", *words, "--plot", figure).status == 0
    assert figure.read_bytes().startswith(b"\x89PNG")


@pytest.mark.slow
def test_which_friction_holds_a_displacement(run, tmp_path, monkeypatch):
    # 25 of the 100 components, of more than the 19 that a quantile of 95 % needs
    monkeypatch.setattr("dcfp.doors.cli.predict.calibration_set", lambda: calibration_set()[::4])
    figure = tmp_path / "chart.svg"
    outcome = run("predict", "--pgv-only", "0.5", "--allow", "300", "--json", "--plot", figure)
    rows = json.loads(outcome.out)
    assert len({row["radius_mm"] for row in rows}) == len(rows) >= 4
    for row in rows:
        half, most = (row[f"least_coefficient_{part}_percent"] for part in ("50", "95"))
        assert half < most
        # from the printed form of Eq. (33): 300 mm at 0.5 m/s
        assert row["nominal_friction_design_method"] == pytest.approx(0.0319, abs=5e-5)
    assert b"<svg" in figure.read_bytes()


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("predict",), "RECORD"),
        (("predict", "NCC", "--pgv-only", "0.5"), "--pgv-only takes no record"),
        (("predict", "--pgv-only", "0.5", "--pgv", "0.5"), "one of the two"),
        (("predict", "--pgv-only", "0.5", "--high-pass", "0.05"), "--high-pass"),
        (("predict", "--pgv-only", "0.5", "--threshold", "0.1"), "--threshold"),
        (("predict", "--pgv-only", "0.5", "--nominal-mu", "0.1"), "below 0.0948"),
        (("predict", "NCC", "--threshold", "2"), "--threshold"),
        (("predict", "NCC", "--zeta", "x"), "--zeta"),
        (("predict", "NCC", "--allow", "300"), "--pgv-only"),
        (("predict", "--pgv-only", "0.5", "--allow", "300", "--radius", "3000"), "--radius"),
        (("predict", "--pgv-only", "0.5", "--allow", "300", "--interval"), "--interval"),
        (("compare",), "RECORD"),
        (("compare", "NCC", "--held-out"), "--pgv"),
        (("compare", "NCC", "--pgv", "0.5", "--held-out"), "earthquakes"),
        (("compare", "P695-FG"), "P695-FG"),
        (("reproduce", "NCC=file"), "JKB"),
        (("reproduce", "JKB=nowhere.csv"), "nowhere.csv"),
    ],
)
def test_bad_input_is_one_sentence(run, words, told):
    status, out, err = run(*words)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert told in err


@pytest.mark.parametrize("command", ["predict", "compare"])
def test_a_file_of_another_kind_is_refused_before_any_work(run, tmp_path, command):
    status, _, err = run(command, "NCC", "--out", tmp_path / "table.nc")
    assert status == 2
    assert ".csv" in err
    assert not list(tmp_path.iterdir())


def test_a_pgv_with_a_spectrum_is_told_beside_the_paper_s_and_a_record_takes_none(run) -> None:
    (told,) = json.loads(run("predict", "--pgv-only", "0.5", "--asce", "1.5", "0.6", "--json").out)
    assert [one["method"] for one in told["predictions"]] == ["design", "design with spectrum"]
    for wrong, words in (
        (
            ("NCC", "--asce", "1.5", "0.6"),
            "--asce is for the design method, which takes PGVs with --pgv-only",
        ),
        (("--pgv-only", "0.5", "--allow", "300", "--asce", "1.5", "0.6"), "without --allow"),
        (("--pgv-only", "0.5", "--asce", "1.5", "0.6", "--spectrum", "a.csv"), "give one of"),
    ):
        answer = run("predict", *wrong)
        assert answer.status == 2
        assert words in answer.err


def test_the_amplification_of_a_pulse_whose_slopes_are_those_of_friction_can_be_given(run):
    """LPG at 0.25 m/s has such a pulse, NCC at 0.5 m/s none; the default is the paper's."""

    def dy(record: str, pgv: str, *words: object) -> float:
        (told,) = json.loads(run("predict", record, "--pgv", pgv, *words, "--json").out)
        (pulse,) = (one for one in told["predictions"] if one["method"] == "pulse")
        return pulse["dy_mm"]

    assert dy("LPG", "0.25") == dy("LPG", "0.25", "--amplification", "1.5")
    assert dy("LPG", "0.25") > 2.0 * dy("LPG", "0.25", "--amplification", "1.2") > 0.0
    assert dy("NCC", "0.5") == dy("NCC", "0.5", "--amplification", "1.2")


@pytest.mark.parametrize("command", ["predict", "compare"])
def test_what_makes_the_methods_unreliable_is_said_beside_them(run, command):
    words = " ".join(run(command, "LPG", "--pgv", "0.25").out.split())
    assert "LPG: dy by the pulse method is unreliable, since its governing pulse has a ku/kg of 0.89" in words
    assert "with ripples down to 0.05 PGV as peaks it is 20 mm in place of 152 mm" in words
    (told,) = json.loads(run("predict", "LPG", "--pgv", "0.25", "--json").out)
    assert sum("unreliable" in remark for remark in told["remarks"]) == 4
