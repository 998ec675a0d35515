"""`dcfp report` from end to end."""

import json
import sys
from pathlib import Path

import pytest

SCENARIO = '[factors]\nrecord = ["pulse.txt"]\n[motion]\nunits = "m/s2"\n[report]\nproject = "P"\n'


@pytest.fixture
def scenario(pulse: Path) -> Path:
    path = pulse.with_name("tower.toml")
    path.write_text(SCENARIO, encoding="utf-8")
    return path


@pytest.mark.slow
def test_a_report_is_a_pdf_named_after_the_scenario(run, scenario: Path, tmp_path: Path, monkeypatch) -> None:
    folder = tmp_path / "here"
    folder.mkdir()
    monkeypatch.chdir(folder)
    assert run("report", scenario) == (0, "tower.pdf: written.\n", "")
    assert [path.name for path in folder.iterdir()] == ["tower.pdf"]
    assert (folder / "tower.pdf").read_bytes().startswith(b"%PDF")
    status, out, err = run("report", scenario)
    assert (status, out) == (2, "")
    assert "tower.pdf: the file exists" in err


@pytest.mark.slow
def test_json_holds_the_numbers_and_writes_a_file_only_where_one_is_named(
    run, scenario: Path, tmp_path: Path, monkeypatch
) -> None:
    folder = tmp_path / "here"
    folder.mkdir()
    monkeypatch.chdir(folder)
    status, out, err = run("report", scenario, "--json")
    assert (status, err) == (0, "")
    assert list(folder.iterdir()) == []
    (case,) = json.loads(out)["cases"]
    respond = json.loads(run("respond", scenario.with_name("pulse.txt"), "--units", "m/s2", "--json").out)[0]
    assert {key: case[key] for key in respond if key != "elapsed_s"} == {
        key: value for key, value in respond.items() if key != "elapsed_s"
    }
    assert set(respond) <= set(case)
    status, again, err = run("report", scenario, "--json", "--out", "page.html")
    assert (status, err) == (0, "")
    assert json.loads(again)["formulas"] == json.loads(out)["formulas"]
    assert (folder / "page.html").read_text(encoding="utf-8").startswith("<!doctype html>")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("missing.toml",), "there is no such file"),
        (("{scenario}", "--out", "report.docx"), "a report can be written as .pdf, .html, .htm"),
        (("{scenario}", "--out", "no/such/report.pdf"), "there is no folder"),
        (("{scenario}", "--out", "."), "a report can be written as"),
        (("{study}",), "a scenario has one bearing, but factor 'mu' has 2 values"),
        (("{broken}",), "this is not TOML"),
        (("{unknown}",), "[report]: there is no parameter of a report 'colour'"),
        (("{number}",), "[report]: author: who has calculated it must be a text, not 5"),
        (("{silent}",), "there is no factor 'record'"),
    ],
)
def test_what_is_wrong_gets_one_sentence(
    run, scenario: Path, tmp_path: Path, monkeypatch, words, sentence: str
) -> None:
    monkeypatch.chdir(tmp_path)
    files = {
        "scenario": SCENARIO,
        "study": SCENARIO.replace("[motion]", "mu = [0.05, 0.06]\n[motion]"),
        "broken": "title = ",
        "unknown": SCENARIO + 'colour = "red"\n',
        "number": SCENARIO + "author = 5\n",
        "silent": 'title = "T"\n',
    }
    places = {name: scenario.with_name(f"{name}.toml") for name in files}
    for name, text in files.items():
        places[name].write_text(text, encoding="utf-8")
    before = sorted(tmp_path.iterdir())
    status, out, err = run("report", *(word.format(**places) for word in words))
    assert (status, out) == (2, "")
    assert sentence in err
    assert err.count("\n") == 1
    assert sorted(tmp_path.iterdir()) == before


def test_the_scenario_is_never_written_over(run, scenario: Path) -> None:
    page = scenario.rename(scenario.with_name("tower.html"))
    status, _, err = run("report", page, "--out", page, "--overwrite")
    assert status == 2
    assert "this file is an input" in err
    assert page.read_text(encoding="utf-8") == SCENARIO


def test_a_folder_that_cannot_be_written_to_is_told_before_the_work(
    run, scenario: Path, tmp_path: Path, monkeypatch
) -> None:
    monkeypatch.setattr("os.access", lambda *_: False)  # a test that runs as root may write anywhere
    status, _, err = run("report", scenario, "--out", tmp_path / "r.pdf")
    assert status == 2
    assert "no permission" in err


@pytest.mark.slow
def test_without_typst_there_is_still_a_page(run, scenario: Path, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "typst", None)
    status, _, err = run("report", scenario, "--out", tmp_path / "r.pdf")
    assert status == 2
    assert "pip install 'dcfp[report]'" in err
    assert not (tmp_path / "r.pdf").exists()
    assert run("report", scenario, "--out", tmp_path / "r.html").status == 0


def test_a_failure_leaves_what_was_there(run, scenario: Path, tmp_path: Path, monkeypatch) -> None:
    report = tmp_path / "r.html"
    report.write_text("before")

    def fail(*_: object) -> str:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("dcfp.present.report.page_of", fail)
    status, _, err = run("report", scenario, "--out", report, "--overwrite")
    assert status == 2
    assert "No space left" in err
    assert report.read_text() == "before"
    assert [path.name for path in tmp_path.iterdir() if path.name.startswith(".")] == []
