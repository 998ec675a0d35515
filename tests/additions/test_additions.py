"""What one module outside of the package adds is found at every door, and nothing else has to be said anywhere."""

import csv
import json
import os
import subprocess
import sys
from collections.abc import Iterator
from html import unescape
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from light_pdf import leave_out_figures, page_texts

import dcfp
from dcfp.analysis.response import PEAKS
from dcfp.doors.cli.main import main
from dcfp.schema.quantities import NOMENCLATURE
from dcfp.system import FRICTION_LAWS

HERE = Path(__file__).parent
#: A law, its parameter at two values, and a PGV at which it slides.
TOY = ["respond", "NCC", "--pgv", "0.5", "--friction", "toy"]
FRICTION = '[{}]\nlaw = "toy"\nhalving_speed = "0.4 m/s"\n'
WORDS = "speed that halves the toy's friction"


@pytest.fixture(autouse=True)
def toys(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Add them for a test."""
    monkeypatch.syspath_prepend(HERE)
    for name in ("toy_law", "toy_quantity"):
        import_module(name)
    yield
    FRICTION_LAWS.remove("toy")
    PEAKS.remove("toy_speed")
    NOMENCLATURE.remove("toy_speed")
    for name in ("toy_law", "toy_quantity"):
        del sys.modules[name]


def answer(capsys: pytest.CaptureFixture[str], *words: str | Path) -> str:
    assert main([str(word) for word in words]) == 0
    return capsys.readouterr().out


@pytest.mark.slow
def test_an_installed_package_adds_by_its_entry_points(tmp_path: Path) -> None:
    about = tmp_path / "toys-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: toys\nVersion: 1.0\n")
    (about / "entry_points.txt").write_text("[dcfp.plugins]\nlaw = toy_law\nquantity = toy_quantity\n")
    for module in HERE.glob("toy_*.py"):
        (tmp_path / module.name).write_text(module.read_text())
    source = str(Path(dcfp.__file__).parents[1])
    environment = os.environ | {"PYTHONPATH": os.pathsep.join((str(tmp_path), source))}
    command = [sys.executable, "-m", "dcfp.doors.cli.main", *TOY, "--json"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    (response,) = json.loads(done.stdout)
    assert response["friction"] == "toy"
    assert response["toy_speed_mm_s"] == pytest.approx(0.5 * response["v_max_mm_s"])


def test_the_command_line(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    said = " ".join(answer(capsys, "respond", "--help").split())
    assert "toy" in said
    assert f"--friction.halving-speed MM_PER_S {WORDS} [mm/s]" in said
    by_option = json.loads(answer(capsys, *TOY, "--friction.halving-speed", "400", "--json"))
    file = tmp_path / "toy.toml"
    file.write_text(FRICTION.format("friction"))
    by_file = json.loads(answer(capsys, "respond", "NCC", "--pgv", "0.5", "--bearing", file, "--json"))
    assert by_option[0]["y_max_mm"] == by_file[0]["y_max_mm"]
    assert by_option[0]["y_max_mm"] > json.loads(answer(capsys, *TOY, "--json"))[0]["y_max_mm"]
    assert main([*TOY, "--friction.halving-speed", "4"]) == 2
    assert "must be a number of mm/s from 10 to 100000, not '4'" in " ".join(capsys.readouterr().err.split())


@pytest.mark.slow
def test_tables_and_files(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    table = answer(capsys, *TOY)
    assert "toy_speed" in table
    assert "law of the toy works" in table or "toy" in table
    answer(capsys, *TOY, "--pgv", "0.5", "1.0", "--out", tmp_path / "peaks.csv")
    with (tmp_path / "peaks.csv").open() as lines:
        rows = list(csv.DictReader(lines))
    assert float(rows[0]["toy_speed [mm s-1]"]) > 0.0
    answer(capsys, *TOY, "--pgv", "0.5", "1.0", "--out", tmp_path / "peaks.nc")
    with xr.open_dataset(tmp_path / "peaks.nc", engine="h5netcdf") as data:
        assert data["toy_speed"].attrs == {"long_name": "half of the largest relative velocity", "units": "mm s-1", "symbol": "v_{toy}"}  # fmt: skip


def test_python_and_notebook() -> None:
    system = dcfp.System.of(None, "toy")
    response = dcfp.respond("NCC", system, pgv=500)
    assert response.summary()["toy_speed_mm_s"] == pytest.approx(0.5 * response.peak_velocity)
    assert response.to_dataset().attrs["toy_speed_mm_s"] == response.summary()["toy_speed_mm_s"]
    speed = 0.5 * response.peak_velocity
    assert 'toy_speed [mm/s]</td><td style="text-align: right' in response._repr_html_()
    assert f">{speed:.5g}</td>" in response._repr_html_()
    assert "halving" in system.friction._repr_html_()
    assert "toy_speed" in repr(response)
    with pytest.raises(dcfp.InputError, match=WORDS):
        system.changed({"friction.halving_speed": 1.0})


@pytest.mark.slow
def test_workbook_and_report(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    from openpyxl import load_workbook

    file = tmp_path / "toy.toml"
    wave = 3.0 * np.sin(2.0 * np.pi * 0.02 * np.arange(101))  # few lines in the workbook
    np.savetxt(tmp_path / "short.txt", wave, fmt="%.6f")
    file.write_text(
        'title = "Toy"\n[factors]\nrecord = ["short.txt"]\npgv = { values = [0.5], unit = "m/s" }\n'
        '[motion]\nunits = "m/s2"\ntime_step = 0.02\n[analysis]\ntail = 0\n'
        + FRICTION.format("bearing.friction")
    )
    (told,) = json.loads(answer(capsys, "export", file, "--out", tmp_path / "toy.xlsx", "--json"))["analyses"]
    speed = told["toy_speed_mm_s"]
    cells = [
        cell.value
        for sheet in load_workbook(tmp_path / "toy.xlsx").worksheets
        for row in sheet.iter_rows()
        for cell in row
        if cell.value is not None
    ]
    assert "toy_speed [mm/s]" in cells
    assert pytest.approx(speed, rel=1e-12) in [cell for cell in cells if isinstance(cell, float)]
    assert any(WORDS in str(cell).casefold() for cell in cells)
    answer(capsys, "report", file, "--out", tmp_path / "toy.html")
    leave_out_figures(monkeypatch)
    answer(capsys, "report", file, "--out", tmp_path / "toy.pdf")
    printed = " ".join(page_texts((tmp_path / "toy.pdf").read_bytes()))
    for text in (printed, unescape((tmp_path / "toy.html").read_text())):
        text = " ".join(text.split())
        assert WORDS in text.casefold()
        assert f"{speed / 1e3:.4f}" in text
        assert "half of the largest relative velocity" in text


@pytest.mark.slow
def test_studies(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    file = tmp_path / "toy-study.toml"
    factors = '[factors]\nrecord = ["NCC"]\npgv = { values = [0.5], unit = "m/s" }\n"friction.halving_speed" = { values = [0.4, 0.8], unit = "m/s" }\n'
    file.write_text(f'title = "Toy"\n[bearing.friction]\nlaw = "toy"\n{factors}')
    answer(capsys, "study", "run", file, "--out", tmp_path / "toy.zarr")
    answer(capsys, "study", "export", tmp_path / "toy.zarr", "--out", tmp_path / "toy.csv")
    with (tmp_path / "toy.csv").open() as lines:
        rows = list(csv.DictReader(lines))
    peaks = [float(row["peak_displacement [mm]"]) for row in rows]
    assert len(peaks) == 2
    assert peaks[0] > peaks[1]
    assert [float(row["toy_speed [mm s-1]"]) for row in rows] == [
        pytest.approx(0.5 * float(row["peak_velocity [mm s-1]"])) for row in rows
    ]
    with xr.open_zarr(tmp_path / "toy.zarr", consolidated=False) as data:
        assert data["toy_speed"].attrs == {"long_name": "half of the largest relative velocity", "units": "mm s-1", "symbol": "v_{toy}"}  # fmt: skip
        assert data["friction.halving_speed"].attrs == {"long_name": WORDS, "units": "mm s-1"}
    assert "toy_speed" in answer(capsys, "study", "show", tmp_path / "toy.zarr")
    ida = ("study", "ida", tmp_path / "toy.zarr", "--quantity", "toy_speed", "--at")
    told = json.loads(answer(capsys, *ida, "friction.halving_speed=400", "--json"))
    assert told["at"] == {"friction.halving_speed_mm_s": 400.0}
    assert told["results"][0]["records"]["NCC"] == pytest.approx(float(rows[0]["toy_speed [mm s-1]"]))


def test_the_page() -> None:
    pytest.importorskip("nicegui", reason="the web page needs nicegui")
    from dcfp.doors.app.session import BearingForm, capitalised

    form = BearingForm()
    form.put("law", "toy")
    assert list(form.law_fields()) == ["friction.slow", "friction.halving_speed"]
    assert capitalised(form.law_fields()["friction.halving_speed"].words).casefold() == WORDS
    form.put("friction.halving_speed", 400.0)
    assert form.system().friction.rows
    assert form.system().friction.velocity_factor(400.0) == pytest.approx(0.5)


def test_the_documentation(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("sphinx", reason="the documentation needs Sphinx")
    monkeypatch.syspath_prepend(HERE.parents[1] / "docs" / "_extensions")
    declared = import_module("declared")
    (listed,) = [one for name, one in declared.sources().items() if name == "friction toy"]
    assert f"| `halving_speed` | $v_h$ | {WORDS} |" in declared.parameter_table(listed)
    assert "half of the largest relative velocity" in declared.quantity_table()
