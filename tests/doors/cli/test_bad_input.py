"""Bad input: one line on standard error, status 2, nothing written, and what was there before is untouched."""

from pathlib import Path

import pytest

AT2 = (
    "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, 1/1/2000, Station, 0\n"
    "ACCELERATION TIME SERIES IN UNITS OF G\nNPTS=   20, DT=   .0100 SEC\n"
)
FINE = " ".join(["0.01"] * 5)


def is_refused(outcome, *words: str) -> None:
    status, out, err = outcome
    assert (status, out, err.count("\n")) == (2, "", 1), err
    assert err.startswith("dcfp: ")
    assert "Traceback" not in err
    for word in words:
        assert word in err


@pytest.mark.parametrize(
    ("name", "content", "options", "words"),
    [
        ("missing.AT2", None, (), ("missing.AT2",)),
        ("empty.txt", b"", (), ("empty.txt",)),
        ("binary.dat", bytes(range(256)) * 8, (), ("binary.dat",)),
        ("cut.AT2", (AT2 + f"{FINE}\n{FINE}\n").encode(), (), ("cut.AT2", "20")),
        ("nan.txt", b"0.00 0.1\n0.01 nan\n0.02 0.1\n", ("--units", "m/s2"), ("nan.txt", "2")),
        ("text.txt", b"0.00 0.1\n0.01 oops\n0.02 0.1\n", ("--units", "m/s2"), ("text.txt", "oops")),
        ("units.txt", b"0.00 0.1\n0.01 0.2\n0.02 0.1\n", ("--units", "furlong"), ("furlong", "m/s2")),
        ("nounits.txt", b"0.00 0.1\n0.01 0.2\n0.02 0.1\n", (), ("unit",)),
        ("nostep.txt", b"0.1\n0.2\n0.1\n", ("--units", "g"), ("time step",)),
    ],
)
def test_files(
    run, tmp_path: Path, name: str, content: bytes | None, options: tuple[str, ...], words
) -> None:
    file = tmp_path / name
    if content is not None:
        file.write_bytes(content)
    before = sorted(tmp_path.iterdir())
    is_refused(
        run("respond", file, *options, "--out", tmp_path / "o.nc", "--plot", tmp_path / "o.png"), *words
    )
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.parametrize(
    "option",
    ["--pgv", "--radius", "--slider", "--pressure", "--stiffness", "--capacity", "--step", "--high-pass", "--mu",
     "--tolerance", "--time-step"],
)  # fmt: skip
@pytest.mark.parametrize("value", ["0", "-1", "nan", "inf", "x"])
def test_numbers_that_must_be_positive(run, option: str, value: str) -> None:
    is_refused(run("respond", "NCC", option, value), option)


@pytest.mark.parametrize(("option", "value"), [("--tail", "-1"), ("--ambient", "warm"), ("--mu", "1.5")])
def test_other_numbers(run, option: str, value: str) -> None:
    is_refused(run("respond", "NCC", option, value), option, value)


def test_a_number_in_another_unit_is_asked_about(run) -> None:
    sentence = "must be a number of mm from 100 to 1e+06, not '4.5' (were m meant?).\n"
    assert run("respond", "NCC", "--radius", "4.5").err == (
        f"dcfp: --radius: effective radius of both plates, or of the lower and the upper one {sentence}"
    )
    plain = run("respond", "NCC", "--pgv", "0.5", "--radius", "4500", "--json").out
    assert (
        run("respond", "NCC", "--pgv", "500 mm/s", "--radius", "4.5 m", "--json").out.partition("elapsed")[0]
        == (plain.partition("elapsed")[0])
    )


def test_more_than_two_radii(run) -> None:
    is_refused(run("respond", "NCC", "--radius", "1000", "2000", "3000"), "--radius", "2")


def test_a_record_of_zeros_has_no_pgv(run, zeros: Path) -> None:
    is_refused(run("respond", zeros, "--units", "m/s2", "--pgv", "0.5"), "zeros", "zero")


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (("P695-FF-99-a",), ("P695-FF-99-a", "1 to 22")),
        (("NCD",), ("NCC",)),
        (("JKB",), ("JKB", "KJM000")),
        (("NCC", "--friction", "kumar2051"), ("kumar2051", "kumar2015")),
        (("NCC", "--heating", "precis"), ("precis", "precise")),
        (("NCC", "--units", "g"), ("NCC",)),
        (("NCC", "--bearing", "none.toml"), ("none.toml",)),
    ],
)
def test_names(run, words: tuple[str, ...], expected: tuple[str, ...]) -> None:
    is_refused(run("respond", *words), *expected)


def test_a_file_with_several_components_asks_for_one(run, three_components: Path) -> None:
    is_refused(run("respond", three_components), "3 components", "'NS', 'EW', 'UD'")
    is_refused(run("respond", f"{three_components}::NS", "--component", "EW"), "NS", "EW")
    is_refused(run("respond", three_components, "--component", "XY"), "XY")
    assert run("respond", three_components, "--component", "EW").status == 0


def test_a_bearing_file_with_a_slip(run, tmp_path: Path) -> None:
    file = tmp_path / "b.toml"
    file.write_text("radios = 4500\n")
    is_refused(run("respond", "NCC", "--bearing", file), "b.toml", "radios")
    file.write_text("radius = -4500\n")
    is_refused(run("respond", "NCC", "--bearing", file), "b.toml", "radius")
    file.write_text("radius = [\n")
    is_refused(run("respond", "NCC", "--bearing", file), "b.toml", "TOML")


@pytest.mark.parametrize(
    ("option", "name", "word"),
    [
        ("--out", "no/such/folder/r.nc", "folder"),
        ("--plot", "no/such/folder/r.png", "folder"),
        ("--out", "r.ods", ".nc, .csv, .xlsx, .py"),
        ("--plot", "r.bmp", ".png, .pdf, .svg"),
        ("--plot", "r", ".png, .pdf, .svg"),
    ],
)
def test_outputs_that_cannot_be(run, tmp_path: Path, option: str, name: str, word: str) -> None:
    is_refused(run("respond", "NCC", option, tmp_path / name), Path(name).name, word)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_is_no_output(run, tmp_path: Path) -> None:
    (tmp_path / "r.nc").mkdir()
    is_refused(run("respond", "NCC", "--out", tmp_path / "r.nc", "--overwrite"), "folder")


def test_an_existing_output_is_kept_unless_told(run, tmp_path: Path) -> None:
    old = tmp_path / "r.csv"
    old.write_text("precious")
    is_refused(run("respond", "NCC", "--out", old), "exists", "--overwrite")
    assert old.read_text() == "precious"
    assert run("respond", "NCC", "--out", old, "--overwrite").status == 0
    assert old.read_text().startswith("time [s]")


def test_an_input_is_no_output_even_when_told(run, tmp_path: Path) -> None:
    record = tmp_path / "record.csv"
    record.write_text("0.00 0.1\n0.01 0.2\n0.02 0.1\n")
    is_refused(run("respond", record, "--units", "g", "--out", record, "--overwrite"), "input")
    is_refused(run("respond", f"{record}::1", "--units", "g", "--out", record, "--overwrite"), "input")
    assert record.read_text().startswith("0.00 0.1")


def test_a_failed_analysis_leaves_the_old_files(run, tmp_path: Path, monkeypatch) -> None:
    from dcfp.errors import AnalysisError

    def fail(*_: object, **__: object) -> None:
        msg = "it makes no progress."
        raise AnalysisError(msg)

    monkeypatch.setattr("dcfp.doors.cli.respond.analyse_record", fail)
    old = tmp_path / "r.nc"
    old.write_text("precious")
    status, out, err = run("respond", "NCC", "--out", old, "--overwrite")
    assert (status, out, err) == (1, "", "dcfp: it makes no progress.\n")
    assert old.read_text() == "precious"
    assert list(tmp_path.iterdir()) == [old]


def test_a_figure_that_fails_takes_the_data_with_it(run, tmp_path: Path, monkeypatch) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("dcfp.present.figures.save_figure", full)
    is_refused(
        run("respond", "NCC", "--out", tmp_path / "r.nc", "--plot", tmp_path / "r.png"), "No space left"
    )
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("option", "value"),
    [
        ("--pgv", "500"),
        ("--pressure", "60e6"),
        ("--slider", "0.4"),
        ("--radius", "4.5"),
        ("--stiffness", "1.9e9"),
        ("--ambient", "-300"),
        ("--tail", "1e9"),
    ],
)
def test_a_number_in_the_wrong_unit_is_refused(run, option: str, value: str) -> None:
    is_refused(run("respond", "NCC", option, value), option, value)


def test_a_record_that_drifts_is_not_scaled_to_a_pgv(run, drifting: Path) -> None:
    words = ("respond", drifting, "--units", "m/s2", "--pgv", "0.5")
    is_refused(run(*words), "--high-pass", "--baseline")
    assert run(*words, "--baseline").status == 0


def test_the_capacity_of_a_bearing_file_stays(run, tmp_path: Path) -> None:
    bearing = tmp_path / "own.toml"
    bearing.write_text("radius = 4000\ncapacity = 50\n")
    outcome = run("respond", "NCC", "--pgv", "0.5", "--bearing", bearing, "--slider", "350", "--json")
    assert '"beyond capacity"' in outcome.out
