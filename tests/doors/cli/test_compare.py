"""``dcfp compare`` and ``dcfp reproduce`` from end to end."""

import csv
import json
import re

import pytest

from dcfp.present.figures import li_2020
from dcfp.present.figures.li_2020 import paper_figures

PGVS = ("0.25", "0.5", "0.75", "1.0")


@pytest.mark.slow
def test_the_four_records_at_the_four_pgvs(run):
    outcome = run("compare", "NCC", "KNA", "LPG", "IVD", "--pgv", *PGVS)
    assert outcome.status == 0
    # once with the predictions and once with the methods of codes
    assert len(re.findall(r"^(?:NCC|KNA|LPG|IVD) ", outcome.out, re.MULTILINE)) == 2 * 16
    told = json.loads(run("compare", "NCC", "KNA", "LPG", "IVD", "--pgv", *PGVS, "--json").out)
    assert len(told["cases"]) == 16
    assert told["held_out"] is None
    scatter = {(row["method"], row["basis"], row["quantity"]): row for row in told["scatter"]}
    # every blind ratio of the energies is in the printed ranges, to half of their last digit
    for method, quantity, low, high in (
        ("pulse", "V_dE", 0.8, 1.9),
        ("pulse", "V_dEhr", 0.8, 1.6),
        ("simplified", "V_dE", 0.8, 1.5),
        ("simplified", "V_dEhr", 0.7, 1.6),
    ):
        row = scatter[method, "blind", quantity]
        assert low - 0.05 <= row["least"] <= row["largest"] <= high + 0.05, (method, quantity)
    assert scatter["pulse march", "blind", "dy"]["dispersion"] < scatter["pulse", "blind", "dy"]["dispersion"]


def test_a_case_holds_its_swing_and_the_pulse_behind_it(run):
    (case,) = json.loads(run("compare", "NCC", "--pgv", "0.25", "--json").out)["cases"]
    swing, pulse = case["governing_swing"], case["governing_pulse"]
    assert swing["start_s"] < pulse["peak_s"] < swing["end_s"]
    assert swing["dy_mm"] * pulse["dvg_mm_s"] < 0.0
    assert abs(swing["dy_mm"]) == pytest.approx(case["analysis"]["dy_mm"], rel=1e-3)
    said = {(one["method"], one["basis"]): one for one in case["predictions"]}
    assert said["pulse", "informed"]["dy_mm"] <= said["pulse", "blind"]["dy_mm"]
    assert said["pulse", "blind"]["ratios"]["dy"] == pytest.approx(
        said["pulse", "blind"]["dy_mm"] / case["analysis"]["dy_mm"]
    )


@pytest.mark.slow
@pytest.mark.parametrize(
    ("records", "number"), [("P695-FF", 44), pytest.param("P695", 100, marks=pytest.mark.long)]
)
def test_a_set_on_held_out_earthquakes(run, records, number):
    told = json.loads(run("compare", records, "--pgv", "0.25", "0.5", "--held-out", "--json").out)
    assert len(told["cases"]) == 2 * number
    for row in told["held_out"]["coverage"]:
        assert 0.8 < row["mean"] < 1.0, row
    march = next(
        r for r in told["held_out"]["coverage"] if (r["method"], r["quantity"]) == ("pulse march", "y")
    )
    assert 0.85 <= march["mean"] <= 0.95
    refits = {(row["method"], row["constants_from"]): row for row in told["held_out"]["refits"]}
    given, fitted = refits["simplified", "as given"], refits["simplified", "least squares"]
    assert abs(fitted["bias"] - 1.0) < abs(given["bias"] - 1.0)


@pytest.mark.slow
def test_every_case_as_csv_and_a_figure(run, tmp_path):
    table, figure = tmp_path / "cases.csv", tmp_path / "cases.png"
    words = ("compare", "NCC", "LPG", "--pgv", "0.25", "1.0")
    assert run(*words, "--out", table, "--plot", figure).status == 0
    rows = list(csv.DictReader(table.read_text().splitlines()))
    ours = {"pulse", "simplified", "design", "design with spectrum", "pulse march"}
    of_codes = [row for row in rows if row["basis"] == "spectrum" and row["method"] not in ours]
    assert {row["method"] for row in rows if row not in of_codes} == {"analysis", *ours}
    assert len(rows) == 4 * 8 + len(of_codes)
    assert all(row["verdict"] for row in of_codes)
    assert figure.read_bytes().startswith(b"\x89PNG")


def test_the_figure_of_one_case_shows_its_pulses(run, tmp_path):
    figure = tmp_path / "ncc.svg"
    assert run("compare", "NCC", "--pgv", "0.5", "--plot", figure).status == 0
    assert b"<svg" in figure.read_bytes()


def test_remarks_stay_beside_the_results(run):
    told = json.loads(run("compare", "IVD", "--pgv", "1.0", "--friction", "lomiento2013", "--json").out)
    remarks = " ".join(told["cases"][0]["remarks"])
    assert "capacity" in remarks
    assert "unconfirmed" in remarks


@pytest.mark.slow
def test_the_paper_made_again(run, tmp_path, monkeypatch):
    def few(cases, loops, numbers=None):
        """Of all figures one of loops, one of histories and one of points; all are in the tests of figures."""
        assert numbers is None
        return paper_figures(cases, loops, numbers=("10", "13", "26"))

    monkeypatch.setattr(li_2020, "paper_figures", few)
    page, sheet = tmp_path / "paper.html", tmp_path / "sheet.png"
    told = json.loads(run("reproduce", "--out", page, "--plot", sheet, "--json").out)
    assert told["missing_records"] == ["JKB", "TC1", "TSD", "TIM"]
    findings = {one["name"]: one for one in told["findings"]}
    outside = {
        (case["record"], round(case["pgv_m_s"], 6))
        for one in told["findings"]
        for case in one["outside"]
        if "ku/kg" in case["words"]
    }
    assert outside == {("LPG", 0.25), ("IVD", 1.0)}
    for one in told["findings"]:
        assert one["agrees"] or one["words"], one["name"]
        for case in one["outside"]:
            assert "ku/kg" in case["words"] or "precise heating" in one["name"]
    assert findings["design method at PGV 0.25 m/s: V_dE, V_dEhr, dy"]["agrees"]
    text = page.read_text(encoding="utf-8")
    for number in (10, 13, 26):
        assert f"<figcaption>Figure {number}. " in text
    assert "://" not in re.sub(r"https://doi\.org/\S+", "", text)
    assert sheet.read_bytes().startswith(b"\x89PNG")


@pytest.mark.slow
def test_another_record_of_the_paper_from_a_file(run, three_components):
    told = json.loads(run("reproduce", f"JKB={three_components}::NS", "--json").out)
    assert "JKB" in told["records"]
    assert "JKB" not in told["missing_records"]
    assert any("Table 3" in remark for remark in told["remarks"])
