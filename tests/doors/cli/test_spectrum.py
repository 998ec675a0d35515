"""``dcfp spectrum`` from end to end."""

import csv
import json
import math

import pytest


def test_spectra_of_a_record(run):
    told = json.loads(run("spectrum", "NCC", "--pgv", "0.5", "--periods", "0.5", "1", "3", "--json").out)
    assert told["damping"] == 0.05
    assert [row["period_s"] for row in told["spectra"]] == [0.5, 1.0, 3.0]
    for row in told["spectra"]:
        omega = 2.0 * math.pi / row["period_s"]
        assert row["S_v_mm_s"] == pytest.approx(omega * row["S_d_mm"])
        assert row["S_a_mm_s2"] == pytest.approx(omega**2 * row["S_d_mm"])
        # what an oscillator holds at its largest displacement was put in before
        assert row["V_E_mm_s"] >= row["S_v_mm_s"]
    (most,) = told["maxima"]
    assert most["V_E_max_mm_s"] >= max(row["V_E_mm_s"] for row in told["spectra"])
    assert run("spectrum", "NCC", "--pgv", "0.5").out.count("NCC") == 2


def test_more_damping_moves_less(run):
    def displacement(*words: str) -> float:
        told = json.loads(run("spectrum", "KNA", "--periods", "1", *words, "--json").out)
        return told["spectra"][0]["S_d_mm"]

    assert displacement("--damping", "0") > displacement() > displacement("--damping", "0.2")


@pytest.mark.slow
def test_every_period_as_csv_and_a_figure(run, tmp_path):
    table, figure = tmp_path / "table.csv", tmp_path / "figure.png"
    assert run("spectrum", "NCC", "LPG", "--out", table, "--plot", figure).status == 0
    rows = list(csv.DictReader(table.read_text().splitlines()))
    assert len(rows) == 2 * 200
    assert figure.read_bytes().startswith(b"\x89PNG")
    many = tmp_path / "many.svg"
    records = [f"P695-FF-{number:02}-a" for number in range(1, 10)]  # more than there are colours
    assert run("spectrum", *records, "--plot", many).status == 0
    assert b"<svg" in many.read_bytes()


def test_a_silent_record_has_a_spectrum_of_zeros(run, zeros):
    told = json.loads(run("spectrum", zeros, "--units", "m/s2", "--json").out)
    assert all(row["S_d_mm"] == 0.0 for row in told["spectra"])
    assert told["maxima"] == []


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ((), "RECORD"),
        (("NCC", "--damping", "1.5"), "--damping"),
        (("NCC", "--periods", "3", "1"), "increase"),
        (("NCC", "--periods", "0"), "--periods"),
    ],
)
def test_bad_input_is_one_sentence(run, words, told):
    status, out, err = run("spectrum", *words)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert told in err
