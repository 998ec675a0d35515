"""`dcfp building PROJECT.toml STATION` from end to end."""

import csv
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import xarray

from dcfp import load_station
from dcfp.analysis.plan import respond_plan
from dcfp.system.project import read_plan

TEXT = """name = "Clinic"
[bearing.A]
slider = 320
capacity = 450
[plan]
grid = { x = [0, 6, 12], y = [0, 6], type = "A" }
[building]
weight = "30 MN"
eccentricity = 0.05
height = 0.5
fixed_base_period = 0.4
[[storey]]
count = 2
height = 4
weight = "10 MN"
stiffness = 1000
"""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    path = tmp_path / "clinic.toml"
    path.write_text(TEXT)
    return path


def test_the_document_has_the_keys_of_respond_and_those_of_a_building(run, project: Path) -> None:
    outcome = run("building", project, "P695-FF-2", "--pgv", "0.5", "--tail", "5", "--json")
    assert (outcome.status, outcome.err) == (0, "")
    (found,) = json.loads(outcome.out)
    (plane,) = json.loads(run("respond", "P695-FF-2", "--pgv", "0.5", "--tail", "5", "--heating", "none", "--json").out)  # fmt: skip
    assert plane.keys() - found.keys() == {"temperature_point_max_degC", "friction_min"}
    assert found["corner_max_mm"] / found["y_max_mm"] == pytest.approx(found["corner_ratio"])
    assert found["rotation_max_rad"] > 1e-5
    assert found["base_shear_kN"] == found["force_max_kN"]
    assert len(found["drift_ratio_max"]) == 2
    assert len(found["floor_acceleration_max_m_s2"]) == len(found["levels"]) == 3
    bearings = found["bearings"]
    assert len(bearings) == 6
    assert sum(one["load_static_kN"] for one in bearings) == pytest.approx(30e3)
    assert found["load_min_kN"] == min(one["load_min_kN"] for one in bearings)
    assert found["load_max_kN"] == max(one["load_max_kN"] for one in bearings)
    assert found["temperature_max_degC"] == max(one["temperature_max_degC"] for one in bearings)
    assert found["corner_max_mm"] >= max(one["y_max_mm"] for one in bearings) - 1e-6
    assert found["floor_acceleration_max_m_s2"][2] == found["levels"][2]["acceleration_max_m_s2"]
    assert found["V_E_ratio"] == pytest.approx(1.0, abs=0.1)
    assert [one["code"] for one in found["torsion"]] == ["ASCE 7-16", "NTC 2018"]
    assert found["torsion"][0]["corner_ratio"] >= 1.15
    assert found["energy_residual"] < 1e-9
    assert "proportional to the stiffness" in found["damping"]
    assert any("stiffness kf of spring (b)" in one for one in found["remarks"])


def test_the_page_says_on_what_its_floors_depend(run, project: Path) -> None:
    outcome = run("building", project, "P695-FF-2", "--pgv", "0.5", "--tail", "5")
    assert (outcome.status, outcome.err) == (0, "")
    for words in ("30000 kN on 6 bearings", "goes furthest", "Torsion by codes", "Slab and floors", "every result of storeys and floors is with this", "Akiyama"):  # fmt: skip
        assert words in " ".join(outcome.out.split())


def test_files_of_one_and_of_several(run, project: Path, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    words = ("building", project, "P695-FF-2", "--pgv", "0.5", "--tail", "5")
    assert run(*words, "--out", "one.nc", "--plot", "one.png").err == ""
    data = xarray.open_dataset(tmp_path / "one.nc")
    assert data["bearing_load"].dims == ("time", "bearing")
    assert data["floor_acceleration_x"].dims == ("time", "level")
    assert data["drift_y"].dims == ("time", "storey")
    assert data["bearing_load_static_kN"].sum() == pytest.approx(30e3)
    total = data["bearing_load"].sum("bearing")
    np.testing.assert_allclose(total, 30e6, rtol=1e-9)
    assert data.attrs["y_max_mm"] == pytest.approx(float(data["displacement"].max()), rel=1e-3)
    assert (tmp_path / "one.png").stat().st_size > 10_000
    assert run(*words, "P695-FF-3", "--out", "two.csv", "--plot", "two.png").err == ""
    rows = list(csv.DictReader((tmp_path / "two.csv").read_text().splitlines()))
    assert [row["record"] for row in rows] == ["P695-FF-2", "P695-FF-3"]
    assert float(rows[0]["corner_max [mm]"]) == pytest.approx(float(rows[0]["y_max [mm]"]), rel=0.2)


def test_causes_one_by_one(run, project: Path) -> None:
    rows = json.loads(run("building", project, "P695-FF-2", "--pgv", "0.5", "--tail", "5", "--causes", "--json").out)  # fmt: skip
    assert len(rows) == 4
    symmetric, mass, heat, overturning = rows
    assert symmetric["corner_ratio"] == pytest.approx(1.0, abs=1e-6)
    assert mass["corner_ratio"] > 1.0
    assert heat["temperature_max_degC"] > 50.0 > mass["temperature_max_degC"]
    assert heat["load_max_kN"] == pytest.approx(mass["load_max_kN"])
    assert overturning["load_max_kN"] > 1.02 * heat["load_max_kN"]
    (whole,) = json.loads(run("building", project, "P695-FF-2", "--pgv", "0.5", "--tail", "5", "--json").out)
    assert overturning["corner_max_mm"] == whole["corner_max_mm"]


def test_floor_spectra(run, project: Path, tmp_path: Path) -> None:
    table, figure = tmp_path / "spectra.csv", tmp_path / "spectra.png"
    words = ("building", project, "P695-FF-2", "--pgv", "0.5", "--tail", "5")
    outcome = run(*words, "--floor-spectra", "--out", table, "--plot", figure)
    assert (outcome.status, outcome.err) == (0, "")
    rows = list(csv.DictReader(table.read_text().splitlines()))
    assert len(rows) == 3 * 200
    (found,) = json.loads(run(*words, "--json").out)
    # an oscillator that is stiff goes with the floor
    stiff = [max(float(rows[200 * i][f"S_a_{axis}_m_s2 [m s-2]"]) for axis in "xy") for i in range(3)]
    assert max(stiff) == pytest.approx(max(found["floor_acceleration_max_m_s2"]), rel=0.25)
    assert all(float(row["S_a_broadened_m_s2 [m s-2]"]) >= float(row["S_a_x_m_s2 [m s-2]"]) for row in rows)
    assert figure.stat().st_size > 10_000


def test_a_report_to_sign(run, project: Path, tmp_path: Path) -> None:
    project.write_text(
        TEXT + '[report]\nproject = "Clinic by the river"\nauthor = "A. Name"\ndate = 2026-11-30\n'
    )
    page, sheet = tmp_path / "report.html", tmp_path / "report.pdf"
    words = ("building", project, "P695-FF-2", "--pgv", "0.5", "--tail", "5")
    assert run(*words, "--out", page).err == ""
    text = page.read_text()
    for said in ("Clinic by the river", "A. Name", "2026-11-30", "A corner goes furthest", "Eq. (17.5-3)", "(7.10.4)", "Appendix: project", "fixed_base_period = 0.4", "proportional to the stiffness", "Floor accelerations depend"):  # fmt: skip
        assert said in text, said
    assert text.count("<figure>") == 2
    assert run(*words, "--out", sheet).err == ""
    assert sheet.read_bytes().startswith(b"%PDF")


def test_a_script_for_opensees_and_links_for_sap2000(run, project: Path, tmp_path: Path) -> None:
    script, links = tmp_path / "building.py", tmp_path / "links.s2k"
    words = ("building", project, "P695-FF-2", "--pgv", "0.5", "--tail", "0", "--friction", "constant", "--heating", "none")  # fmt: skip
    assert run(*words, "--out", script).err == ""
    compile(script.read_text(), "building.py", "exec")
    assert "singleFPBearing" in script.read_text()
    assert run(*words, "--out", links, "--link-temperature", "80").err == ""
    assert 'LinkType="Friction Isolator"' in links.read_text()
    assert "80 degC" in links.read_text()
    outcome = run(*words, "P695-FF-3", "--out", tmp_path / "other.py")
    assert (outcome.status, outcome.err.count("\n")) == (2, 1)
    assert "one station at one PGV" in outcome.err


def test_one_bearing_has_no_torsion_of_codes(run, tmp_path: Path) -> None:
    path = tmp_path / "one.toml"
    path.write_text(
        '[bearing.A]\n[plan]\nbearings = [{ x = 0, y = 0, type = "A" }]\n[building]\nweight = "7.5 MN"\n'
    )
    words = ("building", path, "P695-FF-2", "--pgv", "0.5", "--tail", "0")
    (found,) = json.loads(run(*words, "--json").out)
    (plane,) = json.loads(run("respond", "P695-FF-2", "--pgv", "0.5", "--tail", "0", "--heating", "simplified", "--pressure", str(7.5e6 / (np.pi * 200.0**2)), "--json").out)  # fmt: skip
    assert found["torsion"] == []
    assert found["y_max_mm"] == pytest.approx(plane["y_max_mm"], rel=1e-4)
    outcome = run(*words, "--out", tmp_path / "one.html")
    assert (outcome.status, outcome.err) == (0, "")
    assert "Torsion by codes" not in outcome.out


def test_a_project_to_start_from(run, tmp_path: Path) -> None:
    path = tmp_path / "hospital.toml"
    assert run("building", "--example", path).status == 0
    assert read_plan(path).count == 24
    again = run("building", "--example", path)
    assert (again.status, again.err.count("\n")) == (2, 1)
    assert "the file exists" in again.err


def test_a_report_with_another_heading_is_refused(run, project: Path, tmp_path: Path) -> None:
    project.write_text(TEXT + '[report]\nauthr = "A. Name"\n')
    outcome = run("building", project, "P695-FF-2", "--tail", "0", "--out", tmp_path / "r.html")
    assert (outcome.status, outcome.err.count("\n")) == (2, 1)
    assert "'author'" in outcome.err
    assert not (tmp_path / "r.html").exists()


def test_options_of_bearings_change_every_type(run, project: Path) -> None:
    words = ("building", project, "P695-FF-2", "--pgv", "0.5", "--tail", "0", "--json")
    (rough,) = json.loads(run(*words, "--friction", "constant", "--mu", "0.1", "--heating", "none").out)
    plan = read_plan(project)
    system = plan.systems[0].changed({"law": "constant", "mu": 0.1, "heating": "none"})
    motion = load_station("P695-FF-2")
    assert motion is not None
    response = respond_plan(replace(plan, types=(system,) * 6), motion.scaled_to_pgv(500.0), tail=0.0)
    assert rough["y_max_mm"] == response.peak_displacement
    assert (rough["friction"], rough["temperature_max_degC"]) == ("constant", 20.0)


def test_one_component_alone_moves_it_in_x(run, project: Path) -> None:
    (found,) = json.loads(run("building", project, "NCC", "--pgv", "0.5", "--tail", "0", "--json").out)
    assert found["y1_max_mm"] > 50.0
    assert any("one component alone" in remark for remark in found["remarks"])


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--bearing", "b.toml"), "the types of bearings and their loads are those of"),
        (("--pressure", "60"), "the types of bearings and their loads are those of"),
        (("--storeys", "3"), "is for a building of equal storeys"),
        (("--causes", "--floor-spectra"), "give one of the two"),
        (("--causes", "--no-overturning"), "adds overturning as one of them"),
        (("--heating", "precise"), "heated at one point each"),
        (("other.toml",), "name one project"),
        (("--out", "x.xlsx"), ".nc"),
        (("--link-temperature", "80"), "is for links of SAP2000"),
        (("--example", "y.toml"), "give it alone"),
    ],
)
def test_what_does_not_go_together(run, project: Path, words: tuple[str, ...], said: str) -> None:
    outcome = run("building", project, "P695-FF-2", *words)
    assert (outcome.status, outcome.out, outcome.err.count("\n")) == (2, "", 1)
    assert said in outcome.err


@pytest.mark.parametrize("option", [("--vertical",), ("--rotate", "30"), ("--causes",), ("--plot", "a.png")])
def test_what_is_of_a_project_needs_one(run, option: tuple[str, ...], tmp_path: Path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    outcome = run("building", "NCC", *option)
    assert (outcome.status, outcome.out, outcome.err.count("\n")) == (2, "", 1)
    assert "PROJECT.toml" in outcome.err


def test_a_project_without_stations_or_that_is_not_there(run, project: Path, tmp_path: Path) -> None:
    assert "RECORD" in run("building", project).err
    missing = run("building", tmp_path / "none.toml", "P695-FF-2")
    assert (missing.status, missing.err.count("\n")) == (2, 1)
    assert "there is no such file" in missing.err
