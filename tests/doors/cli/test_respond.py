"""`dcfp respond` from end to end."""

import json
from pathlib import Path

import pytest
import xarray

from dcfp import LI_2020, load_motion, respond

#: As docs and scripts know them.
KEYS = {
    "record", "pgv_m_s", "friction", "heating", "y_max_mm", "dy_max_mm", "v_max_mm_s", "residual_mm", "force_max_kN",
    "temperature_max_degC", "friction_min", "V_E_mm_s", "V_Eh_mm_s", "energy_residual", "status", "elapsed_s",
}  # fmt: skip


def rows(outcome) -> list[dict]:
    assert (outcome.status, outcome.err) == (0, "")
    return json.loads(outcome.out)


def test_json_has_the_fixed_keys_and_all_digits(run) -> None:
    found = rows(run("respond", "NCC", "--pgv", "0.25", "0.5", "--json"))
    assert [set(row) for row in found] == [KEYS | {"remarks"}] * 2
    response = respond(load_motion("NCC").scaled_to_pgv(500.0))
    assert found[1]["y_max_mm"] == response.peak_displacement
    assert found[1]["V_E_mm_s"] == response.input_velocity
    assert found[1]["pgv_m_s"] == pytest.approx(0.5, rel=1e-12)
    assert found[1]["remarks"] == ["NCC: scaled by 1.11371."]


@pytest.mark.parametrize(
    "words",
    [
        ("--pgv", "0.25", "0.5", "NCC"),
        ("NCC", "--pgv", "0.25", "0.5"),
        ("--step", "0.01", "NCC", "--pgv", "0.25", "0.5"),
        ("--radius", "4500", "NCC", "--pgv", "0.25", "0.5"),
    ],
)
def test_records_may_stand_anywhere(run, words: tuple[str, ...]) -> None:
    found = rows(run("respond", *words, "--json"))
    assert [(row["record"], round(row["pgv_m_s"], 6)) for row in found] == [("NCC", 0.25), ("NCC", 0.5)]


def test_records_before_and_after_options_are_all_analysed(run) -> None:
    found = rows(run("respond", "KNA", "--pgv", "0.3", "NCC", "--json", "LPG"))
    assert sorted(row["record"] for row in found) == ["KNA", "LPG", "NCC"]


def test_the_table_says_what_was_analysed(run) -> None:
    status, out, err = run("respond", "NCC", "--pgv", "0.5", "2", "--mu", "0.05")
    assert (status, err) == (0, "")
    lines = out.splitlines()
    assert all(
        word in out for word in ("Li et al. (2020)", "slider 400 mm", "li2020", "0.05", "simplified", "20 °C")
    )
    assert all(unit in out for unit in ("[m/s]", "[mm]", "[kN]", "[°C]", "[-]"))
    assert max(len(line) for line in lines) <= 100
    assert not any(line != line.rstrip() for line in lines)
    assert "\x1b" not in out
    assert "exceeds the capacity of 440 mm" in " ".join(out.split())


def test_long_names_are_folded_and_numbers_never_cut(run, pulse: Path) -> None:
    long = pulse.rename(pulse.with_name("a_record_with_a_very_long_name_indeed_0001.txt"))
    _, out, _ = run("respond", long, "--units", "m/s2")
    assert "…" not in out
    assert max(len(line) for line in out.splitlines()) <= 100


def test_options_come_before_the_bearing_file(run, tmp_path: Path) -> None:
    file = tmp_path / "bearing.toml"
    file.write_text(
        'name = "mine"\nradius = 2000\nslider = 300\npressure = 40\n[friction]\nlaw = "constant"\nmu = 0.05\n'
    )
    plain = rows(run("respond", "NCC", "--bearing", file, "--json"))[0]
    assert plain["friction"] == "constant"
    assert plain["friction_min"] == pytest.approx(0.05)
    changed = rows(
        run(
            "respond",
            "NCC",
            "--bearing",
            file,
            "--mu",
            "0.08",
            "--heating",
            "none",
            "--pressure",
            "60",
            "--json",
        )
    )[0]
    assert (changed["friction"], changed["heating"]) == ("constant", "none")
    assert changed["friction_min"] == pytest.approx(0.08)
    assert changed["force_max_kN"] > plain["force_max_kN"]


def test_single_values_change_the_default_bearing(run) -> None:
    _, out, _ = run("respond", "NCC", "--radius", "1000", "2000", "--slider", "250", "--capacity", "20")
    assert "radius 1000 + 2000 mm" in out
    assert "capacity 20 mm" in out
    assert "beyond" in out
    _, out, _ = run("respond", "NCC", "--radius", "1000")
    assert "radius 1000 + 1000 mm" in out
    assert "capacity not given" in " ".join(
        out.split()
    )  # the paper's bearing lends only what was not changed


@pytest.mark.parametrize("law", ["li2020", "constant", "constantinou1990", "kumar2015", "kim2023-third"])
def test_mu_sets_the_reference_of_every_law(run, law: str) -> None:
    low, high = (
        rows(run("respond", "NCC", "--friction", law, "--mu", mu, "--heating", "none", "--json"))[0][
            "force_max_kN"
        ]
        for mu in ("0.03", "0.09")
    )
    assert high > 2.0 * low


def test_ambient_temperature_is_where_heating_starts(run) -> None:
    cold = rows(run("respond", "NCC", "--ambient", "-10", "--json", "--heating", "none"))[0]
    assert cold["temperature_max_degC"] == -10.0


def test_step_and_tail_reach_the_analysis(run, pulse: Path, tmp_path: Path) -> None:
    out = tmp_path / "r.nc"
    status, _, err = run(
        "respond",
        pulse,
        "--units",
        "m/s2",
        "--step",
        "0.005",
        "--tail",
        "1",
        "--tolerance",
        "0.01",
        "--out",
        out,
    )
    assert (status, err) == (0, "")
    with xarray.open_dataset(out) as data:
        assert float(data.time[1]) == pytest.approx(0.005)
        assert float(data.time[-1]) == pytest.approx(5.0)
        assert json.loads(data.attrs["settings"])["tolerance"] == 0.01


def test_drift_and_treatment_are_never_silent(run, drifting: Path) -> None:
    plain = rows(run("respond", drifting, "--units", "m/s2", "--json"))[0]
    assert any("untreated baseline" in remark for remark in plain["remarks"])
    treated = rows(run("respond", drifting, "--units", "m/s2", "--baseline", "--high-pass", "0.2", "--json"))[
        0
    ]
    assert any("linear baseline in velocity removed" in remark for remark in treated["remarks"])
    assert any("high-pass 0.2 Hz" in remark for remark in treated["remarks"])
    assert not any("untreated" in remark for remark in treated["remarks"])
    filtered = rows(run("respond", drifting, "--units", "m/s2", "--high-pass", "0.2", "--json"))[0]
    assert any("mean removed" in remark for remark in filtered["remarks"])
    _, out, _ = run("respond", drifting, "--units", "m/s2")
    assert "untreated baseline" in " ".join(out.split())


@pytest.mark.slow
def test_a_record_of_zeros_can_be_analysed_and_drawn(run, zeros: Path, tmp_path: Path) -> None:
    status, _, err = run("respond", zeros, "--units", "m/s2", "--plot", tmp_path / "z.png")
    assert (status, err) == (0, "")
    assert (tmp_path / "z.png").stat().st_size > 1000


def test_one_analysis_with_precise_heating_keeps_the_plates(run, tmp_path: Path) -> None:
    out = tmp_path / "ncc.nc"
    assert run("respond", "NCC", "--pgv", "0.5", "--heating", "precise", "--out", out).status == 0
    with xarray.open_dataset(out) as data:
        assert data.sizes["profile_time"] == pytest.approx(200, abs=20)
        assert data["plate_temperature"].attrs["units"] == "degC"
        assert data.attrs["y_max_mm"] > 50.0


def test_several_analyses_become_groups(run, tmp_path: Path) -> None:
    out = tmp_path / "all.nc"
    found = rows(run("respond", "NCC", "KNA", "--pgv", "0.25", "0.5", "--out", out, "--json"))
    with xarray.open_datatree(out) as tree:
        assert sorted(tree.children) == ["KNA_0.25", "KNA_0.50", "NCC_0.25", "NCC_0.50"]
        assert tree["y_max"].to_numpy().tolist() == [row["y_max_mm"] for row in found]
        assert tree["/NCC_0.50"]["displacement"].attrs["units"] == "mm"


@pytest.mark.slow
@pytest.mark.parametrize(("extension", "head"), [("png", b"\x89PNG"), ("pdf", b"%PDF"), ("svg", b"<?xml")])
def test_figures_by_extension(run, pulse: Path, tmp_path: Path, extension: str, head: bytes) -> None:
    figure = tmp_path / f"figure.{extension}"
    assert run("respond", pulse, "--units", "m/s2", "--plot", figure).status == 0
    assert figure.read_bytes().startswith(head)


def test_outputs_stay_beside_a_json_document(run, pulse: Path, tmp_path: Path) -> None:
    words = ("--out", tmp_path / "a.csv", "--plot", tmp_path / "a.png", "--json")
    assert len(rows(run("respond", pulse, "--units", "m/s2", *words))) == 1
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.csv", "a.png", "pulse.txt"]


def test_the_default_bearing_is_not_called_changed(run) -> None:
    _, out, _ = run("respond", "NCC", "--pressure", f"{LI_2020.pressure:g}")
    assert "changed" not in out


def test_half_cycles_in_place_of_the_peaks(run, tmp_path: Path) -> None:
    words = ("respond", "NCC", "--pgv", "0.5", "--half-cycles", "50")
    found = rows(run(*words, "--json"))
    peaks = rows(run("respond", "NCC", "--pgv", "0.5", "--json"))[0]
    assert max(abs(row["dy_mm"]) for row in found) == pytest.approx(peaks["dy_max_mm"], rel=1e-4)
    file = tmp_path / "half.csv"
    _, out, _ = run(*words, "--out", str(file))
    assert "dEhr" in out
    lines = file.read_text(encoding="utf-8").splitlines()
    assert len(lines) == len(found) + 1
    assert lines[0].endswith("dEhr [N mm],dEsr [N mm],V_dE [mm s-1],V_dEr [mm s-1],V_dEhr [mm s-1]")


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("P695-FF-2",), "single components"),
        (("NCC", "--out", "a.nc"), "--out FILE.csv"),
    ],
)
def test_half_cycles_that_there_are_not_are_refused(run, words: tuple[str, ...], told: str) -> None:
    status, out, err = run("respond", *words, "--half-cycles", "50")
    assert (status, out) == (2, "")
    assert told in err
