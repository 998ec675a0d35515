"""``dcfp reproduce`` with records of one's own, and what its findings rest on."""

import json
from dataclasses import replace
from pathlib import Path

import pytest
from peer_files import write_peer
from samples import sample_folder

from dcfp.inference import compare
from dcfp.motion.named import named_motion
from dcfp.present.figures import li_2020
from dcfp.present.figures.li_2020 import paper_figures
from dcfp.verify import reproduction
from dcfp.verify.reproduction import Basis

KOBE = "Kobe Japan, 1/16/1995, KJMA"
#: What follows from the paper's formulas, as it is told.
DERIVED = (
    "277.2", "248.8", "73.4", "1108.8", "692.5", "568.4", "421.8", "7.54 MN", "6.02 s", "768.8 t", "177 mm", "0.9997", "9810",
)  # fmt: skip


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of the packaged records NCC alone, for the hundred components too."""
    monkeypatch.setattr(reproduction, "ALIASES", ("NCC",))
    known: list = []

    def cases_at(velocity, methods, report):
        known.append(compare(named_motion("NCC").scaled_to_pgv(velocity)))
        return known[-1:]

    monkeypatch.setattr(reproduction, "cases_at", cases_at)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a file that stands for JKB."""
    place = tmp_path / "records"
    place.mkdir()
    write_peer(place / "KJM000.AT2", f"{KOBE}, 0", 911.0)
    write_peer(place / "KJM090.AT2", f"{KOBE}, 90", 750.0)
    return place


def test_a_record_of_a_folder(run, few, folder: Path, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr(
        li_2020, "paper_figures", lambda cases, loops: paper_figures(cases, loops, numbers=("10",))
    )
    page = tmp_path / "paper.html"
    outcome = run("reproduce", "--records", folder, "--out", page, "--json")
    assert (outcome.status, outcome.err) == (0, "")
    told = json.loads(outcome.out)
    assert told["records"] == ["NCC", "JKB"]
    assert told["missing_records"] == ["TC1", "TSD", "TIM"]
    remarks = " ".join(told["remarks"])
    assert "KJM000.AT2" in remarks
    assert "0.911 m/s, and 0.893 m/s in the paper's Table 3" in remarks
    text = page.read_text(encoding="utf-8")
    assert "KJM000.AT2" in text
    assert "under JKB with the simplified and with the precise" in text
    for finding in told["findings"]:
        assert finding["basis"] in ("printed", "derived", "ours")
    derived = " ".join(one["paper"] for one in told["findings"] if one["basis"] == "derived")
    others = " ".join(one["paper"] for one in told["findings"] if one["basis"] != "derived")
    for number in DERIVED:
        assert number in derived
        assert number not in others
    assert all(one["agrees"] for one in told["findings"] if one["basis"] == "derived")
    assert any(one["basis"] == "ours" for one in told["findings"])
    # ours are no findings of the paper
    assert not any(one["paper"] for one in told["findings"] if one["basis"] == "ours")


def test_a_raw_record_is_treated_as_asked_or_refused(run, few, folder: Path, tmp_path: Path) -> None:
    raw = write_peer(tmp_path / "raw.AT2", f"{KOBE}, 0", 893.0, offset=150.0)
    page = tmp_path / "paper.html"
    for words in ((f"JKB={raw}",), ("--records", tmp_path)):
        outcome = run("reproduce", *words, "--out", page)
        assert (outcome.status, outcome.out, outcome.err.count("\n")) == (2, "", 1)
        assert "JKB: the ground still moves" in outcome.err
        assert not page.exists()
    # the file goes before the folder
    told = json.loads(run("reproduce", f"JKB={raw}", "--records", folder, "--high-pass", "0.1", "--json").out)
    remarks = " ".join(told["remarks"])
    assert "JKB: mean removed; zero-phase Butterworth high-pass 0.1 Hz" in remarks
    assert "KJM000.AT2" not in remarks


@pytest.mark.parametrize("words", ["nowhere", "."])
def test_a_folder_without_such_records(run, tmp_path: Path, monkeypatch, words: str) -> None:
    monkeypatch.chdir(tmp_path)
    outcome = run("reproduce", "--records", words)
    assert (outcome.status, outcome.out, outcome.err.count("\n")) == (2, "", 1)
    assert "JKB" in outcome.err


def test_models_of_heat_that_are_not_similar_differ(few) -> None:
    """The constant coefficient stands for a model that is not similar, and the analyses themselves for one that is."""
    analyses = reproduction.analyse(reproduction.paper_motions())

    def heating(analyses: reproduction.Analyses) -> reproduction.Finding:
        (found,) = (one for one in reproduction.findings_of(analyses) if "precise heating" in one.name)
        return found

    differs = heating(replace(analyses, precise=analyses.constant))
    assert (differs.sign, differs.basis) == ("differs", Basis.PRINTED)
    assert {case.record for case in differs.outside} == {"NCC"}
    own = tuple(case.response for case in analyses.cases if case.response is not None)
    same = heating(replace(analyses, precise=own))
    assert (same.sign, same.outside) == ("as printed", ())


@pytest.mark.slow
@pytest.mark.skipif(sample_folder() is None, reason="needs the sample records")
def test_five_records_of_the_paper(run, few, monkeypatch) -> None:
    monkeypatch.setattr(reproduction, "ALIASES", ("KNA", "NCC", "LPG", "IVD"))
    folder = sample_folder()
    assert folder is not None
    told = json.loads(run("reproduce", "--records", folder / "paper", "--json").out)
    assert told["records"] == ["KNA", "NCC", "LPG", "IVD", "JKB"]
    findings = {one["name"]: one for one in told["findings"]}

    def outside(word: str) -> set[tuple[str, float]]:
        """The cases outside of what is printed, of the findings with a word in their names."""
        named = (one for name, one in findings.items() if word in name)
        return {(case["record"], round(case["pgv_m_s"], 6)) for one in named for case in one["outside"]}

    assert outside("method over analysis") == {("LPG", 0.25), ("IVD", 1.0), ("JKB", 0.5)}
    slope = next(one for name, one in findings.items() if name.startswith("kg_ave"))
    assert slope["ours"] == "812 mm/s² (5 records)"
    assert "716 mm/s²" in slope["words"]
    assert slope["agrees"] is False
    heating = findings["y_max, simplified over precise heating"]
    assert heating["agrees"] is False
    assert {case["record"] for case in heating["outside"]} == {"IVD"}
